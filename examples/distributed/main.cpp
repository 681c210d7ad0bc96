// Meshes a CAD model in all processes of an MPI run. Each gets its part of the mesh and sums over
// the elements at its vertices, as solvers do: ghosts are among them.
#include <af2/dsl/rule_file.h>
#include <af2/engine/algorithm.h>
#include <af2/geometry/mesh_model.h>
#include <af2/mpi/crew.h>
#include <af2/mpi/owned_part.h>
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace {

double areaOf(const af2::mpi::OwnedPart& part, const af2::Element& element) {
  const auto at = [&](std::size_t i) { return part.vertices[element.corners[i].value]; };
  return length(cross(at(1) - at(0), at(2) - at(0))) / 2;
}

/// A third of the area of the triangles around each own vertex: right without a message, because a
/// part has all elements around its vertices.
double areaAtOwnVertices(const af2::mpi::OwnedPart& part) {
  double sum = 0;
  for (const af2::Element& element : part.elements)
    for (const af2::VertexId v : element.vertices())
      if (v.value < part.ownedVertices) sum += areaOf(part, element) / 3;
  return sum;
}

double areaOfOwnElements(const af2::mpi::OwnedPart& part) {
  double sum = 0;
  for (std::size_t e = 0; e < part.ownedElements; ++e) sum += areaOf(part, part.elements[e]);
  return sum;
}

int run(const char* file, double size) {
  const af2::dsl::LoadedRules loaded = af2::dsl::loadRules(RULES);
  const af2::AF2Algorithm algorithm(loaded.rules);
  af2::geometry::MeshingOptions options;
  options.sizes.size = size;
  options.threads = 1;
  af2::mpi::OwnedPart part;
  {
    af2::mpi::Crew crew(MPI_COMM_WORLD, options.threads);
    options.crew = crew.faces();
    using Spool =
        af2::geometry::SpoolRequest;  // faces stay with the processes that have meshed them
    options.spool = {Spool::When::Always, {}, Spool::Where::Memory};
    const af2::geometry::ModelMesh mesh =
        meshModel(af2::geometry::readModel(file), algorithm, options);
    part = distribute(crew, mesh, {});
  }
  double own[2] = {areaAtOwnVertices(part), areaOfOwnElements(part)}, all[2];
  MPI_Allreduce(own, all, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  std::printf("rank %d of %d: %zu of %llu elements and %zu ghosts\n", part.process, part.processes,
              part.ownedElements, static_cast<unsigned long long>(part.allElements),
              part.elements.size() - part.ownedElements);
  if (part.process == 0) std::printf("area %.6g by vertices, %.6g by elements\n", all[0], all[1]);
  return std::abs(all[0] - all[1]) < 1e-9 * all[1] ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int count, char** arguments) {
  int level = 0, code = EXIT_FAILURE;
  MPI_Init_thread(&count, &arguments, MPI_THREAD_SERIALIZED, &level);
  try {
    if (count == 3)
      code = run(arguments[1], std::atof(arguments[2]));
    else
      std::fputs("usage: mpirun -n RANKS distributed MODEL SIZE\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "distributed: %s\n", error.what());
  }
  MPI_Finalize();
  return code;
}
