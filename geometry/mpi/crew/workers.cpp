#include "geometry/mpi/crew/workers.h"

#include <bit>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/mpi/crew/region_bytes.h"

namespace af2::mpi {

using geometry::FaceMesh;
using geometry::MeshTry;

/// A cut face while threads of this process mesh pieces of it. It stays until the last of them has
/// left it.
class Workers::OpenRegion {
 public:
  /// take  null: the region is another process's
  OpenRegion(const RegionKey& key, int owner, std::size_t pieces, const RegionCrew::MeshPiece& mesh,
             const RegionCrew::TakePiece* take)
      : key_(key), owner_(owner), missing_(pieces), mesh_(mesh), take_(take) {}

  const RegionKey& key() const { return key_; }

  /// Meshes pieces as long as there are any that nobody has begun.
  void meshPieces(TaskSource& source, std::size_t slot, bool isInvited) {
    while (const auto piece = source.nextPiece(key_, slot, std::exchange(isInvited, false))) {
      RegionMesh mesh = mesh_(*piece);
      if (take_)
        take(*piece, std::move(mesh));
      else
        source.deliver(owner_, key_, *piece, mesh);
    }
  }

  void take(std::size_t piece, RegionMesh mesh) {
    (*take_)(piece, std::move(mesh));
    const std::lock_guard lock(mutex_);
    --missing_;
    changed_.notify_all();
  }

  /// Returns false if the region is closed, or is none that pieces could be taken for.
  bool enter() {
    const std::lock_guard lock(mutex_);
    if (isClosed_) return false;
    ++inside_;
    return true;
  }
  bool isOwn() const { return take_ != nullptr; }
  void leave() {
    const std::lock_guard lock(mutex_);
    --inside_;
    changed_.notify_all();
  }

  void waitForAll() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return missing_ == 0 || isGivenUp_; });
    if (missing_ > 0) throw InputError("another process has given up");
  }
  void giveUp() {
    const std::lock_guard lock(mutex_);
    isGivenUp_ = true;
    changed_.notify_all();
  }
  void close() {
    std::unique_lock lock(mutex_);
    isClosed_ = true;
    changed_.wait(lock, [&] { return inside_ == 0; });
  }

 private:
  RegionKey key_;
  int owner_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t missing_;
  int inside_ = 0;
  bool isClosed_ = false, isGivenUp_ = false;
  const RegionCrew::MeshPiece& mesh_;
  const RegionCrew::TakePiece* take_;
};

/// What the mesher of one face sees of the others.
class Workers::SharedRegion final : public RegionCrew {
 public:
  /// owner  the process whose face it is
  SharedRegion(Workers& workers, TaskSource& source, std::size_t slot, RegionKey key, int owner,
               bool helps)
      : workers_(workers), source_(source), slot_(slot), key_(key), owner_(owner), helps_(helps) {}

  bool meshPieces(const std::vector<double>& work, const MeshPiece& mesh,
                  const TakePiece& take) override {
    RegionKey key = key_;
    key.cut = cutOf(work);
    const auto region =
        std::make_shared<OpenRegion>(key, owner_, work.size(), mesh, helps_ ? nullptr : &take);
    if (!open(region)) return helps_ ? false : meshAlone(work.size(), mesh, take);
    const Closed closed{workers_, *region};
    if (!helps_) source_.offer(key, work);
    region->meshPieces(source_, slot_, helps_);
    if (!helps_) region->waitForAll();
    return !helps_;
  }

 private:
  struct Closed {
    Workers& workers;
    OpenRegion& region;
    ~Closed() {
      {
        const std::lock_guard lock(workers.mutex_);
        workers.open_.erase(region.key().number);
      }
      region.close();
    }
  };

  static std::uint64_t cutOf(const std::vector<double>& work) {
    std::uint64_t sum = work.size();
    for (const double w : work) sum = sum * 0x100000001b3 ^ std::bit_cast<std::uint64_t>(w);
    return sum;
  }

