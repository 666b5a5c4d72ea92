#include "joint.hpp"

#include <algorithm>
#include <cmath>

#include "pdg/native/separation/separation.hpp"

namespace planner {

using pdg::Constraint;
using pdg::ConvexPiece;
using pdg::EdgeOwner;
using pdg::Motion;
using pdg::PosedPiece;

namespace {

// Choices are tried for at most so many pairs, and at most so many in all. More prove hardly more
// cells (docs/method.md) and cost time on those that they do not prove.
constexpr std::size_t kBranchingPairs = 2;
constexpr std::size_t kCases = 9;

// Bound of |(R(delta) M - M) . e| for |M| = 1: 2 sin(h / 2) |e| <= h (|g1| + |g2|).
double unit_bend(const Motion& m) {
  return m.half_angle * (m.g1_length + m.g2_length);
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

void JointTest::look_at(const Motion& motion, PosedRobot& posed, const ConstraintView& list) {
  terms_.clear();
  several_.clear();
  std::size_t at = 0;
  for (std::size_t i = 0; i < list.pairs.size(); ++i) {
    const PairHeader& pair = list.pairs[i];
    if (pair.count == 1) add_terms(motion, posed, pair, list.constraints[at]);
    if (pair.count > 1) several_.push_back({i, at});
    at += pair.count;
  }
  fixed_ = terms_.size();
  choose_branches(list);
  ranges_.clear();
  for (const Place& place : several_)
    for (const Constraint& c :
         list.constraints.subspan(place.first, list.pairs[place.pair].count)) {
      const std::size_t before = terms_.size();
      add_terms(motion, posed, list.pairs[place.pair], c);
      ranges_.push_back({before, terms_.size()});
    }
}

// The few pairs with the fewest axes.
void JointTest::choose_branches(const ConstraintView& list) {
  const auto choices = [&](const Place& place) {
    return std::size_t{list.pairs[place.pair].count};
  };
  const std::size_t most = std::min(several_.size(), kBranchingPairs);
  std::partial_sort(several_.begin(), several_.begin() + static_cast<std::ptrdiff_t>(most),
                    several_.end(), [&](const Place& a, const Place& b) {
                      return std::pair{choices(a), a.pair} < std::pair{choices(b), b.pair};
                    });
  cases_ = 1;
  std::size_t branching = 0;
  while (branching < most && cases_ * choices(several_[branching]) <= kCases)
    cases_ *= choices(several_[branching++]);
  several_.resize(branching);
  for (Place& place : several_) place.choices = choices(place);
}

bool JointTest::obstructs(const Motion& motion) {
  noted_.clear();
  ends_.clear();
  program_.clear();
  weighed_.clear();
  weigh(motion, {0, fixed_});
  if (refute(motion)) return true;
  if (several_.empty()) return false;
  // Every choice of one axis for each of a few pairs, together with the pairs that have no choice.
  program_.remember();
  for (std::size_t number = 0; number < cases_; ++number) {
    weighed_.resize(fixed_);
    program_.keep(fixed_);
    program_.recall();
    std::size_t rest = number;
    std::size_t first = 0;
    for (const Place& place : several_) {
      weigh(motion, ranges_[first + rest % place.choices]);
      rest /= place.choices;
      first += place.choices;
    }
    if (!refute(motion)) return false;
  }
  return true;
}

// Makes terms part of the programme.
void JointTest::weigh(const Motion& m, const TermRange range) {
  for (std::size_t k = range.begin; k < range.end; ++k) {
    const Term& t = terms_[k];
    const double curvature = t.v < 0.0 ? -t.v * (1.0 - m.cos_half) : 0.0;
    program_.add({{dot(t.normal, m.g1), dot(t.normal, m.g2), t.w * m.half_angle},
                  t.value + t.v + curvature + t.error});
    weighed_.push_back(k);
  }
}

void JointTest::add_terms(const Motion& motion, PosedRobot& posed, const PairHeader& pair,
                          const Constraint& c) {
  const PosedPiece a = posed.piece(pair.robot);
  const ConvexPiece& b = tree_.piece(pair.obstacle);
  const double error = pdg::separation_error(*a.piece, b, motion);
  const std::size_t ring = c.owner == EdgeOwner::kObstacle ? a.vertices.size() : b.edges.size();
  for (std::size_t i = 0; i < c.count; ++i)
    add_term(motion, a, b,
             {pair.obstacle, pair.robot, c.edge, static_cast<std::uint16_t>((c.first + i) % ring),
              c.owner, 0.0},
             error);
}

// Robot edges' second-order terms cancel between them as well: first without any, then with all.
bool JointTest::refute(const Motion& motion) {
  if (weighed_.size() < 2 || !program_.solve()) return false;  // nor with bends, which only add
  if (proves(motion, program_.weights())) return true;
  // What more functions are added to starts from scratch: these weights would be found again.
  program_.forget();
  const auto turning = [&](const std::size_t k) {
    const Vec2 n = terms_[k].turning;
    return n.x != 0.0 || n.y != 0.0;
  };
  if (std::none_of(weighed_.begin(), weighed_.end(), turning)) return false;
  bent_.clear();
  for (std::size_t i = 0; i < weighed_.size(); ++i) {
    WeightProgram::Function function = program_.function(i);
    if (turning(weighed_[i])) function.constant += unit_bend(motion);
    bent_.add(function);
  }
  return bent_.solve() && proves(motion, bent_.weights());
}

void JointTest::note_sum(const WeightProgram::Weights& weights) {
  for (std::size_t i = 0; i < weights.count; ++i) {
    noted_.push_back(terms_[weighed_[weights.items[i].function]].source);
    noted_.back().weight = weights.items[i].value;
  }
  ends_.push_back(noted_.size());
}

// The pairs with a choice, and the one active axis of each pair that had none.
JointProof JointTest::proof(const ConstraintView& list) const {
  JointProof proof;
  if (ends_.size() > 1)
    for (const Place& place : several_) {
      const PairHeader& pair = list.pairs[place.pair];
      PairAxes& axes = proof.pairs.emplace_back(PairAxes{pair.obstacle, pair.robot, {}});
      for (const Constraint& c : list.constraints.subspan(place.first, pair.count))
        axes.axes.push_back({c.owner, c.edge});
    }
  for (const JointTerm& term : noted_) {
    const bool known =
        std::any_of(proof.pairs.begin(), proof.pairs.end(), [&](const PairAxes& pair) {
          return pair.obstacle == term.obstacle && pair.robot == term.robot;
        });
    if (!known) proof.pairs.push_back({term.obstacle, term.robot, {{term.owner, term.edge}}});
  }
  std::size_t from = 0;
  for (const std::size_t end : ends_) {
    const auto begin = noted_.begin();
    proof.sums.emplace_back(begin + static_cast<std::ptrdiff_t>(from),
                            begin + static_cast<std::ptrdiff_t>(end));
    from = end;
  }
  return proof;
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

// The bound itself, for the weights found, whatever the linear programme's rounding did to them:
// every non-negative set of weights proves what it proves.
bool JointTest::proves(const Motion& m, const WeightProgram::Weights& weights) {
  Term sum{};
  double total = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < weights.count; ++i) {
    const double weight = weights.items[i].value;
    const Term& t = terms_[weighed_[weights.items[i].function]];
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
  if (!(bound < -pdg::kJointErrorFactor * largest * total)) return false;
  note_sum(weights);
  return true;
}

}  // namespace planner
