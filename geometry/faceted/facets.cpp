#include "geometry/faceted/facets.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>
#include <sstream>
#include <string_view>
#include <tuple>

#include "engine/base/error.h"
#include "geometry/base/file_extension.h"
#include "geometry/faceted/polygon_triangles.h"
#include "geometry/faceted/repair_facets.h"

namespace af2::geometry {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  if (fs::is_directory(path)) throw InputError(path.string() + ": is a folder, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string() + ": cannot be opened; check that it exists");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The words of a text, with the line of the last one.
class Words {
 public:
  Words(std::string name, std::string_view text) : name_(std::move(name)), text_(text) {}

  /// Empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && isBlank(text_[at_])) line_ += text_[at_++] == '\n';
    const std::size_t first = at_;
    while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
    return text_.substr(first, at_ - first);
  }
  double number() {
    std::string_view word = next();
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      fail("'" + std::string(word) + "' is no number");
    return value;
  }
  Point3 point() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  void skipLine() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }
  /// The rest of the line, and of those that it goes on in after a backslash.
  std::string_view restOfLine() {
    const std::size_t first = at_;
    skipLine();
    while (at_ < text_.size() && endsInBackslash(text_.substr(first, at_ - first))) {
      ++line_;
      ++at_;
      skipLine();
    }
    return text_.substr(first, at_ - first);
  }
  [[noreturn]] void fail(const std::string& fault) const {
    throw InputError(name_ + ":" + std::to_string(line_) + ": " + fault);
  }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  static bool endsInBackslash(std::string_view line) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line.ends_with('\\');
  }

  std::string name_;
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

void addTriangle(Facets& facets, const Point3& a, const Point3& b, const Point3& c) {
  const auto first = static_cast<std::uint32_t>(facets.vertices.size());
  facets.vertices.insert(facets.vertices.end(), {a, b, c});
  facets.triangles.push_back({first, first + 1, first + 2});
}

/// The parts of a file; triangles that are added belong to the one that was begun last.
class Parts {
 public:
  explicit Parts(Facets& facets) : facets_(facets) {}

  void begin(std::string_view name) {
    while (!name.empty() && isBlank(name.front())) name.remove_prefix(1);
    while (!name.empty() && isBlank(name.back())) name.remove_suffix(1);
    close();
    const auto found = std::ranges::find(facets_.groupNames, name);
    current_ = static_cast<std::uint32_t>(found - facets_.groupNames.begin());
    if (found == facets_.groupNames.end()) facets_.groupNames.emplace_back(name);
  }
  /// Gives all triangles so far their part.
  void close() {
    if (facets_.groupNames.empty()) {
      begin_ = facets_.triangles.size();
      return;
    }
    if (begin_ > 0 && facets_.group.empty()) {
      facets_.groupNames.emplace_back();  // those before the first part
      facets_.group.resize(begin_, static_cast<std::uint32_t>(facets_.groupNames.size() - 1));
    }
    facets_.group.resize(facets_.triangles.size(), current_);
  }

 private:
  static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

  Facets& facets_;
  std::uint32_t current_ = 0;
  std::size_t begin_ = 0;  ///< triangles before the first part
};

void readTextStl(const std::string& text, Facets& facets) {
  Words words(facets.name, text);
  Parts parts(facets);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid") {
      parts.begin(words.restOfLine());
    } else if (word == "endsolid") {
      words.skipLine();
    } else if (word == "outer") {
      words.next();  // loop
      std::array<Point3, 3> corners;
      for (Point3& corner : corners) {
        if (words.next() != "vertex") words.fail("'vertex' should stand here");
        corner = words.point();
      }
      addTriangle(facets, corners[0], corners[1], corners[2]);
    } else if (word == "facet") {
      words.skipLine();  // a normal, which the corners tell as well
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
                         " triangles were passed over");
}

/// The size tells: text files may begin with anything, and binary ones with "solid".
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
    throw InputError(facets.name +
                     ": is no STL file, or is cut off: " + std::to_string(data.size()) + " bytes");
}

/// "7/1/3" means vertex 7, "-1" the last one so far.
std::uint32_t cornerFrom(std::string_view word, const Facets& facets, const Words& words) {
  long index = 0;
  const std::string_view number = word.substr(0, word.find('/'));
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
  const auto count = static_cast<long>(facets.vertices.size());
  if (error != std::errc() || end != number.data() + number.size())
    words.fail("'" + std::string(word) + "' is no vertex");
  if (index < 0) index += count + 1;
  if (index < 1 || index > count)
    words.fail("there is no vertex " + std::string(word) + "; there are " + std::to_string(count) +
               " so far");
  return static_cast<std::uint32_t>(index - 1);
}

void readObj(const std::string& text, Facets& facets) {
  Words words(facets.name, text);
  Parts parts(facets);
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
      std::istringstream line(rest);
      std::vector<std::uint32_t> corners;
      for (std::string corner; line >> corner;)
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

/// One vertex for each position, in the order in which they come first.
void mergeVertices(Facets& facets) {
  const auto key = [&](std::uint32_t i) {
    const Point3& p = facets.vertices[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::vector<std::uint32_t> order(facets.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(order.size()), renumbered(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  std::vector<Point3> merged;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      renumbered[i] = static_cast<std::uint32_t>(merged.size());
      merged.push_back(facets.vertices[i]);
    } else {
      renumbered[i] = renumbered[first[i]];
    }
  }
  facets.vertices = std::move(merged);
  for (auto& triangle : facets.triangles)
    for (std::uint32_t& corner : triangle) corner = renumbered[corner];
}

/// Triangles that join three vertices in a row stay: without them the surface would have a slit.
void dropCollapsedTriangles(Facets& facets) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const std::array<std::uint32_t, 3> t = facets.triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    if (!facets.group.empty()) facets.group[kept] = facets.group[i];
    facets.triangles[kept++] = t;
  }
  facets.triangles.resize(kept);
  if (!facets.group.empty()) facets.group.resize(kept);
}

/// However far away they lie, they are none of the surface.
void dropUnusedVertices(Facets& facets) {
  std::vector<bool> isUsed(facets.vertices.size(), false);
  for (const auto& triangle : facets.triangles)
    for (const std::uint32_t corner : triangle) isUsed[corner] = true;
  std::vector<std::uint32_t> renumbered(facets.vertices.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < isUsed.size(); ++i) {
    if (!isUsed[i]) continue;
    renumbered[i] = kept;
    facets.vertices[kept++] = facets.vertices[i];
  }
  facets.vertices.resize(kept);
  for (auto& triangle : facets.triangles)
    for (std::uint32_t& corner : triangle) corner = renumbered[corner];
}

}  // namespace

Facets readFacets(const fs::path& path) {
  Facets facets;
  facets.name = path.string();
  const std::string content = contentOf(path);
  extensionOf(path) == ".obj" ? readObj(content, facets) : readStl(content, facets);
  mergeVertices(facets);
  dropCollapsedTriangles(facets);
  dropUnusedVertices(facets);
  if (facets.triangles.empty()) throw InputError(facets.name + ": holds no triangle");
  repairFacets(facets);
  if (facets.triangles.empty())
    throw InputError(facets.name + ": no triangle is left when what is no surface is repaired" +
                     (facets.notes.empty() ? "" : ": " + facets.notes.back()));
  return facets;
}

}  // namespace af2::geometry
