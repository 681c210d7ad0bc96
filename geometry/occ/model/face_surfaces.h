// The surfaces of all faces of a model, each made once.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// A cache of surfaces. Making a surface takes longer than meshing a small face, and every edge of
/// the face, every piece of it and every run needs it. Threads may share this.
class FaceSurfaces {
 public:
  explicit FaceSurfaces(int faces)
      : slots_(std::make_unique<Slot[]>(static_cast<std::size_t>(faces))) {}
  /// The same surfaces, except those of faces that have creases.
  FaceSurfaces(std::shared_ptr<const FaceSurfaces> others, int faces,
               std::map<int, FaceCells> cells)
      : others_(std::move(others)),
        slots_(std::make_unique<Slot[]>(static_cast<std::size_t>(faces))),
        cells_(std::move(cells)) {}

  /// A copy of the surface of the face with the number `id`; the original is made at the first
  /// request. Throws GeometryError if the face has none.
  FaceSurface of(const TopoDS_Face& face, int id) const { return original(face, id); }
  /// Without a copy of the surface, because copying is expensive.
  std::vector<SharpTip> sharpTipsOf(const TopoDS_Face& face, int id) const {
    return original(face, id).sharpTips();
  }

 private:
  /// The shared original, which must not be evaluated.
  const FaceSurface& original(const TopoDS_Face& face, int id) const {
    const auto cells = cells_.find(id);
    if (others_ && cells == cells_.end()) return others_->original(face, id);
    Slot& slot = slots_[static_cast<std::size_t>(id) - 1];
    std::call_once(slot.once,
                   [&] { slot.surface.emplace(face, others_ ? cells->second : FaceCells{}); });
    return *slot.surface;
  }

  struct Slot {
    std::once_flag once;
    std::optional<FaceSurface> surface;
  };
  std::shared_ptr<const FaceSurfaces> others_;  ///< null: these are all
  std::unique_ptr<Slot[]> slots_;
  std::map<int, FaceCells> cells_;
};

}  // namespace af2::geometry
