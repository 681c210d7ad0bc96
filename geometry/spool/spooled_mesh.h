// The elements of a mesh, and its vertices inside faces, on disk: one face after the other.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/spool/mesh_slice.h"
#include "geometry/spool/spooled_face.h"

namespace af2::geometry {

/// One face of such a mesh.
struct SpooledPart {
  std::int32_t face = 0;  ///< id of the model face
  std::shared_ptr<const StoredFace> bulk;
  /// By vertex of its boundary: the vertex of the mesh.
  std::vector<std::uint32_t> boundary;
  std::shared_ptr<const SpooledFloats> scores = {};  ///< may be null
};

/// The vertices of boundaries, which come first, are in memory elsewhere.
class SpooledMesh {
 public:
  /// shared  number of vertices of boundaries
  /// file    for numbers of elements
  /// scale   factor for the positions of all vertices and for their sizes
  SpooledMesh(std::vector<SpooledPart> parts, std::size_t shared, std::shared_ptr<SpoolFile> file,
              double scale = 1);

  const std::vector<SpooledPart>& parts() const { return parts_; }
  const std::shared_ptr<SpoolFile>& file() const { return file_; }
  std::size_t vertexCount() const { return firstVertex_.back(); }
  std::size_t elementCount() const { return firstElement_.back(); }
  std::size_t quadCount() const;
  /// Ids in the mesh of the first vertex inside a part, and of its first element.
  std::size_t firstVertex(std::size_t part) const { return firstVertex_[part]; }
  std::size_t firstElement(std::size_t part) const { return firstElement_[part]; }
  /// The part that has an element.
  std::size_t partOf(std::size_t element) const;

  /// The vertices of boundaries and their sizes.
  struct Shared {
    std::span<const Point3> vertices;
    std::span<const double> wantedSizes;
  };
  /// Calls `visit` with a slice of one part, which is in memory for so long.
  void visitPart(std::size_t part, const Shared& shared, const SliceVisit& visit) const;
  /// Calls `visit` first with a slice of the vertices of boundaries, then with all parts in turn.
  void visitAll(const Shared& shared, const SliceVisit& visit) const;

 private:
  void readAhead(std::size_t part, std::size_t& ahead) const;

  std::vector<SpooledPart> parts_;
  std::shared_ptr<SpoolFile> file_;
  double scale_;
  std::vector<std::size_t> firstVertex_, firstElement_;  ///< by part, and the end
};

}  // namespace af2::geometry
