// The processes of an MPI run that mesh a model together.
#pragma once

#include <mpi.h>

#include <memory>
#include <string>

#include "engine/base/error.h"

namespace af2::geometry {
class FaceCrew;
}

namespace af2::mpi {

class Process;

/// The leader has ended the run.
struct RunStopped : InputError {
  RunStopped(const std::string& reason, int code) : InputError(reason), exitCode(code) {}
  int exitCode;
};

/// The processes of a communicator. Give `faces` to `MeshingOptions::crew`: then `meshModel` and
/// its like return the mesh of the whole model on rank 0, with the same bits as without a crew, and
/// on other ranks the reports of its faces without vertices and elements. With
/// `MeshingOptions::spool`, which counts on rank 0 only, but for the folder, faces stay with the
/// processes that have meshed them. `distribute` gives each process its part.
///
/// All processes make their crew at the same time, mesh the same models with the same options, and
/// give up the crew at the same time; between, MPI must not be called for anything else. If one of
/// them throws, the others throw InputError when they next wait for it.
class Crew {
 public:
  /// threads  that mesh faces in this process. All processes should have as many.
  ///
  /// Throws InputError unless MPI was started by `MPI_Init_thread` with MPI_THREAD_SERIALIZED or
  /// more.
  Crew(MPI_Comm processes, int threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  geometry::FaceCrew* faces();
  Process& process() { return *process_; }

 private:
  std::unique_ptr<Process> process_;
};

}  // namespace af2::mpi
