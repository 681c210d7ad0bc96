#include "cli/meshing/layers_request.h"

#include <fmt/core.h>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"

namespace af2::cli {
namespace {

/// Up to a comma; the rest remains.
std::string takeWord(std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  std::string word = text.substr(0, comma);
  text.erase(0, std::min(comma + 1, text.size()));
  return word;
}

void takeHeights(const std::string& text, std::string heights, geometry::LayerRequest& request) {
  const auto positive = [&](const char* what) {
    const std::string word = takeWord(heights);
    try {
      return parsePositive("--layers", word, what);
    } catch (const UsageError&) {
      throw UsageError(
          fmt::format("--layers '{}': {} must be a number greater than 0", text, what));
    }
  };
  request.first = positive("the height of the first layer");
  request.growth = positive("the growth, the ratio of the heights of successive layers,");
  const double count = positive("the number of layers");
  if (count != static_cast<int>(count) || count > geometry::kMaxLayers)
    throw UsageError(
        fmt::format("--layers '{}': the number of layers must be a whole number from "
                    "1 to {}",
                    text, geometry::kMaxLayers));
  if (!heights.empty())
    throw UsageError(fmt::format("--layers '{}': there are more than three numbers", text));
  request.count = static_cast<int>(count);
}

geometry::LayerRequest parseLayers(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError(fmt::format(
        "--layers '{}': write edges, '=', the height of the first layer, the growth and "
        "the number of layers, such as 3,7-9=0.01,1.2,5",
        text));
  geometry::LayerRequest request;
  const std::size_t at = std::min(text.rfind('@', equals), equals);
  if (at > 0) {
    FaceList edges = parseFaces("--layers", text.substr(0, at), "edge");
    request.edges = std::move(edges.ids);
    request.edgeNames = std::move(edges.names);
  }
  if (at < equals) {
    FaceList faces = parseFaces("--layers", text.substr(at + 1, equals - at - 1));
    request.faces = std::move(faces.ids);
    request.faceNames = std::move(faces.names);
  }
  takeHeights(text, text.substr(equals + 1), request);
  return request;
}

}  // namespace

void declareLayers(CLI::App& command, std::vector<std::string>& layers) {
  command
      .add_option(
          "--layers", layers,
          "layers of quadrilaterals along edges: height of the first layer, growth from "
          "layer to layer, and number, e.g. 3,7-9=0.01,1.2,5; on one face only: "
          "3@2=0.01,1.2,5; along all edges of a face: @2=0.01,1.2,5. Edges by number, or by "
          "the name of a boundary or of a face beside them")
      ->type_name("EDGES=FIRST,GROWTH,N")
      ->take_all()
      ->expected(1);
}

std::vector<geometry::LayerRequest> checkedLayers(const std::vector<std::string>& layers) {
  std::vector<geometry::LayerRequest> requests;
  for (const std::string& text : layers) requests.push_back(parseLayers(text));
  return requests;
}

}  // namespace af2::cli
