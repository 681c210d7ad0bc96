#include "geometry/occ/step/step_attributes.h"

#include <Quantity_Color.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepBasic_ProductDefinitionWithAssociatedDocuments.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_ProductDefinitionShape.hxx>
#include <StepRepr_RepresentedDefinition.hxx>
#include <StepRepr_SpecifiedHigherUsageOccurrence.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_LayeredItem.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <StepVisual_PresentationStyleByContext.hxx>
#include <StepVisual_StyleContextSelect.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace af2::geometry {
namespace {

using Text = Handle(TCollection_HAsciiString);

bool isGiven(const Text& text) { return !text.IsNull() && text->UsefullLength() > 0; }

std::string textOf(const Text& text) { return text.IsNull() ? "" : text->ToCString(); }

/// "#rrggbb" as screens show it.
std::string textOf(const Handle(StepVisual_Colour) & color) {
  Quantity_Color decoded;
  STEPConstruct_Styles::DecodeColor(color, decoded);
  double r, g, b;
  decoded.Values(r, g, b, Quantity_TOC_sRGB);
  const auto byte = [](double x) { return static_cast<int>(std::lround(255 * x)); };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(r) & 255, byte(g) & 255, byte(b) & 255);
  return text;
}

std::string nameOf(const Handle(StepBasic_ProductDefinition) & product) {
  if (product->Formation().IsNull() || product->Formation()->OfProduct().IsNull()) return "";
  const Handle(StepBasic_Product) named = product->Formation()->OfProduct();
  return textOf(isGiven(named->Name()) ? named->Name() : named->Id());
}

std::string nameOf(const Handle(StepBasic_ProductDefinitionRelationship) & usage) {
  if (usage->HasDescription() && isGiven(usage->Description())) return textOf(usage->Description());
  return textOf(isGiven(usage->Name()) ? usage->Name() : usage->Id());
}

/// The representation of an assembly in which a style is that of one component.
Handle(StepShape_ShapeRepresentation) contextOf(const Handle(StepVisual_StyledItem) & style) {
  for (int i = 1; i <= style->NbStyles(); ++i) {
    const auto byContext =
        Handle(StepVisual_PresentationStyleByContext)::DownCast(style->StylesValue(i));
    if (byContext.IsNull()) continue;
    const auto context =
        Handle(StepShape_ShapeRepresentation)::DownCast(byContext->StyleContext().Representation());
    if (!context.IsNull()) return context;
  }
  return {};
}

/// The usage of a part that such a style is for; null if there is none, or if it is of an assembly
/// further up.
Handle(StepRepr_AssemblyComponentUsage)
    usageOf(const Handle(StepVisual_StyledItem) & style, const StepEntities& entities) {
  Handle(StepRepr_AssemblyComponentUsage) found;
  const Handle(StepShape_ShapeRepresentation) context = contextOf(style);
  if (context.IsNull()) return found;
  entities.forEachUser<StepShape_ShapeDefinitionRepresentation>(context, [&](const auto& user) {
    const auto shape =
        Handle(StepRepr_ProductDefinitionShape)::DownCast(user->Definition().PropertyDefinition());
    if (!found.IsNull() || shape.IsNull()) return;
    found = Handle(StepRepr_AssemblyComponentUsage)::DownCast(
        shape->Definition().ProductDefinitionRelationship());
  });
  return found;
}

}  // namespace

void StepAttributes::read() {
  readColors();
  readNames();
  readLayers();
}

/// The colour of surfaces; one for rendering comes first.
void StepAttributes::readColors() {
  STEPConstruct_Styles styles(session_);
  if (!styles.LoadStyles()) return;
  for (int i = 1; i <= styles.NbStyles(); ++i) {
    const Handle(StepVisual_StyledItem) style = styles.Style(i);
    Handle(StepVisual_Colour) surface, boundary, curve, rendered;
    double transparency = 0;
    bool isOfComponent = false;
    if (style.IsNull() ||
        !styles.GetColors(style, surface, boundary, curve, rendered, transparency, isOfComponent))
      continue;
    const Handle(StepVisual_Colour) color = rendered.IsNull() ? surface : rendered;
    if (color.IsNull()) continue;
    TopoDS_Shape shape = entities_.shapeOf(style->ItemAP242().Value());
    if (isOfComponent) {
      const auto usage = usageOf(style, entities_);
      if (!usage.IsNull() && usage->IsKind(STANDARD_TYPE(StepRepr_SpecifiedHigherUsageOccurrence)))
        continue;
      const StepItem* const instance = parts_.itemOf(entities_.shapeOf(usage));
      if (instance) shape = instance->shape;
    }
    if (shape.IsNull()) continue;
    if (StepItem* const item = parts_.itemOrPiece(shape)) {
      item->color = textOf(color);
      continue;
    }
    for (TopoDS_Iterator it(shape); it.More(); it.Next())
      if (StepItem* const item = parts_.itemOrPiece(it.Value())) item->color = textOf(color);
  }
}

void StepAttributes::readNames() {
  entities_.forEach([&](const Handle(Standard_Transient) & entity) {
    if (entity->IsInstance(STANDARD_TYPE(StepRepr_NextAssemblyUsageOccurrence))) {
      StepItem* const item = parts_.itemOf(entities_.shapeOf(entity));
      if (!item) return;
      entities_.forEachUser<StepRepr_ProductDefinitionShape>(entity, [&](const auto& user) {
        const auto usage = user->Definition().ProductDefinitionRelationship();
        if (!usage.IsNull()) item->name = nameOf(usage);
      });
    } else if (entity->IsInstance(STANDARD_TYPE(StepBasic_ProductDefinition)) ||
               entity->IsInstance(
                   STANDARD_TYPE(StepBasic_ProductDefinitionWithAssociatedDocuments))) {
      const auto product = Handle(StepBasic_ProductDefinition)::DownCast(entity);
      StepItem* const item = parts_.itemOf(entities_.shapeOf(product));
      if (item) item->name = nameOf(product);
    }
  });
}

void StepAttributes::readLayers() {
  entities_.forEach([&](const Handle(Standard_Transient) & entity) {
    const auto layer = Handle(StepVisual_PresentationLayerAssignment)::DownCast(entity);
    if (layer.IsNull() || layer->AssignedItems().IsNull()) return;
    const std::string name = textOf(layer->Name());
    for (int i = 1; i <= layer->NbAssignedItems(); ++i) {
      const TopoDS_Shape shape = entities_.shapeOf(layer->AssignedItemsValue(i).Value());
      StepItem* const item = shape.IsNull() ? nullptr : parts_.itemOrPiece(shape);
      if (item && !std::ranges::count(item->layers, name)) item->layers.push_back(name);
    }
  });
}

}  // namespace af2::geometry
