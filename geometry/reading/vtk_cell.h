// Adds cells by VTK's numbers of types, for both VTK formats.
// Not installed.
#pragma once

#include <algorithm>

#include "geometry/reading/mesh_builder.h"

namespace af2::geometry {

/// 0 for what is no solid cell, or one that is not read.
inline std::size_t cornersOfVtkSolid(int type) {
  constexpr int kTetrahedra[] = {10, 24}, kCubes[] = {12, 25, 29}, kPrisms[] = {13, 26, 32},
                kPyramids[] = {14, 27};
  const auto isIn = [&](const auto& types) {
    return std::ranges::find(types, type) != std::end(types);
  };
  if (isIn(kTetrahedra)) return 4;
  if (isIn(kPyramids)) return 5;
  if (isIn(kPrisms)) return 6;
  return isIn(kCubes) ? 8 : 0;
}

/// corners  of the cell, those of second order after the others
/// face     of an element; edge  of a line
inline void addVtkCell(MeshBuilder& mesh, int type, std::span<const std::uint64_t> corners,
                       std::int32_t face, std::int32_t edge) {
  constexpr int kVertex = 1, kLine = 3, kTriangle = 5, kPolygon = 7, kQuad = 9;
  constexpr int kLine2 = 21, kTriangle2 = 22, kQuad2 = 23, kQuad2Centre = 28;
  std::size_t needed = 0;
  if (type == kVertex) return;
  if (type == kLine || type == kLine2) needed = 2;
  if (type == kTriangle || type == kTriangle2) needed = 3;
  if (type == kQuad || type == kQuad2 || type == kQuad2Centre) needed = 4;
  if (type == kPolygon) needed = corners.size();
  if (const std::size_t solid = cornersOfVtkSolid(type); solid > 0 && corners.size() >= solid)
    return mesh.addSolid(corners.first(solid), "cells of VTK type " + std::to_string(type));
  if (needed == 0) return mesh.leaveOut("cells of VTK type " + std::to_string(type));
  if (corners.size() < needed) mesh.fail("a cell has fewer corners than its type says");
  if (type == kTriangle2 || type == kQuad2 || type == kQuad2Centre) mesh.noteSecondOrder();
  if (needed == 2)
    mesh.addLine(corners[0], corners[1], edge);
  else
    mesh.addElement(corners.first(needed), face);
}

}  // namespace af2::geometry
