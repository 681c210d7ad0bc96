// The process that leads a crew.
#pragma once

#include <deque>
#include <mutex>
#include <string>

#include "geometry/mpi/crew/kept_faces.h"
#include "geometry/mpi/crew/process.h"
#include "geometry/mpi/crew/task_board.h"
#include "geometry/mpi/crew/topics.h"
#include "geometry/mpi/crew/workers.h"

namespace af2::mpi {

class Process::Leader final : public geometry::CrewLeader, private TaskSource {
 public:
  Leader(Post& post, std::size_t threads);

  void beginRun(const geometry::RunChange& change) override;
  void meshAll(const geometry::FaceRound& round, std::span<const geometry::FaceTry> tries,
               std::span<const double> work, const geometry::MeshTry& mesh,
               const geometry::TakeMesh& take) override;
  void endRun() override;
  void endModel(const geometry::ModelMesh& mesh) override;
  void waitForDone(int processes) { board_.waitForDone(processes); }
  void stop(const std::string& reason, int code);

 private:
  /// A thread of another process that waits for a task.
  struct Waiting {
    int process = 0;
    std::uint64_t slot = 0, round = 0;
  };

  Task nextTask(std::size_t slot) override;
  void giveUp(const std::string& reason) override;
  void finish(std::vector<NumberedMesh> meshes) override;
  void offer(const RegionKey& region, const std::vector<double>& work) override;
  std::optional<std::size_t> nextPiece(const RegionKey& region, std::size_t slot,
                                       bool isInvited) override;
  void deliver(int owner, const RegionKey& region, std::size_t piece,
               const RegionMesh& mesh) override;

  void begin(const geometry::TakeMesh& take, std::uint64_t round);
  void end();
  template <class... T>
  void tell(Order order, const T&... values);
  void handleLetters();
  void takeMeshes(const Letter& letter);
  void answerWaiting();

  Post& post_;
  TaskBoard board_;
  Workers workers_;
  FaceFetcher fetcher_;
  std::mutex mutex_;
  std::deque<Waiting> waiting_;
  std::uint64_t round_ = 0;
  const geometry::TakeMesh* take_ = nullptr;
};

}  // namespace af2::mpi
