#include "geometry/fill/face_filling.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/base/stopwatch.h"
#include "engine/mesh/element_shape.h"
#include "engine/optimize/finish_mesh.h"
#include "geometry/base/constants.h"
#include "geometry/fill/crossed_boundary.h"
#include "geometry/fill/diagnose_face.h"
#include "geometry/fill/first_diagonals.h"
#include "geometry/fill/odd_loops.h"
#include "geometry/fill/stuck_front.h"
#include "geometry/mesh/fans.h"
#include "geometry/mesh/layer_elements.h"

namespace af2::geometry {

namespace {

/// The middle of a side on the surface; where that cannot be reached, of the straight side.
Point3 middleOf(const SurfacePoint& from, const SurfacePoint& to,
                const AF2LocalTransformMaker& charts) {
  const Point3 straight = 0.5 * (from.position + to.position);
  const double side = distance(from.position, to.position);
  try {
    ChartSlot slot;
    const auto middle =
        charts.makeLocalTransformIn(slot, from, to, side).transformToSurface({0.5, 0});
    if (middle && distance(middle->position, straight) < side / 2) return middle->position;
  } catch (const GeometryError&) {
  }
  return straight;
}

/// Through the chart of each side, which goes back to the surface from the middle of the side.
void findMiddles(const ChartedSurface& surface, const Mesh& meshed, FaceMesh& mesh) {
  const auto charts =
      surface.makeCharts(surface.isPlane() ? ChartKind::Plane : ChartKind::MeanNormal);
  for (const Element& element : meshed.elements) {
    SideMiddles& middles = mesh.middles.emplace_back();
    const auto corners = element.vertices();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      // The same way round for the elements on both sides.
      const auto [first, last] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
      middles[i] = middleOf(meshed.vertices[first.value], meshed.vertices[last.value], *charts);
    }
  }
}

/// Tells while a mesh is finished that the work goes on; does nothing without a progress callback.
std::function<void()> goesOn(const FaceTask& task, const Mesh& mesh) {
  if (!task.progress) return {};
  return [&task, &mesh] { task.progress({mesh.elements.size(), 0, 0}); };
}

void optimize(const FaceTask& task, FaceAttempt& attempt, FaceMesh& mesh) {
  const Stopwatch watch;
  const FrontInput& input = task.boundary.input;
  if (attempt.chartsKnowOneSheet && hasTwoSheets(input))
    attempt.charts = task.surface.makeCharts(ChartKind::MeanNormal);
  OptimizeOptions options;
  const RuleSet& rules = task.algorithm.rules();
  if (rules.makesQuads()) options.closingRule = originOf(WithoutRule::Closing, rules).rule;
  options.stop = task.options.stop;
  options.goesOn = goesOn(task, attempt.result.mesh);
  options.quads = task.options.quads;
  if (AF2MeshingObserver* observer = task.options.observer ? task.options.observer() : nullptr)
    options.observer = observer->finishing();
  finishMesh(attempt.result.mesh, boundaryOf(input), {rules, *attempt.charts, task.size}, options);
  mesh.optimizeSeconds += watch.seconds();
}

void take(MeshingResult& result, FaceBoundary& boundary, FaceMesh& mesh) {
  mesh.boundary = std::move(boundary.points);
  mesh.uses = std::move(boundary.uses);
  const auto& vertices = result.mesh.vertices;
  constexpr std::size_t kVertices = 1 << 15;
  const std::size_t before = mesh.boundary.size();
  mesh.inside.resize(vertices.size() - before);
  forEachInRanges(mesh.inside.size(), kVertices, 0,
                  [&](std::size_t v) { mesh.inside[v] = vertices[before + v].position; });
  mesh.elements = std::move(result.mesh.elements);
  mesh.origins = std::move(result.mesh.origins);
  mesh.report.elements = mesh.elements.size();
  if (!boundary.layers) return;
  mesh.report.layers = std::move(boundary.layers->along);
  mesh.report.layerElements = boundary.layers->elements.size();
}

/// Before the fans are added.
WithoutRuleCounts countWithoutRule(const FaceTask& task, const FaceAttempt& attempt,
                                   const FaceBoundary& boundary) {
  WithoutRuleCounts counts;
  const ElementOrigin closing = originOf(WithoutRule::Closing, task.algorithm.rules());
  counts.closing = static_cast<std::size_t>(
      std::ranges::count(attempt.result.mesh.origins, closing.rule, &ElementOrigin::rule));
  for (const FaceBoundary::Fan& fan : boundary.fans) counts.fan += fan.rim.size() - 1;
  const Mesh& mesh = attempt.result.mesh;
  if (task.limits.ignoresNormals)
    counts.leaning = static_cast<std::size_t>(std::ranges::count_if(
        mesh.elements, [&](const Element& element) { return leans(mesh, element); }));
  return counts;
}

void reportTriangles(const Mesh& mesh, FaceReport& report) {
  for (const Element& element : mesh.elements) {
    if (element.isQuad() || report.triangles++ > 0) continue;
    const auto at = [&](std::size_t i) { return mesh.vertices[element.corners[i].value].position; };
    report.firstTriangle = 1.0 / 3 * (at(0) + at(1) + at(2));
  }
}

FilledFace fill(const FaceTask& task, FaceMesh& mesh) {
  try {
    return fillFace(task);
  } catch (const InputError& failure) {
    mesh.diagnosis = diagnoseFailure(task.surface, task.boundary, {});
    throw InputError(textOfCrossedBoundary(task.surface, task.boundary.input) + failure.what());
  } catch (...) {
    mesh.diagnosis = diagnoseFailure(task.surface, task.boundary, {});
    throw;
  }
}

IsLeast isLeastFor(const FaceFilling& filling) {
  if (!filling.least) return {};
  return [&](const SurfacePoint& point) {
    const double least = filling.least(point);
    return least > 0 && filling.wanted.sizeAt(point) <= kMoreThanRounding * least;
  };
}

/// By vertex.
std::vector<double> wantedSizes(const FaceFilling& filling, const Mesh& mesh) {
  constexpr std::size_t kVertices = 1 << 14;
  const Ranges ranges(mesh.vertices.size(), kVertices);
  std::vector<double> sizes(mesh.vertices.size());
  forEachInParallel(ranges.count(), 0, [&](std::size_t range) {
    std::shared_ptr<const SizeField> own;
    if (ranges.count() > 1 && filling.makeWanted) own = filling.makeWanted();
    const SizeField& wanted = own ? *own : filling.wanted;
    for (const std::size_t v : ranges[range]) sizes[v] = wanted.sizeAt(mesh.vertices[v]);
  });
  return sizes;
}

[[noreturn]] void giveUp(const FaceFilling& filling, const FilledFace& filled, FaceMesh& mesh) {
  mesh.diagnosis = diagnoseFailure(filling.task.surface, filling.task.boundary, filled.failures);
  const auto first = std::ranges::find(filled.failures, Outcome::Stuck, &MeshingResult::outcome);
  if (first != filled.failures.end()) mesh.report.stuck = stuckPlaces(*first);
  if (filling.findParameters) filling.findParameters(mesh.report.stuck);
  throw GeometryError(textOfCrossedBoundary(filling.task.surface, filling.task.boundary.input) +
                      textOf(filled.attempt.fault));
}

}  // namespace

