// STL files: solids of triangles without shared vertices.
#include <array>
#include <cmath>
#include <cstring>

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/faceted/facet_parts.h"
#include "geometry/faceted/formats.h"

namespace af2::geometry {
namespace {

void addTriangle(Facets& facets, const Point3& a, const Point3& b, const Point3& c) {
  const auto first = static_cast<std::uint32_t>(facets.vertices.size());
  facets.vertices.insert(facets.vertices.end(), {a, b, c});
  facets.triangles.push_back({first, first + 1, first + 2});
}

void readTextStl(const std::string& text, Facets& facets) {
  Words words(facets.name, text);
  FacetParts parts(facets);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid") {
      parts.begin(words.restOfLine());
    } else if (word == "endsolid") {
      words.skipLine();
    } else if (word == "outer") {
      words.next();  // loop
      std::array<Point3, 3> corners;
      for (Point3& corner : corners) {
        if (words.next() != "vertex") words.fail("expected 'vertex'");
        corner = words.point();
      }
      addTriangle(facets, corners[0], corners[1], corners[2]);
    } else if (word == "facet") {
      words.skipLine();  // a normal, which also follows from the corners
    } else if (word != "endloop" && word != "endfacet") {
      words.fail("'" + std::string(word) + "' is not known in an STL file");
    }
  }
  parts.close();
}

void readBinaryStl(const std::string& data, std::uint32_t count, Facets& facets) {
  constexpr std::size_t kHead = 84, kRecord = 50, kNormal = 12;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::array<float, 9> x;
    std::memcpy(x.data(), data.data() + kHead + kRecord * i + kNormal, sizeof x);
    for (const float value : x)
      if (!std::isfinite(value))
        throw InputError(facets.name + ": triangle " + std::to_string(i + 1) +
                         " has a coordinate that is not a number");
    addTriangle(facets, {x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]});
  }
}

/// Some programs write more after the triangles.
void readBinaryStlAndMore(const std::string& data, std::uint32_t count, Facets& facets) {
  readBinaryStl(data, count, facets);
  facets.notes.push_back(std::to_string(data.size() - 84 - 50 * std::size_t{count}) +
                         " bytes after the last of " + std::to_string(count) +
                         " triangles were ignored");
}

}  // namespace

/// The size decides, because text files may begin with anything, and binary files with "solid".
void readStl(const std::string& data, Facets& facets) {
  std::uint32_t count = 0;
  if (data.size() >= 84) std::memcpy(&count, data.data() + 80, sizeof count);
  if (data.size() >= 84 && data.size() == 84 + 50 * std::size_t{count})
    readBinaryStl(data, count, facets);
  else if (data.find("facet") != std::string::npos || data.find("endsolid") != std::string::npos)
    readTextStl(data, facets);
  else if (count > 0 && data.size() > 84 + 50 * std::size_t{count})
    readBinaryStlAndMore(data, count, facets);
  else
    throw InputError(facets.name + ": is not an STL file, or is truncated: " +
                     std::to_string(data.size()) + " bytes");
}

}  // namespace af2::geometry
