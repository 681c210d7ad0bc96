#include "geometry/spool/spooled_face.h"

#include <algorithm>
#include <utility>

namespace af2::geometry {

namespace {

static_assert(sizeof(Point3) == 24 && sizeof(Element) == 16 && sizeof(ElementOrigin) == 4,
              "padding would go to disk");

}  // namespace

SpooledFace::SpooledFace(std::shared_ptr<SpoolFile> file, const Content& content,
                         std::size_t boundary)
    : file_(std::move(file)),
      inside_(content.inside.size()),
      sizes_(content.wantedSizes.size()),
      elements_(content.elements.size()),
      isUsed_(boundary, false) {
  for (const Element& element : content.elements) {
    quads_ += element.isQuad();
    for (const VertexId v : element.vertices())
      if (v.value < boundary) isUsed_[v.value] = true;
  }
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
  bulk.inside.resize(inside_);
  bulk.elements.resize(elements_);
  file_->read(place_.begin, std::span(bulk.inside));
  file_->read(place_.begin + inside_ * sizeof(Point3), std::span(bulk.elements));
  return bulk;
}

FaceBulk SpooledFace::load() const {
  FaceBulk bulk = loadShape();
  bulk.wantedSizes.resize(sizes_);
  bulk.origins.resize(elements_);
  const std::uint64_t sizes = place_.begin + inside_ * sizeof(Point3) + elements_ * sizeof(Element);
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
