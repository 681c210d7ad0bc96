#include "tests/support/small_meshes.h"

#include "tests/support/element.h"

namespace af2::geometry {
namespace {

using testing::elementOf;

void addFace(ModelMesh& mesh, int id, std::array<std::size_t, 4> c) {
  mesh.elements.push_back(elementOf({c[0], c[1], c[2]}));
  mesh.elements.push_back(elementOf({c[0], c[2], c[3]}));
  for (int i = 0; i < 2; ++i) mesh.face.push_back(id);
  for (const std::uint16_t rule : {0, 1}) mesh.origins.push_back({rule});
  mesh.faces.push_back({id, "", "plane", "plane", FaceStatus::Complete, 2, 0.25, 1, ""});
}

}  // namespace

ModelMesh cubeMesh() {
  ModelMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const Point3& p : {Point3{0, 0, z}, Point3{1, 0, z}, Point3{1, 1, z}, Point3{0, 1, z}}) {
      mesh.vertices.push_back(p);
    }
  }
  mesh.ruleNames = {"free \"triangle\" <a & b>", "right 60", "close quad"};
  addFace(mesh, 1, {0, 3, 2, 1});
  addFace(mesh, 2, {0, 1, 5, 4});
  addFace(mesh, 3, {1, 2, 6, 5});
  addFace(mesh, 4, {2, 3, 7, 6});
  addFace(mesh, 5, {3, 0, 4, 7});
  mesh.elements.push_back(elementOf({4, 5, 6, 7}));
  mesh.face.push_back(6);
  mesh.origins.push_back({2});
  mesh.faces.push_back({6, "lid", "plane", "plane", FaceStatus::Complete, 1, 0.25, 1, ""});
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.segments.push_back(
        {VertexId(4 + i), VertexId(4 + (i + 1) % 4), static_cast<int>(i) + 1, 2});
  }
  mesh.groups = {{"lower half", GroupKind::Part, {1, 2}},
                 {"lid", GroupKind::Layer, {6}},
                 {"#ff8000", GroupKind::Color, {2, 6}},
                 {"1", GroupKind::Solid, {1, 2, 3, 4, 5, 6}}};
  return mesh;
}

ModelMesh oneElement(std::vector<Point3> corners) {
  ModelMesh mesh;
  Element only;
  for (std::size_t i = 0; i < corners.size(); ++i) only.corners[i] = VertexId(i);
  mesh.vertices = std::move(corners);
  mesh.elements = {only};
  mesh.face = {1};
  mesh.origins.resize(1);
  mesh.ruleNames = {"only"};
  mesh.faces = {{1, "", "plane", "plane", FaceStatus::Complete, 1, 0, 1, ""}};
  return mesh;
}

}  // namespace af2::geometry
