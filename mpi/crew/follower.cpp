#include "mpi/crew/follower.h"

#include <utility>

#include "geometry/base/parallel.h"
#include "mpi/crew/face_bytes.h"

namespace af2::mpi {

using namespace geometry;

namespace {

Order orderIn(ByteReader& reader) {
  const auto order = reader.take<Order>();
  if (order != Order::Stop) return order;
  const auto reason = reader.take<std::string>();
  throw RunStopped(reason, reader.take<int>());
}

}  // namespace

std::optional<RunChange> Crew::Follower::nextRun() {
  const Letter letter = post_.receive(kOrders);
  ByteReader reader(letter.bytes);
  if (orderIn(reader) == Order::BeginRun) return reader.take<RunChange>();
  reader(reports_.faces, reports_.findings, reports_.notes);
  return std::nullopt;
}

std::optional<FaceRound> Crew::Follower::nextRound() {
  const Letter letter = post_.receive(kOrders);
  ByteReader reader(letter.bytes);
  if (orderIn(reader) == Order::EndRun) return std::nullopt;
  std::vector<SizeSource> near;
  reader(round_, divided_, near);
  return FaceRound{divided_, std::move(near)};
}

void Crew::Follower::help(const MeshTry& mesh) {
  forEachInParallel(threads_, 0, [&](std::size_t) {
    for (auto tries = nextTries(); !tries.empty(); tries = nextTries()) {
      ByteWriter results;
      results(round_);
      for (const NumberedTry& one : tries) results(one.number, mesh(one.what));
      post_.send(0, kResults, results.take());
    }
  });
}

ModelMesh Crew::Follower::reports() { return std::exchange(reports_, {}); }

Bytes Crew::Follower::waitFor(Order order) {
  const Letter letter = post_.receive(kOrders);
  ByteReader reader(letter.bytes);
  if (orderIn(reader) != order) throw InternalError("a process got another order than it expected");
  return reader.take<Bytes>();
}

int Crew::Follower::waitForStop() {
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

std::vector<NumberedTry> Crew::Follower::nextTries() {
  post_.send(0, kTake, bytesOf(round_));
  const Letter letter = post_.receive(kTasks);
  return ByteReader(letter.bytes).take<std::vector<NumberedTry>>();
}

}  // namespace af2::mpi
