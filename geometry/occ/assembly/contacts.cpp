#include "geometry/occ/assembly/contacts.h"

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/base/box_tree.h"
#include "geometry/occ/assembly/common_pieces.h"
#include "geometry/occ/assembly/contact_text.h"
#include "geometry/occ/assembly/model_parts.h"
#include "geometry/occ/base/trial.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

namespace {

Box3 boxOf(const TopoDS_Shape& shape, double tolerance) {
  Box3 box;
  try {
    Bnd_Box bounds;
    BRepBndLib::Add(shape, bounds, false);
    if (bounds.IsVoid() || bounds.IsOpen()) return box;
    bounds.Enlarge(tolerance / 2);
    const gp_Pnt low = bounds.CornerMin(), high = bounds.CornerMax();
    box = {{low.X(), low.Y(), low.Z()}, {high.X(), high.Y(), high.Z()}};
  } catch (const Standard_Failure&) {  // a face without a place meets nothing
  }
  return box;
}

bool holds(const Box3& outer, const Box3& inner) {
  return outer.low.x <= inner.low.x && inner.high.x <= outer.high.x && outer.low.y <= inner.low.y &&
         inner.high.y <= outer.high.y && outer.low.z <= inner.low.z && inner.high.z <= outer.high.z;
}

using PartPair = std::pair<std::size_t, std::size_t>;  // indices of parts, the lower first

/// Pairs with faces whose boxes meet, and pairs of which one may lie inside the other.
std::vector<PartPair> nearPairs(const ModelShape& model, const std::vector<ModelPart>& parts,
                                double tolerance) {
  std::vector<Box3> faceBoxes, partBoxes(parts.size());
  std::vector<std::size_t> partOf;
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (const int face : parts[part].faces) {
      faceBoxes.push_back(boxOf(model.faces(face), tolerance));
      partBoxes[part].add(faceBoxes.back());
      partOf.push_back(part);
    }
  std::set<PartPair> pairs;
  const BoxTree faces(faceBoxes), solids(partBoxes);
  for (std::size_t i = 0; i < faceBoxes.size(); ++i)
    faces.forEachIn(faceBoxes[i], [&](std::uint32_t other) {
      if (partOf[i] < partOf[other]) pairs.emplace(partOf[i], partOf[other]);
    });
  for (std::size_t i = 0; i < parts.size(); ++i)
    solids.forEachIn(partBoxes[i], [&](std::uint32_t other) {
      if (i != other && parts[i].isSolid && holds(partBoxes[i], partBoxes[other]))
        pairs.insert(std::minmax<std::size_t>(i, other));
    });
  return {pairs.begin(), pairs.end()};
}

/// How many plane faces take as long to be compared as this one, roughly. In the collection
/// (docs/performance.md), a plane face took half a millisecond to one, three pairs of two tori 390,
/// and a pair of two free-form faces 30 to 1,300.
std::size_t workOf(const TopoDS_Face& face) {
  constexpr std::size_t kQuadric = 2, kTorus = 20, kFree = 40;
  const Handle(Geom_Surface) definition = BRep_Tool::Surface(face);
  if (definition.IsNull()) return 1;
  const GeomAdaptor_Surface surface(definition);
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      return 1;
    case GeomAbs_Cylinder:
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
      return kQuadric;
    case GeomAbs_Torus:
      return kTorus;
    case GeomAbs_BSplineSurface:
      return kFree + static_cast<std::size_t>(surface.NbUKnots() * surface.NbVKnots());
    default:
      return kFree;
  }
}

/// Those that take least, as many as the limit allows, in the order of the model.
std::vector<PartPair> cheapestOf(std::vector<PartPair> pairs, const ModelShape& model,
                                 const std::vector<ModelPart>& parts, std::size_t maxFaces) {
  if (maxFaces == 0) return pairs;
  std::vector<std::size_t> ofParts;
  for (const ModelPart& part : parts) {
    std::size_t& work = ofParts.emplace_back(0);
    for (const int face : part.faces) work += workOf(model.face(face));
  }
  const auto ofPair = [&](const PartPair& pair) {
    return ofParts[pair.first] + ofParts[pair.second];
  };
  std::ranges::stable_sort(pairs, {}, ofPair);
  std::size_t work = 0, count = 0;
  while (count < pairs.size() && (work += ofPair(pairs[count])) <= maxFaces) ++count;
  pairs.resize(count);
  std::ranges::sort(pairs);
  return pairs;
}

/// Without the noise of computing around zero, which nobody wants to read.
Point3 rounded(const Point3& p, double tolerance) {
  const auto snapped = [&](double x) { return std::abs(x) < tolerance ? 0.0 : x; };
  return {snapped(p.x), snapped(p.y), snapped(p.z)};
}

}  // namespace

PartContacts findContacts(const Model& model, const ContactOptions& options) {
  const ModelShape& shape = model.shape();
  const std::vector<ModelPart> parts = partsOf(shape);
  PartContacts contacts;
  contacts.parts = parts.size();
  if (parts.size() < 2) return contacts;
  const double tolerance =
      options.tolerance > 0 ? options.tolerance : usualFuseTolerance(model.diagonal());
  const std::vector<PartPair> all = nearPairs(shape, parts, tolerance);
  const std::vector<PartPair> pairs = cheapestOf(all, shape, parts, options.maxFaces);
  contacts.notCompared = all.size() - pairs.size();
  const auto compare = [&](std::size_t i) {
    return textOf(contactBetween(shape, parts[pairs[i].first], parts[pairs[i].second],
                                 {tolerance, BOPAlgo_GlueOff, options.secondsForPair, {}}));
  };
  const auto results = resultsOf(pairs.size(), compare, {options.secondsForPair, options.seconds});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    PartContact contact = results[i] ? contactFrom(*results[i]) : PartContact{};
    if (!results[i]) contact.kind = ContactKind::Unknown;
    contact.place = rounded(contact.place, tolerance);
    contact.one = parts[pairs[i].first].name;
    contact.other = parts[pairs[i].second].name;
    const bool isNothing = contact.kind == ContactKind::Touch && contact.area == 0 &&
                           contact.length == 0 && !contact.isAtPoint;
    if (!isNothing) contacts.pairs.push_back(std::move(contact));
  }
  return contacts;
}

}  // namespace af2::geometry
