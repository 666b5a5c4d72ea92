#include "joint.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pdg/native/separation/separation.hpp"
#include "planar_planner/native/tolerances.hpp"

namespace planner {

using pdg::Constraint;
using pdg::ConvexPiece;
using pdg::EdgeOwner;
using pdg::Motion;
using pdg::PosedPiece;
using Term = JointTerms::Term;
using Choice = JointTerms::Choice;

namespace {

// Bound of |(R(delta) M - M) . e| for |M| = 1: 2 sin(h / 2) |e| <= h (|g1| + |g2|).
double unit_bend(const Motion& m) {
  return m.half_angle * (m.g1_length + m.g2_length);
}

Term make_term(const Motion& m, const PosedPiece& a, const ConvexPiece& b, const JointTerm& source,
               const double error) {
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
  return term;
}

// One term for each vertex that can be the minimiser.
void add_terms(const ObstacleTree& tree, const Motion& motion, PosedRobot& posed,
               const PairHeader& pair, const Constraint& c, std::vector<Term>& out) {
  const PosedPiece a = posed.piece(pair.robot);
  const ConvexPiece& b = tree.piece(pair.obstacle);
  const double error = pdg::separation_error(*a.piece, b, motion);
  const std::size_t ring = c.owner == EdgeOwner::kObstacle ? a.vertices.size() : b.edges.size();
  for (std::size_t i = 0; i < c.count; ++i)
    out.push_back(make_term(motion, a, b,
                            {pair.obstacle, pair.robot, c.edge,
                             static_cast<std::uint16_t>((c.first + i) % ring), c.owner, 0.0},
                            error));
}

// Keeps the few choices with the fewest axes.
void limit_choices(JointTerms& terms) {
  std::vector<Choice>& choices = terms.choices;
  const std::size_t most = std::min(choices.size(), kBranchingPairs);
  std::partial_sort(choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(most),
                    choices.end(), [](const Choice& a, const Choice& b) {
                      return std::pair{a.axes, a.pair} < std::pair{b.axes, b.pair};
                    });
  terms.cases = 1;
  std::size_t kept = 0;
  while (kept < most && terms.cases * choices[kept].axes <= kMostCases)
    terms.cases *= choices[kept++].axes;
  choices.resize(kept);
}

// Makes terms part of the programme.
void weigh(const JointTerms& terms, const Motion& m, const JointTerms::Range range,
           JointScratch& scratch) {
  for (std::size_t k = range.begin; k < range.end; ++k) {
    const Term& t = terms.terms[k];
    const double curvature = t.v < 0.0 ? -t.v * (1.0 - m.cos_half) : 0.0;
    scratch.program.add({{dot(t.normal, m.g1), dot(t.normal, m.g2), t.w * m.half_angle},
                         t.value + t.v + curvature + t.error});
    scratch.weighed.push_back(k);
  }
}

// Is the weighted sum negative in the whole motion? This is the bound itself, for the weights
// found, whatever the linear programme's rounding did to them: every non-negative set of weights
// proves what it proves.
bool proves(const std::vector<Term>& terms, const Motion& m,
            const WeightProgram::Weights& weights) {
  Term sum{};
  double total = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < weights.count; ++i) {
    const double weight = weights.items[i].value;
    const Term& t = terms[weights.items[i].function];
    sum.normal = sum.normal + weight * t.normal;
    sum.v += weight * t.v;
    sum.w += weight * t.w;
    sum.value += weight * t.value;
    sum.turning = sum.turning + weight * t.turning;
    total += weight;
    largest = std::max(largest, t.error);
  }
  const double extent = extent_along(m, sum.normal);
  // |(R(delta) - 1) sum of M_k . e|: what cancels between the robot's edges stays cancelled.
  const double bend = pdg::norm(sum.turning) * unit_bend(m);
  const double bound = pdg::sinusoid_range(sum.v, sum.w, m).hi + sum.value + bend + extent;
  return bound < -kJointErrorFactor * largest * total;
}

// The programme's weights as weights of the terms that it was made of.
WeightProgram::Weights of_terms(WeightProgram::Weights weights,
                                const std::vector<std::size_t>& weighed) {
  for (std::size_t i = 0; i < weights.count; ++i)
    weights.items[i].function = weighed[weights.items[i].function];
  return weights;
}

// Weights of terms that prove, if the programme finds any. Second-order terms of robot edges cancel
// between them as well: it is solved first without any of them, then with all.
std::optional<WeightProgram::Weights> refute_case(const JointTerms& terms, const Motion& motion,
                                                  JointScratch& scratch) {
  const std::vector<std::size_t>& weighed = scratch.weighed;
  if (weighed.size() < 2) return std::nullopt;
  const auto straight = scratch.program.solve();
  if (!straight) return std::nullopt;  // nor would it be with bends, which only add
  const WeightProgram::Weights weights = of_terms(*straight, weighed);
  if (proves(terms.terms, motion, weights)) return weights;
  // These weights do not prove. More functions are added next; from this basis the programme would
  // find the same weights again, so it starts anew.
  scratch.program.forget();
  const auto turning = [&](const std::size_t k) {
    const Vec2 n = terms.terms[k].turning;
    return n.x != 0.0 || n.y != 0.0;
  };
  if (std::none_of(weighed.begin(), weighed.end(), turning)) return std::nullopt;
  scratch.bent.clear();
  for (std::size_t i = 0; i < weighed.size(); ++i) {
    WeightProgram::Function function = scratch.program.function(i);
    if (turning(weighed[i])) function.constant += unit_bend(motion);
    scratch.bent.add(function);
  }
  const auto bent = scratch.bent.solve();
  if (!bent) return std::nullopt;
  const WeightProgram::Weights bent_weights = of_terms(*bent, weighed);
  return proves(terms.terms, motion, bent_weights) ? std::optional(bent_weights) : std::nullopt;
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

void gather_terms(const ObstacleTree& tree, const Motion& motion, PosedRobot& posed,
                  const ConstraintView& list, JointTerms& out) {
  out.terms.clear();
  out.choices.clear();
  out.ranges.clear();
  std::size_t at = 0;
  for (std::size_t i = 0; i < list.pairs.size(); ++i) {
    const PairHeader& pair = list.pairs[i];
    if (pair.count == 1) add_terms(tree, motion, posed, pair, list.constraints[at], out.terms);
    if (pair.count > 1) out.choices.push_back({i, at, pair.count});
    at += pair.count;
  }
  out.fixed = out.terms.size();
  limit_choices(out);
  for (const Choice& choice : out.choices)
    for (const Constraint& c : list.constraints.subspan(choice.first, choice.axes)) {
      const std::size_t before = out.terms.size();
      add_terms(tree, motion, posed, list.pairs[choice.pair], c, out.terms);
      out.ranges.push_back({before, out.terms.size()});
    }
}

std::optional<Refutation> refute(const JointTerms& terms, const Motion& motion,
                                 JointScratch& scratch) {
  scratch.program.clear();
  scratch.weighed.clear();
  weigh(terms, motion, {0, terms.fixed}, scratch);
  if (const auto weights = refute_case(terms, motion, scratch))
    return Refutation{.sums = {*weights}, .count = 1};
  if (terms.choices.empty()) return std::nullopt;
  std::optional<Refutation> out(std::in_place);
  // Every choice of one axis for each of a few pairs, together with the pairs that have no choice.
  scratch.program.remember();
  for (std::size_t number = 0; number < terms.cases; ++number) {
    scratch.weighed.resize(terms.fixed);
    scratch.program.keep(terms.fixed);
    scratch.program.recall();
    std::size_t rest = number;
    std::size_t first = 0;
    for (const Choice& choice : terms.choices) {
      weigh(terms, motion, terms.ranges[first + rest % choice.axes], scratch);
      rest /= choice.axes;
      first += choice.axes;
    }
    const auto weights = refute_case(terms, motion, scratch);
    if (!weights) return std::nullopt;
    out->sums[out->count++] = *weights;
  }
  return out;
}

// The pairs with a choice, and the one active axis of each pair that had none.
JointProof proof_of(const Refutation& refutation, const JointTerms& terms,
                    const ConstraintView& list) {
  JointProof proof;
  if (refutation.count > 1)
    for (const Choice& choice : terms.choices) {
      const PairHeader& pair = list.pairs[choice.pair];
      PairAxes& axes = proof.pairs.emplace_back(PairAxes{pair.obstacle, pair.robot, {}});
      for (const Constraint& c : list.constraints.subspan(choice.first, pair.count))
        axes.axes.push_back({c.owner, c.edge});
    }
  const auto add_pair_of = [&](const JointTerm& term) {
    const bool known =
        std::any_of(proof.pairs.begin(), proof.pairs.end(), [&](const PairAxes& pair) {
          return pair.obstacle == term.obstacle && pair.robot == term.robot;
        });
    if (!known) proof.pairs.push_back({term.obstacle, term.robot, {{term.owner, term.edge}}});
  };
  for (std::size_t i = 0; i < refutation.count; ++i) {
    const WeightProgram::Weights& weights = refutation.sums[i];
    JointSum& sum = proof.sums.emplace_back();
    sum.reserve(weights.count);
    for (std::size_t k = 0; k < weights.count; ++k) {
      sum.push_back(terms.terms[weights.items[k].function].source);
      sum.back().weight = weights.items[k].value;
      add_pair_of(sum.back());
    }
  }
  return proof;
}

}  // namespace planner
