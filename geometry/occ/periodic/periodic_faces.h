// Meshes of CAD models in which faces are images of others.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "geometry/occ/merge/merge_request.h"
#include "geometry/occ/run/mesh_model.h"

namespace af2::geometry {

/// Which faces are to be periodic.
struct PeriodicRequest {
  /// "x", "y", "z": the plane faces at the low side of the model's box are mapped to those at its
  /// high side.
  std::vector<std::string> directions;
  std::vector<std::pair<int, int>> pairs;  ///< ids: the first face is mapped to the second

  bool isAsked() const { return !directions.empty() || !pairs.empty(); }
};

/// Finds the map of each pair: a translation or, between plane faces, a rotation around the line in
/// which their planes meet.
///
/// Throws InputError, with the names of the faces and the reason, if a face is not the image of the
/// other, and for directions without such faces.
AF2_EXPORT std::vector<PeriodicPair> findPeriodic(const Model& model,
                                                  const PeriodicRequest& request);

/// As meshModel. The mesh of the second face of each pair is the image of that of the first one, to
/// the last bits of the coordinates; ModelMesh::periodic lists the pairs with their vertices.
///
/// merge  other faces are meshed together as by meshMerged; the edges of periodic ones are kept
///
/// Throws InputError also for a choice of faces and for the fewest elements.
AF2_EXPORT ModelMesh meshPeriodic(const Model& model, const AF2Algorithm& algorithm,
                                  const MeshingOptions& options, std::vector<PeriodicPair> pairs,
                                  const std::optional<MergeRequest>& merge = {});

}  // namespace af2::geometry
