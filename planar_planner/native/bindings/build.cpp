#include "build.hpp"

#include <nanobind/stl/string.h>

#include <string>

#include "build_facts.hpp"

namespace nb = nanobind;

namespace bindings {

namespace {

std::string abi() {
  const std::string python =
      std::to_string(PY_MAJOR_VERSION) + "." + std::to_string(PY_MINOR_VERSION);
#ifdef Py_LIMITED_API
  return "abi3, CPython " + python + " or later";
#else
  return "CPython " + python;
#endif
}

std::string nanobind_version() {
  return std::to_string(NB_VERSION_MAJOR) + "." + std::to_string(NB_VERSION_MINOR) + "." +
         std::to_string(NB_VERSION_PATCH);
}

}  // namespace

nb::dict build_info() {
  nb::dict out;
  out["version"] = build_facts::kVersion;
  out["commit"] = build_facts::kCommit;
  out["compiler"] = build_facts::kCompiler;
  out["build_type"] = build_facts::kBuildType;
  out["flags"] = build_facts::kFlags;
  out["abi"] = abi();
  out["nanobind"] = nanobind_version();
  return out;
}

}  // namespace bindings
