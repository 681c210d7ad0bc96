#include "geometry/mpi/partition/owned_part.h"

#include <optional>
#include <utility>

#include "geometry/mpi/crew/process.h"
#include "geometry/mpi/crew/topics.h"
#include "geometry/mpi/partition/cut_parts.h"
#include "geometry/mpi/partition/part_builder.h"
#include "geometry/mpi/partition/part_bytes.h"
#include "geometry/mpi/partition/part_labels.h"

namespace af2::mpi {

namespace {

/// What a process is told at once; the last time with the end.
using Delivery = std::pair<std::vector<PartPiece>, std::optional<PartEnd>>;

/// Sends pieces to the other processes, several small ones together, and few ahead of those who
/// take them.
class PieceSender {
 public:
  explicit PieceSender(Process& process)
      : process_(process), pending_(static_cast<std::size_t>(process.post().ranks())) {}

  void add(int part, PartPiece piece) {
    Pending& pending = pendingFor(part);
    pending.elements += piece.elements.size();
    pending.pieces.push_back(std::move(piece));
    if (pending.elements >= kElementsAtOnce) send(part, {});
  }
  void end(int part, PartEnd end) { send(part, std::move(end)); }
  void waitForAll() { process_.waitForDone(std::exchange(ahead_, 0)); }

 private:
  static constexpr std::size_t kElementsAtOnce = 20'000;
  struct Pending {
    std::vector<PartPiece> pieces;
    std::size_t elements = 0;
  };

  Pending& pendingFor(int part) { return pending_[static_cast<std::size_t>(part)]; }

  void send(int part, std::optional<PartEnd> end) {
    if (ahead_ >= 2 * process_.post().ranks()) {
      process_.waitForDone(1);
      --ahead_;
    }
    Pending pending = std::exchange(pendingFor(part), {});
    process_.order(part, Order::TakePart,
                   bytesOf(Delivery(std::move(pending.pieces), std::move(end))));
    ++ahead_;
  }

  Process& process_;
  std::vector<Pending> pending_;  ///< by part
  int ahead_ = 0;                 ///< deliveries that may not have been taken yet
};

/// Orders to all are passed on from process to process. One that is sent to a single process might
/// overtake them, unless all have got them.
void beginParts(Process& process) {
  process.orderAll(Order::BeginParts, {});
  process.waitForDone(process.post().ranks() - 1);
}

OwnedPart received(Process& process) {
  process.waitFor(Order::BeginParts);
  process.done();
  PartBuilder builder(process.post().rank());
  while (true) {
    const Bytes bytes = process.waitFor(Order::TakePart);
    auto [pieces, end] = ByteReader(bytes).take<Delivery>();
    for (const PartPiece& piece : pieces) builder.take(piece);
    process.done();
    if (end) return builder.finish(std::move(*end));
  }
}

}  // namespace

OwnedPart distribute(Crew& crew, const geometry::ModelMesh& mesh, geometry::LinesAlong along) {
  Process& process = crew.process();
  if (!process.post().isFirst()) return received(process);
  const std::vector<geometry::LineElement> lines = lineElements(mesh, along);
  const PartLabels labels = labelsOf(mesh, lines);
  const MeshDivision division = divideMesh(mesh, process.post().ranks());
  beginParts(process);
  PartBuilder own(0);
  PieceSender sender(process);
  std::vector<PartEnd> ends = cutParts(mesh, division, lines, [&](int part, PartPiece&& piece) {
    part == 0 ? own.take(piece) : sender.add(part, std::move(piece));
  });
  for (PartEnd& end : ends) end.labels = labels;
  for (int other = 1; other < process.post().ranks(); ++other)
    sender.end(other, std::move(ends[static_cast<std::size_t>(other)]));
  OwnedPart part = own.finish(std::move(ends.front()));
  sender.waitForAll();
  return part;
}

}  // namespace af2::mpi
