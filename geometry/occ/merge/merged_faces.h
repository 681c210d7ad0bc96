// A CAD model as a source of faces, some of which are meshed together.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/occ/merge/merge_plan.h"
#include "geometry/occ/run/cad_faces.h"

namespace af2::geometry {

/// The first face of a quilt gets all elements of it, the others none, until `spread` gives each
/// face its own.
class MergedFaces final : public CadFaces {
 public:
  /// model, request  kept as references
  MergedFaces(const Model& model, const MergeRequest& request, const TurnLimits& turns)
      : CadFaces(model, turns), request_(request) {}

  void prepare(const MeshingOptions& options, const std::vector<int>& faces) override;
  double workOn(int face) const override;
  std::vector<int> edgesOf(int face) const override;
  Point3 pointOnEdge(int edge, double parameter) const override;
  std::unique_ptr<FaceDistance> distanceFrom(int face) const override;
  std::vector<CountedLoop> loopsOf(int face, const DividedEdges& divided) const override;
  void fill(int face, const FillRequest& request, FaceMesh& mesh) const override;
  std::optional<FaceOutline> outlineOf(int face, const FillRequest& request) const override {
    return quiltWith(face) ? std::nullopt : CadFaces::outlineOf(face, request);
  }
  std::vector<CollapsedEdges> shortEdges(int face, const DividedEdges& divided,
                                         const std::vector<SizeSource>& places) const override;
  std::vector<SizeSource> sizesInside(int face) const override;
  /// Less at first, because quilts that fail are cut instead.
  double retryShare() const override { return isBrief_ ? 0.15 : 1; }
  void retryLonger() { isBrief_ = false; }

  /// Cuts the quilts that failed, or have elements that turn away from their faces, or triangles
  /// where there should be quadrilaterals, into parts;
  /// gives up those that are small. Returns whether there were any.
  bool cutFailed(const ModelMesh& mesh);
  /// Gives each face the elements with their middles on it, and the report what was merged.
  void spread(ModelMesh& mesh) const;
  /// What is merged, with the distances of a mesh that is not spread yet.
  Merging merging(const ModelMesh& mesh) const;

 private:
  const Quilt* quiltWith(int face) const;
  bool isFirst(int face, const Quilt& quilt) const { return quilt.parts->faces.front() == face; }
  void shareAims();
  void spreadReports(ModelMesh& mesh) const;
  void spreadSegments(ModelMesh& mesh) const;
  const MergeRequest& request_;
  MeshingOptions options_;
  MergePlan plan_;
  std::vector<int> planned_;            // the faces asked for when the plan was made
  std::map<int, std::string> givenUp_;  // faces, and why
  std::map<int, int> part_;             // by face, of quilts that were cut
  std::vector<EdgeJoint> joints_;
  bool isBrief_ = true;
};

}  // namespace af2::geometry
