// How faces were filled, for models that are meshed several times. Not installed.
#pragma once

#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/mesh/front_input.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// A face on the same surface with the same numbers is filled in the same way: what was found
/// before is used again. May be used by several threads at once.
class FaceMemory {
 public:
  struct Key {
    std::shared_ptr<const ChartedSurface> surface;
    std::vector<double> numbers;  ///< all else on which the mesh depends
    void add(const std::vector<BoundaryCorner>& corners);
  };
  struct Filled {
    /// Without what depends on the numbers of points and edges: `boundary` and `uses`.
    FaceMesh mesh;
    std::exception_ptr failure;  ///< with which the attempt ended; null: it did not fail
  };

  /// Null if the face was never filled, or was not kept.
  std::shared_ptr<const Filled> find(const Key& key) const;
  /// So many faces are kept that their elements take no more than some hundred megabytes.
  void keep(const Key& key, std::shared_ptr<const Filled> filled);

 private:
  using Known = std::pair<std::vector<double>, std::shared_ptr<const Filled>>;
  mutable std::mutex mutex_;
  std::map<std::shared_ptr<const ChartedSurface>, std::vector<Known>> known_;
  std::size_t elements_ = 0;
};

}  // namespace af2::geometry
