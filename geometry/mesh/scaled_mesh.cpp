#include "geometry/mesh/scaled_mesh.h"

#include <memory>

#include "geometry/spool/spooled_mesh.h"

namespace af2::geometry {
namespace {

void scaleFace(FaceReport& face, double factor) {
  face.area *= factor * factor;
  face.firstTriangle = factor * face.firstTriangle;
  for (StuckPlace& place : face.stuck) {
    place.from = factor * place.from;
    place.to = factor * place.to;
  }
  for (FaceReport::OddLoop& loop : face.oddLoops) {
    loop.longest.from = factor * loop.longest.from;
    loop.longest.to = factor * loop.longest.to;
  }
}

}  // namespace

std::span<const LengthUnit> lengthUnits() {
  static constexpr LengthUnit kUnits[] = {{"mm", 1},        {"cm", 1 / 10.},    {"m", 1 / 1000.},
                                          {"um", 1000},     {"inch", 1 / 25.4}, {"in", 1 / 25.4},
                                          {"ft", 1 / 304.8}};
  return kUnits;
}

ModelMesh scaledMesh(ModelMesh mesh, double factor) {
  for (Point3& vertex : mesh.vertices) vertex = factor * vertex;
  for (double& size : mesh.wantedSizes) size *= factor;
  for (EdgeSegment& segment : mesh.segments) segment.middle = factor * segment.middle;
  for (FaceReport& face : mesh.faces) scaleFace(face, factor);
  if (mesh.spooled)
    mesh.spooled = std::make_shared<const SpooledMesh>(mesh.spooled->parts(), mesh.vertices.size(),
                                                       mesh.spooled->file(), factor);
  return mesh;
}

}  // namespace af2::geometry
