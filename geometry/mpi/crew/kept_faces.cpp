#include "geometry/mpi/crew/kept_faces.h"

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
  const StoredFace::Counts& counts = mesh.bulk->counts();
  kept[0].inside = counts.inside;
  kept[0].elements = counts.elements;
  kept[0].quads = counts.quads;
  kept[0].isUsed.assign(counts.isUsed.begin(), counts.isUsed.end());
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
  const auto isShape = reader.take<bool>();
  const auto call = reader.take<std::uint64_t>();
  std::shared_ptr<const StoredFace> face;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = faces_.find(number); found != faces_.end()) face = found->second;
  }
  Bytes bytes;
  try {
    if (!face) throw InternalError("a face is asked for that is not kept");
    const FaceBulk bulk = isShape ? face->loadShape() : face->load();
    bytes = bytesOf(std::string(), bulk.inside, bulk.wantedSizes, bulk.elements, bulk.origins);
  } catch (const std::exception& error) {
    bytes = bytesOf(post_.name() + ": " + error.what());
  }
  post_.send(letter.from, fetchedBy(call), std::move(bytes));
}

class FaceFetcher::RemoteFace final : public StoredFace {
 public:
  RemoteFace(FaceFetcher& fetcher, int process, std::uint64_t number, Counts counts)
      : StoredFace(std::move(counts)), fetcher_(fetcher), process_(process), number_(number) {}
  ~RemoteFace() override { fetcher_.post_.send(process_, kForget, bytesOf(number_)); }

  FaceBulk load() const override { return fetcher_.fetch(process_, number_, false); }
  FaceBulk loadShape() const override { return fetcher_.fetch(process_, number_, true); }

 private:
  FaceFetcher& fetcher_;
  int process_;
  std::uint64_t number_;
};

void FaceFetcher::attach(int process, std::vector<KeptFace> kept, FaceMesh& mesh) {
  if (kept.empty()) return;
  KeptFace& face = kept.front();
  StoredFace::Counts counts{face.inside, face.elements, face.quads,
                            std::vector<bool>(face.isUsed.begin(), face.isUsed.end())};
  mesh.evidence = std::make_shared<const FaceEvidence>(std::move(face.evidence));
  mesh.bulk = std::make_shared<const RemoteFace>(*this, process, face.number, std::move(counts));
}

FaceBulk FaceFetcher::fetch(int process, std::uint64_t number, bool isShape) {
  std::uint64_t call = 0;
  {
    const std::lock_guard lock(mutex_);
    while (!calls_.insert(call).second) ++call;
  }
  post_.send(process, kFetch, bytesOf(number, isShape, call));
  const Letter letter = post_.receive(fetchedBy(call));
  {
    const std::lock_guard lock(mutex_);
    calls_.erase(call);
  }
  ByteReader reader(letter.bytes);
  if (const auto fault = reader.take<std::string>(); !fault.empty()) throw InputError(fault);
  FaceBulk bulk;
  reader(bulk.inside, bulk.wantedSizes, bulk.elements, bulk.origins);
  return bulk;
}

}  // namespace af2::mpi
