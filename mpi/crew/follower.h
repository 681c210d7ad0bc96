// A process of a crew that does not lead.
#pragma once

#include <vector>

#include "mpi/crew/crew.h"
#include "mpi/crew/numbered_try.h"
#include "mpi/crew/topics.h"

namespace af2::mpi {

class Crew::Follower final : public geometry::CrewFollower {
 public:
  Follower(Post& post, std::size_t threads) : post_(post), threads_(threads) {}

  std::optional<geometry::RunChange> nextRun() override;
  std::optional<geometry::FaceRound> nextRound() override;
  void help(const geometry::MeshTry& mesh) override;
  geometry::ModelMesh reports() override;
  Bytes waitFor(Order order);
  int waitForStop();

 private:
  std::vector<NumberedTry> nextTries();

  Post& post_;
  std::size_t threads_;
  std::uint64_t round_ = 0;
  geometry::DividedEdges divided_;
  geometry::ModelMesh reports_;
};

}  // namespace af2::mpi
