#include "geometry/mpi/crew/follower.h"

#include <utility>

#include "geometry/mpi/crew/region_bytes.h"

namespace af2::mpi {

using namespace geometry;

namespace {

Order orderIn(ByteReader& reader) {
  const auto order = reader.take<Order>();
  if (order != Order::Stop) return order;
  const auto reason = reader.take<std::string>();
  throw RunStopped(reason, reader.take<int>());
}

void expectOrder(Order expected, Order order) {
  if (order != expected) throw InternalError("a process got another order than it expected");
}

}  // namespace

Process::Follower::Follower(Post& post, std::size_t threads)
    : post_(post), workers_(post.rank(), threads), kept_(post) {
  post_.handle(kPiece, [this](const Letter& letter) { workers_.takePiece(letter.bytes); });
  post_.handle(kAbandon, [this](const Letter&) { workers_.giveUp(); });
}

std::optional<RunChange> Process::Follower::nextRun() {
  const Letter letter = post_.receive(kOrders);
  ByteReader reader(letter.bytes);
  const Order order = orderIn(reader);
  if (order == Order::BeginRun) return reader.take<RunChange>();
  expectOrder(Order::EndModel, order);
  reader(reports_.faces, reports_.findings, reports_.notes);
  return std::nullopt;
}

std::optional<FaceRound> Process::Follower::nextRound() {
  const Letter letter = post_.receive(kOrders);
  ByteReader reader(letter.bytes);
  const Order order = orderIn(reader);
  if (order == Order::EndRun) return std::nullopt;
  expectOrder(Order::BeginRound, order);
  std::vector<SizeSource> near;
  reader(round_, divided_, near);
  return FaceRound{divided_, std::move(near)};
}

void Process::Follower::help(const MeshTry& mesh, const KeepMesh& keep) {
  keep_ = &keep;
  workers_.work(*this, round_, mesh);
}

ModelMesh Process::Follower::reports() { return std::exchange(reports_, {}); }

Bytes Process::Follower::waitFor(Order order) {
  const Letter letter = post_.receive(kOrders);
  ByteReader reader(letter.bytes);
  expectOrder(order, orderIn(reader));
  return reader.take<Bytes>();
}

int Process::Follower::waitForStop() {
  try {
    while (true) {
      const Letter letter = post_.receive(kOrders);
      ByteReader reader(letter.bytes);
      orderIn(reader);
    }
  } catch (const RunStopped& stop) {
    return stop.exitCode;
  }
}

Task Process::Follower::nextTask(std::size_t slot) {
  post_.send(0, kAsk, bytesOf(std::uint64_t{slot}, round_));
  const Letter letter = post_.receive(replyTo(slot));
  return ByteReader(letter.bytes).take<Task>();
}

void Process::Follower::giveUp(const std::string& reason) {
  post_.send(0, kGivenUp, bytesOf(post_.name() + ": " + reason));
}

void Process::Follower::finish(std::vector<NumberedMesh> meshes) {
  std::vector<std::vector<KeptFace>> kept;
  for (auto& [number, mesh] : meshes) {
    (*keep_)(mesh);
    kept.push_back(kept_.keep(mesh));
  }
  post_.send(0, kResults, bytesOf(round_, meshes, kept));
}

void Process::Follower::offer(const RegionKey& region, const std::vector<double>& work) {
  post_.send(0, kOffer, bytesOf(region, work));
}

std::optional<std::size_t> Process::Follower::nextPiece(const RegionKey& region, std::size_t slot,
                                                        bool isInvited) {
  post_.send(0, kAskPiece, bytesOf(std::uint64_t{slot}, region, isInvited));
  const Letter letter = post_.receive(replyTo(slot));
  return ByteReader(letter.bytes).take<std::optional<std::size_t>>();
}

void Process::Follower::deliver(int owner, const RegionKey& region, std::size_t piece,
                                const RegionMesh& mesh) {
  post_.send(owner, kPiece, bytesOfPiece(region, piece, mesh));
}

}  // namespace af2::mpi
