#include "geometry/occ/step/step_document.h"

#include <BRep_Builder.hxx>
#include <STEPConstruct_ExternRefs.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/occ/step/endless_profiles.h"
#include "geometry/occ/step/step_attributes.h"
#include "geometry/occ/step/step_library.h"
#include "geometry/occ/step/step_omissions.h"

namespace af2::geometry {
namespace {

TopoDS_Shape withoutPlace(const TopoDS_Shape& shape) { return shape.Located(TopLoc_Location()); }

void addCompounds(const TopoDS_Shape& shape, TopTools_MapOfShape& shapes) {
  shapes.Add(withoutPlace(shape));
  if (shape.ShapeType() != TopAbs_COMPOUND) return;
  for (TopoDS_Iterator it(shape); it.More(); it.Next()) addCompounds(it.Value(), shapes);
}

/// Other formats than these are not read.
bool isStep(const Handle(TCollection_HAsciiString) & format) {
  if (format.IsNull()) return true;
  constexpr bool kWithCase = false;
  return format->IsSameString(new TCollection_HAsciiString("STEP AP203"), kWithCase) ||
         format->IsSameString(new TCollection_HAsciiString("STEP AP214"), kWithCase);
}

}  // namespace

IFSelect_ReturnStatus readStepText(STEPControl_Reader& reader, const std::filesystem::path& path,
                                   std::string text) {
  mendStepText(text);
  const Handle(XSControl_WorkSession) session = reader.WS();
  const Handle(IFSelect_WorkLibrary) given = session->WorkLibrary();
  session->SetLibrary(new StepLibrary(std::move(text)));
  const IFSelect_ReturnStatus status = reader.ReadFile(path.c_str());
  session->SetLibrary(given);
  return status;
}

std::filesystem::path besideStepFile(const std::filesystem::path& file, const std::string& name) {
  return (file.parent_path() / name).lexically_normal();
}

/// Finds the parts of one file in its shapes. A compound is an assembly if something in it is a
/// product or a representation of its own; others are bodies that belong together.
class StepDocument::PartFinder {
 public:
  PartFinder(StepDocument& document, STEPControl_Reader& reader) : document_(document) {
    TopTools_MapOfShape shapes;
    for (int i = 1; i <= reader.NbShapes(); ++i) addCompounds(reader.Shape(i), shapes);
    const StepEntities entities(reader.WS());
    entities.forEach([&](const Handle(Standard_Transient) & entity) {
      const bool isProduct = entity->IsKind(STANDARD_TYPE(StepBasic_ProductDefinition));
      if (!isProduct && !entity->IsKind(STANDARD_TYPE(StepShape_ShapeRepresentation))) return;
      const TopoDS_Shape shape = entities.shapeOf(entity);
      if (shape.IsNull() || !shapes.Contains(shape)) return;
      own_.Add(shape);
      if (isProduct) products_[entity.get()] = shape;
    });
  }

  /// Whether the file itself has nothing of a product that it uses.
  bool lacks(const Handle(StepBasic_ProductDefinition) & product) const {
    const auto found = products_.find(product.get());
    return found != products_.end() && found->second.ShapeType() == TopAbs_COMPOUND &&
           found->second.NbChildren() == 0;
  }
  /// The product is in another file, with this index in tops_.
  void bind(const Handle(StepBasic_ProductDefinition) & product, int top) {
    others_.Bind(products_.at(product.get()), top);
  }

  PlacedStepPart add(const TopoDS_Shape& shape) {
    if (!shape.Location().IsIdentity()) {
      const PlacedStepPart inner = add(withoutPlace(shape));
      return {inner.part, shape.Location() * inner.place};
    }
    StepParts& parts = document_.parts_;
    if (const int known = parts.find(shape); known >= 0)
      return {static_cast<std::size_t>(known), {}};
    if (shape.ShapeType() != TopAbs_COMPOUND) return {parts.add(shape), {}};
    if (const int* top = others_.Seek(shape)) {
      Top& other = document_.tops_[static_cast<std::size_t>(*top)];
      other.isUsed = true;
      parts.remember(shape, parts[other.part]);
      return other;
    }
    const std::size_t part = parts.add(shape);
    if (!isAssembly(shape)) return {part, {}};
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      const PlacedStepPart inner = add(withoutPlace(it.Value()));
      parts.addInstance(part, it.Value(), inner.part, it.Value().Location() * inner.place);
    }
    return {part, {}};
  }

