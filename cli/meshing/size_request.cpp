#include "cli/meshing/size_request.h"

#include <fmt/core.h>

#include <utility>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"
#include "geometry/io/size_file.h"

namespace af2::cli {

void declareSizeOptions(CLI::App& command, SizeOptions& options) {
  command
      .add_option(
          "-s,--size", options.size,
          "wanted edge length; in millimetres for STEP and IGES files, whatever unit they use, "
          "otherwise in the unit of the file")
      ->type_name("SIZE")
      ->required();
  command.add_option("--min-size", options.smallest, "lower limit of the wanted size")
      ->type_name("SIZE");
  command.add_option("--max-size", options.largest, "upper limit of the wanted size")
      ->type_name("SIZE");
  command
      .add_option("--curvature", options.curvature,
                  "number of elements around a full turn of a curved face or edge, e.g. 20")
      ->type_name("N");
  command
      .add_option("--proximity", options.proximity,
                  "number of elements across strips of faces, walls and gaps, e.g. 3")
      ->type_name("N");
  command
      .add_option("--grading", options.grading,
                  "largest growth of the size per unit of length, default 0.3")
      ->type_name("GROWTH");
  command
      .add_option("--sizes", options.file,
                  "JSON file with sizes at points, in boxes, in fields and of named parts")
      ->type_name("FILE");
  command
      .add_option("--face-size", options.faceSizes,
                  "a different size for some faces, by number or name, e.g. 3,7-9=0.1 or "
                  "inlet=0.1")
      ->type_name("FACES=SIZE")
      ->take_all()
      ->expected(1);
  command
      .add_option("--edge-size", options.edgeSizes,
                  "a different size along some edges, e.g. 5=0.05")
      ->type_name("EDGES=SIZE")
      ->take_all()
      ->expected(1);
}

geometry::Sizes checkedSizes(const SizeOptions& options) {
  geometry::Sizes sizes;
  sizes.size = parseSize("--size", options.size);
  if (!options.smallest.empty()) sizes.minSize = parseSize("--min-size", options.smallest);
  if (!options.largest.empty()) sizes.maxSize = parseSize("--max-size", options.largest);
  if (sizes.minSize > sizes.maxSize)
    throw UsageError(
        fmt::format("--min-size {} is above --max-size {}", options.smallest, options.largest));
  if (!options.curvature.empty()) {
    sizes.elementsPerTurn =
        parsePositive("--curvature", options.curvature, "the number of elements around a turn");
    if (sizes.elementsPerTurn < 3)
      throw UsageError(
          fmt::format("--curvature {}: a turn needs at least 3 elements", options.curvature));
  }
  if (!options.proximity.empty())
    sizes.elementsAcross =
        parsePositive("--proximity", options.proximity, "the number of elements across");
  if (!options.grading.empty()) {
    sizes.growth = parsePositive("--grading", options.grading, "the growth");
    if (sizes.growth > geometry::kMaxGrowth)
      throw UsageError(fmt::format("--grading {}: the growth must be at most {} per unit of length",
                                   options.grading, geometry::kMaxGrowth));
  }
  FaceSizeList faceSizes = parseFaceSizes("--face-size", options.faceSizes);
  sizes.faceSizes = std::move(faceSizes.byId);
  sizes.edgeSizes = parseSizes("--edge-size", options.edgeSizes);
  if (!options.file.empty()) {
    geometry::SizeFile file = geometry::readSizeFile(options.file);
    sizes.sources = std::move(file.sources);
    sizes.partSizes = std::move(file.parts);
  }
  // The last match counts.
  sizes.partSizes.insert(sizes.partSizes.end(), faceSizes.byName.begin(), faceSizes.byName.end());
  return sizes;
}

}  // namespace af2::cli
