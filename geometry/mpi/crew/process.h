// A process of a crew, behind crew.h.
#pragma once

#include <memory>
#include <string>

#include "geometry/meshing/face_crew.h"
#include "geometry/mpi/crew/crew.h"
#include "geometry/mpi/messages/post.h"

namespace af2::mpi {

enum class Order;

/// This process as one of a crew, which either leads or follows.
class Process final : public geometry::FaceCrew {
 public:
  Process(MPI_Comm processes, int threads);
  ~Process() override;

  geometry::CrewLeader* leader() override;
  geometry::CrewFollower* follower() override;
  Post& post() { return post_; }

  /// The leader: sends an order, with what belongs to it, to one process or to all. What goes to
  /// one may overtake what went to all before, and the other way round.
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
