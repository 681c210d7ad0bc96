// A model of unit squares, for tests of what is done with faces of any kind.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/meshing/face_source.h"

namespace af2::testing {

using namespace af2::geometry;

/// Unit squares side by side along x, each filled with two triangles. Corners 2 i and 2 i + 1 are
/// at (i, 0) and (i, 1). Divided edges, each a single segment: between these two the one numbered
/// 3 i + 1, from there to the next square 3 i + 2 below and 3 i + 3 above; ids are greater by 100.
class Squares : public FaceSource {
 public:
  explicit Squares(int count) : count_(count) {
    for (int face = 1; face <= count; ++face)
      groups_.push_back({"group " + std::to_string(face), GroupKind::Part, {face}});
  }

  int faceCount() const override { return count_; }
  int edgeCount() const override { return 100 + 3 * count_ + 1; }
  double diagonal() const override { return 10; }
  FaceReport reportOf(int face) const override {
    FaceReport report;
    report.id = face;
    report.name = "square " + std::to_string(face);
    report.surfaceType = "plane";
    report.area = 1;
    return report;
  }
  const std::vector<FaceGroup>& groups() const override { return groups_; }

  void prepare(const MeshingOptions& options, const std::vector<int>& faces) override {
    prepared.push_back(options);
    asked = faces;
  }
  double workOn(int) const override { return 3; }
  const PositionSize& sizesByPosition() const override { return prepared.back().sizes.function; }
  std::vector<int> edgesOf(int face) const override {
    const int first = 3 * (face - 1) + 1;
    return {first, first + 1, first + 2, first + 3};
  }
  int idOfEdge(int divided) const override { return 100 + divided; }
  Point3 pointOnEdge(int divided, double parameter) const override {
    return {static_cast<double>(divided), parameter, 0};
  }

  DividedEdges divide(const PositionSize&, const CollapsedEdges&,
                      const SegmentChanges&) const override {
    DividedEdges divided;
    for (int i = 0; i <= count_; ++i) {
      divided.points.push_back({double(i), 0, 0});
      divided.points.push_back({double(i), 1, 0});
    }
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
      divided.edges.push_back({{0, 1}, {from, to}, {}, "", 1, 0, {}});
    };
    for (std::uint32_t i = 0; i <= static_cast<std::uint32_t>(count_); ++i) {
      add(2 * i, 2 * i + 1);
      if (i == static_cast<std::uint32_t>(count_)) break;
      add(2 * i, 2 * i + 2);
      add(2 * i + 1, 2 * i + 3);
    }
    return divided;
  }

  std::vector<CountedLoop> loopsOf(int, const DividedEdges&) const override { return {}; }

  void fill(int face, const FillRequest& request, FaceMesh& mesh) const override {
    if (request.options.observer) request.options.observer();
    const auto first = static_cast<std::uint32_t>(2 * (face - 1));
    mesh.boundary = {first, first + 2, first + 3, first + 1};
    mesh.wantedSizes.assign(4, prepared.back().sizes.size);
    mesh.elements = {{{VertexId(0), VertexId(1), VertexId(2)}},
                     {{VertexId(0), VertexId(2), VertexId(3)}}};
    mesh.origins.resize(2);
    for (const int edge : edgesOf(face)) mesh.uses.push_back({edge, 0});
    if (request.findMiddles) mesh.middles.resize(2);
    mesh.report.elements = 2;
    if (request.progress) request.progress({2});
  }

  void complete(const MeshFaults&, ModelMesh& mesh) const override {
    mesh.notes.push_back("these are squares");
  }

  std::vector<MeshingOptions> prepared;
  std::vector<int> asked;

 private:
  int count_;
  std::vector<FaceGroup> groups_;
};

}  // namespace af2::testing
