// Faces whose meshes are told in advance, for tests of remedies.
#pragma once

#include <functional>
#include <vector>

#include "geometry/retry/remedy.h"

namespace af2::testing {

inline geometry::FaceMesh goodFace(int id) {
  geometry::FaceMesh mesh;
  mesh.report.id = id;
  mesh.elements.push_back({{VertexId(0), VertexId(1), VertexId(2), VertexId()}});
  mesh.searchCost = 1000;
  return mesh;
}

inline geometry::FaceMesh failedFace(int id, std::vector<geometry::SizeSource> places = {}) {
  geometry::FaceMesh mesh;
  mesh.report.id = id;
  mesh.report.status = geometry::FaceStatus::Failed;
  mesh.report.reason = "it failed";
  mesh.diagnosis.isBad = true;
  mesh.diagnosis.places = std::move(places);
  mesh.searchCost = 1000;
  return mesh;
}

/// Those of each face.
using Edges = std::vector<std::vector<int>>;

/// Each face is meshed as `meshed` says; edges have no points.
class RetriedFaces : public geometry::RetriedModel {
 public:
  using Meshed = std::function<geometry::FaceMesh(std::size_t, const geometry::TryLimits&)>;

  explicit RetriedFaces(Edges edges, Meshed meshed = {})
      : edges_(std::move(edges)), meshed_(std::move(meshed)) {}

  const std::vector<std::vector<int>>& edgesOfFaces() const override { return edges_; }
  geometry::DividedEdges divide(const geometry::PositionSize&,
                                const geometry::CollapsedEdges&) const override {
    return {};
  }
  std::vector<geometry::CollapsedEdges> shortEdges(
      std::size_t, const geometry::DividedEdges&,
      const std::vector<geometry::SizeSource>&) const override {
    return choices;
  }
  void mesh(std::size_t i, const geometry::PositionSize&, const geometry::TryLimits& limits,
            geometry::FaceMeshes& into) const override {
    into.meshes[i] = meshed_(i, limits);
  }
  void join(geometry::FaceMeshes&) const override {}
  std::vector<geometry::SizeSource> sizesInside(std::size_t) const override { return inside; }
  bool hasFaultInModel(std::size_t) const override { return isFaulty; }

  std::vector<geometry::CollapsedEdges> choices;
  std::vector<geometry::SizeSource> inside;
  bool isFaulty = false;

 private:
  std::vector<std::vector<int>> edges_;
  Meshed meshed_;
};

/// What remedies see of a model before the first round.
struct RetrialOf {
  explicit RetrialOf(const geometry::RetriedModel& model)
      : retrial{model, options, geometry::Refinement({}, geometry::kDefaultGrowth, 1),
                std::vector<geometry::FaceRecord>(model.edgesOfFaces().size()),
                geometry::RetryBudget(1e6)} {}

  geometry::RetryOptions options;
  geometry::Retrial retrial;
};

}  // namespace af2::testing
