#include "geometry/occ/run/cad_faces.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/layers/layer_ends.h"
#include "geometry/mesh/inside_out.h"
#include "geometry/mesh/volume_note.h"
#include "geometry/meshing/check_options.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/edge_division.h"
#include "geometry/occ/edges/short_edges.h"
#include "geometry/occ/faces/face_area.h"
#include "geometry/occ/faces/face_loops.h"
#include "geometry/occ/faces/face_mesher.h"
#include "geometry/occ/faces/faces_on_faces.h"
#include "geometry/occ/faces/fault_reasons.h"
#include "geometry/occ/faces/meeting_faces.h"
#include "geometry/occ/faces/solid_volume.h"
#include "geometry/occ/run/creased_shape.h"
#include "geometry/occ/sizes/face_range.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/face_surface.h"
#include "geometry/occ/surfaces/surface_distance.h"

namespace af2::geometry {

namespace {

std::string textOfLost(const std::vector<std::string>& faces) {
  constexpr std::size_t kMaxNamed = 10;
  std::string text = faces.size() == 1 ? "a face" : std::to_string(faces.size()) + " faces";
  text += " of the file could not be read, so the mesh lacks " +
          std::string(faces.size() == 1 ? "it: " : "them: ");
  for (std::size_t i = 0; i < std::min(faces.size(), kMaxNamed); ++i)
    text += (i > 0 ? ", " : "") + faces[i];
  if (faces.size() > kMaxNamed)
    text += " and " + std::to_string(faces.size() - kMaxNamed) + " more";
  return text + "; export the model again";
}

double areaOfElements(const ModelMesh& mesh) {
  double sum = 0;
  forEachSlice(mesh, [&](const MeshSlice& slice) {
    for (const Element& element : slice.elements) {
      const auto at = [&](std::size_t i) { return slice.position(element.corners[i]); };
      sum += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
      if (element.isQuad()) sum += length(cross(at(2) - at(0), at(3) - at(0))) / 2;
    }
  });
  return sum;
}

}  // namespace

FaceReport CadFaces::reportOf(int face) const {
  FaceReport report;
  report.id = face;
  report.name = model_.faceName(face);
  report.surfaceType = model_.surfaceType(face);
  if (!areas_.empty()) report.area = areas_[indexOf(face)];
  return report;
}

void CadFaces::prepare(const MeshingOptions& options, const std::vector<int>& faces) {
  options_ = &options;
  faces_ = faces;
  sizes_ = CadSizes{options.sizes, turns_, {}};
  finer_ = geometry::finerInside(sizes_);
  refuseBlurred(farthestVertex(), model_.shape().diagonal, sizes_.size);
  shape_ = withCreases(model_.sharedShape(), faces_, sizes_, options.threads, options.stop);
  findFacesOnFaces();
  findAreas();
  expectByFace();
  const std::vector<int> uneven = unevenFaces(*shape_, sizes_, options.threads, options.stop);
  std::vector<int> spread;
  std::ranges::set_union(uneven, spread_, std::back_inserter(spread));
  sizes_ = spreadSizes(*shape_, std::move(sizes_), spread, options.threads, options.stop);
  expectMoreOn(uneven);
  expectByPosition();
  sampled_ = sampleEdges(*shape_, sizes_, options.threads, options.stop);
  strips_ = {};
  findLayers();
}

/// Of the faces to be meshed, with the places at which they end on other edges.
void CadFaces::findLayers() {
  layers_.clear();
  layerEnds_.clear();
  if (options_->layers.empty()) return;
  for (const int face : faces_)
    if (EdgeLayers own = layersOfFace(options_->layers, face, edgesOf(face)); !own.empty())
      layers_[face] = std::move(own);
  const DividedEdges divided = divide(sizesByPosition(), {}, {});
  for (const auto& [face, layers] : layers_)
    addLayerEndsOfFace(*shape_, face, layers, divided, onFaces_, layerEnds_);
  fitLayerEnds(divided, layerEnds_);
}

const EdgeLayers* CadFaces::layersOn(int face) const {
  const auto own = layers_.find(face);
  return own == layers_.end() ? nullptr : &own->second;
}

/// Of the model itself, without those along creases.
std::vector<int> CadFaces::edgeIdsOf(int face) const {
  std::vector<int> ids;
  for (const EdgeUse& use : model_.shape().edgesOfFaces[indexOf(face)]) ids.push_back(use.id);
  std::ranges::sort(ids);
  return ids;
}

std::vector<int> CadFaces::edgesOf(int face) const {
  std::vector<int> edges;
  for (const EdgeUse& use : shape_->edgesOfFaces[indexOf(face)]) edges.push_back(use.id);
  std::ranges::sort(edges);
  edges.erase(std::ranges::unique(edges).begin(), edges.end());
  return edges;
}

Point3 CadFaces::pointOnEdge(int edge, double parameter) const {
  return toPoint(BRepAdaptor_Curve(shape_->edge(edge)).Value(parameter));
}

std::unique_ptr<FaceDistance> CadFaces::distanceFrom(int face) const {
  return distanceFromSurface(shape_->face(face), shape_->surface(face));
}

DividedEdges CadFaces::divide(const PositionSize& sizes, const CollapsedEdges& asPoints,
                              const SegmentChanges& changes) const {
  return divideEdges(*shape_, sampled_, withFunction(sizes), options_->threads, options_->stop,
                     options_->edgePoints, asPoints, changes, merged_, layerEnds_, &strips_);
}

std::vector<CountedLoop> CadFaces::loopsOf(int face, const DividedEdges& divided) const {
  return countedLoops(*shape_, face, divided, onFaces_, fanElementsFor(options_->quads));
}

template <class Use>
auto CadFaces::withContext(int face, const FillRequest& request, const Use& use) const {
  const auto useWith = [&](const CadSizes& sizes) {
    return use({*shape_, sizes, onFaces_, finer_, request, layersOn(face)});
  };
  return request.limits.hasOriginalSizes ? useWith(sizes_) : useWith(withFunction(request.sizes));
}

void CadFaces::fill(int face, const FillRequest& request, FaceMesh& mesh) const {
  withContext(face, request, [&](const FaceMeshingContext& context) {
    meshFace(context, face, areas_[indexOf(face)], work_[indexOf(face)], mesh);
  });
}

std::optional<FaceOutline> CadFaces::outlineOf(int face, const FillRequest& request) const {
  return withContext(face, request, [&](const FaceMeshingContext& context) {
    return geometry::outlineOf(context, face, areas_[indexOf(face)]);
  });
}

std::vector<CollapsedEdges> CadFaces::shortEdges(int face, const DividedEdges& divided,
                                                 const std::vector<SizeSource>& places) const {
  return shortEdgesNear(*shape_, face, divided, places, wantedOnFace(sizes_, face));
}

/// With elements for turns, these sizes are spread already.
std::vector<SizeSource> CadFaces::sizesInside(int face) const {
  if (sizes_.elementsPerTurn > 0) return {};
  return geometry::sizesInside(*shape_, face, sizes_);
}

bool CadFaces::hasFaultInModel(int face) const {
  return !faultOf(*shape_, face, sizes_.size).empty();
}

bool CadFaces::meetsOthers(int face, const std::vector<Crossing>& crossings) const {
  return !meetingOf(*shape_, face, crossings, sizes_.size).empty();
}

void CadFaces::complete(const MeshFaults& faults, ModelMesh& mesh) const {
  mesh.unit = model_.unit();
  mesh.fileUnit = model_.fileUnit();
  mesh.notes = model_.notes();
  mesh.healing = model_.healing();
  mesh.imprinting = model_.imprinting();
  tellOfMeetingFaces(*shape_, faults.crossings, sizes_.size, mesh.faces);
  tellOfFaults(*shape_, sizes_.size, mesh);
  tellOfTurnedEdges(*shape_, mesh.faces);
  const bool areAll = faces_.size() == static_cast<std::size_t>(faceCount());
  if (areAll && !model_.lostFaces().empty())
    mesh.findings.push_back(textOfLost(model_.lostFaces()));
  if (areAll) noteVolume(mesh);
}

/// The largest coordinate of a vertex.
double CadFaces::farthestVertex() const {
  const ModelShape& shape = model_.shape();
  double farthest = 0;
  for (int id = 1; id <= shape.vertices.Extent(); ++id) {
    const Point3 p = toPoint(BRep_Tool::Pnt(shape.vertex(id)));
    farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return farthest;
}

CadSizes CadFaces::withFunction(const PositionSize& function) const {
  CadSizes sizes = sizes_;
  sizes.function = function;
  return sizes;
}

/// The volume of the model takes time, so it is asked for only where the areas differ.
void CadFaces::noteVolume(ModelMesh& mesh) const {
  constexpr double kNear = 0.002;
  const double wanted = std::accumulate(areas_.begin(), areas_.end(), 0.0);
  if (std::abs(areaOfElements(mesh) - wanted) <= kNear * wanted) return;
  std::string note;
  const auto isOff = [&](double enclosed) {
    note = volumeNote(enclosed, volumeOfSolids(model_.shape()).value_or(0), "the model");
    return !note.empty();
  };
  if (enclosedVolumeIf(mesh, isOff)) mesh.notes.push_back(note);
}

/// Keeps only faces that lie on another face which is also meshed.
void CadFaces::findFacesOnFaces() {
  onFaces_ = facesOnFaces(*shape_, options_->threads);
  std::erase_if(onFaces_, [&](const FaceOnFace& lying) {
    return !std::ranges::binary_search(faces_, lying.under);
  });
}

/// Without what other faces cover.
void CadFaces::findAreas() {
  areas_.assign(static_cast<std::size_t>(faceCount()), 0);
  forEachFace([&](int face) {
    if (!options_->stop.stop_requested()) areas_[indexOf(face)] = areaOf(*shape_, face);
  });
  for (const FaceOnFace& lying : onFaces_) {
    if (!lying.isDouble()) areas_[indexOf(lying.under)] -= areaOf(*shape_, lying.face);
    areas_[indexOf(lying.face)] = 0;
  }
}

/// The number of elements of a face; 0 if unknown.
///
/// samples  along each parameter, of what is wanted by position; 0: that does not count
double CadFaces::expectedOn(int face, int samples) const {
  const double area = areas_[indexOf(face)];
  if (!(area > 0) || options_->stop.stop_requested()) return 0;
  try {
    const FaceSurface surface = shape_->surface(face);
    if (samples == 0) return expectedElements(sizes_, face, surface, area);
    return expectedByPosition(sizes_, face, surface, area, rangeOf(shape_->face(face), surface),
                              samples);
  } catch (const GeometryError&) {  // reported when the face is meshed
  } catch (const Standard_Failure&) {
  }
  return 0;
}

void CadFaces::expectByFace() {
  work_.assign(static_cast<std::size_t>(faceCount()), 0);
  forEachFace([&](int face) { work_[indexOf(face)] = 1 + expectedOn(face, 0); });
  refuseTooMany(work_, memoryLimitOf(*options_));
}

/// Once it is known how sizes spread there.
void CadFaces::expectMoreOn(const std::vector<int>& uneven) {
  constexpr int kSamples = 32;
  forEachFace([&](int face) {
    if (std::ranges::binary_search(uneven, face))
      work_[indexOf(face)] = 1 + expectedOn(face, kSamples);
  });
  refuseTooMany(work_, memoryLimitOf(*options_));
}

/// Points, boxes, functions and turns may want small sizes anywhere. A few samples find what turns
/// want as well as what faces want without them; points, boxes and functions may hide.
void CadFaces::expectByPosition() {
  constexpr int kSamples = 8;
  const Sizes& asked = options_->sizes;
  if (!asked.function && asked.sources.isEmpty() && asked.elementsPerTurn == 0) return;
  std::vector<double> elements(work_.size());
  forEachFace([&](int face) {
    elements[indexOf(face)] = expectedOn(face, kSamples);
    double& work = work_[indexOf(face)];
    work = std::max(work, 1 + elements[indexOf(face)]);
  });
  refuseTooMany(elements, memoryLimitOf(*options_));
}

template <class Work>
void CadFaces::forEachFace(const Work& work) const {
  forEachInParallel(faces_.size(), options_->threads, [&](std::size_t i) { work(faces_[i]); });
}

}  // namespace af2::geometry
