// Meshes a CAD file with Netgen, for comparison:
//   netgen_driver MODEL SIZE              the raw front at one uniform size
//   netgen_driver MODEL SIZE N FILE.obj   as it is by default, with N elements around a full turn
// A program of its own, so that nothing of AF2 is linked with Netgen.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "result_line.h"

#define OCCGEOMETRY
namespace nglib {
#include <nglib.h>
}

namespace {

/// The front alone, at one size everywhere: no refinement at curves, no optimisation.
nglib::Ng_Meshing_Parameters rawFront(double size) {
  nglib::Ng_Meshing_Parameters parameters;
  parameters.uselocalh = 0;
  parameters.maxh = parameters.minh = size;
  parameters.grading = 0.9;
  parameters.elementsperedge = parameters.elementspercurve = 1e-3;
  parameters.optsurfmeshenable = 0;
  parameters.optsteps_2d = 0;
  return parameters;
}

nglib::Ng_Meshing_Parameters byDefault(double size, double elementsPerTurn) {
  constexpr double kTurn = 6.283185307179586;
  nglib::Ng_Meshing_Parameters parameters;
  parameters.maxh = size;
  parameters.elementspercurve = elementsPerTurn / kTurn;  // per radius of curvature
  return parameters;
}

nglib::Ng_OCC_Geometry* load(const std::string& path) {
  if (path.ends_with(".brep")) return nglib::Ng_OCC_Load_BREP(path.c_str());
  if (path.ends_with(".iges") || path.ends_with(".igs"))
    return nglib::Ng_OCC_Load_IGES(path.c_str());
  return nglib::Ng_OCC_Load_STEP(path.c_str());
}

void writeObj(const char* path, nglib::Ng_Mesh* mesh) {
  std::FILE* const file = std::fopen(path, "w");
  if (!file) return;
  for (int i = 1; i <= nglib::Ng_GetNP(mesh); ++i) {
    double p[3];
    nglib::Ng_GetPoint(mesh, i, p);
    std::fprintf(file, "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
  }
  for (int i = 1; i <= nglib::Ng_GetNSE(mesh); ++i) {
    int vertices[NG_SURFACE_ELEMENT_MAXPOINTS];
    nglib::Ng_GetSurfaceElement(mesh, i, vertices);
    std::fprintf(file, "f %d %d %d\n", vertices[0], vertices[1], vertices[2]);
  }
  std::fclose(file);
}

std::vector<double> qualitiesOf(nglib::Ng_Mesh* mesh) {
  std::vector<double> qualities;
  for (int i = 1; i <= nglib::Ng_GetNSE(mesh); ++i) {
    int vertices[NG_SURFACE_ELEMENT_MAXPOINTS];
    nglib::Ng_GetSurfaceElement(mesh, i, vertices);
    af2::benchmark::Corner corners[3];
    for (int k = 0; k < 3; ++k) nglib::Ng_GetPoint(mesh, vertices[k], corners[k].data());
    qualities.push_back(af2::benchmark::triangleQuality(corners[0], corners[1], corners[2]));
  }
  return qualities;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 5) {
    std::fprintf(stderr, "usage: netgen_driver MODEL SIZE [N FILE.obj]\n");
    return 2;
  }
  // Netgen reports its progress on standard output: keep that for the result.
  std::FILE* const result = fdopen(dup(STDOUT_FILENO), "w");
  std::freopen("/dev/null", "w", stdout);
  nglib::Ng_Init();
  nglib::Ng_OCC_Geometry* geometry = load(argv[1]);
  if (!geometry) return 1;
  nglib::Ng_Mesh* mesh = nglib::Ng_NewMesh();
  nglib::Ng_Meshing_Parameters parameters =
      argc == 3 ? rawFront(std::atof(argv[2])) : byDefault(std::atof(argv[2]), std::atof(argv[3]));

  const double start = af2::benchmark::userSeconds();
  nglib::Ng_OCC_SetLocalMeshSize(geometry, mesh, &parameters);
  nglib::Ng_OCC_GenerateEdgeMesh(geometry, mesh, &parameters);
  const nglib::Ng_Result status = nglib::Ng_OCC_GenerateSurfaceMesh(geometry, mesh, &parameters);
  const double seconds = af2::benchmark::userSeconds() - start;

  if (status != nglib::NG_OK) return 3;
  if (argc == 5) writeObj(argv[4], mesh);
  af2::benchmark::printResult(result, seconds, qualitiesOf(mesh));
  std::fclose(result);
  // Netgen's clean-up at exit is not part of the measure, and not always safe.
  std::_Exit(0);
}
