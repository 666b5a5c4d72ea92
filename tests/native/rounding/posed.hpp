// A piece turned the way the core turns it, and the bounds that the documents state: as numbers of
// their own, so that errors are held against them also where the core is built without margins.
#pragma once

#include <vector>

#include "pdg/native/separation/separation.hpp"

namespace rounding {

inline constexpr double kSeparationUnits = 64.0;
inline constexpr double kAngleUnits = 8.0;

struct Posed {
  Posed(const pdg::ConvexPiece& a, const pdg::Rotation r) : piece(a) {
    for (const pdg::Edge& edge : a.edges) {
      vertices.push_back(pdg::rotate(r, edge.vertex));
      normals.push_back(pdg::rotate(r, edge.normal));
    }
    inner = pdg::rotate(r, a.inner_centre);
  }
  [[nodiscard]] pdg::PosedPiece view() const { return {&piece, vertices, normals, inner}; }

  const pdg::ConvexPiece& piece;
  std::vector<pdg::Vec2> vertices, normals;
  pdg::Vec2 inner;
};

}  // namespace rounding
