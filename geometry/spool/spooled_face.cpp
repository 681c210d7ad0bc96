#include "geometry/spool/spooled_face.h"

#include <algorithm>
#include <utility>

namespace af2::geometry {

namespace {

static_assert(sizeof(Point3) == 24 && sizeof(Element) == 16 && sizeof(ElementOrigin) == 4,
              "padding would go to disk");

StoredFace::Counts countsOf(const SpooledFace::Content& content, std::size_t boundary) {
  StoredFace::Counts counts{content.inside.size(), content.elements.size(), 0,
                            std::vector<bool>(boundary, false)};
  for (const Element& element : content.elements) {
    counts.quads += element.isQuad();
    for (const VertexId v : element.vertices())
      if (v.value < boundary) counts.isUsed[v.value] = true;
  }
  return counts;
}

}  // namespace

SpooledFace::SpooledFace(std::shared_ptr<SpoolFile> file, const Content& content,
                         std::size_t boundary)
    : StoredFace(countsOf(content, boundary)),
      file_(std::move(file)),
      sizes_(content.wantedSizes.size()) {
  place_ = file_->reserve(content.inside.size_bytes() + content.elements.size_bytes() +
                          content.wantedSizes.size_bytes() + content.origins.size_bytes());
  std::uint64_t at = place_.begin;
  const auto put = [&](const auto& values) {
    file_->write(at, values);
    at += values.size_bytes();
  };
  put(content.inside);
  put(content.elements);
  put(content.wantedSizes);
  put(content.origins);
}

FaceBulk SpooledFace::loadShape() const {
  FaceBulk bulk;
  bulk.inside.resize(counts().inside);
  bulk.elements.resize(counts().elements);
  file_->read(place_.begin, std::span(bulk.inside));
  file_->read(place_.begin + counts().inside * sizeof(Point3), std::span(bulk.elements));
  return bulk;
}

FaceBulk SpooledFace::load() const {
  FaceBulk bulk = loadShape();
  bulk.wantedSizes.resize(sizes_);
  bulk.origins.resize(counts().elements);
  const std::uint64_t sizes =
      place_.begin + counts().inside * sizeof(Point3) + counts().elements * sizeof(Element);
  file_->read(sizes, std::span(bulk.wantedSizes));
  file_->read(sizes + sizes_ * sizeof(double), std::span(bulk.origins));
  return bulk;
}

SpooledFloats::SpooledFloats(std::shared_ptr<SpoolFile> file, std::span<const float> values)
    : file_(std::move(file)), place_(file_->reserve(values.size_bytes())) {
  file_->write(place_.begin, values);
}

std::vector<float> SpooledFloats::load() const {
  std::vector<float> values(place_.size / sizeof(float));
  file_->read(place_.begin, std::span(values));
  return values;
}

}  // namespace af2::geometry
