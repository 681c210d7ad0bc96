// The process that leads a crew.
#pragma once

#include <mutex>
#include <string>

#include "mpi/crew/crew.h"
#include "mpi/crew/task_board.h"
#include "mpi/crew/topics.h"

namespace af2::mpi {

class Crew::Leader final : public geometry::CrewLeader {
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
  std::uint64_t begin(std::span<const geometry::FaceTry> tries, std::span<const double> work,
                      const geometry::TakeMesh& take);
  void end();
  template <class... T>
  void tell(Order order, const T&... values);
  void answer(const Letter& letter);
  void takeResults(const Letter& letter);

  Post& post_;
  std::size_t threads_;
  TaskBoard board_;
  std::mutex mutex_;
  std::uint64_t round_ = 0;
  std::span<const geometry::FaceTry> tries_;
  const geometry::TakeMesh* take_ = nullptr;
};

}  // namespace af2::mpi
