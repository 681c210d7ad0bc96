#include "geometry/meshing/part_sizes.h"

#include <cmath>
#include <set>
#include <string_view>

#include "engine/base/error.h"

namespace af2::geometry {

namespace {

/// The number of bytes of the UTF-8 character that begins here.
std::size_t bytesOf(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) ++end;
  return end - at;
}

/// "solid 1" and "color #ff0000". The first word must be written out, lest "s*" mean all solids.
bool fitsInMeshFiles(const FaceGroup& group, const std::string& pattern) {
  if (group.kind != GroupKind::Solid && group.kind != GroupKind::Color) return false;
  const std::string kind = std::string(toString(group.kind)) + " ";
  return pattern.starts_with(kind) && fitsPattern(group.name, pattern.substr(kind.size()));
}

}  // namespace

bool fitsPattern(const std::string& name, const std::string& pattern) {
  constexpr std::size_t kNone = std::string::npos;
  std::size_t n = 0, p = 0, star = kNone, afterStar = 0;  // the last `*`, and what it takes up to
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      afterStar = n;
    } else if (p < pattern.size() && pattern[p] == '?') {
      n += bytesOf(name, n);
      ++p;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++n;
      ++p;
    } else if (star != kNone) {
      n = ++afterStar;
      p = star + 1;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == kNone;
}

std::vector<int> facesCalled(const std::string& pattern, std::span<const std::string> names,
                             std::span<const FaceGroup> groups) {
  std::set<int> faces;
  for (const FaceGroup& group : groups)
    if (fitsPattern(group.name, pattern) || fitsInMeshFiles(group, pattern))
      faces.insert(group.faces.begin(), group.faces.end());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (fitsPattern(names[i], pattern)) faces.insert(static_cast<int>(i) + 1);
  return {faces.begin(), faces.end()};
}

std::vector<int> withFacesCalled(std::vector<int> faces, std::span<const std::string> patterns,
                                 std::span<const std::string> names,
                                 std::span<const FaceGroup> groups) {
  for (const std::string& pattern : patterns) {
    const std::vector<int> called = facesCalled(pattern, names, groups);
    if (called.empty())
      throw InputError("there is no face or group called '" + pattern + "' (see af2 inspect)");
    faces.insert(faces.end(), called.begin(), called.end());
  }
  return faces;
}

std::vector<int> facesNamed(const std::string& pattern, std::span<const std::string> names,
                            std::span<const FaceGroup> groups) {
  std::vector<int> faces = facesCalled(pattern, names, groups);
  if (faces.empty())
    throw InputError("the sizes are for parts named '" + pattern +
                     "', but no face or group has such a name (see af2 inspect)");
  return faces;
}

std::map<int, double> sizesByName(std::span<const std::pair<std::string, double>> parts,
                                  std::span<const std::string> names,
                                  std::span<const FaceGroup> groups) {
  std::map<int, double> sizes;
  for (const auto& [pattern, size] : parts) {
    if (!(size > 0) || !std::isfinite(size))
      throw InputError("the size for parts named '" + pattern + "' must be a positive number");
    for (const int face : facesNamed(pattern, names, groups)) sizes[face] = size;
  }
  return sizes;
}

}  // namespace af2::geometry
