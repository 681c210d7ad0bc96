// Physical groups of a mesh, for Gmsh's format.
// Not installed.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/formats/msh_volumes.h"
#include "geometry/io/formats.h"

namespace af2::geometry {

struct PhysicalGroup {
  static constexpr std::int32_t kCurve = 1, kSurface = 2, kVolume = 3;
  std::int32_t dimension = kSurface, number = 0;
  auto operator<=>(const PhysicalGroup&) const = default;
};

/// Groups of surfaces: each face has a group of its own, with its number, or shares it with the
/// first face of the same name; the groups of the model follow. With FileOptions::groups each face
/// has one of these only. Groups of curves: each boundary has a group, with its number if that is
/// positive; then each edge with lines that is in no boundary has one of its own. Groups of
/// volumes: each volume has one of its own, with its number.
class MshGroups {
 public:
  /// `mesh` must live as long as this.
  MshGroups(const ModelMesh& mesh, const Extras& extras, const std::vector<MshVolume>& volumes);

  /// The names are unique and need no escapes between quotation marks.
  const std::map<PhysicalGroup, std::string>& names() const { return names_; }
  /// Numbers of the groups of a face, its own first if it has one.
  std::vector<std::int32_t> ofFace(std::int32_t face) const;
  /// The name of the first group of a face.
  std::string nameOf(std::int32_t face) const;
  std::int32_t of(const LineElement& line) const;

 private:
  void findThoseOfFaces(std::span<const Grouping> order);
  std::int32_t onlyGroupOf(const FaceReport& face, std::span<const Grouping> order) const;
  void nameThoseOfFaces();
  void nameThoseOfEdges(Lines lines);
  std::string unique(std::string name, const std::string& what);
  std::int32_t groupOf(const EdgeGroup& boundary) const;
  std::int32_t groupOfEdge(int edge) const;

  const ModelMesh& mesh_;
  std::int32_t highestFace_ = 0, highestBoundary_ = 0;
  std::map<std::int32_t, std::vector<std::int32_t>> ofFace_;
  std::map<PhysicalGroup, std::string> names_;
  std::set<std::string> taken_;
};

}  // namespace af2::geometry
