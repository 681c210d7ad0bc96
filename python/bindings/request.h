// What is asked of one mesh, from a dictionary that the package makes of the arguments of af2.mesh.
#pragma once

#include <af2/geometry/merge_request.h>
#include <af2/geometry/meshing_options.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/common.h"
#include "python/bindings/run.h"

namespace af2::python {

/// A face by its id, or by a name if that is not empty.
struct FaceReference {
  int id = 0;
  std::string name = {};
};

struct Request {
  geometry::MeshingOptions options;
  bool heal = false;
  double healTolerance = 0;
  bool imprint = false, glue = false;
  std::string overlap;  ///< "first", "last" or "cut"; empty: refuse
  double imprintTolerance = 0;
  std::vector<std::string> periodicDirections;
  std::vector<std::pair<FaceReference, FaceReference>> periodicPairs;
  std::optional<geometry::MergeRequest> merge;
  std::vector<Point3> points;               ///< become vertices inside faces
  std::vector<std::vector<Point3>> curves;  ///< become edges inside faces
  std::shared_ptr<Call> call;               ///< for callbacks

  /// Whether faces or edges are named by number: healing changes the numbers.
  bool asksByNumber() const;
};

/// `call` gets the functions of sizes and progress. The package has checked types and words.
Request requestFrom(const py::dict& asked, const std::shared_ptr<Call>& call);

}  // namespace af2::python
