// Measures a mesh: shapes, angles, lengths, irregular vertices, how it meets its boundaries, and
// whether it is sound. docs/quality.md has the formulas.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/quality/distribution.h"

namespace af2::geometry {

struct MeasureOptions {
  double size = 0;  ///< wanted edge length; 0: ModelMesh::wantedSizes, or the median length
  /// Edges at which the surface turns by more than this angle are boundaries, in addition to those
  /// of faces and of ModelMesh::segments. 180: no others.
  double featureDegrees = 180;
};

/// What edge lengths are divided by.
enum class LengthReference { GivenSize, WantedSizes, MedianLength };

/// Vertices, and those of them that are irregular.
struct VertexCount {
  std::size_t all = 0, irregular = 0;
  bool operator==(const VertexCount&) const = default;
};

/// A vertex is irregular if its elements do not fill the angle there: each quadrilateral counts 90
/// degrees and each triangle 60, and a vertex inside a face has 360. The sum may differ by half of
/// the smallest of its elements, so that a vertex inside a face is regular with four quadrilaterals
/// or with six triangles. A vertex on a boundary is irregular if the elements between two of its
/// boundary edges do not fill the angle between them; a single element fills every smaller angle.
struct IrregularVertices {
  static constexpr std::size_t kRings = 5;

  VertexCount inner;     ///< inside faces
  VertexCount boundary;  ///< on boundaries
  /// By the number of edges to the nearest boundary: 0, 1, 2, 3; [4]: more, or there is no
  /// boundary.
  std::array<VertexCount, kRings> rings{};
  /// The least number of irregular vertices inside faces that the corners and the Euler numbers of
  /// the faces allow, if each of them has one element too many or one too few.
  std::size_t least = 0;

  std::size_t irregular() const { return inner.irregular + boundary.irregular; }
};

/// Fronts that advance row by row from all boundaries meet at the vertices from which no edge leads
/// farther away from the boundaries. The elements at these vertices, and all others.
struct MeetingFronts {
  Distribution jacobian, jacobianElsewhere;   ///< of elements
  VertexCount irregular, irregularElsewhere;  ///< inside faces: where fronts meet, and the others
};

/// How a mesh hangs together.
struct MeshShape {
  std::size_t edges = 0;
  std::size_t freeEdges = 0;         ///< of one element
  std::size_t nonManifoldEdges = 0;  ///< of more than two elements
  std::size_t turnedEdges = 0;       ///< between elements of opposite orientation
  std::size_t foldedEdges = 0;       ///< inside a face, with normals more than 90 degrees apart
  std::size_t components = 0;        ///< pieces that no edge joins
  std::size_t faces = 0;             ///< faces of the model that have elements
  std::size_t regions = 0;           ///< parts that boundaries enclose
  long euler = 0;                    ///< vertices - edges + elements
  bool isClosed() const { return edges > 0 && freeEdges == 0; }
};

struct MeshMeasures {
  std::size_t vertices = 0;  ///< that are corners of elements
  std::size_t triangles = 0, quads = 0;
  std::size_t inverted = 0;  ///< elements with a scaled Jacobian of 0 or less
  /// Of triangles and of quadrilaterals. In a planar mesh, elements of the wrong orientation have a
  /// negative scaled Jacobian.
  Distribution triangleJacobian, quadJacobian;
  Distribution jacobian;                    ///< of all elements
  Distribution triangleAngles, quadAngles;  ///< of all corners, in degrees
  Distribution quality;                     ///< as shapeQuality gives it
  Distribution aspect;
  LengthReference lengthUnit = LengthReference::MedianLength;
  double medianLength = 0;  ///< of edges
  Distribution lengths;     ///< of edges, divided by lengthUnit
  IrregularVertices irregular;
  MeetingFronts meeting;
  Distribution spokes;  ///< deviations in degrees, between the edges that leave smooth
                        ///< boundaries inward and the directions of a regular mesh
  MeshShape shape;

  std::size_t elements() const { return triangles + quads; }
  double quadShare() const {
    return elements() > 0 ? static_cast<double>(quads) / static_cast<double>(elements()) : 0;
  }
};

/// All zero for a mesh without elements. For elements of second order, only the corners count.
AF2_EXPORT MeshMeasures measureMesh(const ModelMesh& mesh, const MeasureOptions& options = {});

/// The ends of all edges that measureMesh takes for boundaries, the lower vertex first.
AF2_EXPORT std::vector<std::pair<VertexId, VertexId>> boundaryEdges(
    const ModelMesh& mesh, const MeasureOptions& options = {});

}  // namespace af2::geometry
