#include "geometry/occ/face_mesher.h"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <chrono>
#include <cstdio>

#include "engine/error.h"
#include "engine/mesh_check.h"
#include "engine/optimize.h"
#include "geometry/graded_size.h"
#include "geometry/occ/face_size.h"

namespace af2::geometry {

namespace {

std::string toText(const Point3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.x, p.y, p.z);
  return text;
}

/// Where and why the front got stuck: its first edge, and what kept the most promising rule away.
std::string stuckReason(const MeshingResult& result, const AF2Algorithm& algorithm) {
  std::string text = "the front got stuck with " + std::to_string(result.stuck.size()) + " edges left";
  if (result.stuck.empty()) return text;
  const StuckEdge& edge = result.stuck.front();
  text += ", the first from " + toText(result.mesh.vertices[edge.from.value].position) + " to " +
          toText(result.mesh.vertices[edge.to.value].position);
  const RuleRefusal* farthest = nullptr;
  for (const RuleRefusal& refusal : edge.refusals)
    if (!farthest || refusal.reason > farthest->reason) farthest = &refusal;
  if (farthest)
    text += "; rule '" + algorithm.rules().rules()[farthest->rule].name() + "': " +
            toString(farthest->reason);
  return text;
}

/// One way to mesh a face, and how it went.
struct Attempt {
  MeshingResult result;
  std::string fault;  ///< empty: complete and sound
};

/// Stops a run that no longer fills a region but grows without end, because the boundary does not
/// enclose one.
class RunawayGuard {
 public:
  RunawayGuard(std::size_t limit, const std::stop_token& outer)
      : limit_(limit), forward_(outer, Forward{&source_}) {}

  std::stop_token token() const { return source_.get_token(); }
  void see(const Progress& progress) {
    if (progress.elements <= limit_) return;
    ranAway_ = true;
    source_.request_stop();
  }
  bool ranAway() const { return ranAway_; }

 private:
  struct Forward {
    std::stop_source* source;
    void operator()() const { source->request_stop(); }
  };
  std::size_t limit_;
  bool ranAway_ = false;
  std::stop_source source_;
  std::stop_callback<Forward> forward_;
};

class FaceMesher {
 public:
  FaceMesher(const FaceMeshingContext& context, int face, double expectedElements)
      : context_(context),
        face_(face),
        expected_(expectedElements),
        surface_(context.model.face(face)) {}

  void meshInto(FaceMesh& mesh) {
    FaceBoundary boundary = findBoundary(context_.model, face_, context_.divided, surface_);
    const FaceSize wanted(context_.options.sizes, face_, surface_);
    const GradedSize size(wanted, boundary.input, context_.options.sizes.growth);
    const auto charts = surface_.makeCharts({});
    Attempt attempt = run(*charts, boundary.input, size);
    if (attempt.result.outcome == Outcome::Cancelled && attempt.fault.empty()) {
      mesh.report.status = FaceStatus::Cancelled;
      return;
    }
    if (!attempt.fault.empty()) throw GeometryError(attempt.fault);
    if (context_.options.optimize) {
      const auto start = std::chrono::steady_clock::now();
      OptimizeOptions options;
      options.stop = context_.options.stop;
      optimizeMesh(attempt.result.mesh, boundary.input, *charts, options);
      // What the optimiser leaves is held against the same checks; the raw mesh has passed them.
      if (!faultOf(attempt.result, boundary.input).empty())
        attempt = run(*charts, boundary.input, size);
      const auto end = std::chrono::steady_clock::now();
      mesh.optimizeSeconds = std::chrono::duration<double>(end - start).count();
    }
    take(attempt.result, boundary, mesh);
  }

 private:
  Attempt run(const AF2LocalTransformMaker& charts, const FrontInput& input, const SizeField& size) {
    RunawayGuard guard(elementLimit(input), context_.options.stop);
    MeshingOptions options;
    options.stop = guard.token();
    if (context_.options.observer) options.observer = context_.options.observer(face_);
    options.progress = [&](const Progress& progress) {
      guard.see(progress);
      if (context_.progress) context_.progress(progress);
    };
    Attempt attempt{context_.algorithm.execute(charts, input, size, options), ""};
    if (guard.ranAway())
      attempt.fault = "far more elements than the area has room for: the boundary does not enclose "
                      "a region";
    else if (attempt.result.outcome == Outcome::Stuck)
      attempt.fault = stuckReason(attempt.result, context_.algorithm);
    else if (attempt.result.outcome == Outcome::Complete)
      attempt.fault = faultOf(attempt.result, input);
    return attempt;
  }

  /// Many more than expected: short segments of the boundary and curvature want smaller elements.
  std::size_t elementLimit(const FrontInput& input) const {
    std::size_t corners = 0;
    for (const auto& loop : input.loops) corners += loop.size();
    return static_cast<std::size_t>(std::min(100 * expected_, 1e9)) + 100 * corners + 10000;
  }

  static std::string faultOf(const MeshingResult& result, const FrontInput& input) {
    const std::vector<MeshFault> faults = checkMesh(result.mesh, input);
    if (faults.empty()) return "";
    return "the mesh has " + std::to_string(faults.size()) +
           " faults: " + describe(faults.front(), result.mesh);
  }

  static void take(MeshingResult& result, FaceBoundary& boundary, FaceMesh& mesh) {
    mesh.boundary = std::move(boundary.points);
    mesh.uses = std::move(boundary.uses);
    const auto& vertices = result.mesh.vertices;
    for (std::size_t i = boundary.input.vertexCount; i < vertices.size(); ++i)
      mesh.inside.push_back(vertices[i].position);
    mesh.elements = std::move(result.mesh.elements);
    mesh.rule = std::move(result.mesh.rule);
    mesh.report.elements = mesh.elements.size();
  }

  const FaceMeshingContext& context_;
  int face_;
  double expected_;
  FaceSurface surface_;
};

void fail(FaceMesh& mesh, const std::string& reason) {
  mesh.report.status = FaceStatus::Failed;
  mesh.report.reason = reason;
}

}  // namespace

FaceMesh meshFace(const FaceMeshingContext& context, int face, double expectedElements) {
  FaceMesh mesh;
  const auto start = std::chrono::steady_clock::now();
  const auto index = static_cast<std::size_t>(face) - 1;
  mesh.report.id = face;
  mesh.report.name = context.model.faceNames[index];
  mesh.report.surfaceType = context.model.surfaceTypes[index];
  try {
    FaceMesher(context, face, expectedElements).meshInto(mesh);
  } catch (const Standard_Failure& failure) {
    fail(mesh, std::string("OpenCASCADE: ") + failure.DynamicType()->Name());
  } catch (const std::exception& failure) {
    fail(mesh, failure.what());
  }
  const auto end = std::chrono::steady_clock::now();
  mesh.report.seconds = std::chrono::duration<double>(end - start).count();
  return mesh;
}

double areaOf(const ModelShape& model, int face) {
  try {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(model.face(face), properties);
    return std::abs(properties.Mass());
  } catch (const Standard_Failure&) {
    return 0;
  }
}

}  // namespace af2::geometry
