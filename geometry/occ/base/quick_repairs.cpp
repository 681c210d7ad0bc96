#include "geometry/occ/base/quick_repairs.h"

#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <ShapeAlgo_ToolContainer.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopoDS_Iterator.hxx>
#include <mutex>
#include <typeinfo>
#include <unordered_set>

namespace af2::geometry {
namespace {

/// Which shapes are replaced, by what they have in common wherever they are placed: the
/// replacements are kept by the base class, and so are these shapes.
class QuickReShape final : public ShapeBuild_ReShape {
 public:
  using ShapeBuild_ReShape::Apply;
  TopoDS_Shape Apply(const TopoDS_Shape& shape, TopAbs_ShapeEnum until) override {
    if (shape.IsNull() || isAnyReplaced(shape)) return ShapeBuild_ReShape::Apply(shape, until);
    myStatus = 0;  // what the base class says where nothing was replaced
    return shape;
  }
  void Clear() override {
    replaced_.clear();
    ShapeBuild_ReShape::Clear();
  }

 protected:
  void replace(const TopoDS_Shape& shape, const TopoDS_Shape& by,
               const TReplacementKind kind) override {
    if (!shape.IsNull()) replaced_.insert(shape.TShape().get());
    ShapeBuild_ReShape::replace(shape, by, kind);
  }

 private:
  /// The shape or a part of it.
  bool isAnyReplaced(const TopoDS_Shape& shape) const {
    if (replaced_.empty()) return false;
    if (replaced_.contains(shape.TShape().get())) return true;
    for (TopoDS_Iterator part(shape, false, false); part.More(); part.Next())
      if (isAnyReplaced(part.Value())) return true;
    return false;
  }

  std::unordered_set<const TopoDS_TShape*> replaced_;
};

class QuickTools final : public ShapeAlgo_ToolContainer {
 public:
  Handle(ShapeFix_Shape) FixShape() const override {
    Handle(ShapeFix_Shape) fix = ShapeAlgo_ToolContainer::FixShape();
    const Handle(ShapeBuild_ReShape) context = new QuickReShape;
    context->ModeConsiderLocation() = true;  // as in the context that the tool would make itself
    fix->SetContext(context);
    return fix;
  }
};

}  // namespace

void repairShapesQuickly() {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  ShapeAlgo::Init();
  const Handle(ShapeAlgo_AlgoContainer) algorithms = ShapeAlgo::AlgoContainer();
  const Handle(ShapeAlgo_ToolContainer) tools = algorithms->ToolContainer();
  if (tools.IsNull() || typeid(*tools) == typeid(ShapeAlgo_ToolContainer))
    algorithms->SetToolContainer(new QuickTools);
}

}  // namespace af2::geometry
