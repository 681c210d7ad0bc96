#include "geometry/domain_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/error.h"
#include "engine/mesh_check.h"
#include "engine/optimize.h"
#include "engine/stopwatch.h"
#include "geometry/append_face.h"
#include "geometry/close_front.h"
#include "geometry/element_crossings.h"
#include "geometry/graded_size.h"
#include "geometry/narrow_places.h"
#include "geometry/sound_faces.h"
#include "geometry/stuck_front.h"

namespace af2::geometry {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

DomainMesh::DomainMesh(const AF2Algorithm& algorithm, const DomainMeshingOptions& options)
    : algorithm_(algorithm), options_(options) {
  for (const AF2Rule& rule : algorithm.rules().rules()) mesh_.ruleNames.push_back(rule.name());
  mesh_.ruleNames.push_back("closing");  // what closes a stuck front
}

VertexId DomainMesh::addVertex(const Point3& position) {
  mesh_.vertices.push_back(position);
  mesh_.wantedSizes.push_back(kFar);
  return VertexId(mesh_.vertices.size() - 1);
}

void DomainMesh::addCurve(DividedCurve curve) { curves_.push_back(std::move(curve)); }

void DomainMesh::addFace(DomainFace face) {
  const Stopwatch watch;
  FaceReport report;
  report.id = static_cast<int>(faces_.size()) + 1;
  report.surfaceType = face.surfaceType;
  report.chart = face.chart;
  report.area = face.area;
  const double optimizing = mesh_.seconds.optimize;
  if (options_.stop.stop_requested())
    report.status = FaceStatus::Cancelled;
  else
    fill(face, report);
  report.seconds = watch.seconds();
  mesh_.seconds.surface += report.seconds - (mesh_.seconds.optimize - optimizing);
  mesh_.faces.push_back(std::move(report));
  faces_.push_back(std::move(face));
}

void DomainMesh::fill(const DomainFace& face, FaceReport& report) {
  const Stopwatch watch;
  std::vector<VertexId> boundary;
  const FrontInput input = boundaryOf(face, boundary);
  const auto size = std::make_shared<const GradedSize>(*face.wanted, input, options_.growth);
  const RegionTask task{input,
                        [&] {
                          return PieceTools{face.makeCharts(), size};
                        },
                        face.cuts,
                        {},
                        options_.optimize,
                        options_.threads};
  try {
    RegionMesh meshed =
        meshRegion(algorithm_, task, {options_.observer, options_.progress, options_.stop});
    if (meshed.seconds > 0)
      mesh_.seconds.optimize += watch.seconds() * meshed.optimizeSeconds / meshed.seconds;
    close(task, meshed, report);
    judge(meshed, report);
    if (report.status == FaceStatus::Complete)
      add(std::move(meshed.result.mesh), boundary, *face.wanted, report);
  } catch (const std::runtime_error& error) {  // of the surface or the boundary
    report.status = FaceStatus::Failed;
    report.reason = error.what();
  }
}

FrontInput DomainMesh::boundaryOf(const DomainFace& face, std::vector<VertexId>& boundary) {
  localIds_.resize(mesh_.vertices.size());
  FrontInput input;
  for (const auto& loop : face.loops) {
    std::vector<BoundaryCorner> corners;
    for (const CurveUse& use : loop) {
      std::vector<VertexId> along = curves_[use.curve].vertices;
      if (use.reversed) std::reverse(along.begin(), along.end());
      along.pop_back();
      for (const VertexId id : along) corners.push_back(cornerOf(id, face, boundary));
    }
    input.loops.push_back(std::move(corners));
  }
  for (const VertexId id : boundary) localIds_[id.value] = VertexId();
  input.vertexCount = boundary.size();
  return input;
}

BoundaryCorner DomainMesh::cornerOf(VertexId id, const DomainFace& face,
                                    std::vector<VertexId>& boundary) {
  VertexId& local = localIds_[id.value];
  if (local.isNone()) {
    local = VertexId(boundary.size());
    boundary.push_back(id);
  }
  SurfacePoint point = face.nearest(mesh_.vertices[id.value]);
  point.position = mesh_.vertices[id.value];
  return {local, point};
}

void DomainMesh::close(const RegionTask& task, RegionMesh& meshed, FaceReport& report) const {
  if (meshed.result.outcome != Outcome::Stuck) return;
  MeshingResult closed = meshed.result;
  const std::uint16_t rule = closingRule(algorithm_.rules());
  const MeshBoundary boundary = af2::boundaryOf(task.input);
  if (!closeFront(closed, rule) || !faultOf(closed.mesh, boundary).empty()) return;
  report.reason = std::to_string(closed.mesh.elements.size() - meshed.result.mesh.elements.size()) +
                  " elements were made without a rule, where rules had no room";
  meshed.result = std::move(closed);
  meshed.result.outcome = Outcome::Complete;
  meshed.fault.clear();
  if (!task.optimize) return;
  OptimizeOptions options;
  if (algorithm_.rules().makesQuads()) options.closingRule = rule;
  options.stop = options_.stop;
  optimizeMesh(meshed.result.mesh, boundary, *task.makeTools().charts, options);
}

void DomainMesh::judge(const RegionMesh& meshed, FaceReport& report) const {
  const MeshingResult& result = meshed.result;
  if (result.outcome == Outcome::Complete && meshed.fault.empty()) return;
  report.status = result.outcome == Outcome::Cancelled ? FaceStatus::Cancelled : FaceStatus::Failed;
  report.stuck = stuckPlaces(result);
  report.reason = result.outcome == Outcome::Stuck ? stuckReason(result, algorithm_) : meshed.fault;
}

void DomainMesh::add(Mesh meshed, const std::vector<VertexId>& boundary, const SizeField& wanted,
                     FaceReport& report) {
  makeRoom(mesh_.wantedSizes, meshed.vertices.size() - boundary.size());
  for (std::size_t i = 0; i < meshed.vertices.size(); ++i) {
    const double size = wanted.sizeAt(meshed.vertices[i]);
    if (i >= boundary.size()) {
      mesh_.wantedSizes.push_back(size);
      continue;
    }
    double& there = mesh_.wantedSizes[boundary[i].value];
    there = std::min(there, size);
  }
  appendFace(mesh_, std::move(meshed), boundary, report);
}

/// Counts only the faces that were meshed.
void DomainMesh::addSegments() {
  std::vector<int> uses(curves_.size(), 0);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (mesh_.faces[i].status != FaceStatus::Complete) continue;
    for (const auto& loop : faces_[i].loops)
      for (const CurveUse& use : loop) ++uses[use.curve];
  }
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    const DividedCurve& curve = curves_[c];
    for (std::size_t i = 0; uses[c] > 0 && i + 1 < curve.vertices.size(); ++i)
      mesh_.segments.push_back(
          {curve.vertices[i], curve.vertices[i + 1], curve.edge, uses[c], curve.middles[i]});
  }
}

