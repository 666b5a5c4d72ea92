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

// Choices are tried for at most so many pairs, and at most so many in all. More prove hardly more
// cells (docs/method.md) and cost time on those that they do not prove.
constexpr std::size_t kBranchingPairs = 2;
constexpr std::size_t kCases = 9;

// Bound of |(R(delta) M - M) . e| for |M| = 1: 2 sin(h / 2) |e| <= h (|g1| + |g2|).
double unit_bend(const Motion& m) {
  return m.half_angle * (m.g1_length + m.g2_length);
}

bool is_turning(const Vec2 n) {
  return n.x != 0.0 || n.y != 0.0;
}

}  // namespace

std::size_t JointProof::bytes() const {
  std::size_t sum = sizeof(JointProof);
  for (const PairAxes& pair : pairs)
    sum += sizeof(pair) + pair.axes.capacity() * sizeof(PairAxes::Axis);
  for (const JointSum& terms : sums) {
    sum += sizeof(JointSum) + terms.capacity() * sizeof(JointTerm);
  }
  return sum;
}

bool JointTest::obstructs(const Motion& motion, const pdg::PosedRobot& posed,
                          const ConstraintView& list) {
  proof_ = {};
  collect(motion, posed, list);
  return refute(motion) || refute_cases(motion, posed, list);
}

void JointTest::collect(const Motion& motion, const pdg::PosedRobot& posed,
                        const ConstraintView& list) {
  terms_.clear();
  several_.clear();
  std::size_t at = 0;
  for (std::size_t i = 0; i < list.pairs.size(); ++i) {
    const PairHeader& pair = list.pairs[i];
    if (pair.count == 1) add_terms(motion, posed, pair, list.constraints[at]);
    if (pair.count > 1) several_.push_back({i, at});
    at += pair.count;
  }
}

void JointTest::add_terms(const Motion& motion, const pdg::PosedRobot& posed,
                          const PairHeader& pair, const Constraint& c) {
  const PosedPiece a = posed_piece(robot_, posed, pair.robot);
  const ConvexPiece& b = tree_.piece(pair.obstacle);
  const double error = pdg::separation_error(*a.piece, b, motion);
  const std::size_t ring = c.owner == EdgeOwner::kObstacle ? a.vertices.size() : b.edges.size();
  for (std::size_t i = 0; i < c.count; ++i)
    add_term(motion, a, b,
             {pair.obstacle, pair.robot, c.edge, static_cast<std::uint16_t>((c.first + i) % ring),
              c.owner, 0.0},
             error);
}

// Every choice of one axis for each of a few pairs, together with the pairs that have no choice.
bool JointTest::refute_cases(const Motion& motion, const pdg::PosedRobot& posed,
                             const ConstraintView& list) {
  const auto choices = [&](const Place& place) {
    return std::size_t{list.pairs[place.pair].count};
  };
  std::stable_sort(several_.begin(), several_.end(),
                   [&](const Place& a, const Place& b) { return choices(a) < choices(b); });
  std::size_t cases = 1;
  std::size_t branching = 0;
  while (branching < several_.size() && branching < kBranchingPairs &&
         cases * choices(several_[branching]) <= kCases)
    cases *= choices(several_[branching++]);
  if (branching == 0) return false;
  several_.resize(branching);
  for (const Place& place : several_) {
    const PairHeader& pair = list.pairs[place.pair];
    PairAxes& axes = proof_.pairs.emplace_back(PairAxes{pair.obstacle, pair.robot, {}});
    for (std::size_t k = 0; k < pair.count; ++k) {
      const Constraint& c = list.constraints[place.first + k];
      axes.axes.push_back({c.owner, c.edge});
    }
  }
  const std::size_t fixed = terms_.size();
  for (std::size_t number = 0; number < cases; ++number) {
    terms_.resize(fixed);
    std::size_t rest = number;
    for (const Place& place : several_) {
      const std::size_t axis = rest % choices(place);
      rest /= choices(place);
      add_terms(motion, posed, list.pairs[place.pair], list.constraints[place.first + axis]);
    }
    if (!refute(motion)) return false;
  }
  return true;
}

// Robot edges' second-order terms cancel between them as well: first without any, then with all.
bool JointTest::refute(const Motion& motion) {
  if (terms_.size() < 2) return false;
  const bool turning = std::any_of(terms_.begin(), terms_.end(),
                                   [](const Term& t) { return is_turning(t.turning); });
  for (const bool with_bends : {false, true}) {
    if (!find_weights(motion, with_bends)) return false;  // nor with bends, which only add to it
    if (proves(motion)) {
      note_sum();
      return true;
    }
    if (!turning) return false;
  }
  return false;
}

// The weighted terms as evidence, and the one active axis of each pair that had no choice.
void JointTest::note_sum() {
  JointSum& sum = proof_.sums.emplace_back();
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    if (weights_[k] == 0.0) continue;
    const JointTerm& source = terms_[k].source;
    sum.push_back(source);
    sum.back().weight = weights_[k];
    const bool known =
        std::any_of(proof_.pairs.begin(), proof_.pairs.end(), [&](const PairAxes& pair) {
          return pair.obstacle == source.obstacle && pair.robot == source.robot;
        });
    if (!known)
      proof_.pairs.push_back({source.obstacle, source.robot, {{source.owner, source.edge}}});
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
    term.turning = n;
  }
  terms_.push_back(term);
}

// Minimises  sum lambda_k c_k + |sum lambda_k g_k|_1  over lambda >= 0, sum lambda = 1: by duality
// the largest value that min_k s_k can take in the linearised cell, scaled to [-1, 1]^3. Primal
// simplex on  G lambda = p - q, p, q >= 0  with a 4 x 4 basis inverse, until the value is negative.
bool JointTest::find_weights(const Motion& m, const bool with_bends) {
  const std::size_t count = terms_.size();
  columns_.clear();
  costs_.clear();
  for (const Term& t : terms_) {
    columns_.push_back({dot(t.normal, m.g1), dot(t.normal, m.g2), t.w * m.half_angle, 1.0});
    const double curvature = t.v < 0.0 ? -t.v * (1.0 - m.cos_half) : 0.0;
    const double bend = with_bends && is_turning(t.turning) ? unit_bend(m) : 0.0;
    costs_.push_back(t.value + t.v + curvature + bend + t.error);
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
    sum.turning = sum.turning + weight * t.turning;
    total += weight;
    largest = std::max(largest, t.error);
  }
  const double extent = std::abs(dot(sum.normal, m.g1)) + std::abs(dot(sum.normal, m.g2));
  // |(R(delta) - 1) sum of M_k . e|: what cancels between the robot's edges stays cancelled.
  const double bend = pdg::norm(sum.turning) * unit_bend(m);
  const double bound = pdg::sinusoid_range(sum.v, sum.w, m).hi + sum.value + bend + extent;
  return bound < -pdg::kJointErrorFactor * largest * total;
}

}  // namespace planner
