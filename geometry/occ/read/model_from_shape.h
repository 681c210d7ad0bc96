// Makes a model of a shape that a program has in memory.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// A name for a part of a shape.
struct NamedShape {
  TopoDS_Shape shape;  ///< a face, or anything that contains faces
  std::string name;
  /// With GroupKind::Part a face gets the name itself (Model::faceName); other shapes, and other
  /// kinds, become groups (Model::groups). Not GroupKind::Solid: each solid is a group anyway.
  GroupKind kind = GroupKind::Part;
};

/// What a shape does not say by itself.
struct ShapeNames {
  /// In the order of the groups. Shapes with the same name and kind are one group. The last name of
  /// a face counts.
  std::vector<NamedShape> names;
  std::string unit;  ///< of all lengths, for reports: "mm", "m"; may be empty
};

/// The same model as of a BREP file with this shape, with the repairs that readModel makes.
///
/// Edges that have curves only in parameter space get one in space, which changes them in `shape`,
/// too. Apart from that, `shape` is not changed, and must not be changed by others while the model
/// is in use.
///
/// Throws InputError if the shape is null, damaged, or has no face; or if a name is empty, is of a
/// shape that does not consist of faces of `shape`, or is a colour other than "#rrggbb".
AF2_EXPORT Model modelFrom(const TopoDS_Shape& shape, const ShapeNames& names = {});

}  // namespace af2::geometry