std::vector<SideMiddles> DomainMesh::middlesOfSides() const {
  std::vector<SideMiddles> middles;
  for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
    const auto corners = mesh_.elements[e].vertices();
    const DomainFace& face = faces_[static_cast<std::size_t>(mesh_.face[e]) - 1];
    SideMiddles& own = middles.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      // The same way round for the elements on both sides.
      const auto [first, last] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
      own[i] =
          face.nearest(0.5 * (mesh_.vertices[first.value] + mesh_.vertices[last.value])).position;
    }
  }
  return middles;
}

ModelMesh DomainMesh::finish(bool isFlat) {
  addSegments();
  const auto oneByOne = [](std::size_t count, const auto& work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
  };
  mesh_.findings =
      keepSoundFaces(mesh_, isFlat ? std::vector<Crossing>() : elementCrossings(mesh_, oneByOne));
  if (options_.order == 2) makeSecondOrder(mesh_, middlesOfSides());
  return std::move(mesh_);
}

void checkSize(const DomainMeshingOptions& options) {
  if (!(options.size > 0) || !std::isfinite(options.size))
    throw InputError("the size must be a positive number");
  if (options.order != 1 && options.order != 2) throw InputError("elements can have order 1 or 2");
}

void addNarrowPlaces(const ModelMesh& coarse, double elementsAcross, DomainMeshingOptions& finer) {
  addSources(narrowPlaces(coarse, elementsAcross), leastForLimits(finer.size, finer.minSize),
             finer.sources);
}

}  // namespace af2::geometry
