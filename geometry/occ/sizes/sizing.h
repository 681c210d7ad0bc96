// Limits sizes by curvature, and spreads the sizes wanted inside faces beyond them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <stop_token>

#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// The same sizes, with the limits by position, and those on the faces by curvature and function,
/// combined into one function: it grows through space from wherever it is small, by at most
/// sizes.growth.
///
/// uneven  faces whose limits by curvature are spread in any case
CadSizes spreadSizes(const ModelShape& model, CadSizes sizes, const std::vector<int>& uneven,
                     int threads, const std::stop_token& stop);

/// The large faces, in order, on which sizes by curvature change so much from one element to the
/// next that a front could not follow them. None if all faces are spread anyway.
std::vector<int> unevenFaces(const ModelShape& model, const CadSizes& sizes, int threads,
                             const std::stop_token& stop);

/// The sizes wanted by curvature and function inside a face where they are below its size. Nothing
/// if the face cannot be sampled.
std::vector<SizeSource> sizesInside(const ModelShape& model, int face, const CadSizes& sizes);

/// The effect of curvature on a size on a face.
struct CurvedSize {
  double limit;  ///< the size, or less where an edge of an element would turn by more than faceTurn
  double share;  ///< of it that elements aim at: 1 where the face is as good as flat, elsewhere
                 ///< sizes.curvedShare
  double least;  ///< lower bound of all sizes there: sizes.minSize, or less on a tube that would
                 ///< otherwise have fewer than four elements around it
};
CurvedSize curvedSizeAt(const CadSizes& sizes, int face, double size, const FaceSurface& surface,
                        const SurfacePoint& point);

/// `size`, brought between the bounds of all sizes there.
double bounded(const CadSizes& sizes, const CurvedSize& curved, double size);

/// The approximate number of triangles of a face: its area over theirs, at the sizes from the
/// options and the curvature.
double expectedElements(const CadSizes& sizes, int face, const FaceSurface& surface, double area);
/// The same, where what is wanted by position counts, too.
///
/// where    the range of OpenCASCADE's parameters that the face is in
/// samples  so many places along each parameter; where sizes cannot change much, fewer will do
double expectedByPosition(const CadSizes& sizes, int face, const FaceSurface& surface, double area,
                          const SplineSurface::Box& where, int samples);

}  // namespace af2::geometry