void fillAndJudge(const FaceFilling& filling, FaceBoundary& boundary, FaceMesh& mesh) {
  const FaceTask& task = filling.task;
  const bool makesQuads = task.algorithm.rules().makesQuads();
  mesh.report.oddLoops = oddLoopsOf(task.boundary.input, makesQuads ? &filling.wanted : nullptr);
  const Stopwatch watch;
  FilledFace filled = fill(task, mesh);
  FaceAttempt& attempt = filled.attempt;
  mesh.optimizeSeconds = attempt.optimizeShare * watch.seconds();
  mesh.searchCost = filled.searchCost;
  mesh.history.insert(mesh.history.end(), filled.history.begin(), filled.history.end());
  if (attempt.chart != ChartKind::Auto) mesh.report.chart = toString(attempt.chart);
  if (!attempt.fault.isNone()) giveUp(filling, filled, mesh);
  if (attempt.result.outcome == Outcome::Cancelled) {
    mesh.report.status = FaceStatus::Cancelled;
    return;
  }
  if (task.options.optimize && !attempt.isOptimized) optimize(task, attempt, mesh);
  // Without charts, normals mean nothing here, and nothing may move.
  if (task.options.quads.onlyQuads && attempt.charts)
    joinTriangles(attempt.result.mesh, boundaryOf(task.boundary.input), *attempt.charts,
                  task.options.stop, goesOn(task, attempt.result.mesh));
  mesh.report.acts = attempt.result.acts;
  mesh.report.withoutRule = countWithoutRule(task, attempt, boundary);
  mesh.report.stuck = std::move(attempt.stuck);
  if (filling.findParameters) filling.findParameters(mesh.report.stuck);
  mesh.diagnosis = diagnoseMesh(attempt.result.mesh, boundary, task.surface.isPlane(), task.area,
                                filling.unseen, isLeastFor(filling));
  const bool onlyQuads = task.options.quads.onlyQuads;
  addLayers(boundary, originOf(WithoutRule::Layer, task.algorithm.rules()), attempt.result.mesh);
  addFans(boundary, fanElementsFor(task.options.quads),
          originOf(WithoutRule::Fan, task.algorithm.rules()), attempt.result.mesh);
  // What could not become one quadrilateral where the fan was made can when its rim may move.
  const bool hasLayers = boundary.layers && !boundary.layers->elements.empty();
  if (onlyQuads && attempt.charts && !boundary.fans.empty() && !hasLayers) {
    joinAtTips(boundary, *attempt.charts, attempt.result.mesh);
    joinTriangles(attempt.result.mesh, boundaryWithFans(boundary), *attempt.charts,
                  task.options.stop, goesOn(task, attempt.result.mesh));
  }
  if (makesQuads || onlyQuads)
    beginAtBoundaryCorners(boundaryWithFans(boundary), attempt.result.mesh);
  mesh.wantedSizes = wantedSizes(filling, attempt.result.mesh);
  if (onlyQuads) {
    reportTriangles(attempt.result.mesh, mesh.report);
    if (mesh.report.oddLoops.empty())
      askForRoom(attempt.result.mesh, isLeastFor(filling), mesh.diagnosis);
  }
  if (filling.findMiddles) findMiddles(task.surface, attempt.result.mesh, mesh);
  take(attempt.result, boundary, mesh);
}

void failFor(const std::string& reason, FaceMesh& mesh) {
  mesh.report.status = FaceStatus::Failed;
  mesh.report.reason = reason;
}

}  // namespace af2::geometry
