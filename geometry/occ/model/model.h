// A CAD model as it was read: faces, edges and vertices with their numbers.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "geometry/base/file_extension.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

struct ModelShape;  // the OpenCASCADE side of it, occ/model_shape.h

/// A CAD model. Copies share the same, immutable shape.
class AF2_EXPORT Model {
 public:
  explicit Model(std::shared_ptr<const ModelShape> shape);

  /// Faces, edges and vertices are numbered 1, 2, ... in the order in which the model contains
  /// them.
  int faceCount() const;
  int edgeCount() const;
  int vertexCount() const;

  /// From the file; empty if it has none.
  const std::string& faceName(int face) const;
  /// "plane", "cylinder", "cone", "sphere", "torus", "bspline", ...
  const std::string& surfaceType(int face) const;
  /// Groups of faces in the file (STEP only: names of parts, layers, colours), and solids.
  const std::vector<FaceGroup>& groups() const;
  /// The unit of all coordinates: "mm" from STEP and IGES; empty from BREP, which has no unit.
  const std::string& unit() const;
  /// The unit used in the file, as named there; empty if the file has none.
  const std::string& fileUnit() const;
  /// Diagonal of the box around all vertices and edges.
  double diagonal() const;
  /// Repairs made while reading, and suspected faults; one sentence each.
  const std::vector<std::string>& notes() const;

  /// Faces of the file that could not be read and are missing in the model, with their numbers in
  /// the file: "#17 'inlet'" from STEP, "D17" from IGES.
  const std::vector<std::string>& lostFaces() const;

  /// The changes of healModel, if it made this model.
  const std::optional<Healing>& healing() const;

  /// The result of imprintModel, if it made this model.
  const std::optional<Imprinting>& imprinting() const;

  const ModelShape& shape() const { return *shape_; }
  std::shared_ptr<const ModelShape> sharedShape() const { return shape_; }

 private:
  std::shared_ptr<const ModelShape> shape_;
};

/// The formats that readModel reads, in the order in which messages list them.
AF2_EXPORT std::vector<FileFormat> cadFormats();

/// Reads a STEP, IGES or BREP file; the content determines the format.
///
/// Throws InputError, with the file, the cause and a remedy, if the file cannot be read, is
/// truncated or damaged, or contains no face.
///
/// Must not be called from two threads at once, because OpenCASCADE's readers share global state.
AF2_EXPORT Model readModel(const std::filesystem::path& path);

}  // namespace af2::geometry
