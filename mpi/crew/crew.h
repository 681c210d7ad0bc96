// The processes of an MPI run as a crew that meshes the faces of a model together.
#pragma once

#include <memory>
#include <string>

#include "engine/base/error.h"
#include "geometry/meshing/face_crew.h"
#include "mpi/messages/post.h"

namespace af2::mpi {

enum class Order;

/// The leader has ended the run.
struct RunStopped : InputError {
  RunStopped(const std::string& reason, int code) : InputError(reason), exitCode(code) {}
  int exitCode;
};

/// The crew of a communicator, in which the process of rank 0 leads. Use it as the `crew` of
/// `MeshingOptions`: then `meshModel` and its like return the mesh of the whole model on rank 0,
/// and on other ranks the reports of its faces without vertices and elements.
///
/// All processes make their crew at the same time, mesh the same models with the same options, and
/// give up the crew at the same time; between, MPI must not be called for anything else. If one of
/// them throws, the others throw InputError with its reason when they next wait for it.
class Crew final : public geometry::FaceCrew {
 public:
  /// threads  that mesh faces in this process. All processes should have as many.
  ///
  /// Throws InputError if MPI was not started by `MPI_Init_thread` with MPI_THREAD_SERIALIZED.
  Crew(MPI_Comm processes, int threads);
  ~Crew() override;

  geometry::CrewLeader* leader() override;
  geometry::CrewFollower* follower() override;
  Post& post() { return post_; }

  /// The leader: sends an order, with what belongs to it, to one process or to all.
  void order(int process, Order order, Bytes bytes);
  void orderAll(Order order, Bytes bytes);
  /// The leader: waits until as many more processes have done what they were told. Throws
  /// InputError if one has given up.
  void waitForDone(int processes);

  /// Another process: waits for an order. Returns what belongs to it. Throws RunStopped if the
  /// leader ends the run.
  Bytes waitFor(Order order);
  /// Another process: has done what it was told.
  void done();

  /// The leader: ends the run of all others with an exit code.
  void stop(const std::string& reason, int code);
  /// Another process: tells the leader why this one cannot go on.
  void giveUp(const std::string& reason);
  /// Another process: waits until the leader ends the run. Returns the exit code.
  int waitForStop();

 private:
  class Leader;
  class Follower;
  std::unique_ptr<Leader> leader_;
  std::unique_ptr<Follower> follower_;
  Post post_;  // goes first, because its thread uses the others
};

}  // namespace af2::mpi
