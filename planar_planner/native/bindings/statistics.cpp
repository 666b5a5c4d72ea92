#include "statistics.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <string>

#include "outcome.hpp"
#include "planar_planner/native/statistics.hpp"

namespace nb = nanobind;

namespace nanobind::detail {

// A dict, label by label; what is missing counts 0.
template <>
struct type_caster<planner::LabelCounts> {
  static constexpr std::array<const char*, 4> kLabels{"free", "star", "full", "mixed"};

  NB_TYPE_CASTER(planner::LabelCounts, const_name("dict[str, int]"))
  bool from_python(const handle source, const std::uint32_t, cleanup_list*) {
    if (!isinstance<dict>(source)) return false;
    const dict counts = borrow<dict>(source);
    for (std::size_t i = 0; i < kLabels.size(); ++i)
      if (counts.contains(kLabels[i]) && !try_cast(counts[kLabels[i]], value.of[i])) return false;
    return true;
  }
  static handle from_cpp(const planner::LabelCounts& source, rv_policy, cleanup_list*) {
    dict counts;
    for (std::size_t i = 0; i < kLabels.size(); ++i) counts[kLabels[i]] = source.of[i];
    return counts.release();
  }
};

}  // namespace nanobind::detail

namespace bindings {

namespace {

using planner::Bytes;
using planner::Count;
using planner::Decision;
using planner::LabelCounts;
using planner::LevelCounts;
using planner::Real;
using planner::Seconds;
using planner::Statistics;
using planner::Work;

std::string documentation(const std::string& meaning, const std::string& unit) {
  return unit.empty() ? meaning : meaning + " Unit: " + unit + ".";
}

// Calls visit(name, field) for every field in order.
template <class Visit>
void visit(Seconds& s, const Visit& visit) {
#define PLANNER_VISIT(name, adding, meaning) visit(#name, s.name);
  PLANNER_SECONDS(PLANNER_VISIT)
#undef PLANNER_VISIT
}

template <class Visit>
void visit(Statistics& s, const Visit& visit) {
#define PLANNER_VISIT(type, name, adding, unit, meaning) visit(#name, s.name);
  PLANNER_STATISTICS(PLANNER_VISIT)
#undef PLANNER_VISIT
}

template <class Fields>
nb::dict fields_of(const Fields& fields) {
  Fields copy = fields;
  nb::dict out;
  visit(copy, [&](const char* name, const auto& value) { out[name] = value; });
  return out;
}

nb::dict to_dict(const Seconds& seconds) {
  return fields_of(seconds);
}

nb::dict to_dict(const Statistics& statistics) {
  nb::dict out = fields_of(statistics);
  out["seconds"] = to_dict(statistics.seconds);
  return out;
}

template <class Fields>
Fields replaced(const Fields& fields, const nb::dict& changes) {
  Fields out = fields;
  nb::dict left = nb::borrow<nb::dict>(changes.attr("copy")());
  visit(out, [&]<class Value>(const char* name, Value& value) {
    if (!left.contains(name)) return;
    if (!nb::try_cast(left[name], value))
      throw nb::type_error((std::string(name) + " is of another type").c_str());
    nb::del(left[name]);
  });
  for (const auto [name, value] : left)
    throw nb::type_error(
        ("there is no statistic " + nb::cast<std::string>(nb::repr(name))).c_str());
  return out;
}

// What was counted, without what is 0.
template <class Fields>
std::string representation(const char* class_name, const Fields& fields) {
  Fields zero, copy = fields;
  const nb::dict none = fields_of(zero);
  std::string out;
  visit(copy, [&](const char* name, const auto& value) {
    const nb::object shown = nb::cast(value);
    if (shown.equal(none[name])) return;
    out += (out.empty() ? "" : ", ") + std::string(name) + "=" + nb::repr(shown).c_str();
  });
  return class_name + ("(" + out + ")");
}

// What both classes have besides their fields.
template <class Fields>
void add_common(nb::class_<Fields>& made, const char* class_name) {
  made.def(
          "to_dict", [](const Fields& self) { return to_dict(self); },
          "Return all fields by name, in their order, in Python's own types.")
      .def(
          "replace",
          [](const Fields& self, const nb::kwargs& changes) { return replaced(self, changes); },
          "Return a copy with some fields changed.")
      .def(
          "__eq__", [](const Fields& self, const Fields& other) { return self == other; },
          nb::is_operator())
      .def("__repr__",
           [class_name](const Fields& self) { return representation(class_name, self); })
      .def("__getstate__", [](const Fields& self) { return fields_of(self); })
      .def("__setstate__", [](Fields& self, const nb::dict& state) {
        new (&self) Fields(replaced(Fields{}, state));
      });
  made.attr("__hash__") = nb::none();
}

void add_seconds(nb::module_& m) {
  nb::class_<Seconds> made(m, "Seconds",
                           "Seconds of wall-clock time that an answer took, by what was done.");
#define PLANNER_PARAMETER(name, adding, meaning) , const double name
#define PLANNER_ARGUMENT(name, adding, meaning) , nb::arg(#name) = 0.0
#define PLANNER_SET(name, adding, meaning) self->name = name;
#define PLANNER_PROPERTY(name, adding, meaning) \
  made.def_prop_ro(#name, [](const Seconds& self) { return self.name; }, meaning);
  made.def(
      "__init__",
      [](Seconds* self PLANNER_SECONDS(PLANNER_PARAMETER)) {
        new (self) Seconds();
        PLANNER_SECONDS(PLANNER_SET)
      },
      nb::kw_only() PLANNER_SECONDS(PLANNER_ARGUMENT));
  PLANNER_SECONDS(PLANNER_PROPERTY)
#undef PLANNER_PARAMETER
#undef PLANNER_ARGUMENT
#undef PLANNER_SET
#undef PLANNER_PROPERTY
  add_common(made, "Seconds");
}

}  // namespace

void add_statistics(nb::module_& m) {
  add_seconds(m);
  nb::class_<Statistics> made(
      m, "Statistics",
      "Counts and times of an answer.\n\n"
      "They are of one query, that of discs tried on the way included. `cells`, `cells_by_label`, "
      "`cells_by_level` and\n`memory_bytes` describe the subdivision with what earlier queries of "
      "the planner left in it.");
#define PLANNER_PARAMETER(type, name, adding, unit, meaning) , const type& name
#define PLANNER_ARGUMENT(type, name, adding, unit, meaning) \
  , nb::arg(#name) = type {}
#define PLANNER_SET(type, name, adding, unit, meaning) self->name = name;
#define PLANNER_PROPERTY(type, name, adding, unit, meaning)    \
  made.def_prop_ro(                                            \
      #name, [](const Statistics& self) { return self.name; }, \
      documentation(meaning, unit).c_str());
  made.def(
      "__init__",
      [](Statistics* self PLANNER_STATISTICS(PLANNER_PARAMETER)) {
        new (self) Statistics();
        PLANNER_STATISTICS(PLANNER_SET)
      },
      nb::kw_only() PLANNER_STATISTICS(PLANNER_ARGUMENT));
  PLANNER_STATISTICS(PLANNER_PROPERTY)
#undef PLANNER_PARAMETER
#undef PLANNER_ARGUMENT
#undef PLANNER_SET
#undef PLANNER_PROPERTY
  add_common(made, "Statistics");
}

}  // namespace bindings
