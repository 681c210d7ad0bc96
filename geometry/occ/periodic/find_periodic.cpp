// Finds how faces are mapped to others.
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/occ/base/points.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/periodic/face_map.h"
#include "geometry/occ/periodic/periodic_faces.h"

namespace af2::geometry {
namespace {

constexpr double kTolerance = 1e-6;  // of the diagonal

std::string nameOf(const Model& model, int face) {
  const std::string& name = model.faceName(face);
  return "face " + std::to_string(face) + (name.empty() ? "" : " \"" + name + "\"");
}

std::vector<Point3> cornersOf(const Model& model, int face) {
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(model.shape().face(face), TopAbs_VERTEX, vertices);
  std::vector<Point3> corners;
  for (int i = 1; i <= vertices.Extent(); ++i)
    corners.push_back(toPoint(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)))));
  return corners;
}

/// The distance of the worst image from the nearest of some points.
double misfit(const FaceMap& map, const std::vector<Point3>& from, const std::vector<Point3>& to) {
  if (from.size() != to.size()) return std::numeric_limits<double>::infinity();
  double worst = 0;
  for (const Point3& p : from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point3& q : to) nearest = std::min(nearest, distance(map.at(p), q));
    worst = std::max(worst, nearest);
  }
  return worst;
}

struct Measured {
  double area;
  Point3 centre;
};
Measured measure(const Model& model, int face) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(model.shape().face(face), properties);
  return {std::abs(properties.Mass()), toPoint(properties.CentreOfMass())};
}

struct FacePlane {
  Point3 origin, normal;  ///< outwards
};
std::optional<FacePlane> planeOf(const Model& model, int face) {
  const TopoDS_Face shape = TopoDS::Face(model.shape().face(face));
  const BRepAdaptor_Surface surface(shape, false);
  if (surface.GetType() != GeomAbs_Plane) return std::nullopt;
  const gp_Pln plane = surface.Plane();
  Point3 normal = toPoint(plane.Axis().Direction());
  if (!plane.Direct()) normal = -1 * normal;
  if (shape.Orientation() == TopAbs_REVERSED) normal = -1 * normal;
  return FacePlane{toPoint(plane.Location()), normal};
}

/// Around the line in which two planes meet, both ways.
std::vector<FaceMap> rotationsBetween(const FacePlane& one, const FacePlane& other) {
  const Point3 along = cross(one.normal, other.normal);
  const double sine = length(along);
  if (sine < 1e-9) return {};
  const Point3 axis = 1 / sine * along;
  const double d1 = dot(one.normal, one.origin), d2 = dot(other.normal, other.origin);
  const Point3 onAxis =
      1 / (sine * sine) * (d1 * cross(other.normal, along) + d2 * cross(along, one.normal));
  // The image of the first normal is the second, or its opposite.
  const double angle = angleOf({dot(one.normal, other.normal), sine});
  std::vector<FaceMap> maps;
  for (const double turn : {angle, angle - std::numbers::pi, angle + std::numbers::pi})
    maps.push_back(FaceMap::rotation(onAxis, axis, turn));
  return maps;
}

FaceMap mapBetween(const Model& model, int first, int second) {
  const std::string names = nameOf(model, first) + " and " + nameOf(model, second);
  const Measured one = measure(model, first), other = measure(model, second);
  constexpr double kAlike = 1e-5;
  if (!(std::abs(one.area - other.area) <= kAlike * std::max(one.area, other.area)))
    throw InputError(names + " are not periodic: their areas are " + af2::textOf(one.area, 6) +
                     " and " + af2::textOf(other.area, 6));
  std::vector<FaceMap> maps{FaceMap::translation(other.centre - one.centre)};
  const auto plane = planeOf(model, first), otherPlane = planeOf(model, second);
  if (plane && otherPlane)
    for (const FaceMap& map : rotationsBetween(*plane, *otherPlane)) maps.push_back(map);
  const std::vector<Point3> from = cornersOf(model, first), to = cornersOf(model, second);
  if (from.size() != to.size())
    throw InputError(names + " are not periodic: they have " + std::to_string(from.size()) +
                     " and " + std::to_string(to.size()) + " vertices");
  double least = std::numeric_limits<double>::infinity();
  for (const FaceMap& map : maps) {
    const double gap = std::max(misfit(map, from, to), distance(map.at(one.centre), other.centre));
    if (gap <= kTolerance * model.diagonal()) return map;
    least = std::min(least, gap);
  }
  throw InputError(names + " are not periodic: no translation" +
                   (maps.size() > 1 ? " or rotation" : "") +
                   " maps the vertices of one to those of the other; the best is off by " +
                   af2::textOf(least, 3));
}

