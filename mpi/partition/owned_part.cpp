#include "mpi/partition/owned_part.h"

#include "mpi/crew/crew.h"
#include "mpi/crew/topics.h"
#include "mpi/partition/cut_part.h"
#include "mpi/partition/part_bytes.h"

namespace af2::mpi {

/// One part after the other, so that few are in memory beside the mesh.
OwnedPart distribute(Crew& crew, const geometry::ModelMesh& mesh, geometry::LinesAlong along) {
  Post& post = crew.post();
  if (!post.isFirst()) {
    const Bytes bytes = crew.waitFor(Order::TakePart);
    crew.done();
    return ByteReader(bytes).take<OwnedPart>();
  }
  const std::vector<geometry::LineElement> lines = lineElements(mesh, along);
  const DividedMesh divided(mesh, divideMesh(mesh, post.ranks()), post.ranks());
  const std::vector<std::int32_t> owners = ownersOfLines(divided, lines);
  const PartLabels labels = labelsOf(mesh, lines);
  const auto partOf = [&](int process) {
    OwnedPart part = cutPart(divided, lines, owners, process);
    part.labels = labels;
    return part;
  };
  for (int process = 1; process < post.ranks(); ++process) {
    crew.order(process, Order::TakePart, bytesOf(partOf(process)));
    crew.waitForDone(1);
  }
  return partOf(0);
}

}  // namespace af2::mpi
