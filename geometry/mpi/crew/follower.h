// A process of a crew that does not lead.
#pragma once

#include "geometry/mpi/crew/kept_faces.h"
#include "geometry/mpi/crew/process.h"
#include "geometry/mpi/crew/topics.h"
#include "geometry/mpi/crew/workers.h"

namespace af2::mpi {

class Process::Follower final : public geometry::CrewFollower, private TaskSource {
 public:
  Follower(Post& post, std::size_t threads);

  std::optional<geometry::RunChange> nextRun() override;
  std::optional<geometry::FaceRound> nextRound() override;
  void help(const geometry::MeshTry& mesh, const geometry::KeepMesh& keep) override;
  geometry::ModelMesh reports() override;
  Bytes waitFor(Order order);
  int waitForStop();

 private:
  Task nextTask(std::size_t slot) override;
  void giveUp(const std::string& reason) override;
  void finish(std::vector<NumberedMesh> meshes) override;
  void offer(const RegionKey& region, const std::vector<double>& work) override;
  std::optional<std::size_t> nextPiece(const RegionKey& region, std::size_t slot,
                                       bool isInvited) override;
  void deliver(int owner, const RegionKey& region, std::size_t piece,
               const RegionMesh& mesh) override;

  Post& post_;
  Workers workers_;
  KeptFaces kept_;
  const geometry::KeepMesh* keep_ = nullptr;  ///< during a round
  std::uint64_t round_ = 0;
  geometry::DividedEdges divided_;
  geometry::ModelMesh reports_;
};

}  // namespace af2::mpi
