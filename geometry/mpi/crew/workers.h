// The threads of a process that mesh faces, and pieces of faces together with other processes.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "geometry/meshing/face_crew.h"
#include "geometry/mpi/crew/tasks.h"
#include "geometry/mpi/messages/bytes.h"

namespace af2::mpi {

class Workers {
 public:
  Workers(int process, std::size_t threads) : process_(process), threads_(threads) {}

  /// Does tasks until the round is over. Throws what a thread of this process has thrown.
  void work(TaskSource& source, std::uint64_t round, const geometry::MeshTry& mesh);
  /// A piece that another process has meshed for this one, as `bytesOfPiece` gives it.
  void takePiece(const Bytes& bytes);
  /// Nobody will mesh the pieces that are missing: those who wait for them throw InputError.
  void giveUp();

 private:
  class OpenRegion;
  class SharedRegion;
  void doTasks(TaskSource& source, std::uint64_t round, std::size_t slot,
               const geometry::MeshTry& mesh);
  void meshFaces(TaskSource& source, std::uint64_t round, std::size_t slot, const Task& task,
                 const geometry::MeshTry& mesh);
  void help(TaskSource& source, std::uint64_t round, std::size_t slot, const Task& task,
            const geometry::MeshTry& mesh);
  std::shared_ptr<OpenRegion> find(std::uint64_t number);

  int process_;
  std::size_t threads_;
  std::mutex mutex_;
  std::map<std::uint64_t, std::shared_ptr<OpenRegion>> open_;  ///< by number of the try
  bool isGivenUp_ = false;
};

/// For people.
std::string reasonOf(const std::exception& error);

Bytes bytesOfPiece(const RegionKey& region, std::size_t piece, const RegionMesh& mesh);

}  // namespace af2::mpi
