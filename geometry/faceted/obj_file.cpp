// Wavefront OBJ files: polygons between numbered vertices.
#include <algorithm>

#include "geometry/base/words.h"
#include "geometry/faceted/facet_parts.h"
#include "geometry/faceted/formats.h"
#include "geometry/faceted/polygon_triangles.h"

namespace af2::geometry {
namespace {

/// "7/1/3" means vertex 7, "-1" the last one so far.
std::uint32_t cornerFrom(std::string_view word, const Facets& facets, const Words& words) {
  const auto number = numberIn<long>(word.substr(0, word.find('/')));
  const auto count = static_cast<long>(facets.vertices.size());
  if (!number) words.fail("'" + std::string(word) + "' is not a vertex number");
  const long index = *number < 0 ? *number + count + 1 : *number;
  if (index < 1 || index > count)
    words.fail("there is no vertex " + std::string(word) + "; there are " + std::to_string(count) +
               " so far");
  return static_cast<std::uint32_t>(index - 1);
}

}  // namespace

void readObj(const std::string& text, Facets& facets) {
  Words words(facets.name, text);
  FacetParts parts(facets);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "g" || word == "o") {
      parts.begin(words.restOfLine());
      continue;
    }
    if (word == "v") {
      facets.vertices.push_back(words.point());
    } else if (word == "f") {
      std::string rest(words.restOfLine());
      std::ranges::replace(rest, '\\', ' ');
      std::vector<std::uint32_t> corners;
      for (const std::string_view corner : wordsIn(rest))
        corners.push_back(cornerFrom(corner, facets, words));
      if (corners.size() < 3) words.fail("a face has at least three vertices");
      for (const auto& triangle : trianglesOfPolygon(facets.vertices, corners))
        facets.triangles.push_back(triangle);
      continue;
    }
    words.skipLine();
  }
  parts.close();
}

}  // namespace af2::geometry
