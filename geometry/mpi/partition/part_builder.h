// Makes the part of a process from its pieces.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mpi/partition/owned_part.h"
#include "geometry/mpi/partition/part_piece.h"

namespace af2::mpi {

class PartBuilder {
 public:
  explicit PartBuilder(int part) : process_(part) {}

  /// Pieces come in the order of their elements.
  void take(const PartPiece& piece);
  OwnedPart finish(PartEnd end);

 private:
  /// Vertices are ids, and numbers count among the elements of their owner, until all is known.
  struct Elements {
    std::vector<Element> corners;
    std::vector<std::array<VertexId, 4>> midsides;
    std::vector<std::uint64_t> ids, numbers;
    std::vector<std::int32_t> owners, faces;
  };

  std::int32_t process_;
  Elements own_, ghosts_;
  std::vector<PieceVertex> vertices_;
  std::vector<std::size_t> ghostsBegin_{0};
  std::vector<std::int32_t> ghostsOf_;
};

}  // namespace af2::mpi
