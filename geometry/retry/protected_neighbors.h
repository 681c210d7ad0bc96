// A remedy: what one face asks for must not spoil those beside it. Where curves touch at an angle
// of zero, the element there is the worse the shorter it is. Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// Which faces were bad before any remedy: these are not protected.
void rememberBadFaces(Retrial& retrial, const FaceMeshes& state);
/// Whether a face that was good is bad now.
bool isSpoiledNeighbor(const Retrial& retrial, const FaceMeshes& next, std::size_t face);
/// Takes back what was asked for it or a face beside it, or softens it if the face that it was
/// meant for cannot do without. Those that asked are given up.
std::optional<std::size_t> protectNeighbor(Retrial& retrial, FaceMeshes& next, std::size_t face);

}  // namespace af2::geometry
