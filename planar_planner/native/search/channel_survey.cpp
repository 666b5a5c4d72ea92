#include "channel_survey.hpp"

#include <algorithm>

namespace planner {

// Ways of joins have one configuration mostly; a hash table has a pointer and a bucket for each.
std::size_t ChannelSurvey::bytes() const {
  return places_.capacity() * sizeof(Place) +
         joins_.size() * (sizeof(Join) + sizeof(ScaledConfiguration) + 3 * sizeof(void*));
}

void ChannelSurvey::forget(const CellId cell) {
  if (cell >= places_.size()) return;
  const std::uint32_t version = places_[cell].version + 1;
  places_[cell] = {};
  places_[cell].version = version;
}

const ChannelSurvey::Place& ChannelSurvey::place_of(const CellId cell) {
  if (places_.size() < subdivision_.size()) places_.resize(subdivision_.size());
  Place& place = places_[cell];
  if (place.state != Place::State::kUnknown) return place;
  const Foothold found = ridge_.foothold(cell);
  place.q = found.q;
  if (found.coarse)
    place.state = Place::State::kCoarse;
  else
    place.state = found.clearance > 0.0 ? Place::State::kHeld : Place::State::kNone;
  return place;
}

const ChannelSurvey::Join& ChannelSurvey::join(const CellId from, const CellId to) {
  const Place& a = places_[from];
  const Place& b = places_[to];
  Join& join = joins_[(std::uint64_t{from} << 32U) | to];
  if (join.from == a.version + 1 && join.to == b.version + 1) return join;
  join = {a.version + 1, b.version + 1, false, {}};
  ScaledConfiguration end = b.q;
  if (problem_.rotation) end.theta = nearest_turn(end.theta, a.q.theta);
  join.certified = ridge_.join(a.q, end, {from, to}, join.way);
  return join;
}

bool ChannelSurvey::join_by(const CellId from, const CellId to, const Connector& connector,
                            const Terminator& stop) {
  ridge_.begin(UINT64_MAX, stop);
  const Place& a = places_[from];
  Join join{a.version + 1, places_[to].version + 1, false, {}};
  const double theta =
      problem_.rotation ? nearest_turn(radians_of_turns(connector.turns), a.q.theta) : a.q.theta;
  ScaledConfiguration end = places_[to].q;
  if (problem_.rotation) end.theta = nearest_turn(end.theta, theta);
  const ScaledConfiguration middle =
      scaled(problem_, configuration_of(problem_, {connector.t, theta}));
  join.certified = ridge_.join(a.q, middle, {from, to}, join.way) &&
                   ridge_.join(middle, end, {from, to}, join.way);
  const bool certified = join.certified;
  joins_[(std::uint64_t{from} << 32U) | to] = std::move(join);
  return certified;
}

// Of two cells that are not joined the larger one, if it can be split.
void ChannelSurvey::stick(Survey& out, const CellId a, const CellId b) const {
  const Cell& first = subdivision_.cell(a);
  const Cell& second = subdivision_.cell(b);
  const auto may = [](const Cell& cell) { return cell.label == Label::kMixed; };
  if (first.solid() && second.solid() && a != b) out.apart.emplace_back(a, b);
  if (may(first) && (!may(second) || first.size >= second.size)) out.stuck.push_back(a);
  if (may(second) && (!may(first) || second.size >= first.size)) out.stuck.push_back(b);
}

Survey ChannelSurvey::look(const std::vector<CellId>& channel, const Configuration& start,
                           const Configuration& goal, const Terminator& stop) {
  Survey out;
  ridge_.begin(UINT64_MAX, stop);
  for (const CellId cell : channel) {
    if (stop()) return {};
    const Place& place = place_of(cell);
    if (place.state == Place::State::kCoarse || place.state == Place::State::kNone)
      out.stuck.push_back(cell);
  }
  const auto append = [&](std::vector<ScaledConfiguration>& to,
                          const std::vector<ScaledConfiguration>& more) {
    for (ScaledConfiguration q : more) {
      if (problem_.rotation) q.theta = nearest_turn(q.theta, to.back().theta);
      to.push_back(q);
    }
  };
  const auto held = [&](const CellId cell) { return places_[cell].state == Place::State::kHeld; };
  std::vector<ScaledConfiguration> way{scaled(problem_, start)};
  const auto link_end = [&](const ScaledConfiguration& from, const ScaledConfiguration& to,
                            const CellId cell) {
    std::vector<ScaledConfiguration> more;
    ScaledConfiguration end = to;
    if (problem_.rotation) end.theta = nearest_turn(end.theta, from.theta);
    if (ridge_.join(from, end, {cell, cell}, more)) return more;
    stick(out, cell, cell);
    return std::vector<ScaledConfiguration>{};
  };
  bool whole = out.stuck.empty();
  if (held(channel.front())) {
    const auto more = link_end(way.back(), places_[channel.front()].q, channel.front());
    whole = whole && !more.empty();
    if (whole) append(way, more);
  }
  for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
    if (stop()) return {};
    if (!held(channel[i]) || !held(channel[i + 1])) continue;
    const Join& joined = join(channel[i], channel[i + 1]);
    whole = whole && joined.certified;
    if (!joined.certified) stick(out, channel[i], channel[i + 1]);
    if (whole) append(way, joined.way);
  }
  if (held(channel.back())) {
    const ScaledConfiguration end = scaled(problem_, goal);
    ScaledConfiguration from = places_[channel.back()].q;
    if (whole) from = way.back();
    const auto more = link_end(from, end, channel.back());
    whole = whole && !more.empty();
    if (whole) append(way, more);
  }
  if (!whole) return out;
  out.path.push_back(start);
  for (std::size_t i = 1; i < way.size(); ++i)
    out.path.push_back(configuration_of(problem_, way[i]));
  out.path.back() = {goal.x, goal.y, way.back().theta};
  if (!problem_.rotation) out.path.back().theta = start.theta;
  return out;
}

}  // namespace planner
