// The meshes of faces and what belongs to them as bytes. A new field of one of these types does
// not compile until it is named here.
#pragma once

#include "geometry/check/face_evidence.h"
#include "geometry/meshing/face_crew.h"
#include "geometry/mpi/crew/kept_faces.h"
#include "geometry/mpi/messages/bytes.h"

namespace af2 {

void pass(auto& archive, mpi::Is<FrontPiece> auto& piece) {
  auto& [vertices, chains, isolated, base, level, size, colours] = piece;
  archive(vertices, chains, isolated, base, level, size, colours);
}

}  // namespace af2

namespace af2::geometry {

void pass(auto& archive, mpi::Is<StuckPlace> auto& place) {
  auto& [from, to, u, v, level, refusals, around] = place;
  archive(from, to, u, v, level, refusals, around);
}

void pass(auto& archive, mpi::Is<FaceReport> auto& report) {
  auto& [id, name, surfaceType, chart, status, elements, seconds, area, reason, cause, attempts,
         stuck, withoutRule, acts, layers, layerElements, oddLoops, triangles, firstTriangle,
         deviation, congruentTo] = report;
  archive(id, name, surfaceType, chart, status, elements, seconds, area, reason, cause, attempts,
          stuck, withoutRule, acts, layers, layerElements, oddLoops, triangles, firstTriangle,
          deviation, congruentTo);
}

void pass(auto& archive, mpi::Is<FillFault> auto& fault) {
  auto& [kind, details] = fault;
  archive(kind, details);
}

void pass(auto& archive, mpi::Is<FaceStep> auto& step) {
  auto& [kind, name, fault, details, count] = step;
  archive(kind, name, fault, details, count);
}

void pass(auto& archive, mpi::Is<FaceDiagnosis> auto& diagnosis) {
  auto& [places, poorness, isBad, hasBadAngle, hasWrongArea] = diagnosis;
  archive(places, poorness, isBad, hasBadAngle, hasWrongArea);
}

/// What a process has put away stays there: kept_faces.h.
void pass(auto& archive, mpi::Is<FaceMesh> auto& mesh) {
  auto& [report, boundary, inside, wantedSizes, elements, origins, middles, uses, hasVanished,
         optimizeSeconds, diagnosis, history, searchCost, bulk, evidence] = mesh;
  archive(report, boundary, inside, wantedSizes, elements, origins, middles, uses, hasVanished,
          optimizeSeconds, diagnosis, history, searchCost);
}

void pass(auto& archive, mpi::Is<StoredCounts> auto& stored) {
  auto& [inside, elements, quads, isUsed, elementBytes, originBytes, wantedSizes, storedSizes,
         size] = stored;
  archive(inside, elements, quads, isUsed, elementBytes, originBytes, wantedSizes, storedSizes,
          size);
}

void pass(auto& archive, mpi::Is<MeshFinding> auto& finding) {
  auto& [face, what, place] = finding;
  archive(face, what, place);
}

void pass(auto& archive, mpi::Is<OutlinedPatch> auto& patch) {
  auto& [first, last, box, boxes, normal, corners, sides, onSegments] = patch;
  archive(first, last, box, boxes, normal, corners, sides, onSegments);
}

void pass(auto& archive, mpi::Is<FaceEvidence> auto& evidence) {
  auto& [findings, area, isSoundInside, atBoundary, patch, firstCorners, canBeDrawn, isStarShaped] =
      evidence;
  archive(findings, area, isSoundInside, atBoundary, patch, firstCorners, canBeDrawn, isStarShaped);
}

void pass(auto& archive, mpi::Is<DividedEdge> auto& edge) {
  auto& [parameters, points, stops, problem, wanted, twin, point, counts] = edge;
  archive(parameters, points, stops, problem, wanted, twin, point, counts);
}

void pass(auto& archive, mpi::Is<DividedEdges> auto& divided) {
  auto& [points, edges, counts] = divided;
  archive(points, edges, counts);
}

void pass(auto& archive, mpi::Is<SizeGrid> auto& grid) {
  auto& [origin, spacing, counts, sizes] = grid;
  archive(origin, spacing, counts, sizes);
}

void pass(auto& archive, mpi::Is<SizeCells> auto& field) {
  auto& [vertices, sizes, cells] = field;
  archive(vertices, sizes, cells);
}

void pass(auto& archive, mpi::Is<SizeSources> auto& sources) {
  auto& [points, boxes, grids, cells] = sources;
  archive(points, boxes, grids, cells);
}

void pass(auto& archive, mpi::Is<ChordBounds> auto& bounds) {
  auto& [everywhere, faces, parts, aims] = bounds;
  archive(everywhere, faces, parts, aims);
}

void pass(auto& archive, mpi::Is<RunChange> auto& change) {
  auto& [faces, faceSizes, sources, chords, optimize, evenLoops, hasLayers, order, keepFaces,
         keptIn] = change;
  archive(faces, faceSizes, sources, chords, optimize, evenLoops, hasLayers, order, keepFaces,
          keptIn);
}

}  // namespace af2::geometry

namespace af2::mpi {

void pass(auto& archive, Is<KeptFace> auto& face) {
  auto& [number, counts, evidence] = face;
  archive(number, counts, evidence);
}

}  // namespace af2::mpi
