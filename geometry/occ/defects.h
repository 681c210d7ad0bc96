// What is wrong or awkward in a model, and how large it is against the size of a mesh.
#pragma once

#include <string>
#include <vector>

#include "geometry/occ/model.h"

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
  NoCurve,          ///< an edge without a curve in space
  NoSurface,        ///< a face without a surface, or without any edge
  Invalid,          ///< something else that OpenCASCADE's checks find
};

/// "tiny edge", "sliver", ...
const char* toString(DefectKind kind);

struct Defect {
  DefectKind kind = DefectKind::Invalid;
  int face = 0, edge = 0, vertex = 0;  ///< where; 0: none
  /// Length of an edge, width of a sliver or a gap, how far it is from where a loop ends to where
  /// it may go on; in the unit of the model. 0: has no size.
  double extent = 0;
  Point3 place;
  std::string detail;  ///< may be empty
};

/// All defects of a model, by kind; tiny edges, slivers, gaps and open loops from the most to the
/// least severe, others in the order of the model. Gaps below a ten-thousandth of the mesh size do
/// not count.
///
/// size  edge length of a mesh, > 0
std::vector<Defect> findDefects(const Model& model, double size);

/// Points along an edge of the model, near enough to each other to draw it; empty if it has no
/// length.
std::vector<Point3> pointsAlong(const Model& model, int edge);
/// The edges around a face, each once.
std::vector<int> edgesAround(const Model& model, int face);

}  // namespace af2::geometry
