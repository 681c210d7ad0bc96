// Edges that faces lack: where a loop ends at one vertex and begins at another.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace af2::geometry {

/// A face that was given the edges that it lacked.
struct ClosedFace {
  TopoDS_Shape before, after;
  struct Addition {
    TopoDS_Edge edge;
    bool isNew = true;  ///< else the only other face of the edge had it already
  };
  std::vector<Addition> added;
};

/// Closes each wire that ends at one vertex only and begins at one only: with the edge of another
/// face that joins the two, if that has no other face and lies on this one; else with a new one
/// that is straight in the parameters of the surface, and straight in space on a plane. Faces that
/// lack the same edge share it. Faces that would have no area are left out.
///
/// tolerance  how far from a face an edge may lie to belong to it
std::vector<ClosedFace> closeOpenLoops(const TopoDS_Shape& shape, double tolerance);

}  // namespace af2::geometry
