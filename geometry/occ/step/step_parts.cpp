#include "geometry/occ/step/step_parts.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace af2::geometry {

int StepParts::find(const TopoDS_Shape& shape) const {
  const int* part = partOf_.Seek(shape);
  return part ? *part : -1;
}

std::size_t StepParts::add(const TopoDS_Shape& shape) {
  StepPart& part = parts_.emplace_back();
  part.shape = shape;
  partOf_.Bind(shape, static_cast<int>(parts_.size() - 1));
  remember(shape, part);
  return parts_.size() - 1;
}

void StepParts::addInstance(std::size_t assembly, const TopoDS_Shape& shape, std::size_t part,
                            const TopLoc_Location& place) {
  StepInstance& instance = parts_[assembly].instances.emplace_back();
  instance.shape = parts_[part].shape.Located(place);
  instance.part = part;
  parts_[part].isUsed = true;
  remember(shape, instance);
}

StepItem* StepParts::itemOf(const TopoDS_Shape& shape) {
  StepItem* const* item = itemOf_.Seek(shape);
  return item ? *item : nullptr;
}

StepItem* StepParts::itemOrPiece(const TopoDS_Shape& shape) {
  if (StepItem* const item = itemOf(shape)) return item;
  const int whole = wholeOf(shape);
  if (whole < 0) return nullptr;
  StepItem& piece = parts_[static_cast<std::size_t>(whole)].pieces.emplace_back();
  piece.shape = shape;
  remember(shape, piece);
  return &piece;
}

int StepParts::wholeOf(const TopoDS_Shape& piece) {
  for (; searched_ < parts_.size(); ++searched_) {
    if (!parts_[searched_].instances.empty()) continue;
    TopTools_IndexedMapOfShape pieces;
    TopExp::MapShapes(parts_[searched_].shape, pieces);
    for (int i = 1; i <= pieces.Extent(); ++i)
      if (!wholeOf_.IsBound(pieces(i))) wholeOf_.Bind(pieces(i), static_cast<int>(searched_));
  }
  const int* whole = wholeOf_.Seek(piece);
  return whole ? *whole : -1;
}

void StepParts::remember(const TopoDS_Shape& shape, StepItem& item) {
  if (!itemOf_.IsBound(shape)) itemOf_.Bind(shape, &item);
}

}  // namespace af2::geometry
