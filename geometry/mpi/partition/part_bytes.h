// Parts of meshes as bytes. A new field does not compile until it is named here.
#pragma once

#include "geometry/mpi/messages/bytes.h"
#include "geometry/mpi/partition/part_piece.h"

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

void pass(auto& archive, Is<PartPiece> auto& piece) {
  auto& [face, vertices, elements, ghostCounts, ghostsOf] = piece;
  archive(face, vertices, elements, ghostCounts, ghostsOf);
}

void pass(auto& archive, Is<PartEnd> auto& end) {
  auto& [vertices, elements, allLines, lines, labels] = end;
  archive(vertices, elements, allLines, lines, labels);
}

}  // namespace af2::mpi
