#include "geometry/occ/face_mesher.h"

#include <BRep_Tool.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/optimize.h"
#include "engine/plane_chart.h"
#include "engine/stopwatch.h"
#include "geometry/close_front.h"
#include "geometry/conformal_chart.h"
#include "geometry/graded_size.h"
#include "geometry/laid_out.h"
#include "geometry/occ/edge_samples.h"
#include "geometry/occ/face_attempt.h"
#include "geometry/occ/face_size.h"
#include "geometry/occ/points.h"
#include "geometry/occ/sizing.h"
#include "geometry/stuck_front.h"

namespace af2::geometry {

namespace {

/// Nothing if there are none.
void tellOfPoints(const char* why, const std::vector<int>& edges, std::vector<std::string>& told) {
  constexpr std::size_t kMostNamed = 5;
  if (edges.empty()) return;
  std::string ids;
  for (std::size_t i = 0; i < std::min(edges.size(), kMostNamed); ++i)
    ids += (i > 0 ? ", " : "") + std::to_string(edges[i]);
  if (edges.size() > kMostNamed)
    ids += " and " + std::to_string(edges.size() - kMostNamed) + " more";
  told.push_back(std::string(why) + ": edges " + ids);
}

std::string toldOfTouching(const FaceBoundary::TouchingEdges& edges) {
  char gap[32];
  std::snprintf(gap, sizeof gap, "%.2g", edges.gap);
  return "edges " + std::to_string(edges.one) + " and " + std::to_string(edges.other) +
         " lie on each other, but for " + gap + ": where they do, the face has no width";
}

std::string toldOfLying(const FaceOnFace& lying) {
  const std::string under = "face " + std::to_string(lying.under);
  return lying.isDouble() ? "is " + under + " once more, so it has no elements"
                          : "lies on " + under + ", turned back, so it has no elements";
}

class FaceMesher {
 public:
  FaceMesher(const FaceMeshingContext& context, int face, double area, double expectedElements)
      : context_(context),
        face_(face),
        area_(area),
        expected_(expectedElements),
        surface_(context.model.surface(face)) {}

  void meshInto(FaceMesh& mesh) {
    const auto lying = std::ranges::find(context_.onFaces, face_, &FaceOnFace::face);
    if (lying != context_.onFaces.end()) {
      mesh.report.reason = toldOfLying(*lying);
      return;
    }
    FaceBoundary boundary =
        findBoundary(context_.model, face_, context_.divided, surface_, context_.onFaces);
    mesh.report.attempts = boundary.repairs;
    std::ranges::copy(boundary.notes, std::back_inserter(mesh.report.attempts));
    tellOfPoints(boundary.pointEdges, mesh.report.attempts);
    double closed = 0;  // area between edges that are one
    for (const FaceBoundary::TouchingEdges& edges : boundary.touching) {
      mesh.report.attempts.push_back(toldOfTouching(edges));
      closed += edges.gap * edges.length;
    }
    if (boundary.input.loops.empty()) {
      mesh.report.reason = "has no width, so it has no elements: its boundary runs back on itself";
      return;
    }
    constexpr double kMostClosed = 0.05;  // of the area
    if (!boundary.repairs.empty() || closed > kMostClosed * area_)
      mesh.report.area = area_ = 0;  // was found with the old boundary
    const FaceSize wanted(context_.options.sizes, face_, surface_);
    const GradedSize size(wanted, boundary.input, context_.options.sizes.growth);
    const Stopwatch filling;
    FaceAttempt attempt = fill(boundary, size, mesh);
    mesh.optimizeSeconds = attempt.optimizeShare * filling.seconds();
    mesh.effort = attempt.effort;
    std::ranges::move(attempt.steps, std::back_inserter(mesh.report.attempts));
    if (attempt.chart != ChartKind::Auto) mesh.report.chart = toString(attempt.chart);
    if (!attempt.fault.empty()) {
      mesh.trouble = troubleOfFailure(surface_, boundary, attempt.failures);
      if (!attempt.failures.empty()) mesh.report.stuck = stuckOnFace(attempt.failures.front());
      throw GeometryError(attempt.fault);
    }
    if (attempt.result.outcome == Outcome::Cancelled) {
      mesh.report.status = FaceStatus::Cancelled;
      return;
    }
    if (context_.options.optimize && !attempt.isOptimized) optimize(attempt, boundary.input, mesh);
    if (attempt.closingElements > 0)
      mesh.report.reason = std::to_string(attempt.closingElements) +
                           " elements were made without a rule, where rules had no room";
    mesh.wantedSizes.reserve(attempt.result.mesh.vertices.size());
    for (const SurfacePoint& vertex : attempt.result.mesh.vertices)
      mesh.wantedSizes.push_back(wanted.sizeAt(vertex));
    if (context_.options.order == 2) findMiddles(attempt.result.mesh, mesh);
    mesh.trouble = troubleOfMesh(attempt.result.mesh, boundary, surface_.isPlane(), area_,
                                 kUnseen * wantedOnFace(context_.options.sizes, face_));
    take(attempt.result, boundary, mesh);
  }

 private:
  void tellOfPoints(std::vector<int> edges, std::vector<std::string>& told) const {
    const auto asked = std::ranges::stable_partition(edges, [&](int edge) {
      return !context_.divided.edges[static_cast<std::size_t>(edge) - 1].point;
    });
    geometry::tellOfPoints("too short to be seen in the mesh, so taken for points",
                           {edges.begin(), asked.begin()}, told);
    geometry::tellOfPoints("short, and taken for points because a face there failed with them",
                           {asked.begin(), edges.end()}, told);
  }

