#include "geometry/occ/step/step_groups.h"

#include <Quantity_Color.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFPrs.hxx>
#include <XCAFPrs_IndexedDataMapOfShapeStyle.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace af2::geometry {
namespace {

std::string textOf(const TCollection_ExtendedString& text) {
  return TCollection_AsciiString(text).ToCString();
}

/// Readers make up names for what has none.
bool isMadeUp(const std::string& name) {
  constexpr std::array kKinds{"COMPOUND", "COMPSOLID", "SOLID",  "SHELL",    "FACE",
                              "WIRE",     "EDGE",      "VERTEX", "ASSEMBLY", "NONE"};
  return name.empty() || name.starts_with("=>") ||
         std::find(kKinds.begin(), kKinds.end(), name) != kKinds.end() || name[0] == '#';
}

std::string nameOf(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  const std::string text = textOf(name->Get());
  return isMadeUp(text) ? "" : text;
}

/// "#rrggbb" as screens show it.
std::string textOf(const Quantity_Color& color) {
  double r, g, b;
  color.Values(r, g, b, Quantity_TOC_sRGB);
  const auto byte = [](double x) { return static_cast<int>(std::lround(255 * x)); };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(r) & 255, byte(g) & 255, byte(b) & 255);
  return text;
}

class Collector {
 public:
  explicit Collector(const Handle(TDocStd_Document) & document)
      : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        layers_(XCAFDoc_DocumentTool::LayerTool(document->Main())) {}

  std::vector<ShapeGroup> collect() {
    TDF_LabelSequence free;
    shapes_->GetFreeShapes(free);
    for (const TDF_Label& label : free) {
      walk(label, TopLoc_Location());
      addColors(label);
    }
    return std::move(groups_);
  }

 private:
  ShapeGroup& group(GroupKind kind, const std::string& name) {
    for (ShapeGroup& group : groups_)
      if (group.kind == kind && group.name == name) return group;
    groups_.push_back({name, kind, {}});
    return groups_.back();
  }

  /// Visits a label and its components; `around` is the location of the assembly above it.
  void walk(const TDF_Label& label, const TopLoc_Location& around) {
    add(label, around);
    TDF_Label part = label;
    TopLoc_Location place = around;
    if (XCAFDoc_ShapeTool::GetReferredShape(label, part)) {
      place = around * XCAFDoc_ShapeTool::GetLocation(label);
      add(part, place);
    }
    TDF_LabelSequence inside;
    if (XCAFDoc_ShapeTool::IsAssembly(part))
      XCAFDoc_ShapeTool::GetComponents(part, inside);
    else
      XCAFDoc_ShapeTool::GetSubShapes(part, inside);
    for (const TDF_Label& child : inside) walk(child, place);
  }

  void add(const TDF_Label& label, const TopLoc_Location& around) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    if (shape.IsNull()) return;
    const TopoDS_Shape placed = shape.Moved(around);
    const std::string name = nameOf(label);
    if (!name.empty()) group(GroupKind::Part, name).shapes.push_back(placed);
    Handle(TColStd_HSequenceOfExtendedString) layers;
    if (!layers_->GetLayers(label, layers)) return;
    for (const TCollection_ExtendedString& layer : layers->Sequence())
      group(GroupKind::Layer, textOf(layer)).shapes.push_back(placed);
  }

  /// Each face has the colour of the smallest part that has one.
  void addColors(const TDF_Label& label) {
    XCAFPrs_IndexedDataMapOfShapeStyle styles;
    XCAFPrs::CollectStyleSettings(label, TopLoc_Location(), styles);
    TopTools_IndexedMapOfShape faces;
    std::vector<std::string> colors;
    for (int type = TopAbs_COMPOUND; type <= TopAbs_FACE; ++type) {
      for (int i = 1; i <= styles.Extent(); ++i) {
        const TopoDS_Shape& shape = styles.FindKey(i);
        const XCAFPrs_Style& style = styles(i);
        if (shape.ShapeType() != type || !style.IsSetColorSurf()) continue;
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(shape, TopAbs_FACE, own);
        for (int k = 1; k <= own.Extent(); ++k) {
          const int index = faces.Add(own(k));
          colors.resize(static_cast<std::size_t>(faces.Extent()));
          colors[static_cast<std::size_t>(index) - 1] = textOf(style.GetColorSurf());
        }
      }
    }
    for (int i = 1; i <= faces.Extent(); ++i)
      group(GroupKind::Color, colors[static_cast<std::size_t>(i) - 1]).shapes.push_back(faces(i));
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_LayerTool) layers_;
  std::vector<ShapeGroup> groups_;
};

}  // namespace

std::vector<ShapeGroup> groupsOf(const Handle(TDocStd_Document) & document) {
  return Collector(document).collect();
}

}  // namespace af2::geometry
