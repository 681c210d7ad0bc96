#include "geometry/mpi/crew/kept_faces.h"

#include <optional>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "geometry/mpi/crew/topics.h"

namespace af2::mpi {

using namespace geometry;

KeptFaces::KeptFaces(Post& post) : post_(post) {
  post_.handle(kFetch, [this](const Letter& letter) { answer(letter); });
  post_.handle(kForget, [this](const Letter& letter) {
    const std::lock_guard lock(mutex_);
    faces_.erase(ByteReader(letter.bytes).take<std::uint64_t>());
  });
}

std::vector<KeptFace> KeptFaces::keep(FaceMesh& mesh) {
  if (!mesh.bulk) return {};
  std::vector<KeptFace> kept(1);
  kept[0].counts = mesh.bulk->counts();
  kept[0].evidence = *mesh.evidence;
  const std::lock_guard lock(mutex_);
  kept[0].number = ++last_;
  faces_[last_] = std::move(mesh.bulk);
  return kept;
}

/// Called on the thread of the post, which must go on whatever happens.
void KeptFaces::answer(const Letter& letter) {
  ByteReader reader(letter.bytes);
  const auto number = reader.take<std::uint64_t>();
  const auto call = reader.take<std::uint64_t>();
  std::shared_ptr<const StoredFace> face;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = faces_.find(number); found != faces_.end()) face = found->second;
  }
  Bytes bytes;
  try {
    if (!face) throw InternalError("a face is asked for that is not kept");
    face->read(face->counts().allBytes(), [&](std::span<const std::uint8_t> some) {
      ByteWriter writer;
      writer(std::string());  // no fault
      writer.append(some.data(), some.size());
      bytes = writer.take();
    });
  } catch (const std::exception& error) {
    bytes = bytesOf(post_.name() + ": " + error.what());
  }
  post_.send(letter.from, fetchedBy(call), std::move(bytes));
}

class FaceFetcher::RemoteFace final : public StoredFace {
 public:
  RemoteFace(FaceFetcher& fetcher, int process, std::uint64_t number, StoredCounts counts)
      : StoredFace(std::move(counts)), fetcher_(fetcher), process_(process), number_(number) {}
  ~RemoteFace() override {
    if (all_) fetcher_.giveRoomBack(size());
    fetcher_.post_.send(process_, kForget, bytesOf(number_));
  }

  void read(std::size_t count, const UseBytes& use) const override {
    std::shared_ptr<const Bytes> bytes = kept();
    if (!bytes) bytes = fetched();
    ByteReader reader(*bytes);
    reader.take<std::string>();  // no fault
    use({reinterpret_cast<const std::uint8_t*>(reader.rest().data()), count});
  }
  void readAhead() const override {
    const std::lock_guard lock(mutex_);
    if (!all_ && !ahead_) ahead_ = fetcher_.call(process_, number_);
  }

 private:
  std::size_t size() const { return counts().allBytes(); }

  std::shared_ptr<const Bytes> kept() const {
    const std::lock_guard lock(mutex_);
    return all_;
  }
  std::optional<std::uint64_t> takeAhead() const {
    const std::lock_guard lock(mutex_);
    return std::exchange(ahead_, std::nullopt);
  }

  std::shared_ptr<const Bytes> fetched() const {
    const std::optional<std::uint64_t> ahead = takeAhead();
    std::shared_ptr<const Bytes> bytes =
        fetcher_.answer(ahead ? *ahead : fetcher_.call(process_, number_));
    const std::lock_guard lock(mutex_);
    if (!all_ && fetcher_.takeRoomFor(size())) all_ = bytes;
    return bytes;
  }

  FaceFetcher& fetcher_;
  int process_;
  std::uint64_t number_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const Bytes> all_;    ///< if there is room
  mutable std::optional<std::uint64_t> ahead_;  ///< the call that asks for them
};

void FaceFetcher::attach(int process, std::vector<KeptFace> kept, FaceMesh& mesh) {
  if (kept.empty()) return;
  KeptFace& face = kept.front();
  mesh.evidence = std::make_shared<const FaceEvidence>(std::move(face.evidence));
  mesh.bulk =
      std::make_shared<const RemoteFace>(*this, process, face.number, std::move(face.counts));
}

std::uint64_t FaceFetcher::call(int process, std::uint64_t number) {
  std::uint64_t call = 0;
  {
    const std::lock_guard lock(mutex_);
    while (!calls_.insert(call).second) ++call;
  }
  post_.send(process, kFetch, bytesOf(number, call));
  return call;
}

std::shared_ptr<const Bytes> FaceFetcher::answer(std::uint64_t call) {
  auto bytes = std::make_shared<const Bytes>(post_.receive(fetchedBy(call)).bytes);
  {
    const std::lock_guard lock(mutex_);
    calls_.erase(call);
  }
  if (const auto fault = ByteReader(*bytes).take<std::string>(); !fault.empty())
    throw InputError(fault);
  return bytes;
}

bool FaceFetcher::takeRoomFor(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (bytes_ + bytes > kMostBytes) return false;
  bytes_ += bytes;
  return true;
}

void FaceFetcher::giveRoomBack(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  bytes_ -= bytes;
}

}  // namespace af2::mpi
