// Brackets of the generalized depth for Python.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "pdg/native/bounds/bracket.hpp"
#include "rows.hpp"
#include "separators.hpp"
#include "subjects.hpp"
#include "watch.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace pdg::python {
namespace {

using Numbers = nb::ndarray<nb::numpy, double, nb::shape<-1, 9>>;
using Counts = nb::ndarray<nb::numpy, std::uint64_t, nb::shape<-1, 2>>;
using Ends = nb::ndarray<nb::numpy, std::uint8_t, nb::shape<-1>>;

std::array<double, 9> numbers_of(const pdg::Bracket& found) {
  const pdg::Pose& p = found.displaced.pose;
  const pdg::Pose& q = found.distanced.pose;
  return {found.lower, found.displaced.displacement, p.t.x, p.t.y,
          p.theta,     found.distanced.distance,     q.t.x, q.t.y,
          q.theta};
}

// Brackets the depth of each pose, without the interpreter's lock. Returns the first row that is
// out of range, or -1, and for each row (lower, displacement, its pose, distance, its pose),
// (nodes, slices) and the end. `timeout` and `max_nodes` are for each pose.
auto bracket_depths(const pdg::PieceSet& a, const pdg::PieceSet& b, const SeparatorSet* separators,
                    const Poses& poses, const double relative_tolerance, const double timeout,
                    const std::uint64_t max_nodes) {
  const std::size_t count = poses.shape(0);
  std::vector<double> numbers(9 * count);
  std::vector<std::uint64_t> counts(2 * count);
  std::vector<std::uint8_t> ends(count);
  const std::vector<pdg::ConvexSeparator> none;
  Watch watch(timeout);
  const pdg::BracketLimits limits{relative_tolerance, max_nodes, [&] { return watch.over(); }};
  const std::int64_t bad = for_each_row(count, [&](const std::size_t row) {
    watch.begin();
    const pdg::Bracket found = pdg::bracket_depth(
        a, b, pose_of(poses, row), limits, separators == nullptr ? none : separators->separators);
    const std::array<double, 9> values = numbers_of(found);
    std::copy(values.begin(), values.end(), numbers.begin() + static_cast<std::ptrdiff_t>(9 * row));
    counts[2 * row] = found.nodes;
    counts[2 * row + 1] = found.slices;
    ends[row] = static_cast<std::uint8_t>(found.end);
  });
  return std::tuple{bad, to_array<double, Numbers>(std::move(numbers), {count, 9}),
                    to_array<std::uint64_t, Counts>(std::move(counts), {count, 2}),
                    to_array<std::uint8_t, Ends>(std::move(ends), {count})};
}

}  // namespace

void bind_bracket(nb::module_& m) {
  m.def("bracket_depths", &bracket_depths, "a"_a, "b"_a, "separators"_a.none(), "poses"_a,
        "relative_tolerance"_a, "timeout"_a, "max_nodes"_a);
}

}  // namespace pdg::python
