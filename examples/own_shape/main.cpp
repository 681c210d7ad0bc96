// Meshes a shape that this program makes, with names for its faces: own_shape SIZE OUTPUT
#include <cstdio>
#include <cstdlib>
#include <exception>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <af2/dsl/rule_file.h>
#include <af2/engine/algorithm.h>
#include <af2/engine/error.h>
#include <af2/geometry/mesh_files.h>
#include <af2/geometry/mesh_model.h>
#include <af2/geometry/model_from_shape.h>

namespace {

/// A pipe whose faces have names.
af2::geometry::Model pipe() {
  const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(1, 4).Shape();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return af2::geometry::modelFrom(
      shape,
      {.names = {{faces(1), "wall"}, {faces(2), "outlet"}, {faces(3), "inlet"}}, .unit = "mm"});
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: own_shape SIZE OUTPUT\n");
    return 2;
  }
  try {
    const af2::dsl::LoadedRules loaded = af2::dsl::loadRules(RULES);
    if (!loaded.rules) throw af2::InputError(af2::dsl::toPretty(loaded.diagnostics));
    af2::geometry::MeshingOptions options;
    options.sizes.size = std::atof(arguments[1]);
    const af2::geometry::ModelMesh mesh =
        af2::geometry::meshModel(pipe(), af2::AF2Algorithm(loaded.rules), options);
    af2::geometry::writeMesh(mesh, arguments[2]);
    for (const af2::geometry::FaceReport& face : mesh.faces)
      std::printf("%s: %zu elements\n", face.name.c_str(), face.elements);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
