// Physical groups of a mesh, for Gmsh's format.
// Not installed.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/io/formats.h"
#include "geometry/io/msh_volumes.h"

namespace af2::geometry {

struct PhysicalGroup {
  static constexpr std::int32_t kCurve = 1, kSurface = 2, kVolume = 3;
  std::int32_t dimension = kSurface, number = 0;
  auto operator<=>(const PhysicalGroup&) const = default;
};

/// Groups of surfaces: each face has a group of its own, with its number; the groups of the model
/// follow. Groups of curves: each boundary has a group, with its number if that is positive; then
/// each edge with lines that is in no boundary has one of its own. Groups of volumes: each volume
/// has one of its own, with its number.
class MshGroups {
 public:
  /// `mesh` must live as long as this.
  MshGroups(const ModelMesh& mesh, Lines lines, const std::vector<MshVolume>& volumes);

  /// The names are unique and need no escapes between quotation marks.
  const std::map<PhysicalGroup, std::string>& names() const { return names_; }
  /// Numbers of the groups of a face, its own first.
  std::vector<std::int32_t> ofFace(std::int32_t face) const;
  std::int32_t of(const LineElement& line) const;

 private:
  void nameThoseOfFaces();
  void nameThoseOfEdges(Lines lines);
  std::string unique(std::string name, const std::string& what);
  std::int32_t groupOf(const EdgeGroup& boundary) const;
  std::int32_t groupOfEdge(int edge) const;

  const ModelMesh& mesh_;
  std::int32_t highestFace_ = 0, highestBoundary_ = 0;
  std::map<PhysicalGroup, std::string> names_;
  std::set<std::string> taken_;
};

}  // namespace af2::geometry
