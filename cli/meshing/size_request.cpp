#include "cli/meshing/size_request.h"

#include <fmt/core.h>

#include <limits>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"
#include "geometry/domain/domain_check.h"

namespace af2::cli {

void declareSizeOptions(CLI::App& command, SizeOptions& options) {
  command
      .add_option("-s,--size", options.size,
                  "wanted edge length: in millimetres for STEP and IGES files, whatever these use, "
                  "else in the "
                  "unit of the file")
      ->type_name("SIZE")
      ->required();
  command.add_option("--min-size", options.smallest, "no wanted size is smaller than this")
      ->type_name("SIZE");
  command.add_option("--max-size", options.largest, "no wanted size is larger than this")
      ->type_name("SIZE");
  command
      .add_option("--curvature", options.curvature,
                  "elements around a full turn of a curved face or edge, e.g. 20")
      ->type_name("N");
  command
      .add_option("--proximity", options.proximity,
                  "elements across strips of faces, walls and gaps, e.g. 3")
      ->type_name("N");
  command
      .add_option("--grading", options.grading,
                  "most growth of the size per unit of length, default 0.3")
      ->type_name("GROWTH");
  command
      .add_option("--sizes", options.file,
                  "file (JSON) with sizes at points, in boxes, in fields, of named parts")
      ->type_name("FILE");
  command
      .add_option("--face-size", options.faceSizes, "another size for some faces, e.g. 3,7-9=0.1")
      ->type_name("FACES=SIZE")
      ->take_all()
      ->expected(1);
  command
      .add_option("--edge-size", options.edgeSizes, "another size along some edges, e.g. 5=0.05")
      ->type_name("EDGES=SIZE")
      ->take_all()
      ->expected(1);
}

SizeRequest checkedSizes(const SizeOptions& options) {
  SizeRequest request;
  request.size = parseSize("--size", options.size);
  if (!options.smallest.empty()) request.smallest = parseSize("--min-size", options.smallest);
  request.largest = options.largest.empty() ? std::numeric_limits<double>::infinity()
                                            : parseSize("--max-size", options.largest);
  if (request.smallest > request.largest)
    throw UsageError(
        fmt::format("--min-size {} is above --max-size {}", options.smallest, options.largest));
  if (!options.curvature.empty()) {
    request.elementsPerTurn =
        parsePositive("--curvature", options.curvature, "how many elements go round");
    if (request.elementsPerTurn < 3)
      throw UsageError(
          fmt::format("--curvature {}: a turn needs at least 3 elements", options.curvature));
  }
  if (!options.proximity.empty())
    request.elementsAcross =
        parsePositive("--proximity", options.proximity, "how many elements go across");
  if (!options.grading.empty()) {
    request.growth = parsePositive("--grading", options.grading, "the growth");
    if (request.growth > geometry::kMostGrowth)
      throw UsageError(fmt::format("--grading {}: the growth must be at most {} per unit of length",
                                   options.grading, geometry::kMostGrowth));
  }
  request.faceSizes = parseSizes("--face-size", options.faceSizes);
  request.edgeSizes = parseSizes("--edge-size", options.edgeSizes);
  if (!options.file.empty()) request.file = geometry::readSizeFile(options.file);
  return request;
}

}  // namespace af2::cli
