// A remedy: withdraws requests of a face that degrade its neighbours. Where curves touch at an
// angle of zero, shorter elements are worse. Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// Records which faces were bad before any remedy: these are not protected.
void rememberBadFaces(Retrial& retrial, const FaceMeshes& state);
/// Whether a face that was good is bad now.
bool isSpoiledNeighbor(const Retrial& retrial, const FaceMeshes& next, std::size_t face);
/// Withdraws the requests for this face or a neighbour, or softens them if the face that made them
/// needs them. Faces whose requests are withdrawn are given up.
std::optional<std::size_t> protectNeighbor(Retrial& retrial, FaceMeshes& next, std::size_t face);

}  // namespace af2::geometry
