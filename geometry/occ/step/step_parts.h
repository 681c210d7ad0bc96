// The parts that a STEP file describes: how assemblies consist of them, and what names, layers and
// colours they have.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <NCollection_DataMap.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

namespace af2::geometry {

/// A shape with what the file says about it.
struct StepItem {
  TopoDS_Shape shape;
  std::string name;
  std::vector<std::string> layers;
  std::string color;  ///< of surfaces, "#rrggbb"; may be empty, as the name
};

/// A part that an assembly has in some place, which is that of its shape.
struct StepInstance : StepItem {
  std::size_t part = 0;
};

/// A part, in its own place.
struct StepPart : StepItem {
  std::deque<StepInstance> instances;  ///< of an assembly
  std::deque<StepItem> pieces;         ///< faces, solids and others that have layers or colours
  bool isUsed = false;                 ///< by an assembly
};

class StepParts {
 public:
  StepParts() = default;
  StepParts(const StepParts&) = delete;
  StepParts& operator=(const StepParts&) = delete;

  StepPart& operator[](std::size_t part) { return parts_[part]; }
  const StepPart& operator[](std::size_t part) const { return parts_[part]; }
  std::size_t count() const { return parts_.size(); }

  /// The number of the part with a shape without location; -1: there is none.
  int find(const TopoDS_Shape& shape) const;
  std::size_t add(const TopoDS_Shape& shape);
  /// shape  of the instance in the file: of a part in another file, the file has no faces
  void addInstance(std::size_t assembly, const TopoDS_Shape& shape, std::size_t part,
                   const TopLoc_Location& place);
  /// Makes an item the one that has this shape, too, if there is none yet.
  void remember(const TopoDS_Shape& shape, StepItem& item);

  /// The part, instance or piece that has this shape; null if there is none.
  StepItem* itemOf(const TopoDS_Shape& shape);
  /// The same; a piece of the first part that has it is added where there is none. Null if no part
  /// has it.
  StepItem* itemOrPiece(const TopoDS_Shape& shape);

 private:
  /// Finds the part that has a shape as a piece; -1: none.
  int wholeOf(const TopoDS_Shape& piece);

  std::deque<StepPart> parts_;
  TopTools_DataMapOfShapeInteger partOf_, wholeOf_;
  NCollection_DataMap<TopoDS_Shape, StepItem*, TopTools_ShapeMapHasher> itemOf_;
  std::size_t searched_ = 0;  ///< so many parts have their pieces in wholeOf_
};

}  // namespace af2::geometry
