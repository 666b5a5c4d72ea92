#include "outcome.hpp"

namespace nb = nanobind;

namespace bindings {

namespace {

constexpr const char* kModule = "planar_planner._core";

template <class Enum>
void add_enumeration(nb::module_& m, const char* doc) {
  using Names = planner::Names<Enum>;
  nb::list members;
  for (const auto& name : Names::kAll)
    members.append(nb::make_tuple(name.python, nb::cast(name.word)));
  const nb::object make = nb::module_::import_("enum").attr("StrEnum");
  nb::object made = make(Names::kClass, members, nb::arg("module") = kModule);
  made.attr("__doc__") = doc;
  m.attr(Names::kClass) = made;
}

}  // namespace

void add_outcome(nb::module_& m) {
  add_enumeration<planner::DecidedBy>(m, "What a path or its absence was shown by.");
  add_enumeration<planner::StopReason>(m, "Why a query stayed undecided.");
}

nb::object python_member(const char* class_name, const std::string_view word) {
  return nb::module_::import_(kModule).attr(class_name)(nb::cast(word));
}

}  // namespace bindings
