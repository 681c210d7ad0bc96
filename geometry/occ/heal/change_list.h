// Records the changes that healing makes to a shape: how often, and where.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <ShapeExtend_MsgRegistrator.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/point.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// A place on a shape: the position of its first vertex.
std::optional<Point3> placeOf(const TopoDS_Shape& shape);

/// Counts changes by kind.
class ChangeList {
 public:
  void add(const std::string& what, const std::optional<Point3>& place, std::size_t count = 1);
  /// Adds the messages of a tool of OpenCASCADE. Single findings are reported along with their sum.
  void add(const Handle(ShapeExtend_MsgRegistrator) & messages);

  std::vector<HealedChange> take() const;

 private:
  std::map<std::string, HealedChange> changes_;
};

}  // namespace af2::geometry
