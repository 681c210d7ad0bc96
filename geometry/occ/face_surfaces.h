// The surfaces of all faces of a model, each made once.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "geometry/occ/face_surface.h"

namespace af2::geometry {

/// To make a surface takes longer than to mesh a small face, and every edge of the face, every
/// piece of it and every run needs it. Threads may share this.
class FaceSurfaces {
 public:
  explicit FaceSurfaces(int faces)
      : slots_(std::make_unique<Slot[]>(static_cast<std::size_t>(faces))) {}

  /// A copy of the surface of a face, whose number is `id`; made when it is first asked for. Throws
  /// GeometryError if the face has none.
  FaceSurface of(const TopoDS_Face& face, int id) const {
    Slot& slot = slots_[static_cast<std::size_t>(id) - 1];
    std::call_once(slot.once, [&] { slot.surface.emplace(face); });
    return *slot.surface;
  }

 private:
  struct Slot {
    std::once_flag once;
    std::optional<FaceSurface> surface;
  };
  std::unique_ptr<Slot[]> slots_;
};

}  // namespace af2::geometry
