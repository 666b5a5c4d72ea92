#include "joint.hpp"

#include <algorithm>
#include <cmath>

#include "pdg/native/separation.hpp"

namespace planner {

using pdg::Constraint;
using pdg::ConvexPiece;
using pdg::EdgeOwner;
using pdg::Motion;
using pdg::PosedPiece;

namespace {

// The linear programme has three unknowns; it is stopped after so many pivots.
constexpr int kPivots = 24;

}  // namespace

bool JointTest::obstructs(const Motion& motion, const pdg::PosedRobot& posed,
                          const ConstraintView& list) {
  collect(motion, posed, list);
  return terms_.size() >= 2 && find_weights(motion) && proves(motion);
}

void JointTest::collect(const Motion& motion, const pdg::PosedRobot& posed,
                        const ConstraintView& list) {
  terms_.clear();
  std::size_t at = 0;
  for (const PairHeader& header : list.pairs) {
    if (header.count == 1) {  // with several axes left a pair only gives a disjunction
      const PosedPiece a = posed_piece(robot_, posed, header.robot);
      const ConvexPiece& b = tree_.piece(header.obstacle);
      const Constraint& c = list.constraints[at];
      const double error = pdg::separation_error(*a.piece, b, motion);
      const std::size_t ring = c.owner == EdgeOwner::kObstacle ? a.vertices.size() : b.edges.size();
      for (std::size_t i = 0; i < c.count; ++i)
        add_term(motion, a, b,
                 {header.obstacle, header.robot, c.edge,
                  static_cast<std::uint16_t>((c.first + i) % ring), c.owner, 0.0},
                 error);
    }
    at += header.count;
  }
}

void JointTest::add_term(const Motion& m, const PosedPiece& a, const ConvexPiece& b,
                         const JointTerm& source, const double error) {
  Term term{};
  term.error = error;
  term.source = source;
  if (source.owner == EdgeOwner::kObstacle) {
    const pdg::Edge& edge = b.edges[source.edge];
    const Vec2 p = a.vertices[source.vertex];
    term.normal = edge.normal;
    term.v = dot(edge.normal, p);
    term.w = cross(p, edge.normal);
    term.value = dot(edge.normal, m.t) - edge.offset;
  } else {
    const Vec2 n = a.normals[source.edge];
    const Vec2 u = b.edges[source.vertex].vertex - m.t;
    term.normal = -n;
    term.v = dot(n, u);
    term.w = cross(n, u);
    term.value = -a.piece->edges[source.edge].offset;
    // |(R(delta) M - M) . e| <= 2 sin(h / 2) |e| <= h (|g1| + |g2|)
    term.bend = m.half_angle * (m.g1_length + m.g2_length);
  }
  terms_.push_back(term);
}

// Minimises  sum lambda_k c_k + |sum lambda_k g_k|_1  over lambda >= 0, sum lambda = 1: by duality
// the largest value that min_k s_k can take in the linearised cell, scaled to [-1, 1]^3. Primal
// simplex on  G lambda = p - q, p, q >= 0  with a 4 x 4 basis inverse, until the value is negative.
bool JointTest::find_weights(const Motion& m) {
  const std::size_t count = terms_.size();
  columns_.clear();
  costs_.clear();
  for (const Term& t : terms_) {
    columns_.push_back({dot(t.normal, m.g1), dot(t.normal, m.g2), t.w * m.half_angle, 1.0});
    const double curvature = t.v < 0.0 ? -t.v * (1.0 - m.cos_half) : 0.0;
    costs_.push_back(t.value + t.v + curvature + t.bend + t.error);
  }
  for (int row = 0; row < 3; ++row)
    for (const double sign : {-1.0, 1.0}) {  // p and q
      Column column{};
      column[static_cast<std::size_t>(row)] = sign;
      columns_.push_back(column);
      costs_.push_back(1.0);
    }
  // Start: the single best term, with p or q for each of its components.
  std::size_t first = 0;
  double least = INFINITY;
  for (std::size_t k = 0; k < count; ++k) {
    const Column& g = columns_[k];
    const double alone = costs_[k] + std::abs(g[0]) + std::abs(g[1]) + std::abs(g[2]);
    if (alone < least) {
      least = alone;
      first = k;
    }
  }
  std::array<std::size_t, kRows> basis{};
  std::array<Column, kRows> inverse{};  // rows of the basis inverse
  Column solution{};
  basis[3] = first;
  inverse[3][3] = 1.0;
  solution[3] = 1.0;
  for (std::size_t row = 0; row < 3; ++row) {
    const double g = columns_[first][row];
    const double sign = g >= 0.0 ? -1.0 : 1.0;  // p - q = g, written as g - p + q = 0
    basis[row] = count + 2 * row + (sign > 0.0 ? 1 : 0);
    inverse[row][row] = sign;
    inverse[row][3] = -sign * g;
    solution[row] = std::abs(g);
  }
  for (int pivot = 0; pivot <= kPivots; ++pivot) {
    double value = 0.0;
    Column prices{};
    for (std::size_t i = 0; i < kRows; ++i) {
      const double cost = costs_[basis[i]];
      value += cost * solution[i];
      for (std::size_t j = 0; j < kRows; ++j) prices[j] += cost * inverse[i][j];
    }
    if (value < 0.0) {
      weights_.assign(count, 0.0);
      for (std::size_t i = 0; i < kRows; ++i)
        if (basis[i] < count) weights_[basis[i]] = std::max(solution[i], 0.0);
      return true;
    }
    std::size_t entering = columns_.size();
    double steepest = 0.0;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const Column& g = columns_[k];
      const double reduced =
          costs_[k] - prices[0] * g[0] - prices[1] * g[1] - prices[2] * g[2] - prices[3] * g[3];
      if (reduced < steepest) {
        steepest = reduced;
        entering = k;
      }
    }
    if (entering == columns_.size()) return false;  // optimal, and not negative
    Column direction{};
    for (std::size_t i = 0; i < kRows; ++i)
      for (std::size_t j = 0; j < kRows; ++j) direction[i] += inverse[i][j] * columns_[entering][j];
    std::size_t leaving = kRows;
    double step = INFINITY;
    for (std::size_t i = 0; i < kRows; ++i)
      if (direction[i] > 0.0 && solution[i] < step * direction[i]) {
        step = solution[i] / direction[i];
        leaving = i;
      }
    if (leaving == kRows) return false;
    for (std::size_t i = 0; i < kRows; ++i) {
      if (i == leaving) continue;
      const double factor = direction[i] / direction[leaving];
      solution[i] -= factor * solution[leaving];
      for (std::size_t j = 0; j < kRows; ++j) inverse[i][j] -= factor * inverse[leaving][j];
    }
    const double scale = 1.0 / direction[leaving];
    solution[leaving] *= scale;
    for (double& x : inverse[leaving]) x *= scale;
    basis[leaving] = entering;
  }
  return false;
}

// The bound itself, for the weights found, whatever the linear programme's rounding did to them:
// every non-negative set of weights proves what it proves.
bool JointTest::proves(const Motion& m) const {
  Term sum{};
  double total = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const double weight = weights_[k];
    if (weight == 0.0) continue;
    const Term& t = terms_[k];
    sum.normal = sum.normal + weight * t.normal;
    sum.v += weight * t.v;
    sum.w += weight * t.w;
    sum.value += weight * t.value;
    sum.bend += weight * t.bend;
    total += weight;
    largest = std::max(largest, t.error);
  }
  const double extent = std::abs(dot(sum.normal, m.g1)) + std::abs(dot(sum.normal, m.g2));
  const double bound = pdg::sinusoid_range(sum.v, sum.w, m).hi + sum.value + sum.bend + extent;
  return bound < -pdg::kJointErrorFactor * largest * total;
}

JointProof JointTest::proof() const {
  JointProof proof;
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    if (weights_[k] == 0.0) continue;
    JointTerm& term = proof.terms[proof.count++];
    term = terms_[k].source;
    term.weight = weights_[k];
  }
  return proof;
}

}  // namespace planner
