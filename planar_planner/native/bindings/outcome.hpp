// DecidedBy and StopReason as enumerations of strings in Python, made from the lists of
// outcome.hpp.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string_view.h>

#include <cstdint>
#include <string_view>

#include "planar_planner/native/outcome.hpp"

namespace bindings {

// Adds both classes to the module.
void add_outcome(nanobind::module_& m);

// The member with this value of a class that was added.
nanobind::object python_member(const char* class_name, std::string_view word);

template <class Enum>
bool from_word(const nanobind::handle source, Enum& out) {
  std::string_view text;
  if (!nanobind::try_cast(source, text)) return false;
  for (const auto& name : planner::Names<Enum>::kAll)
    if (name.word == text) {
      out = name.value;
      return true;
    }
  return false;
}

template <class Enum>
nanobind::handle to_member(const Enum value) {
  return python_member(planner::Names<Enum>::kClass, planner::word(value)).release();
}

}  // namespace bindings

// From Python a word will do in place of the member.
namespace nanobind::detail {

template <>
struct type_caster<planner::DecidedBy> {
  NB_TYPE_CASTER(planner::DecidedBy, const_name("DecidedBy"))
  bool from_python(const handle source, const std::uint32_t, cleanup_list*) {
    return bindings::from_word(source, value);
  }
  static handle from_cpp(const planner::DecidedBy source, rv_policy, cleanup_list*) {
    return bindings::to_member(source);
  }
};

template <>
struct type_caster<planner::StopReason> {
  NB_TYPE_CASTER(planner::StopReason, const_name("StopReason"))
  bool from_python(const handle source, const std::uint32_t, cleanup_list*) {
    return bindings::from_word(source, value);
  }
  static handle from_cpp(const planner::StopReason source, rv_policy, cleanup_list*) {
    return bindings::to_member(source);
  }
};

}  // namespace nanobind::detail
