// Meshes a torus with rules from a file: torus RULES.af2 SIZE OUTPUT
#include <cstdio>
#include <cstdlib>
#include <exception>

#include <af2/dsl/rule_file.h>
#include <af2/engine/algorithm.h>
#include <af2/engine/error.h>
#include <af2/engine/mesh_check.h>
#include <af2/geometry/mesh_files.h>
#include "torus.h"

namespace {

/// AF2's mesh files hold the mesh of a model; here the model has one face.
af2::geometry::ModelMesh asModelMesh(const af2::Mesh& mesh, const af2::RuleSet& rules) {
  af2::geometry::ModelMesh result;
  for (const af2::SurfacePoint& vertex : mesh.vertices) result.vertices.push_back(vertex.position);
  result.elements = mesh.elements;
  result.face.assign(mesh.elements.size(), 1);
  result.origins = mesh.origins;
  for (const af2::AF2Rule& rule : rules.rules()) result.ruleNames.push_back(rule.name());
  return result;
}

int run(const char* ruleFile, double size, const char* output) {
  const af2::dsl::LoadedRules loaded = af2::dsl::loadRules(ruleFile);
  if (!loaded.rules) throw af2::InputError(af2::dsl::toPretty(loaded.diagnostics));
  const Torus torus;
  const af2::FrontInput boundary = cutOpen(torus, size);
  const af2::AF2Algorithm algorithm(loaded.rules);
  const af2::MeshingResult result =
      algorithm.execute(TorusChartMaker(torus), boundary, af2::UniformSize(size));

  const auto faults = af2::checkMesh(result.mesh, boundary);
  for (const auto& fault : faults) {
    std::fprintf(stderr, "%s\n", af2::describe(fault, result.mesh).c_str());
  }
  if (result.outcome != af2::Outcome::Complete || !faults.empty()) return 1;
  af2::geometry::writeMesh(asModelMesh(result.mesh, *loaded.rules), output);
  std::printf("%zu vertices, %zu elements\n", result.mesh.vertices.size(),
              result.mesh.elements.size());
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fprintf(stderr, "usage: torus RULES.af2 SIZE OUTPUT\n");
    return 2;
  }
  try {
    return run(arguments[1], std::atof(arguments[2]), arguments[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
