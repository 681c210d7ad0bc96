#include "geometry/occ/faces/face_mesher.h"

#include <BRep_Tool.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "engine/surface/plane_chart.h"
#include "geometry/base/constants.h"
#include "geometry/charts/conformal_chart.h"
#include "geometry/charts/laid_out.h"
#include "geometry/fill/face_filling.h"
#include "geometry/layers/leave_out_layers.h"
#include "geometry/mesh/face_parts.h"
#include "geometry/mesh/fans.h"
#include "geometry/mesh/sharp_seams.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/edges/edge_samples.h"
#include "geometry/occ/edges/tip_fans.h"
#include "geometry/occ/edges/touching_edges.h"
#include "geometry/occ/faces/face_area.h"
#include "geometry/occ/faces/face_loops.h"
#include "geometry/occ/faces/most_area.h"
#include "geometry/occ/faces/surface_faults.h"
#include "geometry/occ/sizes/face_size.h"
#include "geometry/occ/sizes/sizing.h"
#include "geometry/occ/surfaces/surface_distance.h"
#include "geometry/sizes/graded_size.h"

namespace af2::geometry {

namespace {

/// Nothing if there are none.
void noteCollapsed(const char* why, const std::vector<int>& edges, FaceHistory& history) {
  constexpr std::size_t kMaxNamed = 5;
  if (edges.empty()) return;
  std::string ids;
  for (std::size_t i = 0; i < std::min(edges.size(), kMaxNamed); ++i)
    ids += (i > 0 ? ", " : "") + std::to_string(edges[i]);
  if (edges.size() > kMaxNamed) ids += " and " + std::to_string(edges.size() - kMaxNamed) + " more";
  history.push_back(note(std::string(why) + ": edges " + ids));
}

std::string textOfTouching(const FaceBoundary::TouchingEdges& edges) {
  char gap[32];
  std::snprintf(gap, sizeof gap, "%.2g", edges.gap);
  return "edges " + std::to_string(edges.one) + " and " + std::to_string(edges.other) +
         " coincide within " + gap + ": there the face has no width";
}

std::string textOfLying(const FaceOnFace& lying) {
  const std::string under = "face " + std::to_string(lying.under);
  return lying.isDouble() ? "is " + under + " again, so it has no elements"
                          : "lies on " + under + ", folded back, so it has no elements";
}

std::string textOfCells(const FaceCells& cells) {
  std::string text = "turns sharply inside, so there are vertices along";
  const auto add = [&](const std::vector<Stretch>& stretches, const char* name) {
    for (std::size_t k = 1; k < stretches.size(); ++k) {
      char value[48];
      std::snprintf(value, sizeof value, " %s = %.6g,", name, stretches[k].low);
      text += value;
    }
  };
  add(cells.u, "u");
  add(cells.v, "v");
  text.pop_back();
  return text;
}

constexpr const char* kVanished =
    "is smaller than any element, so it has none: all its edges were collapsed to points";
constexpr const char* kWithoutWidth =
    "has no width, so it has no elements: its boundary runs back on itself";

constexpr const char* kIsLine = "is a line, without area, so it has no elements";

class FaceMesher {
 public:
  FaceMesher(const FaceMeshingContext& context, int face, double area, double expectedElements)
      : context_(context),
        face_(face),
        area_(area),
        expected_(expectedElements),
        surface_(context.model.surface(face)),
        original_(surface_) {}

  /// Of one cell of a face with creases.
  FaceMesher(const FaceMeshingContext& context, int face, double area, FaceSurface surface)
      : context_(context),
        face_(face),
        area_(area),
        expected_(area > 0 ? geometry::expectedElements(context.sizes, face, surface, area) : 1),
        surface_(std::move(surface)),
        original_(surface_) {}

  void meshInto(FaceMesh& mesh) {
    const auto lying = std::ranges::find(context_.onFaces, face_, &FaceOnFace::face);
    if (lying != context_.onFaces.end()) {
      mesh.report.reason = textOfLying(*lying);
      return;
    }
    if (hasNoArea()) {
      mesh.report.area = 0;
      mesh.report.reason = kIsLine;
      return;
    }
    if (meshInCells(mesh)) return;
    fill(wholeBoundary(), mesh);
  }

