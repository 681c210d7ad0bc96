#include "geometry/occ/heal/heal_model.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeExtend.hxx>
#include <ShapeExtend_MsgRegistrator.hxx>
#include <ShapeFix_FixSmallFace.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Shell.hxx>
#include <ShapeFix_Solid.hxx>
#include <ShapeFix_Wireframe.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cstdio>
#include <functional>

#include "engine/base/error.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/heal/change_list.h"
#include "geometry/occ/heal/missing_edges.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

namespace {

constexpr double kDiagonalShare = 1e-5;

/// Repairs may raise tolerances to at most this multiple of the given one. Some repairs bridge any
/// gap by raising tolerances.
constexpr double kMaxTolerance = 10;

/// Edges that one face has, and that face once: where it is open.
std::vector<TopoDS_Shape> freeEdges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  std::vector<TopoDS_Shape> open;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (faces(i).Extent() == 1 && !BRep_Tool::Degenerated(TopoDS::Edge(faces.FindKey(i))))
      open.push_back(faces.FindKey(i));
  return open;
}

/// Faces with anything that OpenCASCADE's checks find wrong.
std::size_t invalidFaces(const TopoDS_Shape& shape) {
  const BRepCheck_Analyzer check(shape);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::size_t count = 0;
  for (int i = 1; i <= faces.Extent(); ++i) count += !check.IsValid(faces(i));
  return count;
}

class Healer {
 public:
  /// The tools change tolerances in place, so they get a copy.
  Healer(const ModelShape& model, double tolerance) : model_(model), tolerance_(tolerance) {
    BRepBuilderAPI_Copy copy(model.shape);
    shape_ = copy.Shape();
    invalid_ = invalidFaces(shape_);
    for (int id = 1; id <= model.faces.Extent(); ++id) {
      faces_.push_back(copy.ModifiedShape(model.faces(id)));
      before_.push_back(detailsOf(faces_.back()));
    }
  }

  ReadShape heal() {
    ShapeExtend::Init();  // loads the words of the tools
    attempt("closing of loops", [&] { closeLoops(); });
    attempt("repair of wires and faces", [&] { fixShapes(); });
    attempt("removal of small edges", [&] { fixWireframe(); });
    attempt("removal of small faces", [&] { fixSmallFaces(); });
    attempt("sewing", [&] { sewOpenParts(); });
    attempt("orientation of shells", [&] { orientShells(); });
    ReadShape healed;
    healed.shape = shape_;
    healed.unit = model_.unit;
    healed.fileUnit = model_.fileUnit;
    healed.notes = model_.notes;
    healed.lostFaces = model_.lostFaces;
    // OpenCASCADE removes a face without edges as a spot, but the face may have any size, so it
    // counts as lost.
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (faces_[i].IsNull() && before_[i].edges == 0)
        healed.lostFaces.push_back("face " + std::to_string(i + 1) + ", which had no boundary");
    if (const std::size_t count = rebuiltFaces(); count > 0)
      changes_.add("face with other edges, curves or tolerances", std::nullopt, count);
    healed.healing = Healing{tolerance_, changes_.take(), undone_};
    if (healed.healing->changes.empty()) {
      // If no tool reports a change, the original shape is kept, so that there are no unreported
      // changes.
      healed.shape = model_.shape;
      for (int id = 1; id <= model_.faces.Extent(); ++id)
        faces_[static_cast<std::size_t>(id) - 1] = model_.faces(id);
    }
    keepNames(healed);
    return healed;
  }

