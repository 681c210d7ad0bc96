// A page for browsers that shows a mesh: the parts of geometry/page/web/ and the mesh in one file.
#include <algorithm>
#include <limits>

#include "geometry/formats/vtk_cells.h"
#include "geometry/io/formats.h"
#include "geometry/mesh/quality.h"
#include "geometry/page/page_info.h"
#include "geometry/page/page_writer.h"

namespace af2::geometry {
namespace {

/// The middle of the box around the mesh. The page has coordinates of single precision, which keep
/// more digits relative to it.
Point3 centreOf(const ModelMesh& mesh) {
  if (mesh.vertices.empty()) return {};
  Point3 low = mesh.vertices.front(), high = low;
  for (const Point3& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return 0.5 * (low + high);
}

void writeVertices(const ModelMesh& mesh, const Point3& centre, OutputFile& file) {
  writePageArray("positions", "Float32", file, [&](Base64Stream& out) {
    for (const Point3& vertex : mesh.vertices) {
      const Point3 p = vertex - centre;
      for (const double x : {p.x, p.y, p.z}) out.put(static_cast<float>(x));
    }
  });
}

/// The first vertices of each element. A triangle among quadrilaterals has the largest number as
/// its fourth one, which is VertexId's for none.
void writeCorners(const ModelMesh& mesh, std::size_t perElement, OutputFile& file) {
  static_assert(VertexId().value == std::numeric_limits<std::uint32_t>::max());
  writePageArray("corners", "Uint32", file, [&](Base64Stream& out) {
    for (const Element& element : mesh.elements)
      for (std::size_t i = 0; i < perElement; ++i) out.put(element.corners[i].value);
  });
  if (mesh.midsides.empty()) return;
  writePageArray("middles", "Uint32", file, [&](Base64Stream& out) {
    for (const auto& middles : mesh.midsides)
      for (std::size_t i = 0; i < perElement; ++i) out.put(middles[i].value);
  });
}

void writeNumbers(const ModelMesh& mesh, OutputFile& file) {
  writePageArray("face", "Int32", file, [&](Base64Stream& out) {
    for (const std::int32_t face : mesh.face) out.put(face);
  });
  writePageArray("rule", "Int32", file, [&](Base64Stream& out) {
    for (const ElementOrigin& origin : mesh.origins) out.put(ruleNumber(origin));
  });
  writePageArray("level", "Uint8", file, [&](Base64Stream& out) {
    for (const ElementOrigin& origin : mesh.origins) out.put(levelNumber(origin));
  });
  writePageArray("quality", "Float32", file, [&](Base64Stream& out) {
    for (const Element& element : mesh.elements)
      out.put(static_cast<float>(shapeQuality(mesh.vertices, element)));
  });
  if (mesh.scores.empty()) return;
  writePageArray("score", "Float32", file, [&](Base64Stream& out) {
    for (const float score : mesh.scores) out.put(score);
  });
}

void writeData(const ModelMesh& mesh, OutputFile& file) {
  const Point3 centre = centreOf(mesh);
  const int perElement = std::ranges::any_of(mesh.elements, &Element::isQuad) ? 4 : 3;
  writePageJson("info", pageInfo(mesh, centre, perElement), file);
  writeVertices(mesh, centre, file);
  writeCorners(mesh, static_cast<std::size_t>(perElement), file);
  writeNumbers(mesh, file);
}

}  // namespace

void writePage(const ModelMesh& mesh, const Extras&, OutputFile& file) {
  fillPage("page.html", file, [&] { writeData(mesh, file); });
}

}  // namespace af2::geometry
