// Meshes a STEP file with Netgen at one uniform size, for comparison:
//   netgen_driver MODEL SIZE
// A program of its own, so that nothing of AF2 is linked with Netgen.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
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
  if (argc != 3) {
    std::fprintf(stderr, "usage: netgen_driver MODEL.step SIZE\n");
    return 2;
  }
  // Netgen reports its progress on standard output: keep that for the result.
  std::FILE* const result = fdopen(dup(STDOUT_FILENO), "w");
  std::freopen("/dev/null", "w", stdout);
  nglib::Ng_Init();
  nglib::Ng_OCC_Geometry* geometry = nglib::Ng_OCC_Load_STEP(argv[1]);
  if (!geometry) return 1;
  nglib::Ng_Mesh* mesh = nglib::Ng_NewMesh();
  nglib::Ng_Meshing_Parameters parameters = rawFront(std::atof(argv[2]));

  const double start = af2::benchmark::userSeconds();
  nglib::Ng_OCC_SetLocalMeshSize(geometry, mesh, &parameters);
  nglib::Ng_OCC_GenerateEdgeMesh(geometry, mesh, &parameters);
  const nglib::Ng_Result status = nglib::Ng_OCC_GenerateSurfaceMesh(geometry, mesh, &parameters);
  const double seconds = af2::benchmark::userSeconds() - start;

  if (status != nglib::NG_OK) return 3;
  af2::benchmark::printResult(result, seconds, qualitiesOf(mesh));
  std::fclose(result);
  // Netgen's clean-up at exit is not part of the measure, and not always safe.
  std::_Exit(0);
}