 private:
  /// Properties of a face that repairs may change without a report. A new order of its edges is no
  /// change.
  struct Details {
    int edges = 0, missingCurves = 0;
    double tolerances = 0;
    bool operator==(const Details&) const = default;
  };
  static Details detailsOf(const TopoDS_Shape& face) {
    Details details;
    if (face.IsNull()) return details;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      double first, last;
      ++details.edges;
      details.missingCurves += BRep_Tool::Curve(edge, first, last).IsNull();
      details.tolerances += BRep_Tool::Tolerance(edge);
    }
    for (TopExp_Explorer it(face, TopAbs_VERTEX); it.More(); it.Next())
      details.tolerances += BRep_Tool::Tolerance(TopoDS::Vertex(it.Current()));
    return details;
  }

  std::size_t rebuiltFaces() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) count += before_[i] != detailsOf(faces_[i]);
    return count;
  }

  /// A step that fails, or makes matters worse, leaves the shape as it was before.
  template <class Step>
  void attempt(const char* name, const Step& step) {
    const TopoDS_Shape shape = shape_;
    const std::vector<TopoDS_Shape> faces = faces_;
    const ChangeList changes = changes_;
    const double mostBefore = mostTolerance();
    try {
      step();
      const bool isEmpty = shape_.IsNull() || !TopExp_Explorer(shape_, TopAbs_FACE).More();
      const std::size_t invalid = isEmpty ? 0 : invalidFaces(shape_);
      const bool isLoose = mostTolerance() > std::max(mostBefore, kMaxTolerance * tolerance_);
      if (!isEmpty && !isLoose && invalid <= invalid_) {
        invalid_ = invalid;
        return;
      }
      undone_.push_back(std::string("the ") + name + " would have " +
                        (isEmpty   ? "left nothing"
                         : isLoose ? "closed gaps only by tolerances as large as these"
                                   : "made faces invalid") +
                        ", so it was not done");
    } catch (const Standard_Failure& failure) {
      undone_.push_back(std::string("the ") + name + " failed (" + failure.DynamicType()->Name() +
                        ")");
    }
    shape_ = shape;
    faces_ = faces;
    changes_ = changes;
  }

  double mostTolerance() const { return ShapeAnalysis_ShapeTolerance().Tolerance(shape_, 1); }

  void replaceFaces(const std::function<TopoDS_Shape(const TopoDS_Shape&)>& successor) {
    for (TopoDS_Shape& face : faces_)
      if (!face.IsNull()) face = successor(face);
  }
  void replaceFaces(const Handle(ShapeBuild_ReShape) & context) {
    replaceFaces([&](const TopoDS_Shape& face) { return context->Apply(face); });
  }

  void closeLoops() {
    Handle(ShapeBuild_ReShape) context = new ShapeBuild_ReShape;
    const std::vector<ClosedFace> closed = closeOpenLoops(shape_, tolerance_);
    for (const ClosedFace& face : closed) {
      context->Replace(face.before, face.after);
      for (const auto& [edge, isNew] : face.added)
        changes_.add(textOfClosing(edge, isNew), placeOf(edge));
    }
    if (closed.empty()) return;
    shape_ = context->Apply(shape_);
    replaceFaces(context);
  }

  static std::string textOfClosing(const TopoDS_Edge& edge, bool isNew) {
    char length[32];
    std::snprintf(length, sizeof length, "%.4g",
                  GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge)));
    return std::string("open loop closed with ") +
           (isNew ? "a new edge that is straight in its parameters, "
                  : "an edge of another face, ") +
           length + " long";
  }

  void fixShapes() {
    Handle(ShapeExtend_MsgRegistrator) messages = new ShapeExtend_MsgRegistrator;
    Handle(ShapeBuild_ReShape) context = new ShapeBuild_ReShape;
    Handle(ShapeFix_Shape) fix = new ShapeFix_Shape(shape_);
    fix->SetContext(context);
    fix->SetMsgRegistrator(messages);
    fix->SetPrecision(tolerance_);
    fix->SetMaxTolerance(tolerance_);
    fix->FixSolidTool()->CreateOpenSolidMode() = false;
    fix->Perform();
    shape_ = fix->Shape();
    changes_.add(messages);
    replaceFaces(context);
  }

  void fixWireframe() {
    Handle(ShapeExtend_MsgRegistrator) messages = new ShapeExtend_MsgRegistrator;
    Handle(ShapeBuild_ReShape) context = new ShapeBuild_ReShape;
    ShapeFix_Wireframe fix(shape_);
    fix.SetContext(context);
    fix.SetMsgRegistrator(messages);
    fix.SetPrecision(tolerance_);
    fix.SetMaxTolerance(tolerance_);
    fix.ModeDropSmallEdges() = true;
    fix.FixSmallEdges();
    fix.FixWireGaps();
    shape_ = fix.Shape();
    changes_.add(messages);
    replaceFaces(context);
  }

  void fixSmallFaces() {
    Handle(ShapeExtend_MsgRegistrator) messages = new ShapeExtend_MsgRegistrator;
    Handle(ShapeBuild_ReShape) context = new ShapeBuild_ReShape;
    ShapeFix_FixSmallFace fix;
    fix.Init(shape_);
    fix.SetContext(context);
    fix.SetMsgRegistrator(messages);
    fix.SetPrecision(tolerance_);
    fix.SetMaxTolerance(tolerance_);
    fix.Perform();
    shape_ = fix.FixShape();
    changes_.add(messages);
    replaceFaces(context);
  }

  /// Each solid by itself: parts that only touch must not become one.
  void sewOpenParts() {
    BRep_Builder builder;
    TopoDS_Compound all, loose;
    builder.MakeCompound(all);
    builder.MakeCompound(loose);
    bool hasLoose = false;
    for (TopExp_Explorer it(shape_, TopAbs_SOLID); it.More(); it.Next())
      builder.Add(all, sewn(it.Current()));
    for (TopExp_Explorer it(shape_, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next()) {
      builder.Add(loose, it.Current());
      hasLoose = true;
    }
    for (TopExp_Explorer it(shape_, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next()) {
      builder.Add(loose, it.Current());
      hasLoose = true;
    }
    if (hasLoose) builder.Add(all, sewn(loose));
    shape_ = all;
  }

  TopoDS_Shape sewn(const TopoDS_Shape& part) {
    const std::vector<TopoDS_Shape> before = freeEdges(part);
    if (before.empty()) return part;
    BRepBuilderAPI_Sewing sewing(tolerance_);
    sewing.Add(part);
    sewing.Perform();
    const TopoDS_Shape result = sewing.SewedShape();
    if (result.IsNull()) return part;
    const std::size_t after = freeEdges(result).size();
    if (after >= before.size()) return part;
    changes_.add("free edge sewn", placeOf(before.front()), before.size() - after);
    replaceFaces([&](const TopoDS_Shape& face) {
      return sewing.IsModified(face)           ? sewing.Modified(face)
             : sewing.IsModifiedSubShape(face) ? sewing.ModifiedSubShape(face)
                                               : face;
    });
    return result;
  }

  void orientShells() {
    BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (TopExp_Explorer it(shape_, TopAbs_SOLID); it.More(); it.Next())
      builder.Add(all, it.Current());
    for (TopExp_Explorer it(shape_, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next())
      builder.Add(all, oriented(TopoDS::Shell(it.Current())));
    for (TopExp_Explorer it(shape_, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next())
      builder.Add(all, it.Current());
    shape_ = all;
  }

  /// A shell with all faces to one side; one that is closed becomes a solid.
  TopoDS_Shape oriented(const TopoDS_Shell& shell) {
    Handle(ShapeFix_Shell) fix = new ShapeFix_Shell;
    fix->FixFaceOrientation(shell);
    const TopoDS_Shape turned = fix->Shape();
    if (turned.IsNull()) return shell;
    if (fix->Status(ShapeExtend_DONE2))
      changes_.add("shell with faces oriented to both sides: all oriented to one", placeOf(shell));
    if (turned.ShapeType() != TopAbs_SHELL || !freeEdges(turned).empty()) return turned;
    ShapeFix_Solid solid;
    const TopoDS_Solid made = solid.SolidFromShell(TopoDS::Shell(turned));
    if (made.IsNull()) return turned;
    changes_.add("solid made of a closed shell", placeOf(shell));
    return made;
  }

  void keepNames(ReadShape& healed) const {
    TopTools_IndexedMapOfShape made;
    std::vector<std::string> names;
    std::vector<std::vector<TopoDS_Shape>> successors(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (TopExp_Explorer it(faces_[i].IsNull() ? TopoDS_Shape() : faces_[i], TopAbs_FACE);
           it.More(); it.Next()) {
        successors[i].push_back(it.Current());
        const auto index = static_cast<std::size_t>(made.Add(it.Current()));
        if (names.size() < index) names.resize(index);
        names[index - 1] = model_.faceNames[i];
      }
    healed.nameOf = [made, names](const TopoDS_Face& face) {
      const int index = made.FindIndex(face);
      return index > 0 ? names[static_cast<std::size_t>(index) - 1] : std::string();
    };
    for (const FaceGroup& group : model_.groups) {
      if (group.kind == GroupKind::Solid) continue;
      ShapeGroup kept{group.name, group.kind, {}};
      for (const int face : group.faces)
        for (const TopoDS_Shape& successor : successors[static_cast<std::size_t>(face) - 1])
          kept.shapes.push_back(successor);
      healed.groups.push_back(std::move(kept));
    }
  }

  const ModelShape& model_;
  double tolerance_;
  TopoDS_Shape shape_;
  std::size_t invalid_ = 0;          ///< faces of it
  std::vector<TopoDS_Shape> faces_;  ///< what has become of each face of the model
  ChangeList changes_;
  std::vector<Details> before_;  ///< of each face
  std::vector<std::string> undone_;
};

}  // namespace

Model healModel(const Model& model, const HealingOptions& options) {
  if (options.tolerance < 0)
    throw InputError("the tolerance for healing is negative; it must be 0 or more");
  const double usual = std::max(kDiagonalShare * model.diagonal(), Precision::Confusion());
  const double tolerance = options.tolerance > 0 ? options.tolerance : usual;
  return Model(makeModelShape(Healer(model.shape(), tolerance).heal()));
}

}  // namespace af2::geometry
