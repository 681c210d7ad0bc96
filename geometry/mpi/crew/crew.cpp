#include "geometry/mpi/crew/crew.h"

#include "geometry/mpi/crew/process.h"

namespace af2::mpi {

Crew::Crew(MPI_Comm processes, int threads)
    : process_(std::make_unique<Process>(processes, threads)) {}
Crew::~Crew() = default;

geometry::FaceCrew* Crew::faces() { return process_.get(); }

}  // namespace af2::mpi
