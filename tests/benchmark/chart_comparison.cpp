// Meshes one face of each kind of surface through each kind of charts that it has, at sizes from
// coarse to fine against its curvature, and prints the table of docs/charts.md:
//   chart_comparison [SURFACE ...]
// Each line stands for ten sizes, a little apart. `failed`: how often the charts did not do and
// another kind had to be taken.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "dsl/load/rule_file.h"
#include "geometry/occ/run/mesh_model.h"
#include "result_line.h"
#include "spline_face.h"
#include "tests/geometry/occ/shapes.h"

namespace {

namespace geometry = af2::geometry;
using geometry::ChartKind;

/// A smooth curve: with x as given and the height that a function gives.
template <class Height>
TopoDS_Shape curve(double length, Height&& height) {
  constexpr int kPoints = 41;
  TColgp_Array1OfPnt points(1, kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double z = length * i / (kPoints - 1);
    points(i + 1) = gp_Pnt(height(z), 0, z);
  }
  return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve());
}

TopoDS_Shape vase() {
  const auto profile = curve(6, [](double z) { return 1.6 + 0.6 * std::sin(1.2 * z); });
  return BRepPrimAPI_MakeRevol(profile, gp_Ax1({0, 0, 0}, {0, 0, 1})).Shape();
}

TopoDS_Shape corrugation() {
  const auto profile = curve(10, [](double z) { return std::sin(z); });
  return BRepPrimAPI_MakePrism(profile, gp_Vec(0, 4, 0)).Shape();
}

struct Surface {
  std::string name;
  TopoDS_Shape shape;  ///< its face 1 is meshed; the least radius of curvature is about 1
  std::vector<ChartKind> others;  ///< charts that it has beside those that every surface has
};

std::vector<Surface> surfaces() {
  using enum ChartKind;
  return {{"cylinder", BRepPrimAPI_MakeCylinder(1, 5).Shape(), {Parametric, Affine, Developed}},
          {"cone", BRepPrimAPI_MakeCone(2, 0.5, 4).Shape(), {Parametric, Affine, Developed}},
          {"cone with tip", BRepPrimAPI_MakeCone(2, 0, 4).Shape(), {Parametric, Affine, Developed}},
          {"sphere", BRepPrimAPI_MakeSphere(1).Shape(), {Stereographic}},
          {"torus", BRepPrimAPI_MakeTorus(3, 1).Shape(), {Parametric, Affine, Conformal}},
          {"thick torus", BRepPrimAPI_MakeTorus(1.6, 1).Shape(), {Parametric, Affine, Conformal}},
          {"revolution", vase(), {Parametric, Affine, Conformal}},
          {"extrusion", corrugation(), {Parametric, Affine, Developed}},
          {"spline", af2::benchmark::splineFace(), {Parametric, Affine}}};
}

struct Sum {
  int failed = 0, runs = 0;
  double rawSeconds = 0, rawTriangles = 0, seconds = 0;
  std::vector<double> raw, finished;  // qualities
};

void addQualities(const geometry::ModelMesh& mesh, std::vector<double>& qualities) {
  const auto cornerOf = [&](af2::VertexId v) {
    const af2::Point3& p = mesh.vertices[v.value];
    return af2::benchmark::Corner{p.x, p.y, p.z};
  };
  for (const af2::Element& element : mesh.elements)
    qualities.push_back(af2::benchmark::triangleQuality(
        cornerOf(element.corners[0]), cornerOf(element.corners[1]), cornerOf(element.corners[2])));
}

class Comparison {
 public:
  explicit Comparison(const af2::AF2Algorithm& algorithm) : algorithm_(algorithm) {}

  void compare(const Surface& surface) const {
    const geometry::Model model = af2::testing::modelOf(surface.shape);
    std::vector<ChartKind> kinds{ChartKind::MeanNormal, ChartKind::NormalLines};
    kinds.insert(kinds.end(), surface.others.begin(), surface.others.end());
    for (const double size : {1.0, 0.7, 0.4, 0.05})
      for (const ChartKind kind : kinds) print(surface.name, size, kind, run(model, size, kind));
  }

 private:
  Sum run(const geometry::Model& model, double size, ChartKind kind) const {
    constexpr int kSizes = 10;
    Sum sum;
    for (int k = 0; k < kSizes; ++k) {
      geometry::MeshingOptions options;
      options.sizes.size = size * (1 + 0.013 * k);
      options.threads = 1;
      options.faces = {1};
      options.chart = kind;
      const auto finished = meshed(model, options, sum.seconds);
      options.optimize = false;
      const auto raw = meshed(model, options, sum.rawSeconds);
      ++sum.runs;
      sum.rawTriangles += static_cast<double>(raw.elements.size());
      const geometry::FaceReport& report = finished.faces.front();
      if (report.chart != toString(kind) || !report.attempts.empty() ||
          report.status != geometry::FaceStatus::Complete)
        ++sum.failed;
      addQualities(finished, sum.finished);
      addQualities(raw, sum.raw);
    }
    return sum;
  }

  geometry::ModelMesh meshed(const geometry::Model& model, const geometry::MeshingOptions& options,
                             double& seconds) const {
    const double start = af2::benchmark::userSeconds();
    geometry::TurnLimits none;
    none.faceTurn = none.edgeTurn = 1e3;  // the size alone counts
    auto mesh = geometry::meshModel(model, algorithm_, options, none);
    seconds += af2::benchmark::userSeconds() - start;
    return mesh;
  }

  static void print(const std::string& surface, double size, ChartKind kind, Sum sum) {
    std::ranges::sort(sum.finished);
    double mean = 0;
    for (const double quality : sum.finished) mean += quality;
    mean /= static_cast<double>(sum.finished.size());
    std::printf("| %s | %g | `%s` | %.0f | %.0f | %.0f | %.3f | %.3f | %.4f | %d |\n",
                surface.c_str(), size, toString(kind), sum.rawTriangles / sum.runs,
                1e9 * sum.rawSeconds / sum.rawTriangles, 1e9 * sum.seconds / sum.rawTriangles,
                sum.finished.front(), sum.finished[sum.finished.size() / 100], mean, sum.failed);
    std::fflush(stdout);
  }

  const af2::AF2Algorithm& algorithm_;
};

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  af2::dsl::LoadOptions loading;
  loading.searchPaths = {AF2_SOURCE_RULES};
  const auto loaded = af2::dsl::loadRules(AF2_SOURCE_RULES "/tri/even.af2", loading);
  if (!loaded.rules) return 1;
  const af2::AF2Algorithm algorithm(loaded.rules);
  const Comparison comparison(algorithm);
  std::printf(
      "| surface | size / radius | charts | triangles | ns per triangle, raw | finished | min | "
      "1st "
      "percentile | mean | failed of 10 |\n|---|---|---|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Surface& surface : surfaces())
    if (wanted.empty() || std::ranges::find(wanted, surface.name) != wanted.end())
      comparison.compare(surface);
  return 0;
}
