// A defect of a model: a fault, or a detail that is difficult to mesh.
#pragma once

#include <string>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

enum class DefectKind {
  TinyEdge,         ///< shorter than a tenth of the mesh size
  Sliver,           ///< a face narrower than a tenth of the mesh size
  Gap,              ///< an edge does not end at its vertex
  OpenLoop,         ///< a loop of a face that does not close
  TouchingLoop,     ///< a loop that visits a vertex more than once
  FreeEdge,         ///< an edge with only one face
  NonManifoldEdge,  ///< an edge with more than two faces
  TurnedFaces,      ///< two faces at an edge with opposite orientations
  EdgeOnEdge,       ///< edges that a mesh of this size merges
  FaceOnFace,       ///< a face that occurs twice, or overlaps another one
  NoCurve,          ///< an edge without a curve in space
  NoSurface,        ///< a face without a surface, or without any edge
  Invalid,          ///< any other finding of OpenCASCADE's checks
};

/// "tiny edge", "sliver", ...
AF2_EXPORT const char* toString(DefectKind kind);

struct Defect {
  DefectKind kind = DefectKind::Invalid;
  int face = 0, edge = 0, vertex = 0;  ///< where; 0: none
  /// Length of an edge, width of a sliver or a gap, or distance from the end of a loop to where it
  /// may continue; in the unit of the model. 0: it has no size.
  double extent = 0;
  Point3 place;
  std::string detail;  ///< may be empty
};

}  // namespace af2::geometry