  /// Vertices inside quadrics, and those of faces laid out, do not keep the parameters of the file.
  std::vector<StuckPlace> stuckOnFace(const MeshingResult& result) const {
    std::vector<StuckPlace> places = stuckPlaces(result);
    const TopoDS_Face face = TopoDS::Face(context_.model.face(face_));
    ShapeAnalysis_Surface surface(BRep_Tool::Surface(face));
    for (StuckPlace& place : places) {
      const gp_Pnt2d uv = surface.ValueOfUV(toOcc(place.from), BRep_Tool::Tolerance(face));
      place.u = uv.X();
      place.v = uv.Y();
    }
    return places;
  }

  /// Through the chart of each side, which goes back to the surface from the middle of the side.
  void findMiddles(const Mesh& meshed, FaceMesh& mesh) const {
    const auto charts = surface_.makeCharts(ChartKind::MeanNormal);
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

  /// Where the surface cannot be reached: of the straight side.
  static Point3 middleOf(const SurfacePoint& from, const SurfacePoint& to,
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

  FaceAttempt fill(const FaceBoundary& boundary, const SizeField& size, FaceMesh& mesh) const {
    try {
      return fillFace({face_, surface_, boundary, size, area_, expected_, context_.algorithm,
                       context_.options, context_.mayBeFineInside, context_.mostCandidates,
                       context_.mayLean, context_.progress,
                       [&](ChartKind kind) { return makeTools(boundary.input, kind); }});
    } catch (...) {
      mesh.trouble = troubleOfFailure(surface_, boundary, {});
      throw;
    }
  }

  /// A size field with a surface of its own: OpenCASCADE's evaluators are not to be shared.
  struct OwnSize final : SizeField {
    OwnSize(const FaceMeshingContext& context, int face, const FrontInput& input, ChartKind kind)
        : surface(context.model.surface(face)),
          wanted(context.options.sizes, face, surface),
          graded(wanted, input, context.options.sizes.growth),
          map(surface.makePlaneMap(kind)) {
      if (map) laidOut.emplace(graded, *map);
    }
    double sizeAt(const SurfacePoint& point) const override {
      return laidOut ? laidOut->sizeAt(point) : graded.sizeAt(point);
    }

    FaceSurface surface;
    FaceSize wanted;
    GradedSize graded;
    std::unique_ptr<PlaneMap> map;  ///< null: charts see the surface itself
    std::optional<LaidOutSize> laidOut;
  };

  PieceTools makeTools(const FrontInput& input, ChartKind kind) const {
    auto size = std::make_shared<const OwnSize>(context_, face_, input, kind);
    if (size->map && kind == ChartKind::Conformal)
      return {std::make_unique<ConformalChartMaker>(*size->map), std::move(size)};
    if (size->map) return {std::make_unique<PlaneChartMaker>(), std::move(size)};
    auto charts = size->surface.makeCharts(kind);
    return {std::move(charts), std::move(size)};
  }

  void optimize(FaceAttempt& attempt, const FrontInput& input, FaceMesh& mesh) const {
    const Stopwatch watch;
    // Charts in parameters know a vertex of a seam on one of its sheets only.
    const bool inParameters =
        attempt.chart == ChartKind::Parametric || attempt.chart == ChartKind::Affine;
    if (inParameters && hasTwoSheets(input))
      attempt.charts = surface_.makeCharts(ChartKind::MeanNormal);
    OptimizeOptions options;
    const RuleSet& rules = context_.algorithm.rules();
    if (rules.makesQuads()) options.closingRule = closingRule(rules);
    options.stop = context_.options.stop;
    optimizeMesh(attempt.result.mesh, boundaryOf(input), *attempt.charts, options);
    mesh.optimizeSeconds += watch.seconds();
  }

  static void take(MeshingResult& result, FaceBoundary& boundary, FaceMesh& mesh) {
    mesh.boundary = std::move(boundary.points);
    mesh.uses = std::move(boundary.uses);
    const auto& vertices = result.mesh.vertices;
    mesh.inside.reserve(vertices.size() - boundary.input.vertexCount);
    for (std::size_t i = boundary.input.vertexCount; i < vertices.size(); ++i)
      mesh.inside.push_back(vertices[i].position);
    mesh.elements = std::move(result.mesh.elements);
    mesh.rule = std::move(result.mesh.rule);
    mesh.report.elements = mesh.elements.size();
  }

  const FaceMeshingContext& context_;
  int face_;
  double area_, expected_;
  FaceSurface surface_;
};

void fail(FaceMesh& mesh, const std::string& reason) {
  mesh.report.status = FaceStatus::Failed;
  mesh.report.reason = reason;
}

}  // namespace

FaceMesh meshFace(const FaceMeshingContext& context, int face, double area,
                  double expectedElements) {
  FaceMesh mesh;
  const Stopwatch watch;
  const auto index = static_cast<std::size_t>(face) - 1;
  mesh.report.id = face;
  mesh.report.area = area;
  mesh.report.name = context.model.faceNames[index];
  mesh.report.surfaceType = context.model.surfaceTypes[index];
  try {
    FaceMesher(context, face, area, expectedElements).meshInto(mesh);
  } catch (const Standard_Failure& failure) {
    fail(mesh, std::string("OpenCASCADE: ") + failure.DynamicType()->Name());
  } catch (const std::exception& failure) {
    fail(mesh, failure.what());
  }
  mesh.report.seconds = watch.seconds();
  return mesh;
}

}  // namespace af2::geometry
