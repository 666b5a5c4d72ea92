// Loops over the rows of an array without the interpreter's lock.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "pdg/native/pieces/piece_set.hpp"

namespace pdg::python {

namespace nb = nanobind;

using Poses = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

// Python handles signals each time that so many rows are done, so that Ctrl-C ends a long batch.
inline constexpr std::size_t kRowsBetweenSignals = 4096;

// Calls work(row) for each row without the interpreter's lock. Returns the row at which it threw
// std::invalid_argument, which ends the loop, or -1.
template <class Work>
std::int64_t for_each_row(const std::size_t rows, const Work& work) {
  const nb::gil_scoped_release release;
  for (std::size_t row = 0; row < rows; ++row) {
    try {
      work(row);
    } catch (const std::invalid_argument&) {
      return static_cast<std::int64_t>(row);
    }
    if ((row + 1) % kRowsBetweenSignals == 0) {
      const nb::gil_scoped_acquire acquire;
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
    }
  }
  return -1;
}

inline pdg::Pose pose_of(const Poses& poses, const std::size_t row) {
  const double* q = poses.data() + 3 * row;
  return {{q[0], q[1]}, q[2]};
}

}  // namespace pdg::python
