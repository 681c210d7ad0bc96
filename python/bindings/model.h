// What can be meshed, of any kind, as Python holds it.
#pragma once

#include <af2/engine/algorithm.h>
#include <af2/geometry/contact.h>
#include <af2/geometry/defect.h>
#include <af2/geometry/domain_model.h>
#include <af2/geometry/edge_entry.h>
#include <af2/geometry/model_mesh.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "python/bindings/request.h"

namespace af2::python {

/// A point of a face, and how far it is from the point for which it was searched.
struct FoundPoint {
  SurfacePoint point;
  int face = 0;  ///< 0: not known
  double distance = 0;
};

/// The points of a model that was meshed. All functions may be called from several threads.
class Places {
 public:
  virtual ~Places() = default;
  /// faces  by point, 0 for any; empty: any
  virtual std::vector<FoundPoint> nearest(std::span<const Point3> points,
                                          std::span<const int> faces, int threads) const = 0;
  virtual std::vector<FoundPoint> at(int face, std::span<const Point2> parameters) const = 0;
};

struct Meshed {
  geometry::ModelMesh mesh;
  std::shared_ptr<const Places> places;
};

/// A face of a model, before it is meshed.
struct FaceEntry {
  int id = 0;
  std::string name, surface;
  double area = 0;  ///< 0: unknown
  std::vector<int> edges;
};

/// The parts of a model.
struct Parts {
  std::vector<FaceEntry> faces;
  std::vector<geometry::EdgeEntry> edges;
  std::vector<geometry::FaceGroup> groups;
  std::vector<geometry::EdgeGroup> boundaries;
};

/// Immutable, so that threads may mesh it at once.
class MeshableModel {
 public:
  virtual ~MeshableModel() = default;
  virtual Meshed mesh(const Request& request, const AF2Algorithm& algorithm) const = 0;
  /// size  wanted edge length: the faces of planar domains and triangles depend on it
  virtual Parts parts(double size, const std::shared_ptr<Call>& call) const = 0;
  /// What is wrong or awkward in the model for a mesh of this size.
  virtual std::vector<geometry::Defect> defects(double size,
                                                const std::shared_ptr<Call>& call) const = 0;
  /// Where parts touch without sharing faces. Only CAD models have several parts.
  virtual geometry::PartContacts contacts() const { return {}; }
  /// The same model with names for faces: by name their ids. Only for CAD models.
  virtual std::shared_ptr<const MeshableModel> named(
      const std::vector<std::pair<std::string, std::vector<int>>>& names) const;
  /// "cad", "planar", "triangles" or "surface".
  virtual const char* kind() const = 0;
  virtual std::vector<std::string> notes() const { return {}; }
  virtual std::string unit() const { return {}; }
  virtual std::string fileUnit() const { return {}; }
};

using ModelPointer = std::shared_ptr<const MeshableModel>;

ModelPointer cadModelFrom(const std::filesystem::path& path);
ModelPointer planarModelFrom(const py::dict& domain);
ModelPointer planarModelFrom(const std::filesystem::path& path);
ModelPointer trianglesFrom(const py::dict& surface);
ModelPointer trianglesFrom(const std::filesystem::path& path);
/// A surface that a Python class gives.
ModelPointer surfaceFrom(const py::dict& surface);

/// Meshes a domain; `model` is what the places refer to.
Meshed meshedDomain(std::shared_ptr<const geometry::DomainModel> model, const Request& request,
                    const AF2Algorithm& algorithm);
Parts partsOf(const geometry::DomainModel& model);

/// Throw InputError for faces and edges that the model does not have.
void checkIds(const Request& request, int faces, int edges);

}  // namespace af2::python