  std::optional<FaceOutline> outline() {
    if (liesOnAnother() || hasNoArea() || context_.layers || context_.model.cells.contains(face_) ||
        context_.request.limits.ignoresNormals)
      return std::nullopt;
    FaceBoundary boundary = wholeBoundary();
    leaveOutFans(surface_, fanElementsFor(context_.request.options.quads), boundary);
    if (!isPlain(boundary)) return std::nullopt;
    const CadSizes& sizes = context_.sizes;
    FaceOutline outline;
    outline.numbers = {wantedOnFace(sizes, face_), chordOnFace(sizes, face_),
                       sizes.roughFaces.contains(face_) + 0., boundary.closedInParameters + 0.,
                       boundary.canBeCut + 0.};
    if (surface_.isGeneral())
      outline.samples = samples();
    else
      outline.distance = distanceFrom(boundary.input.loops.front().front().point);
    addHistory(boundary, outline.history);
    outline.form = formOf(std::move(boundary.input));
    outline.points = std::move(boundary.points);
    outline.uses = std::move(boundary.uses);
    outline.sizes = sizes.function;
    return outline;
  }

 private:
  bool liesOnAnother() const {
    return std::ranges::find(context_.onFaces, face_, &FaceOnFace::face) != context_.onFaces.end();
  }

  FaceBoundary wholeBoundary() const {
    return findBoundary(context_.model, face_, context_.request.divided, surface_,
                        context_.onFaces);
  }

  /// Of the part of the parameters that the face takes up.
  std::vector<Point3> samples() const {
    constexpr int kSteps = 16;
    const SplineSurface::Box& box = surface_.box();
    std::vector<Point3> places;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; j <= kSteps; ++j) {
        const double u = box.u1 + (box.u2 - box.u1) * i / kSteps;
        const double v = box.v1 + (box.v2 - box.v1) * j / kSteps;
        places.push_back(surface_.inOccParameters().frameAt(u, v).position);
      }
    return places;
  }

  /// place  of the boundary
  std::function<double(const Point3&)> distanceFrom(const SurfacePoint& place) const {
    if (surface_.isPlane())
      return [place](const Point3& p) { return std::abs(dot(p - place.position, place.normal)); };
    return
        [distance = std::shared_ptr<FaceDistance>(distanceFromSurface(
             context_.model.face(face_), surface_))](const Point3& p) { return distance->of(p); };
  }

  bool hasNoArea() const {
    constexpr double kAlmostNone = 1e-6;  // of the square of the size
    const double size = context_.sizes.size;
    return area_ < kAlmostNone * size * size && isLine(TopoDS::Face(context_.model.face(face_)));
  }

  /// Cell by cell, if the face has creases that are edges all through it.
  bool meshInCells(FaceMesh& mesh) const {
    std::vector<BoundedCell> cells =
        boundedCells(context_.model, face_, context_.request.divided, context_.onFaces);
    if (cells.empty()) return false;
    const FaceCells& stretches = context_.model.cells.at(face_);
    std::vector<FaceMesh> parts;
    for (BoundedCell& cell : cells) {
      const Stretch &u = stretches.u[cell.id.u], &v = stretches.v[cell.id.v];
      const double area = area_ > 0 ? areaOf(context_.model, face_, u, v) : 0;
      FaceMesher(context_, face_, area, FaceSurface::ofCell(context_.model.face(face_), u, v))
          .fillOrFail(std::move(cell.boundary), parts.emplace_back());
    }
    for (FaceMesh& part : parts) part.report.area = 0;  // of the face it is known
    joinParts(std::move(parts), mesh);
    mesh.history.insert(mesh.history.begin(), note(textOfCells(stretches)));
    return true;
  }

