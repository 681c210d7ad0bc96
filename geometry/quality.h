// How good the elements of a mesh are, in the numbers that a report gives.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/model_mesh.h"

namespace af2::geometry {

/// How near an element is to its ideal shape: 1 is the best, 0 is degenerate.
///
/// Triangles: 4 sqrt(3) area / sum of squared edges. Quadrilaterals: the least over the corners of
/// 2 |p x q| / (p.p + q.q), p and q the edges at the corner; negative where the corner is turned
/// over. A square has 1, a rectangle of 1 : 2 has 0.8, a rhombus the sine of its angle.
double shapeQuality(const std::vector<Point3>& vertices, const Element& element);

/// Mean and percentiles of edge length over wanted length.
struct LengthRatio {
  double mean = 0, p5 = 0, p95 = 0;
};

/// All zero for a mesh without elements.
struct MeshQuality {
  double min = 0, p1 = 0, mean = 0;   ///< of shapeQuality; p1 is the 1st percentile
  double minAngle = 0, maxAngle = 0;  ///< between the edges at a corner, in degrees
  LengthRatio edges;                  ///< each edge of the mesh counts once
};

/// The wanted length of an edge with its middle at `middle`, which belongs to the model face `face`
/// and runs along the model edge `edge` (0: along none). Must be > 0.
using WantedLength = std::function<double(int face, int edge, const Point3& middle)>;

/// An edge that belongs to several faces is held against the smallest of their wanted lengths.
MeshQuality measureQuality(const ModelMesh& mesh, const WantedLength& wanted);

/// The value below which the fraction `part` (0 to 1) of `values` lies, between neighbours by
/// linear interpolation; 0 if there are none. Reorders `values`.
double percentile(std::span<double> values, double part);

}  // namespace af2::geometry
