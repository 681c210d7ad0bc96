// The named parts of a file of triangles.
// Not installed.
#pragma once

#include <algorithm>
#include <string_view>

#include "geometry/base/words.h"
#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// The parts of a file; added triangles belong to the part that was begun last.
class FacetParts {
 public:
  explicit FacetParts(Facets& facets) : facets_(facets) {}

  void begin(std::string_view name) {
    name = trimmed(name);
    close();
    const auto found = std::ranges::find(facets_.groupNames, name);
    current_ = static_cast<std::uint32_t>(found - facets_.groupNames.begin());
    if (found == facets_.groupNames.end()) facets_.groupNames.emplace_back(name);
  }
  /// Assigns the part to all triangles added since it was begun.
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
  Facets& facets_;
  std::uint32_t current_ = 0;
  std::size_t begin_ = 0;  ///< triangles before the first part
};

}  // namespace af2::geometry
