#include "geometry/occ/merge/merged_faces.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>

#include "engine/base/error.h"
#include "geometry/layers/layers_of_face.h"
#include "geometry/meshing/part_sizes.h"
#include "geometry/occ/edges/edge_chains.h"
#include "geometry/occ/merge/quilt_filling.h"

namespace af2::geometry {

namespace {

/// The distance from faces that are meshed together.
class QuiltDistance final : public FaceDistance {
 public:
  explicit QuiltDistance(std::shared_ptr<const QuiltParts> parts) : surface_(std::move(parts)) {}
  double of(const Point3& point) override { return surface_.distanceFrom(point); }

 private:
  QuiltSurface surface_;
};

bool hasVertexInside(const TopoDS_Shape& face) {
  for (TopoDS_Iterator it(face); it.More(); it.Next())
    if (it.Value().ShapeType() == TopAbs_VERTEX) return true;
  return false;
}

/// Edges between faces that a pattern names and others.
void keepAround(const ModelShape& shape, const std::vector<std::string>& patterns,
                std::set<int>& kept) {
  for (const std::string& pattern : patterns) {
    const std::vector<int> named = facesCalled(pattern, shape.faceNames, shape.groups);
    if (named.empty())
      throw InputError("no face or group is called '" + pattern +
                       "', so that no edges around it can be kept (see af2 inspect)");
    const auto isNamed = [&](int face) { return std::ranges::binary_search(named, face); };
    for (std::size_t e = 0; e < shape.facesOfEdges.size(); ++e) {
      const std::vector<int>& faces = shape.facesOfEdges[e];
      if (std::ranges::any_of(faces, isNamed) && !std::ranges::all_of(faces, isNamed))
        kept.insert(static_cast<int>(e) + 1);
    }
  }
}

/// Faces with edges that coincide with others, or on which others end: their boundaries need what
/// the division of single faces does there.
std::set<int> facesAtTouchingEdges(const ModelShape& shape, const DividedEdges& divided) {
  std::set<int> faces;
  const auto add = [&](std::size_t edge) {
    faces.insert(shape.facesOfEdges[edge].begin(), shape.facesOfEdges[edge].end());
  };
  for (std::size_t e = 0; e < divided.edges.size(); ++e) {
    const DividedEdge& edge = divided.edges[e];
    if (edge.twin > 0) add(static_cast<std::size_t>(edge.twin) - 1);
    if (edge.twin > 0 || !edge.stops.empty() || !edge.problem.empty()) add(e);
  }
  return faces;
}

}  // namespace

void MergedFaces::prepare(const MeshingOptions& options, const std::vector<int>& faces) {
  options_ = options;
  if (planned_ == faces) shareAims();
  CadFaces::prepare(options_, faces);
  if (planned_ == faces) return;  // a further round, with other sizes
  const auto count = static_cast<std::size_t>(faceCount());
  std::vector<double> areas(count, 0), lengths;
  std::vector<bool> mayMerge(count, false);
  merge({});
  const std::set<int> touching =
      facesAtTouchingEdges(shape(), CadFaces::divide(sizes().function, {}, {}));
  for (const int face : faces) {
    areas[indexOf(face)] = areaOfFace(face);
    const bool isLying = std::ranges::any_of(lyingFaces(), [&](const FaceOnFace& lying) {
      return lying.face == face || lying.under == face;
    });
    mayMerge[indexOf(face)] = areaOfFace(face) > 0 && !isLying && !touching.contains(face) &&
                              !shape().cells.contains(face) &&
                              !hasVertexInside(shape().faces(face));
  }
  for (const EdgeSamples& samples : sampledEdges()) lengths.push_back(samples.length);
  std::set<int> kept;
  for (const auto& [edge, size] : options.sizes.edgeSizes) kept.insert(edge);
  for (const auto& [edge, points] : options.edgePoints) kept.insert(edge);
  for (const int face : faces)
    if (!layersOfFace(options_.layers, face, edgesOf(face)).empty())
      for (const int edge : edgesOf(face)) kept.insert(edge);
  keepAround(shape(), request_.keptAround, kept);
  joints_ = jointsOf(shape(), options.threads);
  plan_ = planMerging({sharedShape(), request_, options.sizes, joints_, lengths, std::move(areas),
                       std::move(mayMerge), std::move(kept), givenUp_, part_, options.stop});
  planned_ = faces;
  if (options_.sizes.chords.areGiven()) {
    std::vector<int> inQuilts;
    for (const auto& [face, quilt] : plan_.quiltOf) inQuilts.push_back(face);
    spreadSizesOf(std::move(inQuilts));
    CadFaces::prepare(options_, faces);
  }
  merge(plan_.edges);
}

/// The first face of a quilt stands for all when a mesh is measured.
void MergedFaces::shareAims() {
  std::map<int, double>& aims = options_.sizes.chords.aims;
  for (const Quilt& quilt : plan_.quilts) {
    const std::vector<int>& own = quilt.parts->faces;
    const auto found = aims.find(own.front());
    if (found == aims.end()) continue;
    const double aim = found->second;
    for (const int face : own) aims[face] = aim;
  }
}

const Quilt* MergedFaces::quiltWith(int face) const {
  const auto found = plan_.quiltOf.find(face);
  return found == plan_.quiltOf.end() ? nullptr : &plan_.quilts[found->second];
}

double MergedFaces::workOn(int face) const {
  const Quilt* quilt = quiltWith(face);
  if (!quilt) return CadFaces::workOn(face);
  double sum = 0;
  if (isFirst(face, *quilt))
    for (const int own : quilt->parts->faces) sum += CadFaces::workOn(own);
  return sum;
}

std::vector<int> MergedFaces::edgesOf(int face) const {
  const Quilt* quilt = quiltWith(face);
  if (!quilt) return CadFaces::edgesOf(face);
  std::vector<int> edges;
  if (!isFirst(face, *quilt)) return edges;
  for (const std::vector<QuiltUse>& loop : quilt->boundary.loops)
    for (const QuiltUse& use : loop) edges.push_back(use.edge);
  std::ranges::sort(edges);
  edges.erase(std::ranges::unique(edges).begin(), edges.end());
  return edges;
}

Point3 MergedFaces::pointOnEdge(int edge, double parameter) const {
  const auto chain = std::ranges::find(merged().chains, edge, &EdgeChain::id);
  return chain == merged().chains.end() ? CadFaces::pointOnEdge(edge, parameter)
                                        : ChainCurve(shape(), *chain).at(parameter);
}

std::unique_ptr<FaceDistance> MergedFaces::distanceFrom(int face) const {
  const Quilt* quilt = quiltWith(face);
  if (!quilt) return CadFaces::distanceFrom(face);
  return std::make_unique<QuiltDistance>(quilt->parts);
}

std::vector<CountedLoop> MergedFaces::loopsOf(int face, const DividedEdges& divided) const {
  const Quilt* quilt = quiltWith(face);
  if (!quilt) return CadFaces::loopsOf(face, divided);
  std::vector<CountedLoop> loops;
  if (!isFirst(face, *quilt)) return loops;
  for (const std::vector<QuiltUse>& loop : quilt->boundary.loops) {
    CountedLoop& counted = loops.emplace_back();
    for (const QuiltUse& use : loop) {
      const std::vector<std::size_t>& counts = divided.edges[indexOf(use.edge)].counts;
      counted.counts.insert(counted.counts.end(), counts.begin(), counts.end());
    }
  }
  return loops;
}

void MergedFaces::fill(int face, const FillRequest& request, FaceMesh& mesh) const {
  const Quilt* quilt = quiltWith(face);
  if (!quilt) {
    CadFaces::fill(face, request, mesh);
    return;
  }
  mesh.report.area = 0;
  if (!isFirst(face, *quilt)) {
    mesh.report.reason =
        "is meshed together with face " + std::to_string(quilt->parts->faces.front());
    return;
  }
  mesh.report.area = quilt->area;
  const auto fillBy = [&](const CadSizes& sizes) {
    fillQuilt({*quilt, sizes, request, workOn(face), finerInside()}, mesh);
  };
  request.limits.hasOriginalSizes ? fillBy(sizes()) : fillBy(withFunction(request.sizes));
}

std::vector<CollapsedEdges> MergedFaces::shortEdges(int face, const DividedEdges& divided,
                                                    const std::vector<SizeSource>& places) const {
  if (quiltWith(face)) return {};
  return CadFaces::shortEdges(face, divided, places);
}

std::vector<SizeSource> MergedFaces::sizesInside(int face) const {
  const Quilt* quilt = quiltWith(face);
  if (!quilt) return CadFaces::sizesInside(face);
  std::vector<SizeSource> sizes;
  if (!isFirst(face, *quilt)) return sizes;
  for (const int own : quilt->parts->faces) {
    const std::vector<SizeSource> inside = CadFaces::sizesInside(own);
    sizes.insert(sizes.end(), inside.begin(), inside.end());
  }
  return sizes;
}

bool MergedFaces::cutFailed(const ModelMesh& mesh) {
  constexpr std::size_t kSmall = 6;  // faces
  bool isAny = false;
  int parts = 0;
  for (const auto& [face, part] : part_) parts = std::max(parts, part);
  std::vector<double> areas;
  for (int face = 1; face <= faceCount(); ++face) areas.push_back(areaOfFace(face));
  for (const FaceReport& report : mesh.faces) {
    const Quilt* quilt = quiltWith(report.id);
    if (!quilt || !isFirst(report.id, *quilt)) continue;
    const bool isLeaning = report.withoutRule.leaning > 0;
    if (report.status != FaceStatus::Failed && !isLeaning && report.triangles == 0) continue;
    isAny = true;
    const std::vector<int>& own = quilt->parts->faces;
    if (own.size() > kSmall) {
      ++parts;
      for (const int face : halfOf(own, areas, joints_, merged().isRemoved)) part_[face] = parts;
      continue;
    }
    const std::string why = isLeaning              ? "elements turned away from the faces"
                            : report.triangles > 0 ? "triangles remained"
                                                   : report.reason;
    for (const int face : own) givenUp_[face] = why;
  }
  if (isAny) planned_.clear();
  return isAny;
}

}  // namespace af2::geometry
