// Names, layers and colours of STEP files, compared with those that OpenCASCADE's document has.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFPrs.hxx>
#include <XCAFPrs_IndexedDataMapOfShapeStyle.hxx>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>

#include "geometry/occ/model/model.h"
#include "geometry/occ/model/model_shape.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

namespace fs = std::filesystem;

struct Tools {
  explicit Tools(const Handle(TDocStd_Document) & document)
      : shapes(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
        colors(XCAFDoc_DocumentTool::ColorTool(document->Main())),
        layers(XCAFDoc_DocumentTool::LayerTool(document->Main())) {}
  Handle(XCAFDoc_ShapeTool) shapes;
  Handle(XCAFDoc_ColorTool) colors;
  Handle(XCAFDoc_LayerTool) layers;
};

/// Parts, some with coloured faces, and assemblies of these and of assemblies, all with names and
/// some with layers and colours of their own.
class RandomAssembly {
 public:
  explicit RandomAssembly(unsigned seed)
      : random_(seed), document_(new TDocStd_Document("XmlXCAF")), tools_(document_) {
    for (int i = 2 + below(3); i > 0; --i) addPart(i);
    for (int i = 1 + below(4); i > 0; --i) addAssembly();
    tools_.shapes->UpdateAssemblies();
  }

  /// prefix  null, or that of the names of files, one for each part
  void write(const fs::path& path, const char* prefix) const {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPCAFControl_Writer writer;
    writer.SetLayerMode(true);
    writer.Transfer(document_, STEPControl_AsIs, prefix);
    writer.Write(path.c_str());
  }

 private:
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  bool oneOf(int many) { return below(many) == 0; }

  void describe(const TDF_Label& label, const char* name) {
    if (*name) TDataStd_Name::Set(label, (std::string(name) + std::to_string(below(5))).c_str());
    const auto part = [&] { return below(5) / 4.0; };
    if (oneOf(2))
      tools_.colors->SetColor(label, Quantity_Color(part(), part(), part(), Quantity_TOC_sRGB),
                              XCAFDoc_ColorSurf);
    if (oneOf(3)) tools_.layers->SetLayer(label, ("layer" + std::to_string(below(3))).c_str());
  }

  void addPart(int size) {
    const TopoDS_Shape body = oneOf(2) ? TopoDS_Shape(BRepPrimAPI_MakeBox(size, 2, 3).Shape())
                                       : TopoDS_Shape(BRepPrimAPI_MakeCylinder(size, 2).Shape());
    TopoDS_Shape shape = body;
    if (oneOf(4)) {  // two bodies
      TopoDS_Compound both;
      BRep_Builder().MakeCompound(both);
      BRep_Builder().Add(both, body);
      BRep_Builder().Add(both, BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 0), 1, 1, 1).Shape());
      shape = both;
    }
    const TDF_Label label = tools_.shapes->AddShape(shape, false);
    describe(label, "part");
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i)
      if (oneOf(3)) describe(tools_.shapes->AddSubShape(label, faces(i)), "");
    labels_.push_back(label);
  }

  void addAssembly() {
    const TDF_Label assembly = tools_.shapes->NewShape();
    describe(assembly, "assembly");
    for (int i = 1 + below(4); i > 0; --i) {
      gp_Trsf place;
      if (!oneOf(5)) place.SetTranslation(gp_Vec(below(50), below(50), below(50)));
      const auto part = static_cast<std::size_t>(below(static_cast<int>(labels_.size())));
      describe(tools_.shapes->AddComponent(assembly, labels_[part], TopLoc_Location(place)),
               "instance");
    }
    labels_.push_back(assembly);
  }

  std::mt19937 random_;
  Handle(TDocStd_Document) document_;
  Tools tools_;
  std::vector<TDF_Label> labels_;
};

/// The groups that the document of OpenCASCADE's own reader has.
class DocumentGroups {
 public:
  static Model read(const fs::path& path) {
    STEPCAFControl_Reader reader;
    reader.SetLayerMode(true);
    Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
    EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
    reader.Transfer(document);
    DocumentGroups groups(document);
    ReadShape result;
    TDF_LabelSequence tops;
    groups.tools_.shapes->GetFreeShapes(tops);
    TopoDS_Compound all;
    BRep_Builder().MakeCompound(all);
    for (const TDF_Label& top : tops) {
      groups.walk(top, TopLoc_Location());
      groups.addColors(top);
      BRep_Builder().Add(all, XCAFDoc_ShapeTool::GetShape(top));
    }
    result.shape = all;
    result.groups = groups.groups_;
    return Model(makeModelShape(result));
  }

