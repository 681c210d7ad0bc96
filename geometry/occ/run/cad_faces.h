// A CAD model as a source of faces.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/layers/layer_heights.h"
#include "geometry/layers/layers_of_face.h"
#include "geometry/meshing/face_source.h"
#include "geometry/occ/edges/edge_division.h"
#include "geometry/occ/edges/merged_edges.h"
#include "geometry/occ/faces/faces_on_faces.h"
#include "geometry/occ/model/model.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/sizes/cad_sizes.h"
#include "geometry/sizes/finer_inside.h"

namespace af2::geometry {

class CadFaces : public FaceSource {
 public:
  /// model  kept as a reference
  CadFaces(const Model& model, const TurnLimits& turns) : model_(model), turns_(turns) {}

  int faceCount() const override { return model_.faceCount(); }
  int edgeCount() const override { return model_.edgeCount(); }
  double diagonal() const override { return model_.diagonal(); }
  const std::vector<FaceGroup>& groups() const override { return model_.groups(); }
  FaceReport reportOf(int face) const override;
  void prepare(const MeshingOptions& options, const std::vector<int>& faces) override;
  double workOn(int face) const override { return work_[indexOf(face)]; }
  const PositionSize& sizesByPosition() const override { return sizes_.function; }
  std::vector<int> edgesOf(int face) const override;
  std::vector<int> edgeIdsOf(int face) const override;
  Point3 pointOnEdge(int edge, double parameter) const override;
  std::unique_ptr<FaceDistance> distanceFrom(int face) const override;
  DividedEdges divide(const PositionSize& sizes, const CollapsedEdges& asPoints,
                      const SegmentChanges& changes) const override;
  std::vector<CountedLoop> loopsOf(int face, const DividedEdges& divided) const override;
  void fill(int face, const FillRequest& request, FaceMesh& mesh) const override;
  bool hasOutlines() const override { return true; }
  std::optional<FaceOutline> outlineOf(int face, const FillRequest& request) const override;
  std::vector<CollapsedEdges> shortEdges(int face, const DividedEdges& divided,
                                         const std::vector<SizeSource>& places) const override;
  /// With elements for turns, these sizes are spread already.
  std::vector<SizeSource> sizesInside(int face) const override;
  bool hasFaultInModel(int face) const override;
  bool meetsOthers(int face, const std::vector<Crossing>& crossings) const override;
  void complete(const MeshFaults& faults, ModelMesh& mesh) const override;

 protected:
  static std::size_t indexOf(int face) { return static_cast<std::size_t>(face) - 1; }
  /// Which edges meshes do not follow from now on, or divide as one.
  void merge(MergedEdges edges) {
    merged_ = std::move(edges);
    strips_ = {};
  }
  const MergedEdges& merged() const { return merged_; }
  /// From the next call of `prepare` on, the sizes inside these faces are known outside them.
  void spreadSizesOf(std::vector<int> faces) { spread_ = std::move(faces); }

  const MeshingOptions& options() const { return *options_; }
  const std::vector<int>& faces() const { return faces_; }
  const CadSizes& sizes() const { return sizes_; }
  const ModelShape& shape() const { return *shape_; }
  std::shared_ptr<const ModelShape> sharedShape() const { return shape_; }
  const std::vector<FaceOnFace>& lyingFaces() const { return onFaces_; }
  double areaOfFace(int face) const { return areas_[indexOf(face)]; }
  const std::vector<EdgeSamples>& sampledEdges() const { return sampled_.byFaces; }
  const FinerInside& finerInside() const { return finer_; }
  CadSizes withFunction(const PositionSize& function) const;

 private:
  double farthestVertex() const;
  void noteVolume(ModelMesh& mesh) const;
  void findFacesOnFaces();
  void findLayers();
  const EdgeLayers* layersOn(int face) const;
  void findAreas();
  double expectedOn(int face, int samples) const;
  void expectByFace();
  void expectMoreOn(const std::vector<int>& uneven);
  void expectByPosition();
  template <class Use>
  auto withContext(int face, const FillRequest& request, const Use& use) const;
  template <class Work>
  void forEachFace(const Work& work) const;

  const Model& model_;
  const TurnLimits turns_;
  const MeshingOptions* options_ = nullptr;
  std::vector<int> faces_;  // that were asked for
  CadSizes sizes_;
  std::shared_ptr<const ModelShape> shape_;  // with edges along its creases
  std::vector<FaceOnFace> onFaces_;
  std::vector<double> areas_, work_;  // by face; 0 of those not asked for
  SampledEdges sampled_;
  mutable KnownStrips strips_;  // changes how long divisions take, not what they are
  MergedEdges merged_;
  std::vector<int> spread_;           // ids: see spreadSizesOf
  std::map<int, EdgeLayers> layers_;  // by face
  LayerEnds layerEnds_;
  FinerInside finer_;  // how small these may be
};

}  // namespace af2::geometry
