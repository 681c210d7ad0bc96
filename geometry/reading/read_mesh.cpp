#include "geometry/reading/read_mesh.h"

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/reading/formats.h"

namespace af2::geometry {

std::span<const MeshFileFormat> meshFileFormats() { return kMeshFileFormats; }

MeshFile readMesh(const std::filesystem::path& path) {
  const MeshFileFormat* const format = formatOf(meshFileFormats(), path);
  if (!format) {
    std::vector<std::string_view> extensions;
    for (const MeshFileFormat& known : meshFileFormats()) extensions.push_back(known.extensions[0]);
    throw InputError(path.string() + ": is not a mesh file that AF2 reads; give a file in one of " +
                     listed(extensions, "or"));
  }
  MeshBuilder mesh(path.string());
  format->read(contentOf(path), mesh);
  return mesh.finish();
}

}  // namespace af2::geometry
