// The meshes of pieces, and tasks, as bytes. A new field does not compile until it is named here.
#pragma once

#include "engine/run/mesh_region.h"
#include "geometry/mpi/crew/face_bytes.h"
#include "geometry/mpi/crew/tasks.h"

namespace af2 {

void pass(auto& archive, mpi::Is<Mesh> auto& mesh) {
  auto& [vertices, elements, origins] = mesh;
  archive(vertices, elements, origins);
}

void pass(auto& archive, mpi::Is<LocalFront> auto& front) {
  auto& [piece, ids] = front;
  archive(piece, ids);
}

void pass(auto& archive, mpi::Is<RuleRefusal> auto& refusal) {
  auto& [rule, reason, from, to, matches, matched, score, seconds] = refusal;
  archive(rule, reason, from, to, matches, matched, score, seconds);
}

void pass(auto& archive, mpi::Is<StuckEdge> auto& edge) {
  auto& [from, to, level, refusals, around] = edge;
  archive(from, to, level, refusals, around);
}

void pass(auto& archive, mpi::Is<MeshingResult> auto& result) {
  auto& [outcome, mesh, stuck, unused, steps, failedSteps, acts, candidates] = result;
  archive(outcome, mesh, stuck, unused, steps, failedSteps, acts, candidates);
}

void pass(auto& archive, mpi::Is<RegionMesh> auto& mesh) {
  auto& [result, fault, optimizeSeconds, seconds, progress] = mesh;
  archive(result, fault, optimizeSeconds, seconds, progress);
}

}  // namespace af2

namespace af2::mpi {

void pass(auto& archive, Is<Task> auto& task) {
  auto& [kind, tries, owner] = task;
  archive(kind, tries, owner);
}

}  // namespace af2::mpi
