// Adds edges that faces lack, where a loop ends at one vertex and begins at another.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace af2::geometry {

/// A face to which its missing edges were added.
struct ClosedFace {
  TopoDS_Shape before, after;
  struct Addition {
    TopoDS_Edge edge;
    bool isNew = true;  ///< false: the edge already had one other face
  };
  std::vector<Addition> added;
};

/// Closes each wire that has exactly one end and one beginning. It uses the edge of another face
/// that joins the two, if that edge belongs to no third face and is on this face; else a new edge
/// that is straight in the parameters of the surface, or straight in space on a plane. Faces that
/// lack the same edge share it. Faces that would have no area are skipped.
///
/// tolerance  maximum distance of an edge from a face to which it belongs
std::vector<ClosedFace> closeOpenLoops(const TopoDS_Shape& shape, double tolerance);

}  // namespace af2::geometry
