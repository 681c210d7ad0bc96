// Faces that stay with the process that has meshed them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "geometry/check/face_evidence.h"
#include "geometry/mesh/face_mesh.h"
#include "geometry/mpi/messages/post.h"

namespace af2::mpi {

/// What the leader is told of such a face.
struct KeptFace {
  std::uint64_t number = 0;  ///< in the process that keeps it
  geometry::StoredCounts counts;
  geometry::FaceEvidence evidence;
};

/// Those that this process keeps for the leader, and how it hands them out.
class KeptFaces {
 public:
  explicit KeptFaces(Post& post);

  /// Keeps the bulk of a face if it has been put away. Returns what to tell the leader; nothing if
  /// it has not.
  std::vector<KeptFace> keep(geometry::FaceMesh& mesh);

 private:
  void answer(const Letter& letter);

  Post& post_;
  std::mutex mutex_;
  std::uint64_t last_ = 0;
  std::map<std::uint64_t, std::shared_ptr<const geometry::StoredFace>> faces_;
};

/// How the leader gets at faces of others. It keeps the bytes of some, because it needs most faces
/// several times.
class FaceFetcher {
 public:
  explicit FaceFetcher(Post& post) : post_(post) {}

  /// Gives a mesh the bulk that another process keeps for it, if it does.
  void attach(int process, std::vector<KeptFace> kept, geometry::FaceMesh& mesh);

 private:
  static constexpr std::size_t kMostBytes = 64'000'000;  ///< of those that are kept here
  class RemoteFace;
  /// Asks for a face. Returns the number of the call.
  std::uint64_t call(int process, std::uint64_t number);
  /// Waits for its bytes. Throws InputError if the other process cannot read them.
  std::shared_ptr<const Bytes> answer(std::uint64_t call);
  bool takeRoomFor(std::size_t bytes);
  void giveRoomBack(std::size_t bytes);

  Post& post_;
  std::mutex mutex_;
  std::set<std::uint64_t> calls_;  ///< those whose answers have not come yet
  std::size_t bytes_ = 0;          ///< of the faces that are kept here
};

}  // namespace af2::mpi
