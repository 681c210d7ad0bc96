#include "geometry/mpi/crew/leader.h"

#include "geometry/mpi/crew/region_bytes.h"

namespace af2::mpi {

using namespace geometry;

Process::Leader::Leader(Post& post, std::size_t threads)
    : post_(post),
      board_(threads * static_cast<std::size_t>(post.ranks())),
      workers_(post.rank(), threads),
      fetcher_(post) {
  handleLetters();
}

void Process::Leader::handleLetters() {
  post_.handle(kAsk, [this](const Letter& letter) {
    Waiting next{letter.from, 0, 0};
    ByteReader(letter.bytes)(next.slot, next.round);
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(next);
    }
    answerWaiting();
  });
  post_.handle(kAskPiece, [this](const Letter& letter) {
    ByteReader reader(letter.bytes);
    const auto slot = reader.take<std::uint64_t>();
    const auto region = reader.take<RegionKey>();
    post_.send(letter.from, replyTo(slot), bytesOf(board_.nextPiece(region, reader.take<bool>())));
  });
  post_.handle(kOffer, [this](const Letter& letter) {
    ByteReader reader(letter.bytes);
    const auto region = reader.take<RegionKey>();
    board_.offer(region, letter.from, reader.take<std::vector<double>>());
    answerWaiting();
  });
  post_.handle(kPiece, [this](const Letter& letter) { workers_.takePiece(letter.bytes); });
  post_.handle(kResults, [this](const Letter& letter) { takeMeshes(letter); });
  post_.handle(kDone, [this](const Letter&) { board_.done(); });
  post_.handle(kGivenUp, [this](const Letter& letter) {
    giveUp(ByteReader(letter.bytes).take<std::string>());
  });
}

void Process::Leader::beginRun(const RunChange& change) { tell(Order::BeginRun, change); }

void Process::Leader::meshAll(const FaceRound& round, std::span<const FaceTry> tries,
                              std::span<const double> work, const MeshTry& mesh,
                              const TakeMesh& take) {
  begin(take, board_.begin(tries, work));
  struct End {
    Leader& leader;
    ~End() { leader.end(); }
  } const end{*this};
  tell(Order::BeginRound, round_, round.divided, round.near);
  workers_.work(*this, round_, mesh);
  board_.check();
}

void Process::Leader::begin(const TakeMesh& take, std::uint64_t round) {
  const std::lock_guard lock(mutex_);
  take_ = &take;
  round_ = round;
}

/// From now on, results are not wanted any more: if somebody has given up, some may still come.
void Process::Leader::end() {
  const std::lock_guard lock(mutex_);
  take_ = nullptr;
}

void Process::Leader::endRun() { tell(Order::EndRun); }

void Process::Leader::endModel(const ModelMesh& mesh) {
  tell(Order::EndModel, mesh.faces, mesh.findings, mesh.notes);
}

void Process::Leader::stop(const std::string& reason, int code) { tell(Order::Stop, reason, code); }

template <class... T>
void Process::Leader::tell(Order order, const T&... values) {
  if (post_.ranks() > 1) post_.sendToAll(kOrders, bytesOf(order, values...));
}

Task Process::Leader::nextTask(std::size_t) { return board_.take(round_); }

void Process::Leader::finish(std::vector<NumberedMesh> meshes) {
  for (auto& [number, mesh] : meshes) (*take_)(number, std::move(mesh));
  board_.finish(meshes.size());
  answerWaiting();
}

void Process::Leader::offer(const RegionKey& region, const std::vector<double>& work) {
  board_.offer(region, post_.rank(), work);
  answerWaiting();
}

std::optional<std::size_t> Process::Leader::nextPiece(const RegionKey& region, std::size_t,
                                                      bool isInvited) {
  return board_.nextPiece(region, isInvited);
}

void Process::Leader::deliver(int owner, const RegionKey& region, std::size_t piece,
                              const RegionMesh& mesh) {
  post_.send(owner, kPiece, bytesOfPiece(region, piece, mesh));
}

/// Those who can have a task, or whose round is over, get an answer.
void Process::Leader::answerWaiting() {
  const std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [&](const Waiting& one) {
    const std::optional<Task> task = board_.takeIfAny(one.round);
    if (task) post_.send(one.process, replyTo(one.slot), bytesOf(*task));
    return task.has_value();
  });
}

void Process::Leader::takeMeshes(const Letter& letter) {
  ByteReader reader(letter.bytes);
  const auto round = reader.take<std::uint64_t>();
  auto meshes = reader.take<std::vector<NumberedMesh>>();
  auto kept = reader.take<std::vector<std::vector<KeptFace>>>();
  for (std::size_t i = 0; i < meshes.size(); ++i)
    fetcher_.attach(letter.from, std::move(kept.at(i)), meshes[i].second);
  {
    const std::lock_guard lock(mutex_);
    if (round != round_ || !take_) return;
    for (auto& [number, mesh] : meshes) (*take_)(number, std::move(mesh));
  }
  board_.finish(meshes.size());
  answerWaiting();
}

void Process::Leader::giveUp(const std::string& reason) {
  board_.giveUp(reason);
  workers_.giveUp();
  post_.sendToAll(kAbandon, {});
  answerWaiting();
}

}  // namespace af2::mpi
