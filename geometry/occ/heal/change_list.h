// What healing has changed of a shape: how often, and where.
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

/// A place on a shape: of its first vertex.
std::optional<Point3> placeOf(const TopoDS_Shape& shape);

/// Counts what was changed, by what it was.
class ChangeList {
 public:
  void add(const std::string& what, const std::optional<Point3>& place, std::size_t count = 1);
  /// What a tool of OpenCASCADE tells. Single findings are told along with their sum.
  void add(const Handle(ShapeExtend_MsgRegistrator) & told);

  std::vector<HealedChange> take() const;

 private:
  std::map<std::string, HealedChange> changes_;
};

}  // namespace af2::geometry
