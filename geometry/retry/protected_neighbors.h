// A remedy: withdraws requests of a face that degrade its neighbours. Where curves touch at an
// angle of zero, shorter elements are worse. Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// Whether a face failed or has an element that is hardly usable.
bool isBad(const FaceMesh& mesh);
/// Records whether a face was bad before any remedy: then it is not protected.
void rememberBadFace(Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// Whether a face that was good is bad now.
bool isSpoiledNeighbor(const Retrial& retrial, const FaceMeshes& next, std::size_t face);
/// Withdraws the requests for this face or a neighbour, or softens them if the face that made them
/// needs them. Faces whose requests are withdrawn are given up.
std::optional<std::size_t> protectNeighbor(Retrial& retrial, FaceMeshes& next, std::size_t face);

}  // namespace af2::geometry
