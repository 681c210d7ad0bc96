#include "geometry/planar/planar_file.h"

#include "engine/base/error.h"
#include "geometry/planar/formats.h"

namespace af2::geometry {

std::span<const PlanarFormat> planarFormats() { return kPlanarFormats; }

PlanarDomain readPlanar(const std::filesystem::path& path) {
  const PlanarFormat* format = formatOf(planarFormats(), path);
  if (!format)
    throw InputError(path.string() + ": its extension is not that of a format of planar domains");
  return format->read(path);
}

}  // namespace af2::geometry