double coordinate(const Point3& p, char axis) {
  return axis == 'x' ? p.x : axis == 'y' ? p.y : p.z;
}

/// The plane faces all of whose vertices have the same coordinate.
std::vector<std::pair<double, int>> facesAcross(const Model& model, char axis) {
  std::vector<std::pair<double, int>> faces;
  for (int face = 1; face <= model.faceCount(); ++face) {
    const auto plane = planeOf(model, face);
    if (!plane) continue;
    const double at = coordinate(plane->origin, axis);
    const std::vector<Point3> corners = cornersOf(model, face);
    if (std::abs(std::abs(coordinate(plane->normal, axis)) - 1) < 1e-9 &&
        std::ranges::all_of(corners, [&](const Point3& p) {
          return std::abs(coordinate(p, axis) - at) <= kTolerance * model.diagonal();
        }))
      faces.emplace_back(at, face);
  }
  return faces;
}

/// The face at the high side whose centre is straight across.
int partnerOf(const Model& model, int low, const std::vector<int>& high, char axis) {
  const Measured from = measure(model, low);
  for (const int face : high) {
    Point3 gap = measure(model, face).centre - from.centre;
    (axis == 'x' ? gap.x : axis == 'y' ? gap.y : gap.z) = 0;
    if (length(gap) <= kTolerance * model.diagonal()) return face;
  }
  throw InputError(nameOf(model, low) + " has no periodic face across in " + std::string(1, axis) +
                   "; name pairs of faces instead");
}

void addAcross(const Model& model, const std::string& direction,
               std::vector<std::pair<int, int>>& pairs) {
  const char axis = direction.front();
  const std::vector<std::pair<double, int>> faces = facesAcross(model, axis);
  if (faces.empty())
    throw InputError("no plane face is across the direction " + direction +
                     ", so none is periodic in it");
  const double low = std::ranges::min(faces).first, high = std::ranges::max(faces).first;
  const double slack = kTolerance * model.diagonal();
  std::vector<int> atLow, atHigh;
  for (const auto& [at, face] : faces) {
    if (at <= low + slack)
      atLow.push_back(face);
    else if (at >= high - slack)
      atHigh.push_back(face);
  }
  if (atLow.size() != atHigh.size())
    throw InputError("there are " + std::to_string(atLow.size()) + " faces at the low side in " +
                     direction + " and " + std::to_string(atHigh.size()) +
                     " at the high side; name pairs of faces instead");
  for (const int face : atLow) pairs.emplace_back(face, partnerOf(model, face, atHigh, axis));
}

}  // namespace

std::vector<PeriodicPair> findPeriodic(const Model& model, const PeriodicRequest& request) {
  std::vector<std::pair<int, int>> asked = request.pairs;
  for (const std::string& direction : request.directions) addAcross(model, direction, asked);
  std::vector<PeriodicPair> pairs;
  std::vector<int> images;
  for (const auto& [first, second] : asked) {
    for (const int face : {first, second})
      if (face < 1 || face > model.faceCount())
        throw InputError("there is no face " + std::to_string(face) +
                         "; the model has faces 1 to " + std::to_string(model.faceCount()));
    if (first == second) throw InputError(nameOf(model, second) + " cannot be its own image");
    if (std::ranges::count(images, second) > 0)
      throw InputError(nameOf(model, second) + " can be the image of one other face only");
    images.push_back(second);
    pairs.push_back({first, second, mapBetween(model, first, second).matrix(), {}});
  }
  for (const PeriodicPair& pair : pairs)
    if (std::ranges::count(images, pair.first) > 0)
      throw InputError(nameOf(model, pair.first) + " is an image itself; pairs cannot be chained");
  return pairs;
}

}  // namespace af2::geometry
