#include "geometry/mpi/partition/owned_part.h"

#include "geometry/mpi/crew/process.h"
#include "geometry/mpi/crew/topics.h"
#include "geometry/mpi/partition/cut_part.h"
#include "geometry/mpi/partition/part_bytes.h"
#include "geometry/mpi/partition/part_labels.h"

namespace af2::mpi {

/// One part after the other, so that few are in memory beside the mesh.
OwnedPart distribute(Crew& crew, const geometry::ModelMesh& mesh, geometry::LinesAlong along) {
  Process& process = crew.process();
  Post& post = process.post();
  if (!post.isFirst()) {
    const Bytes bytes = process.waitFor(Order::TakePart);
    process.done();
    return ByteReader(bytes).take<OwnedPart>();
  }
  const std::vector<geometry::LineElement> lines = lineElements(mesh, along);
  const DividedMesh divided(mesh, divideMesh(mesh, post.ranks()), post.ranks());
  const std::vector<std::int32_t> owners = ownersOfLines(divided, lines);
  const PartLabels labels = labelsOf(mesh, lines);
  const auto partOf = [&](int rank) {
    OwnedPart part = cutPart(divided, lines, owners, rank);
    part.labels = labels;
    return part;
  };
  for (int other = 1; other < post.ranks(); ++other) {
    process.order(other, Order::TakePart, bytesOf(partOf(other)));
    process.waitForDone(1);
  }
  return partOf(0);
}

}  // namespace af2::mpi
