#include "mpi/crew/leader.h"

#include "geometry/base/parallel.h"
#include "mpi/crew/face_bytes.h"
#include "mpi/crew/numbered_try.h"

namespace af2::mpi {

using namespace geometry;

Crew::Leader::Leader(Post& post, std::size_t threads)
    : post_(post), threads_(threads), board_(threads * static_cast<std::size_t>(post.ranks())) {
  post_.handle(kTake, [this](const Letter& letter) { answer(letter); });
  post_.handle(kResults, [this](const Letter& letter) { takeResults(letter); });
  post_.handle(kDone, [this](const Letter&) { board_.done(); });
  post_.handle(kGivenUp, [this](const Letter& letter) {
    board_.giveUp(ByteReader(letter.bytes).take<std::string>());
  });
}

void Crew::Leader::beginRun(const RunChange& change) { tell(Order::BeginRun, change); }

void Crew::Leader::meshAll(const FaceRound& round, std::span<const FaceTry> tries,
                           std::span<const double> work, const MeshTry& mesh,
                           const TakeMesh& take) {
  const std::uint64_t number = begin(tries, work, take);
  struct End {
    Leader& leader;
    ~End() { leader.end(); }
  } const end{*this};
  tell(Order::BeginRound, number, round.divided, round.near);
  forEachInParallel(threads_, 0, [&](std::size_t) {
    for (auto tasks = board_.take(number); !tasks.empty(); tasks = board_.take(number)) {
      for (const std::size_t k : tasks) take(k, mesh(tries[k]));
      board_.finish(tasks.size());
    }
  });
  board_.wait();
}

std::uint64_t Crew::Leader::begin(std::span<const FaceTry> tries, std::span<const double> work,
                                  const TakeMesh& take) {
  const std::lock_guard lock(mutex_);
  tries_ = tries;
  take_ = &take;
  return round_ = board_.begin(work);
}

/// From now on, results are not wanted any more: if somebody has given up, some may still come.
void Crew::Leader::end() {
  const std::lock_guard lock(mutex_);
  take_ = nullptr;
}

void Crew::Leader::endRun() { tell(Order::EndRun); }

void Crew::Leader::endModel(const ModelMesh& mesh) {
  tell(Order::EndModel, mesh.faces, mesh.findings, mesh.notes);
}

void Crew::Leader::stop(const std::string& reason, int code) { tell(Order::Stop, reason, code); }

template <class... T>
void Crew::Leader::tell(Order order, const T&... values) {
  if (post_.ranks() > 1) post_.sendToAll(kOrders, bytesOf(order, values...));
}

void Crew::Leader::answer(const Letter& letter) {
  const std::lock_guard lock(mutex_);
  std::vector<NumberedTry> tries;
  for (const std::size_t k : board_.take(ByteReader(letter.bytes).take<std::uint64_t>()))
    tries.push_back({k, tries_[k]});
  post_.send(letter.from, kTasks, bytesOf(tries));
}

void Crew::Leader::takeResults(const Letter& letter) {
  const std::lock_guard lock(mutex_);
  ByteReader reader(letter.bytes);
  if (reader.take<std::uint64_t>() != round_ || !take_) return;
  std::size_t count = 0;
  for (; !reader.rest().empty(); ++count) {
    const auto k = reader.take<std::uint64_t>();
    (*take_)(k, reader.take<FaceMesh>());
  }
  board_.finish(count);
}

}  // namespace af2::mpi
