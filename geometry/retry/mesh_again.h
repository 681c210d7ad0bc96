// One round of retries: divides the edges as remedies request, and meshes the affected faces again.
// Not installed.
#pragma once

#include <vector>

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// Meshes, and what was asked of the edges for them.
struct RetryState {
  FaceMeshes meshes;
  Refinement requests;
};

/// A state in the making: the faces that ask for something are meshed, so that they can ask for
/// more or give up. All others wait, because most of them are affected by each change of the edges.
struct Draft {
  FaceMeshes meshes;
  RequestedSizes sizes;
};

/// Divides the edges as remedies request, and meshes the given faces and those of the draft within
/// them. A face of which the base has the mesh that would result waits instead.
///
/// base   the state before the draft
/// draft  null: the base is the last state
/// faces  in ascending order
Draft drafted(Retrial& retrial, const RetryState& base, const Draft* draft,
              const std::vector<std::size_t>& faces);

/// Whether a draft, if it were completed, would be the base: all that was tried has been withdrawn.
/// The base then takes over what its history tells of that.
bool changesNothing(Retrial& retrial, const Draft& draft, FaceMeshes& base);
/// Meshes the faces of a draft that wait; those at unchanged edges are taken from the base. The
/// history of each face is kept.
FaceMeshes completed(Retrial& retrial, const FaceMeshes& base, Draft draft);
/// Meshes the faces that wait for their first mesh.
void meshWaiting(const Retrial& retrial, FaceMeshes& state);

/// Joins the meshes, and applies the remedies for joined meshes.
void joinWithRemedies(const Retrial& retrial, FaceMeshes& state);

}  // namespace af2::geometry
