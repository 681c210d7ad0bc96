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
  const auto count = reader.take<std::uint64_t>();
  const auto call = reader.take<std::uint64_t>();
  std::shared_ptr<const StoredFace> face;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = faces_.find(number); found != faces_.end()) face = found->second;
  }
  Bytes bytes;
  try {
    if (!face) throw InternalError("a face is asked for that is not kept");
    face->read(count, [&](std::span<const std::uint8_t> some) {
      ByteWriter writer;
      writer(std::string());
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
  ~RemoteFace() override { fetcher_.post_.send(process_, kForget, bytesOf(number_)); }

  void read(std::size_t count, const UseBytes& use) const override {
    const std::optional<std::uint64_t> ahead = takeAhead();
    fetcher_.answer(ahead ? *ahead : fetcher_.call(process_, number_, count),
                    [&](std::span<const std::uint8_t> bytes) { use(bytes.first(count)); });
  }
  void readAhead() const override {
    const std::lock_guard lock(mutex_);
    if (!ahead_) ahead_ = fetcher_.call(process_, number_, counts().allBytes());
  }

 private:
  std::optional<std::uint64_t> takeAhead() const {
    const std::lock_guard lock(mutex_);
    return std::exchange(ahead_, std::nullopt);
  }

  FaceFetcher& fetcher_;
  int process_;
  std::uint64_t number_;
  mutable std::mutex mutex_;
  mutable std::optional<std::uint64_t> ahead_;  ///< the call that asks for all
};

void FaceFetcher::attach(int process, std::vector<KeptFace> kept, FaceMesh& mesh) {
  if (kept.empty()) return;
  KeptFace& face = kept.front();
  mesh.evidence = std::make_shared<const FaceEvidence>(std::move(face.evidence));
  mesh.bulk =
      std::make_shared<const RemoteFace>(*this, process, face.number, std::move(face.counts));
}

std::uint64_t FaceFetcher::call(int process, std::uint64_t number, std::uint64_t count) {
  std::uint64_t call = 0;
  {
    const std::lock_guard lock(mutex_);
    while (!calls_.insert(call).second) ++call;
  }
  post_.send(process, kFetch, bytesOf(number, count, call));
  return call;
}

void FaceFetcher::answer(std::uint64_t call, const StoredFace::UseBytes& use) {
  const Letter letter = post_.receive(fetchedBy(call));
  {
    const std::lock_guard lock(mutex_);
    calls_.erase(call);
  }
  ByteReader reader(letter.bytes);
  if (const auto fault = reader.take<std::string>(); !fault.empty()) throw InputError(fault);
  const std::span<const std::byte> bytes = reader.rest();
  use({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

}  // namespace af2::mpi
