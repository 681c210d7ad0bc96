// Where a mesh turned out to need shorter edges than the sizes asked for, and a new try with them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/graded_size.h"
#include "geometry/occ/edge_division.h"
#include "geometry/occ/mesh_model.h"

namespace af2::geometry {

/// Sizes that are asked for, limited further around some places.
class Refinement {
 public:
  explicit Refinement(const ModelMeshingOptions& asked) : asked_(asked), options_(asked) {}

  /// Sizes below a ten-thousandth of what was asked for are raised to that.
  void add(const std::vector<SizeSource>& places);
  const ModelMeshingOptions& options() const { return options_; }

 private:
  const ModelMeshingOptions& asked_;
  ModelMeshingOptions options_;
  std::vector<SizeSource> sources_;
};

/// What changed from one division of the same edges to the next.
struct DivisionChange {
  std::vector<bool> isChanged;  ///< by edge; [0] is edge 1
  std::vector<std::uint32_t>
      newIndex;  ///< by point of the old division; only for edges that stayed
};

DivisionChange compare(const DividedEdges& before, const DividedEdges& after);

}  // namespace af2::geometry
