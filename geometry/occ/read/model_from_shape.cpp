#include "geometry/occ/read/model_from_shape.h"

#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <string_view>

#include "engine/base/error.h"
#include "geometry/occ/model/model_shape.h"
#include "geometry/occ/read/crossed_faces.h"

namespace af2::geometry {

namespace {

[[noreturn]] void refuse(const std::string& reason) { throw InputError("modelFrom: " + reason); }

bool isColor(const std::string& name) {
  return name.size() == 7 && name[0] == '#' &&
         name.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
}

void checkName(const NamedShape& named, const TopTools_IndexedMapOfShape& faces) {
  if (named.name.empty()) refuse("a name is empty");
  const std::string quoted = "'" + named.name + "'";
  if (named.shape.IsNull()) refuse("the shape called " + quoted + " is null");
  if (named.kind == GroupKind::Solid)
    refuse(quoted + " names a group of the kind Solid; name the solid as a Part");
  if (named.kind == GroupKind::Color && !isColor(named.name))
    refuse(quoted + " is not a colour of the form #rrggbb, in lower case");
  TopExp_Explorer it(named.shape, TopAbs_FACE);
  if (!it.More()) refuse("the shape called " + quoted + " has no face");
  for (; it.More(); it.Next())
    if (!faces.Contains(it.Current()))
      refuse("the shape called " + quoted + " has a face that the model does not have");
}

bool namesFaceItself(const NamedShape& named) {
  return named.kind == GroupKind::Part && named.shape.ShapeType() == TopAbs_FACE;
}

std::vector<ShapeGroup> groupsOf(const std::vector<NamedShape>& names) {
  std::vector<ShapeGroup> groups;
  for (const NamedShape& named : names) {
    if (namesFaceItself(named)) continue;
    auto group = std::ranges::find_if(groups, [&](const ShapeGroup& other) {
      return other.kind == named.kind && other.name == named.name;
    });
    if (group == groups.end())
      group = groups.insert(groups.end(), ShapeGroup{named.name, named.kind, {}});
    group->shapes.push_back(named.shape);
  }
  return groups;
}

std::function<std::string(const TopoDS_Face&)> namesOfFaces(const std::vector<NamedShape>& names) {
  TopTools_DataMapOfShapeInteger index;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!namesFaceItself(names[i])) continue;
    index.UnBind(names[i].shape);
    index.Bind(names[i].shape, static_cast<int>(i));
  }
  return [index, names](const TopoDS_Face& face) {
    const int* const found = index.Seek(face);
    return found ? names[static_cast<std::size_t>(*found)].name : std::string();
  };
}

}  // namespace

Model modelFrom(const TopoDS_Shape& shape, const ShapeNames& names) {
  if (shape.IsNull()) refuse("the shape is null");
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  if (faces.IsEmpty()) refuse("the shape has no face");
  for (const NamedShape& named : names.names) checkName(named, faces);
  ReadShape read;
  read.shape = shape;
  read.unit = names.unit;
  read.groups = groupsOf(names.names);
  read.nameOf = namesOfFaces(names.names);
  try {
    turnBackCrossedFaces(read);
    return Model(makeModelShape(std::move(read)));
  } catch (const Standard_Failure& failure) {
    refuse(std::string("the shape is damaged (") + failure.DynamicType()->Name() + ")");
  }
}

}  // namespace af2::geometry
