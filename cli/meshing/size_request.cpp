#include "cli/meshing/size_request.h"

#include <fmt/core.h>

#include <string_view>
#include <utility>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"
#include "geometry/io/size_file.h"
#include "geometry/reading/size_field.h"

namespace af2::cli {

void declareSizeOptions(CLI::App& command, SizeOptions& options) {
  command
      .add_option(
          "-s,--size", options.size,
          "wanted edge length; in millimetres for STEP and IGES files, whatever unit they use, "
          "otherwise in the unit of the file. May be left out with --fewest")
      ->type_name("SIZE");
  command.add_option("--min-size", options.smallest, "lower limit of the wanted size")
      ->type_name("SIZE");
  command.add_option("--max-size", options.largest, "upper limit of the wanted size")
      ->type_name("SIZE");
  command
      .add_option("--curvature", options.curvature,
                  "number of elements around a full turn of a curved face or edge, e.g. 20, or the "
                  "angle by which an element may turn, e.g. 18deg")
      ->type_name("N");
  command
      .add_option("--chord", options.chord,
                  "largest distance between the mesh and the model: a length, or a share of the "
                  "size, e.g. 5%")
      ->type_name("D");
  command
      .add_option("--face-chord", options.faceChords,
                  "another largest distance on some faces, e.g. 3,7-9=0.01")
      ->type_name("FACES=D")
      ->take_all()
      ->expected(1);
  command.add_flag("--fewest", options.fewest,
                   "with --chord: as few triangles as it allows, of any size and shape");
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
      .add_option("--size-field", options.fields,
                  "sizes at the vertices of another mesh: node data of an .msh file, a view in a "
                  ".pos file or a point array in a .vtu file; FILE:ARRAY if there are several. May "
                  "be given several times")
      ->type_name("FILE")
      ->take_all()
      ->expected(1);
  command
      .add_option("--face-size", options.faceSizes,
                  "a different size for some faces, by number or name, e.g. 3,7-9=0.1 or "
                  "inlet=0.1")
      ->type_name("FACES=SIZE")
      ->take_all()
      ->expected(1);
  command
      .add_option(
          "--edge-size", options.edgeSizes,
          "a different size along some edges, by number or by the name of a boundary or of a "
          "face beside them, e.g. 5=0.05 or inlet=0.05")
      ->type_name("EDGES=SIZE")
      ->take_all()
      ->expected(1);
}

namespace {

geometry::ChordBound parseChord(const std::string& option, const std::string& text) {
  constexpr double kPercent = 0.01;
  const bool isShare = text.ends_with('%');
  const double value =
      parsePositive(option, isShare ? text.substr(0, text.size() - 1) : text, "the distance");
  return {isShare ? kPercent * value : value, isShare};
}

geometry::ChordBounds checkedChords(const SizeOptions& options) {
  geometry::ChordBounds chords;
  if (!options.chord.empty()) chords.everywhere = parseChord("--chord", options.chord);
  for (const std::string& text : options.faceChords) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw UsageError(
          fmt::format("--face-chord '{}': write ids, '=' and a distance, e.g. 3,7-9=0.01", text));
    const geometry::ChordBound bound = parseChord("--face-chord", text.substr(equals + 1));
    for (const int id : parseIds("--face-chord", text.substr(0, equals))) chords.faces[id] = bound;
  }
  return chords;
}

/// N elements around a turn, or the angle of each.
double parseTurn(const std::string& text) {
  constexpr std::string_view kDegrees = "deg";
  if (!text.ends_with(kDegrees))
    return parsePositive("--curvature", text, "the number of elements around a turn");
  return 360 / parsePositive("--curvature", text.substr(0, text.size() - kDegrees.size()),
                             "the angle of an element");
}

/// Without a size, only the part and the distance limit the elements.
double checkedSize(const SizeOptions& options) {
  constexpr double kUnlimited = 1e300;
  if (!options.size.empty()) return parseSize("--size", options.size);
  if (!options.fewest) throw UsageError("--size is required");
  if (options.chord.ends_with('%'))
    throw UsageError("--chord " + options.chord + ": a share of the size needs --size");
  return kUnlimited;
}

}  // namespace

geometry::Sizes checkedSizes(const SizeOptions& options) {
  geometry::Sizes sizes;
  sizes.chords = checkedChords(options);
  if (options.fewest && !sizes.chords.everywhere.isGiven())
    throw UsageError("--fewest needs --chord, the largest distance from the model");
  sizes.size = checkedSize(options);
  if (!options.smallest.empty()) sizes.minSize = parseSize("--min-size", options.smallest);
  if (!options.largest.empty()) sizes.maxSize = parseSize("--max-size", options.largest);
  if (sizes.minSize > sizes.maxSize)
    throw UsageError(
        fmt::format("--min-size {} is above --max-size {}", options.smallest, options.largest));
  if (!options.curvature.empty()) {
    sizes.elementsPerTurn = parseTurn(options.curvature);
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
  FaceSizeList edgeSizes = parseFaceSizes("--edge-size", options.edgeSizes, "edge");
  sizes.edgeSizes = std::move(edgeSizes.byId);
  sizes.edgeNames = std::move(edgeSizes.byName);
  if (!options.file.empty()) {
    geometry::SizeFile file = geometry::readSizeFile(options.file);
    sizes.sources = std::move(file.sources);
    sizes.partSizes = std::move(file.parts);
    sizes.chords.parts = std::move(file.chords);
  }
  for (const std::string& field : options.fields)
    sizes.sources.cells.push_back(geometry::readSizeField(geometry::sizeFieldName(field)));
  // The last match counts.
  sizes.partSizes.insert(sizes.partSizes.end(), faceSizes.byName.begin(), faceSizes.byName.end());
  return sizes;
}

}  // namespace af2::cli
