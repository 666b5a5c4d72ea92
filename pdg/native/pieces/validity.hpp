// Whether a polygon is one: valid as a simple feature (OGC 06-103r4, 6.1.11), decided exactly.
#pragma once

#include <optional>

#include "pdg/native/geometry/polygon.hpp"

namespace pdg {

struct Defect {
  const char* what;
  Vec2 where;  // rounded, for messages
};

// The first thing that is wrong with a polygon, if any: a ring that meets itself, edges of
// different rings that cross or overlap, a hole outside the outer ring or within another hole, an
// interior in several parts. Rings may touch each other in single points. Rings have three vertices
// or more, and consecutive ones differ. True of the exact doubles given. Throws
// std::invalid_argument where it would take minutes.
std::optional<Defect> find_defect(const Polygon& polygon);

}  // namespace pdg