 private:
  bool isAssembly(const TopoDS_Shape& shape) const {
    for (TopoDS_Iterator it(shape); it.More(); it.Next())
      if (own_.Contains(withoutPlace(it.Value()))) return true;
    return false;
  }

  StepDocument& document_;
  TopTools_MapOfShape own_;
  std::map<const Standard_Transient*, TopoDS_Shape> products_;
  TopTools_DataMapOfShapeInteger others_;
};

bool StepDocument::transfer(STEPControl_Reader& reader, const std::filesystem::path& path) {
  trimEndlessProfiles(reader.WS());
  reader.ClearShapes();
  const int roots = reader.NbRootsForTransfer();
  for (int i = 1; i <= roots; ++i) reader.TransferOneRoot(i);
  if (reader.NbShapes() <= 0) return false;
  PartFinder finder(*this, reader);
  const Handle(XSControl_WorkSession) session = reader.WS();
  readOthers(session, path, finder);
  for (int i = 1; i <= reader.NbShapes(); ++i) {
    const PlacedStepPart part = finder.add(reader.Shape(i));
    tops_.push_back({part, false});
  }
  StepAttributes(session, parts_).read();
  return true;
}

/// Reads the files in which a file has its parts.
void StepDocument::readOthers(const Handle(XSControl_WorkSession) & session,
                              const std::filesystem::path& path, PartFinder& finder) {
  open_.push_back(path.lexically_normal());
  STEPConstruct_ExternRefs references(session);
  references.LoadExternRefs();
  for (int i = 1; i <= references.NbExternRefs(); ++i) {
    const char* const name = references.FileName(i);
    const Handle(StepBasic_ProductDefinition) product = references.ProdDef(i);
    if (!isStep(references.Format(i)) || !name || !*name || product.IsNull() ||
        !finder.lacks(product))
      continue;
    const std::filesystem::path place = besideStepFile(path, name);
    if (std::ranges::count(open_, place) > 0) continue;
    const int top = readOther(place).top;
    if (top >= 0) finder.bind(product, top);
  }
  open_.pop_back();
}

const StepDocument::OtherFile& StepDocument::readOther(const std::filesystem::path& path) {
  const auto [known, isNew] = others_.try_emplace(path);
  if (!isNew) return known->second;
  const Handle(XSControl_WorkSession) session = new XSControl_WorkSession;
  session->SelectNorm("STEP");
  constexpr bool kFromScratch = false;
  STEPControl_Reader reader(session, kFromScratch);
  try {
    if (readStepText(reader, path, contentOf(path)) != IFSelect_RetDone) return known->second;
  } catch (const InputError&) {  // it is not there, or may not be read
    return known->second;
  }
  if (!transfer(reader, path)) return known->second;
  known->second.session = session;
  known->second.top = static_cast<int>(tops_.size()) - reader.NbShapes();
  return known->second;
}

std::vector<PlacedStepPart> StepDocument::tops() const {
  std::vector<PlacedStepPart> tops;
  for (const Top& top : tops_) {
    const bool isUsed = top.place.IsIdentity() ? parts_[top.part].isUsed : top.isUsed;
    const auto isSame = [&](const PlacedStepPart& other) {
      return other.part == top.part && other.place == top.place;
    };
    if (!isUsed && std::ranges::none_of(tops, isSame)) tops.push_back(top);
  }
  return tops;
}

Handle(XSControl_WorkSession) StepDocument::sessionOf(const std::filesystem::path& path) const {
  const auto known = others_.find(path);
  return known == others_.end() ? Handle(XSControl_WorkSession)() : known->second.session;
}

TopoDS_Shape StepDocument::joined() {
  const BRep_Builder builder;
  std::vector<bool> isDone(parts_.count(), false);
  const auto make = [&](const auto& self, std::size_t number) -> const TopoDS_Shape& {
    StepPart& part = parts_[number];
    if (part.instances.empty() || isDone[number]) return part.shape;
    isDone[number] = true;
    TopoDS_Compound whole;
    builder.MakeCompound(whole);
    for (StepInstance& instance : part.instances) {
      instance.shape = self(self, instance.part).Located(instance.shape.Location());
      builder.Add(whole, instance.shape);
    }
    return part.shape = whole;
  };
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const PlacedStepPart& top : tops())
    builder.Add(all, make(make, top.part).Located(top.place));
  return all;
}

}  // namespace af2::geometry
