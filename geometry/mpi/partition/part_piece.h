// What a process needs to make its part of a mesh, face by face.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mpi/partition/owned_part.h"

namespace af2::mpi {

/// A vertex of a mesh. The number counts from 0 among those of its owner.
struct PieceVertex {
  Point3 position;
  std::uint64_t number = 0;
  std::uint32_t id = 0;
  std::int32_t owner = 0;
};

/// An element. Corners and middles of sides are ids; the number counts among those of its owner.
struct PieceElement {
  std::uint64_t id = 0, number = 0;
  std::array<VertexId, 4> corners, midsides;  ///< no midsides: of first order
  std::int32_t owner = 0;
};

/// Elements of one face that a part owns or has as ghosts, and their vertices.
struct PartPiece {
  std::int32_t face = 0;
  std::vector<PieceVertex> vertices;   ///< ascending, each once in a piece
  std::vector<PieceElement> elements;  ///< ascending
  /// By own element: to how many others it is a ghost; and to which, one after the other.
  std::vector<std::int32_t> ghostCounts, ghostsOf;
};

/// What is known when all pieces have been made.
struct PartEnd {
  std::vector<std::uint64_t> vertices, elements;  ///< by part: how many it owns
  std::uint64_t allLines = 0;
  std::vector<OwnedLine> lines;  ///< of this part; vertices are ids
  PartLabels labels;
};

}  // namespace af2::mpi
