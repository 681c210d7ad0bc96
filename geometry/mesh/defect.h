// Something in a model that is wrong or awkward.
#pragma once

#include <string>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

enum class DefectKind {
  TinyEdge,         ///< shorter than a tenth of the mesh size
  Sliver,           ///< a face narrower than a tenth of the mesh size
  Gap,              ///< an edge ends beside its vertex
  OpenLoop,         ///< a loop of a face that does not close
  TouchingLoop,     ///< a loop that comes to a vertex more than once
  FreeEdge,         ///< has one face only
  NonManifoldEdge,  ///< has more than two
  TurnedFaces,      ///< two faces at an edge look to different sides
  EdgeOnEdge,       ///< edges that a mesh of this size takes for one
  FaceOnFace,       ///< a face that is there twice, or lies on another one
  NoCurve,          ///< an edge without a curve in space
  NoSurface,        ///< a face without a surface, or without any edge
  Invalid,          ///< something else that OpenCASCADE's checks find
};

/// "tiny edge", "sliver", ...
AF2_EXPORT const char* toString(DefectKind kind);

struct Defect {
  DefectKind kind = DefectKind::Invalid;
  int face = 0, edge = 0, vertex = 0;  ///< where; 0: none
  /// Length of an edge, width of a sliver or a gap, how far it is from where a loop ends to where
  /// it may go on; in the unit of the model. 0: has no size.
  double extent = 0;
  Point3 place;
  std::string detail;  ///< may be empty
};

}  // namespace af2::geometry