  void fillOrFail(FaceBoundary boundary, FaceMesh& mesh) {
    try {
      fill(std::move(boundary), mesh);
    } catch (const GeometryError& failure) {
      failFor(failure.what(), mesh);
    }
  }

  void addHistory(const FaceBoundary& boundary, FaceHistory& history) const {
    addNotes(boundary.repairs, history);
    addNotes(boundary.notes, history);
    noteCollapsed(boundary.pointEdges, history);
  }

  void fill(FaceBoundary boundary, FaceMesh& mesh) {
    leaveOutFans(surface_, fanElementsFor(context_.request.options.quads), boundary);
    addHistory(boundary, mesh.history);
    double closed = 0;  // area between edges that are one
    for (const FaceBoundary::TouchingEdges& edges : boundary.touching) {
      mesh.history.push_back(note(textOfTouching(edges)));
      closed += edges.gap * edges.length;
    }
    if (boundary.input.loops.empty()) {
      mesh.hasVanished = boundary.uses.empty() && areAllEdgesPoints();
      if (mesh.hasVanished || area_ <= mostWithoutWidth())
        mesh.report.area = 0;  // nothing is to be compared with it
      mesh.report.reason = mesh.hasVanished ? kVanished : kWithoutWidth;
      return;
    }
    if (context_.layers)
      leaveOutLayers(surface_, placeInParametersOf(surface_), *context_.layers,
                     context_.request.divided, stepsFor(context_.request.options.quads), boundary);
    const bool hasLayers = boundary.layers && !boundary.layers->elements.empty();
    if (context_.request.limits.ignoresNormals && !hasLayers)
      partSeams(boundary.input, boundary.points);
    constexpr double kMaxClosed = 0.05;  // of the area
    if (!boundary.repairs.empty() || closed > kMaxClosed * area_)
      mesh.report.area = area_ = 0;  // was found with the old boundary
    const double ready = areaOfFans(boundary) + (boundary.layers ? boundary.layers->area : 0);
    const double toFill = area_ > 0 ? area_ - ready : 0;
    const FillRequest& request = context_.request;
    const FaceSize wanted(context_.sizes, face_, surface_);
    const GradedSize size(wanted, boundary.input, context_.sizes.growth);
    const std::function<PieceTools(ChartKind)> tools = [&](ChartKind kind) {
      return makeTools(size, kind);
    };
    const FaceTask task{surface_,
                        boundary,
                        size,
                        toFill,
                        area_ > 0 ? expected_ : mostElements(boundary.input),
                        request.algorithm,
                        request.options,
                        context_.finer,
                        request.limits,
                        request.progress,
                        tools,
                        false,
                        ready};
    const UngradedSize ungraded(size);
    FaceFilling filling{task, ungraded, kUnseen * wantedOnFace(context_.sizes, face_),
                        request.findMiddles};
    filling.findParameters = [&](std::vector<StuckPlace>& places) { findParameters(places); };
    filling.least = [&](const SurfacePoint& point) { return wanted.leastAt(point); };
    filling.makeWanted = [&] {
      return std::make_shared<const OwnWanted>(context_, face_, original_, size);
    };
    fillAndJudge(filling, boundary, mesh);
  }

  /// What edges may enclose that count as one.
  double mostWithoutWidth() const {
    const DividedEdges& divided = context_.request.divided;
    double both = 0;
    for (const EdgeUse& use : context_.model.edgesOfFaces[static_cast<std::size_t>(face_) - 1]) {
      const DividedEdge& edge = divided.edges[static_cast<std::size_t>(use.id) - 1];
      for (std::size_t i = 1; i < edge.points.size(); ++i)
        both += edge.wanted *
                distance(divided.points[edge.points[i - 1]], divided.points[edge.points[i]]);
    }
    return 0.5 * kMaxBetweenTouching * both;
  }

  bool areAllEdgesPoints() const {
    return std::ranges::all_of(
        context_.model.edgesOfFaces[static_cast<std::size_t>(face_) - 1], [&](const EdgeUse& use) {
          return context_.request.divided.edges[static_cast<std::size_t>(use.id) - 1]
              .points.empty();
        });
  }

