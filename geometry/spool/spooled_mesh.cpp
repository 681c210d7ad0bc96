#include "geometry/spool/spooled_mesh.h"

#include <algorithm>
#include <utility>

namespace af2::geometry {

SpooledMesh::SpooledMesh(std::vector<SpooledPart> parts, std::size_t shared,
                         std::shared_ptr<SpoolFile> file, double scale)
    : parts_(std::move(parts)),
      file_(std::move(file)),
      scale_(scale),
      firstVertex_{shared},
      firstElement_{0} {
  for (const SpooledPart& part : parts_) {
    firstVertex_.push_back(firstVertex_.back() + part.bulk->counts().inside);
    firstElement_.push_back(firstElement_.back() + part.bulk->counts().elements);
  }
}

std::size_t SpooledMesh::quadCount() const {
  std::size_t quads = 0;
  for (const SpooledPart& part : parts_) quads += part.bulk->counts().quads;
  return quads;
}

std::size_t SpooledMesh::partOf(std::size_t element) const {
  const auto after = std::ranges::upper_bound(firstElement_, element);
  return static_cast<std::size_t>(after - firstElement_.begin()) - 1;
}

void SpooledMesh::visitPart(std::size_t i, const Shared& shared, const SliceVisit& visit) const {
  const SpooledPart& part = parts_[i];
  FaceBulk bulk = part.bulk->load();
  std::vector<float> scores;
  if (part.scores) scores = part.scores->load();
  const std::size_t boundary = part.boundary.size();
  for (Element& element : bulk.elements)
    for (VertexId& v : element.corners)
      if (!v.isNone())
        v = v.value < boundary ? VertexId(part.boundary[v.value])
                               : VertexId(firstVertex_[i] + v.value - boundary);
  if (scale_ != 1) {
    for (Point3& vertex : bulk.inside) vertex = scale_ * vertex;
    for (double& size : bulk.wantedSizes) size *= scale_;
  }
  visit({firstVertex_[i],
         firstElement_[i],
         bulk.inside,
         bulk.wantedSizes,
         bulk.elements,
         bulk.origins,
         scores,
         {},
         part.face,
         shared.vertices,
         shared.wantedSizes});
}

void SpooledMesh::visitAll(const Shared& shared, const SliceVisit& visit) const {
  visit({0, 0, shared.vertices, shared.wantedSizes, {}, {}, {}, {}});
  for (std::size_t i = 0, ahead = 0; i < parts_.size(); ++i) {
    readAhead(i, ahead);
    visitPart(i, shared, visit);
  }
}

/// Has at least the next part read, and more if they are small.
void SpooledMesh::readAhead(std::size_t part, std::size_t& ahead) const {
  constexpr std::size_t kManyElements = 50'000;
  ahead = std::max(ahead, part + 1);
  const auto isFar = [&] { return firstElement_[ahead] > firstElement_[part + 1] + kManyElements; };
  for (; ahead < parts_.size() && (ahead == part + 1 || !isFar()); ++ahead)
    parts_[ahead].bulk->readAhead();
}

}  // namespace af2::geometry
