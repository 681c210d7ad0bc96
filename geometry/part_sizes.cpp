#include "geometry/part_sizes.h"

#include <fnmatch.h>

#include "engine/error.h"

namespace af2::geometry {

bool fitsPattern(const std::string& name, const std::string& pattern) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::map<int, double> sizesByName(std::span<const std::pair<std::string, double>> parts,
                                  std::span<const std::string> names,
                                  std::span<const FaceGroup> groups) {
  std::map<int, double> sizes;
  for (const auto& [pattern, size] : parts) {
    bool fits = false;
    for (const FaceGroup& group : groups) {
      if (!fitsPattern(group.name, pattern)) continue;
      for (const int face : group.faces) sizes[face] = size;
      fits = true;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!fitsPattern(names[i], pattern)) continue;
      sizes[static_cast<int>(i) + 1] = size;
      fits = true;
    }
    if (!fits)
      throw InputError("the sizes are for parts named '" + pattern +
                       "', but no face or group has such a name (see af2 inspect)");
  }
  return sizes;
}

}  // namespace af2::geometry
