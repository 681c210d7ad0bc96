#include "geometry/meshing/check_options.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <string>
#include <system_error>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/meshing/edge_names.h"
#include "geometry/meshing/part_sizes.h"

namespace af2::geometry {

MemoryLimit memoryLimitOf(const MeshingOptions& options) {
  MemoryLimit limit{options.maxMemory, options.spool.when == SpoolRequest::When::Always,
                    threadCount(options.threads)};
  limit.isPacked = options.spool.where == SpoolRequest::Where::Memory;
  if (!limit.isSpooled || limit.isPacked) return limit;
  const std::filesystem::path& folder = options.spool.folder;
  std::error_code unknown;
  const auto space = std::filesystem::space(folder.empty() ? "." : folder, unknown);
  if (!unknown) limit.onDisk = static_cast<double>(space.available);
  return limit;
}

std::string whyNotSpooled(const MeshingOptions& options) {
  if (options.order != 1) return "have elements of second order";
  if (options.sizes.chords.areGiven()) return "keep to a distance from the model";
  if (options.sizes.elementsAcross > 0) return "have elements across narrow places";
  return "";
}

void checkOptions(const FaceSource& source, const MeshingOptions& options) {
  const auto check = [](const std::string& what, const std::string& kind, int id, int count) {
    if (id < 1 || id > count)
      throw InputError(what + kind + " " + std::to_string(id) + ": the model has " + kind +
                       "s 1 to " + std::to_string(count));
  };
  checkSizes(options.sizes);
  for (const auto& [face, size] : options.sizes.faceSizes)
    check("size for ", "face", face, source.faceCount());
  for (const auto& [face, bound] : options.sizes.chords.faces)
    check("distance for ", "face", face, source.faceCount());
  for (const auto& [edge, size] : options.sizes.edgeSizes)
    check("size for ", "edge", edge, source.edgeCount());
  if (options.fewest && (!options.sizes.chords.areGiven() || options.order != 1))
    throw InputError("the fewest elements need a bound on the distance, and order 1");
  if (options.fewest && !options.layers.empty())
    throw InputError("layers cannot be combined with the fewest elements, which have any shape");
  if (options.order != 1 && options.order != 2) throw InputError("elements can have order 1 or 2");
  for (const auto& [edge, points] : options.edgePoints)
    check("points for ", "edge", edge, source.edgeCount());
  if (const std::string why = whyNotSpooled(options);
      options.spool.when == SpoolRequest::When::Always && !why.empty())
    throw InputError("a mesh that is put on disk face by face cannot " + why);
  for (const int face : options.faces) check("", "face", face, source.faceCount());
}

namespace {

/// Of several names of an edge, the last one counts.
std::map<int, double> edgeSizesByName(const FaceSource& source,
                                      const std::vector<std::pair<std::string, double>>& names) {
  std::map<int, double> sizes;
  for (const auto& [name, size] : names) {
    if (!(size > 0) || !std::isfinite(size))
      throw InputError("the size for edges named '" + name + "' must be a positive number");
    for (const int edge : edgesNamed(source, name)) sizes[edge] = size;
  }
  return sizes;
}

}  // namespace

MeshingOptions optionsFor(const FaceSource& source, MeshingOptions options) {
  Sizes& sizes = options.sizes;
  if (!sizes.partSizes.empty() || !options.faceNames.empty() || !sizes.chords.parts.empty()) {
    std::vector<std::string> names;
    for (int face = 1; face <= source.faceCount(); ++face)
      names.push_back(source.reportOf(face).name);
    // What is given by id takes precedence.
    sizes.faceSizes.merge(sizesByName(std::exchange(sizes.partSizes, {}), names, source.groups()));
    options.faces = withFacesCalled(std::move(options.faces), std::exchange(options.faceNames, {}),
                                    names, source.groups());
    std::map<int, ChordBound> chords;
    for (const auto& [pattern, bound] : std::exchange(sizes.chords.parts, {}))
      for (const int face : facesNamed(pattern, names, source.groups())) chords[face] = bound;
    sizes.chords.faces.merge(chords);
  }
  sizes.edgeSizes.merge(edgeSizesByName(source, std::exchange(sizes.edgeNames, {})));
  options.layers = layersById(source, std::move(options.layers));
  sizes = withinExtent(std::move(sizes), source.diagonal());
  return options;
}

std::vector<int> facesAskedFor(const FaceSource& source, const MeshingOptions& options) {
  std::vector<int> faces = options.faces;
  if (faces.empty()) {
    faces.resize(static_cast<std::size_t>(source.faceCount()));
    std::iota(faces.begin(), faces.end(), 1);
  }
  std::ranges::sort(faces);
  faces.erase(std::ranges::unique(faces).begin(), faces.end());
  return faces;
}

}  // namespace af2::geometry
