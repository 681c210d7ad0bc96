// Looks at the corners and areas of the elements of a mesh.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

#include "geometry/check/model_check.h"
#include "geometry/mesh/merged_patches.h"

namespace af2::geometry {

/// No more findings than so many.
class Findings {
 public:
  explicit Findings(std::size_t limit) : limit_(limit) {}

  void add(MeshFinding finding) {
    if (all_.size() < limit_) all_.push_back(std::move(finding));
  }
  /// No findings yet; at most `limit` of them are kept.
  Findings none() const { return Findings(limit_); }
  void take(Findings other) { take(std::move(other.all_)); }
  void take(std::vector<MeshFinding> others) {
    for (MeshFinding& finding : others) add(std::move(finding));
  }
  std::vector<MeshFinding> result() { return std::move(all_); }

 private:
  std::size_t limit_;
  std::vector<MeshFinding> all_;
};

/// The vertex from which on none is on a segment of a mesh.
std::uint32_t firstInside(const ModelMesh& mesh);

class ElementChecker {
 public:
  /// firstInside  from here on no vertex is on a segment
  ElementChecker(const ModelMesh& mesh, std::uint32_t firstInside, Findings& findings)
      : mesh_(mesh), patches_(mesh), findings_(findings), firstInside_(firstInside) {}

  /// On up to `threads` threads (0: as many as the caller's TBB arena has).
  void checkElements(int threads);

  /// The lowest vertex such that no later vertex is on a segment or belongs to elements of two
  /// faces; nothing if the numbering gives no such vertex, or if corners are wrong.
  std::optional<std::uint32_t> firstInside() const;
  /// Elements with right corners, ascending.
  std::vector<std::size_t> sound() const;
  /// All of these elements that have a side between vertices before firstInside().
  const std::vector<std::size_t>& atSegments() const { return atSegments_; }
  /// By face, the area of its elements; of faces meshed together by the first.
  const std::map<int, double>& areas() const { return areas_; }
  /// Whether the elements at each vertex from `first` on enclose it: then the sides that end there
  /// are correct, if the elements belong to one face.
  bool areSurrounded(std::uint32_t first, int threads) const;

 private:
  /// The lowest and the highest of some vertices.
  struct Range {
    std::uint32_t low = 0xffffffffu, high = 0;
  };
  /// Consecutive elements of one face.
  struct Run {
    int face = 0;
    double area = 0;
    Range inside;  ///< of their vertices from firstInside_ on
  };
  /// What some elements are like.
  struct Part {
    Findings findings;
    std::vector<std::size_t> unsound, atSegments;
    std::vector<Run> runs;
  };

  const Point3& position(VertexId v) const { return mesh_.vertices[v.value]; }
  Part checked(std::ranges::iota_view<std::size_t, std::size_t> elements) const;
  void take(Part part);
  void addUnsound(std::size_t i, Part& part) const;
  double checkedArea(std::size_t i, Findings& findings) const;
  void noteInside(std::size_t i, Part& part) const;

  const ModelMesh& mesh_;
  const MergedPatches patches_;
  Findings& findings_;
  std::uint32_t firstInside_;
  std::vector<std::size_t> unsound_;     ///< with wrong corners
  std::vector<std::size_t> atSegments_;  ///< with two corners before firstInside_
  std::vector<Run> runs_;
  std::map<int, double> areas_;
};

/// Compares the areas of the elements of faces with those of the faces.
void checkAreas(const ModelMesh& mesh, std::map<int, double> areas, Findings& findings);

}  // namespace af2::geometry