  /// Only one region of a face at a time is shared: parts of a face may be meshed in parallel.
  bool open(const std::shared_ptr<OpenRegion>& region) {
    const std::lock_guard lock(workers_.mutex_);
    return !workers_.isGivenUp_ && workers_.open_.try_emplace(key_.number, region).second;
  }

  static bool meshAlone(std::size_t pieces, const MeshPiece& mesh, const TakePiece& take) {
    for (std::size_t p = 0; p < pieces; ++p) take(p, mesh(p));
    return true;
  }

  Workers& workers_;
  TaskSource& source_;
  std::size_t slot_;
  RegionKey key_;
  int owner_;
  bool helps_;
};

/// Each thread has an arena of its own: one that waited for others in a common arena might do their
/// tasks meanwhile, which may wait for its own.
void Workers::work(TaskSource& source, std::uint64_t round, const MeshTry& mesh) {
  std::mutex mutex;
  std::exception_ptr fault;
  const auto run = [&](std::size_t slot) {
    try {
      withThreads(1, [&] { doTasks(source, round, slot, mesh); });
    } catch (const std::exception& error) {
      source.giveUp(reasonOf(error));  // others would wait for what it has begun
      const std::lock_guard lock(mutex);
      if (!fault) fault = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t slot = 1; slot < threads_; ++slot) others.emplace_back(run, slot);
    run(0);
  }
  if (fault) std::rethrow_exception(fault);
}

void Workers::doTasks(TaskSource& source, std::uint64_t round, std::size_t slot,
                      const MeshTry& mesh) {
  for (Task task = source.nextTask(slot); task.kind != TaskKind::Over; task = source.nextTask(slot))
    if (task.kind == TaskKind::Mesh)
      meshFaces(source, round, slot, task, mesh);
    else
      help(source, round, slot, task, mesh);
}

void Workers::meshFaces(TaskSource& source, std::uint64_t round, std::size_t slot, const Task& task,
                        const MeshTry& mesh) {
  std::vector<NumberedMesh> meshes;
  for (const NumberedTry& one : task.tries) {
    SharedRegion shared(*this, source, slot, {round, one.number, 0}, process_, false);
    meshes.emplace_back(one.number, mesh(one.what, &shared));
  }
  source.finish(std::move(meshes));
}

/// A face of another process is begun here, too, up to where it is cut; the mesh is not wanted.
void Workers::help(TaskSource& source, std::uint64_t round, std::size_t slot, const Task& task,
                   const MeshTry& mesh) {
  const NumberedTry& one = task.tries.front();
  if (const auto region = find(one.number)) {
    region->meshPieces(source, slot, true);
    return region->leave();
  }
  SharedRegion shared(*this, source, slot, {round, one.number, 0}, task.owner, true);
  mesh(one.what, &shared);
}

void Workers::takePiece(const Bytes& bytes) {
  ByteReader reader(bytes);
  const auto key = reader.take<RegionKey>();
  const auto piece = reader.take<std::uint64_t>();
  const auto region = find(key.number);
  if (!region) return;
  if (region->isOwn() && region->key() == key) region->take(piece, reader.take<RegionMesh>());
  region->leave();
}

void Workers::giveUp() {
  const std::lock_guard lock(mutex_);
  isGivenUp_ = true;
  for (const auto& [number, region] : open_) region->giveUp();
}

/// A region that was entered, or null.
std::shared_ptr<Workers::OpenRegion> Workers::find(std::uint64_t number) {
  const std::lock_guard lock(mutex_);
  const auto found = open_.find(number);
  return found != open_.end() && found->second->enter() ? found->second : nullptr;
}

std::string reasonOf(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return "there is not enough memory; use more machines, fewer processes on each, or a larger "
           "size";
  return error.what();
}

Bytes bytesOfPiece(const RegionKey& region, std::size_t piece, const RegionMesh& mesh) {
  return bytesOf(region, std::uint64_t{piece}, mesh);
}

}  // namespace af2::mpi