 private:
  explicit DocumentGroups(const Handle(TDocStd_Document) & document) : tools_(document) {}

  void put(GroupKind kind, const TCollection_ExtendedString& name, const TopoDS_Shape& shape) {
    const std::string text = TCollection_AsciiString(name).ToCString();
    for (ShapeGroup& group : groups_)
      if (group.kind == kind && group.name == text) return group.shapes.push_back(shape);
    groups_.push_back({text, kind, {shape}});
  }

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
    const TopoDS_Shape placed = XCAFDoc_ShapeTool::GetShape(label).Moved(around);
    Handle(TDataStd_Name) name;
    // It makes up "SOLID" and the like, and "=>" for instances.
    const bool isGiven = label.FindAttribute(TDataStd_Name::GetID(), name);
    const char first = isGiven ? TCollection_AsciiString(name->Get()).Value(1) : '=';
    if (first != '=' && !std::isupper(first)) put(GroupKind::Part, name->Get(), placed);
    Handle(TColStd_HSequenceOfExtendedString) layers;
    if (!tools_.layers->GetLayers(label, layers)) return;
    for (const auto& layer : layers->Sequence()) put(GroupKind::Layer, layer, placed);
  }

  void addColors(const TDF_Label& top) {
    XCAFPrs_IndexedDataMapOfShapeStyle styles;
    XCAFPrs::CollectStyleSettings(top, TopLoc_Location(), styles);
    TopTools_IndexedMapOfShape faces;
    std::map<int, std::string> colors;
    for (int type = TopAbs_COMPOUND; type <= TopAbs_FACE; ++type)
      for (int i = 1; i <= styles.Extent(); ++i) {
        if (styles.FindKey(i).ShapeType() != type || !styles(i).IsSetColorSurf()) continue;
        std::array<double, 3> rgb;
        styles(i).GetColorSurf().Values(rgb[0], rgb[1], rgb[2], Quantity_TOC_sRGB);
        std::array<int, 3> bytes;
        for (std::size_t k = 0; k < 3; ++k) bytes[k] = static_cast<int>(std::lround(255 * rgb[k]));
        char text[32];
        std::snprintf(text, sizeof text, "#%02x%02x%02x", bytes[0], bytes[1], bytes[2]);
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(styles.FindKey(i), TopAbs_FACE, own);
        for (int k = 1; k <= own.Extent(); ++k) colors[faces.Add(own(k))] = text;
      }
    for (const auto& [face, color] : colors) put(GroupKind::Color, color.c_str(), faces(face));
  }

  Tools tools_;
  std::vector<ShapeGroup> groups_;
};

std::string textOf(const std::vector<FaceGroup>& groups) {
  std::string text;
  for (const FaceGroup& group : groups) {
    text += std::to_string(static_cast<int>(group.kind)) + " " + group.name + ":";
    for (const int face : group.faces) text += " " + std::to_string(face);
    text += "\n";
  }
  return text;
}

void expectThoseOfTheDocument(const char* prefix) {
  const testing::TestFolder folder;
  std::size_t groups = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const fs::path path = folder / ("model" + std::to_string(seed) + ".step");
    RandomAssembly(seed).write(path, prefix);
    const Model expected = DocumentGroups::read(path);
    const Model model = readModel(path);
    EXPECT_EQ(model.faceCount(), expected.faceCount()) << seed;
    EXPECT_EQ(textOf(model.groups()), textOf(expected.groups())) << seed;
    groups += model.groups().size();
  }
  EXPECT_GT(groups, 300u);
}

TEST(StepAttributes, AreThoseThatOpenCascadesDocumentHas) { expectThoseOfTheDocument(nullptr); }

TEST(StepAttributes, AreThoseThatItHasOfPartsInOtherFiles) { expectThoseOfTheDocument("part_"); }

}  // namespace
}  // namespace af2::geometry
