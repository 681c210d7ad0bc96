#include "geometry/occ/model/model.h"

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

Model::Model(std::shared_ptr<const ModelShape> shape) : shape_(std::move(shape)) {}

int Model::faceCount() const { return shape_->faces.Extent(); }
int Model::edgeCount() const { return shape_->edges.Extent(); }
int Model::vertexCount() const { return shape_->vertices.Extent(); }

const std::string& Model::faceName(int face) const {
  return shape_->faceNames.at(static_cast<std::size_t>(face) - 1);
}
const std::string& Model::surfaceType(int face) const {
  return shape_->surfaceTypes.at(static_cast<std::size_t>(face) - 1);
}
const std::vector<FaceGroup>& Model::groups() const { return shape_->groups; }
const std::string& Model::unit() const { return shape_->unit; }
const std::string& Model::fileUnit() const { return shape_->fileUnit; }
double Model::diagonal() const { return shape_->diagonal; }
const std::vector<std::string>& Model::notes() const { return shape_->notes; }
const std::vector<std::string>& Model::lostFaces() const { return shape_->lostFaces; }
const std::optional<Healing>& Model::healing() const { return shape_->healing; }
const std::optional<Imprinting>& Model::imprinting() const { return shape_->imprinting; }

}  // namespace af2::geometry
