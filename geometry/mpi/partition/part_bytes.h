// Parts of meshes as bytes. A new field does not compile until it is named here.
#pragma once

#include "geometry/mpi/messages/bytes.h"
#include "geometry/mpi/partition/owned_part.h"

namespace af2::mpi {

void pass(auto& archive, Is<PartLabels::Entity> auto& entity) {
  auto& [id, groups] = entity;
  archive(id, groups);
}

void pass(auto& archive, Is<PartLabels::Name> auto& one) {
  auto& [dimension, group, name] = one;
  archive(dimension, group, name);
}

void pass(auto& archive, Is<PartLabels> auto& labels) {
  auto& [faces, edges, names] = labels;
  archive(faces, edges, names);
}

void pass(auto& archive, Is<OwnedPart> auto& part) {
  auto& [process, processes, allVertices, allElements, allLines, vertices, ownedVertices, vertexIds,
         vertexNumbers, vertexOwners, elements, ownedElements, elementIds, elementNumbers,
         elementOwners, face, midsides, ghostsBegin, ghostsOf, lines, labels] = part;
  archive(process, processes, allVertices, allElements, allLines, vertices, ownedVertices,
          vertexIds, vertexNumbers, vertexOwners, elements, ownedElements, elementIds,
          elementNumbers, elementOwners, face, midsides, ghostsBegin, ghostsOf, lines, labels);
}

}  // namespace af2::mpi
