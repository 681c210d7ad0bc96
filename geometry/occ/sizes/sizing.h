// Limits of sizes by curvature, and what faces want inside, known outside them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <stop_token>

#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// The same sizes, but what they want by position, and on the faces by curvature and function, is
/// one function: it grows from wherever it is small, through space, by no more than sizes.growth.
///
/// uneven  faces on which what curvature wants is spread in any case
CadSizes spreadSizes(const ModelShape& model, CadSizes sizes, const std::vector<int>& uneven,
                     int threads, const std::stop_token& stop);

/// The large faces on which sizes by curvature change by much from one element to the next, so that
/// a front could not follow them, in order. None if all faces are spread anyway.
std::vector<int> unevenFaces(const ModelShape& model, const CadSizes& sizes, int threads,
                             const std::stop_token& stop);

/// What curvature and function want inside a face where they want less than its size. Nothing if
/// the face cannot be sampled.
std::vector<SizeSource> sizesInside(const ModelShape& model, int face, const CadSizes& sizes);

/// What curvature does to a size on a face.
struct CurvedSize {
  double limit;  ///< the size, or less where an edge of an element would turn by more than faceTurn
  double share;  ///< of it that elements aim at: 1 where the face is as good as flat, elsewhere
                 ///< sizes.curvedShare
};
CurvedSize curvedSizeAt(const CadSizes& sizes, int face, double size, const FaceSurface& surface,
                        const SurfacePoint& point);

/// The limit alone.
double limitByCurvature(const CadSizes& sizes, int face, double size, const FaceSurface& surface,
                        const SurfacePoint& point);

/// About how many triangles a face will have: its area over theirs, at the sizes that the options
/// and curvature ask for.
///
/// samples  if given, what is wanted by position counts, too, at so many places along each
/// parameter
double expectedElements(const CadSizes& sizes, int face, const FaceSurface& surface, double area,
                        int samples = 0);

}  // namespace af2::geometry
