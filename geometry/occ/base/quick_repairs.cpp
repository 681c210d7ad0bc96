#include "geometry/occ/base/quick_repairs.h"

#include <BRep_Builder.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>
#include <ShapeAlgo_ToolContainer.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Shell.hxx>
#include <ShapeFix_Solid.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <mutex>
#include <typeinfo>
#include <unordered_set>
#include <utility>

#include "geometry/occ/base/outward_shell.h"
#include "geometry/occ/base/sound_plane_face.h"

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

/// Leaves out faces that are certainly sound, and the question what is inside where it is certain.
class QuickSolid final : public ShapeFix_Solid {
 public:
  /// `whole` is the tool that this one belongs to.
  explicit QuickSolid(ShapeFix_Shape& whole) : whole_(whole) {}

  Standard_Boolean Perform(const Message_ProgressRange& progress) override {
    int& faces = FixShellTool()->FixFaceMode();
    TopoDS_Shell shell;
    if (faces == 0 || Context().IsNull() || !isOneShell(shell))
      return ShapeFix_Solid::Perform(progress);
    sound_.clear();
    const bool isAnyFaceRepaired = repairFacesOf(shell);
    const bool isOutward = isOneShell(shell) && isOutwardShell(shell);
    const int faceMode = std::exchange(faces, 0), orientationMode = FixShellOrientationMode();
    if (isOutward) FixShellOrientationMode() = 0;
    const bool isRepaired = ShapeFix_Solid::Perform(progress);
    faces = faceMode;
    FixShellOrientationMode() = orientationMode;
    finish();
    return isAnyFaceRepaired || isRepaired;
  }

 private:
  /// With several shells, each is repaired as a whole before the next one.
  bool isOneShell(TopoDS_Shell& shell) const {
    int count = 0;
    for (TopExp_Explorer it(Context()->Apply(myShape), TopAbs_SHELL); it.More(); it.Next()) {
      shell = TopoDS::Shell(it.Current());
      ++count;
    }
    return count == 1;
  }

  bool repairFacesOf(const TopoDS_Shell& shell) {
    const Handle(ShapeFix_Face) fix = FixShellTool()->FixFaceTool();
    fix->SetContext(Context());
    bool isAnyRepaired = false;
    for (TopoDS_Iterator it(Context()->Apply(shell)); it.More(); it.Next()) {
      TopoDS_Shape face = Context()->Apply(it.Value());
      if (face.ShapeType() == TopAbs_FACE && isSoundPlaneFace(TopoDS::Face(face))) {
        face.Checked(true);  // so that OpenCASCADE does not update it again
        sound_.insert(face.TShape().get());
        continue;
      }
      fix->Init(TopoDS::Face(it.Value()));
      isAnyRepaired = fix->Perform() || isAnyRepaired;
    }
    return isAnyRepaired;
  }

  /// What the whole tool does at the end with all faces of its shape, which is the solid where the
  /// modes ask for it: only with those that are not sound, since tolerances only grow.
  void finish() {
    const bool areParametersWanted = std::exchange(whole_.FixSameParameterMode(), 0) != 0;
    const bool areVerticesWanted = std::exchange(whole_.FixVertexTolMode(), 0) != 0;
    int count = 0;
    TopoDS_Compound others;
    BRep_Builder().MakeCompound(others);
    for (TopExp_Explorer it(Context()->Apply(myShape), TopAbs_FACE); it.More(); it.Next(), ++count)
      if (!sound_.contains(it.Current().TShape().get())) BRep_Builder().Add(others, it.Current());
    if (areParametersWanted) ShapeFix::SameParameter(others, false);
    if (!areVerticesWanted || count < 2) return;
    const Handle(ShapeFix_Edge) fix = whole_.FixEdgeTool();
    for (TopoDS_Iterator face(others); face.More(); face.Next())
      for (TopExp_Explorer it(face.Value(), TopAbs_EDGE); it.More(); it.Next())
        fix->FixVertexTolerance(TopoDS::Edge(it.Current()), TopoDS::Face(face.Value()));
  }

  ShapeFix_Shape& whole_;
  std::unordered_set<const TopoDS_TShape*> sound_;
};

class QuickShape final : public ShapeFix_Shape {
 public:
  QuickShape() {
    myFixSolid = new QuickSolid(*this);
    const Handle(ShapeBuild_ReShape) context = new QuickReShape;
    context->ModeConsiderLocation() = true;  // as in the context that the tool would make itself
    SetContext(context);
  }
};

class QuickTools final : public ShapeAlgo_ToolContainer {
 public:
  Handle(ShapeFix_Shape) FixShape() const override { return new QuickShape; }
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
