// What the threads of a crew are told to do.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/run/mesh_region.h"
#include "geometry/mesh/face_mesh.h"
#include "geometry/mesh/try_limits.h"

namespace af2::mpi {

/// A try at a face with its number in the round.
struct NumberedTry {
  std::uint64_t number = 0;
  geometry::FaceTry what;
};

enum class TaskKind {
  Over,  ///< the round is over
  Mesh,  ///< mesh these faces
  Help,  ///< mesh pieces of a face that another thread has begun, maybe one of another process
};

struct Task {
  TaskKind kind = TaskKind::Over;
  std::vector<NumberedTry> tries;  ///< Help: one
  int owner = 0;                   ///< Help: the process that has begun the face
};

/// A face that was cut. Faces may be cut more than once in a try, in different ways.
struct RegionKey {
  std::uint64_t round = 0, number = 0;
  std::uint64_t cut = 0;  ///< made of the work of all pieces
  bool operator==(const RegionKey&) const = default;
};

using NumberedMesh = std::pair<std::uint64_t, geometry::FaceMesh>;

/// Where the threads of a process get their tasks from, and where the results go.
class TaskSource {
 public:
  virtual ~TaskSource() = default;
  /// Waits for the next task. Each thread that calls this has a slot of its own.
  virtual Task nextTask(std::size_t slot) = 0;
  virtual void finish(std::vector<NumberedMesh> meshes) = 0;
  /// Lets others mesh pieces of a region.
  ///
  /// work  by piece
  virtual void offer(const RegionKey& region, const std::vector<double>& work) = 0;
  /// The next piece of a region that nobody has begun.
  ///
  /// isInvited  whether this is the first that a thread takes because it was told to help
  virtual std::optional<std::size_t> nextPiece(const RegionKey& region, std::size_t slot,
                                               bool isInvited) = 0;
  /// A thread cannot go on: the round is over for all.
  virtual void giveUp(const std::string& reason) = 0;
  /// Sends a piece to the process that owns its region.
  virtual void deliver(int owner, const RegionKey& region, std::size_t piece,
                       const RegionMesh& mesh) = 0;
};

}  // namespace af2::mpi
