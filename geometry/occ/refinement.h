// Where a mesh turned out to need shorter edges than the sizes asked for, and a new try with them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/graded_size.h"
#include "geometry/occ/edge_division.h"
#include "geometry/occ/mesh_model.h"

namespace af2::geometry {

/// Sizes that are asked for, limited further around some places; or edges left out.
class Refinement {
 public:
  explicit Refinement(const ModelMeshingOptions& asked) : asked_(&asked) {}

  /// For the sake of one of the faces. Sizes below a ten-thousandth of what was asked for are
  /// raised to that.
  void add(std::size_t face, const std::vector<SizeSource>& places);
  /// Takes back what was added last for a face.
  void dropLast(std::size_t face);
  /// Takes back all that was added for a face.
  void dropPlaces(std::size_t face) { places_.erase(face); }
  /// The same, and none of its edges is taken for a point. Returns whether there was anything.
  bool dropAll(std::size_t face);
  /// Whether anything was added for a face.
  bool has(std::size_t face) const { return places_.contains(face); }
  /// Asks for sizes some times as large as were added for a face.
  void soften(std::size_t face, double factor);
  /// Takes edges for points for the sake of a face.
  void takeForPoints(std::size_t face, const EdgesAsPoints& edges) { asPoints_[face] = edges; }

  ModelMeshingOptions options() const;
  EdgesAsPoints edgesAsPoints() const;

 private:
  const ModelMeshingOptions* asked_;
  std::map<std::size_t, std::vector<std::vector<SizeSource>>> places_;  ///< by face, in rounds
  std::map<std::size_t, EdgesAsPoints> asPoints_;                       ///< by face
};

/// What changed from one division of the same edges to the next.
struct DivisionChange {
  std::vector<bool> isChanged;  ///< by edge; [0] is edge 1
  std::vector<std::uint32_t>
      newIndex;  ///< by point of the old division; only for edges that stayed
};

DivisionChange compare(const DividedEdges& before, const DividedEdges& after);

}  // namespace af2::geometry