  void noteCollapsed(std::vector<int> edges, FaceHistory& history) const {
    const auto asked = std::ranges::stable_partition(edges, [&](int edge) {
      return !context_.request.divided.edges[static_cast<std::size_t>(edge) - 1].point;
    });
    geometry::noteCollapsed("too short to be visible in the mesh, so collapsed to points",
                            {edges.begin(), asked.begin()}, history);
    geometry::noteCollapsed("short, and collapsed to points because a face there failed with them",
                            {asked.begin(), edges.end()}, history);
  }

  /// Vertices inside quadrics, and those of faces laid out, do not keep the parameters of the file.
  void findParameters(std::vector<StuckPlace>& places) const {
    const TopoDS_Face face = TopoDS::Face(context_.model.face(face_));
    ShapeAnalysis_Surface surface(BRep_Tool::Surface(face));
    for (StuckPlace& place : places) {
      const gp_Pnt2d uv = surface.ValueOfUV(toOcc(place.from), BRep_Tool::Tolerance(face));
      place.u = uv.X();
      place.v = uv.Y();
    }
  }

  /// For a face whose area is not known.
  double mostElements(const FrontInput& input) const {
    return geometry::expectedElements(context_.sizes, face_, surface_,
                                      mostArea(context_.model.face(face_), surface_, input));
  }

  /// The sizes before they are graded, with a surface of their own: OpenCASCADE's evaluators are
  /// not to be shared.
  struct OwnWanted final : SizeField {
    OwnWanted(const FaceMeshingContext& context, int face, const FaceSurface& original,
              const GradedSize& size)
        : surface(original), wanted(context.sizes, face, surface), graded(wanted, size) {}
    double sizeAt(const SurfacePoint& point) const override { return graded.ungradedAt(point); }

    FaceSurface surface;
    FaceSize wanted;
    GradedSize graded;
  };

  struct OwnSize final : SizeField {
    OwnSize(const FaceMeshingContext& context, int face, const FaceSurface& original,
            const GradedSize& size, ChartKind kind)
        : own(context, face, original, size), map(own.surface.makePlaneMap(kind)) {
      if (map) laidOut.emplace(own.graded, *map);
    }
    double sizeAt(const SurfacePoint& point) const override {
      return laidOut ? laidOut->sizeAt(point) : own.graded.sizeAt(point);
    }

    OwnWanted own;
    std::unique_ptr<PlaneMap> map;  ///< null: charts see the surface itself
    std::optional<LaidOutSize> laidOut;
  };

  PieceTools makeTools(const GradedSize& graded, ChartKind kind) const {
    auto size = std::make_shared<const OwnSize>(context_, face_, original_, graded, kind);
    if (size->map && kind == ChartKind::Conformal)
      return {std::make_unique<ConformalChartMaker>(*size->map), std::move(size)};
    if (size->map) return {std::make_unique<PlaneChartMaker>(), std::move(size)};
    auto charts = size->own.surface.makeCharts(kind);
    return {std::move(charts), std::move(size)};
  }

  const FaceMeshingContext& context_;
  int face_;
  double area_, expected_;
  FaceSurface surface_;
  const FaceSurface original_;  ///< only to be copied, by any thread
};

}  // namespace

void meshFace(const FaceMeshingContext& context, int face, double area, double expectedElements,
              FaceMesh& mesh) {
  try {
    FaceMesher(context, face, area, expectedElements).meshInto(mesh);
  } catch (const Standard_Failure& failure) {
    throw GeometryError(std::string("OpenCASCADE: ") + failure.DynamicType()->Name());
  }
}

std::optional<FaceOutline> outlineOf(const FaceMeshingContext& context, int face, double area) {
  try {
    return FaceMesher(context, face, area, 1).outline();
  } catch (const GeometryError&) {  // reported when the face is meshed
  } catch (const Standard_Failure&) {
  }
  return std::nullopt;
}

}  // namespace af2::geometry
