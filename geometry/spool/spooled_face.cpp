#include "geometry/spool/spooled_face.h"

#include <algorithm>
#include <utility>

#include "geometry/spool/packed.h"

namespace af2::geometry {

namespace {

static_assert(sizeof(Point3) == 24, "padding would go to disk");

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

bool areAllTheSame(std::span<const double> values) {
  return std::ranges::all_of(values, [&](double value) { return value == values.front(); });
}

}  // namespace

SpooledFace::SpooledFace(std::shared_ptr<SpoolFile> file, const Content& content,
                         std::size_t boundary)
    : StoredFace(countsOf(content, boundary)),
      file_(std::move(file)),
      sizes_(content.wantedSizes.size()),
      size_(sizes_ > 0 ? content.wantedSizes.front() : 0),
      sizesInFile_(areAllTheSame(content.wantedSizes) ? 0 : sizes_) {
  const Bytes elements = packed(content.elements), origins = packed(content.origins);
  elementBytes_ = elements.size();
  originBytes_ = origins.size();
  place_ = file_->reserve(content.inside.size_bytes() + elementBytes_ +
                          sizesInFile_ * sizeof(double) + originBytes_);
  std::uint64_t at = place_.begin;
  const auto put = [&](const auto& values) {
    file_->write(at, values);
    at += values.size_bytes();
  };
  put(content.inside);
  put(std::span(elements));
  put(content.wantedSizes.first(sizesInFile_));
  put(std::span(origins));
}

FaceBulk SpooledFace::loadShape() const {
  FaceBulk bulk;
  bulk.inside.resize(counts().inside);
  file_->read(place_.begin, std::span(bulk.inside));
  bulk.elements.resize(counts().elements);
  Bytes elements(elementBytes_);
  file_->read(place_.begin + counts().inside * sizeof(Point3), std::span(elements));
  unpack(elements, bulk.elements);
  return bulk;
}

FaceBulk SpooledFace::load() const {
  FaceBulk bulk = loadShape();
  const std::uint64_t sizes = place_.begin + counts().inside * sizeof(Point3) + elementBytes_;
  bulk.wantedSizes.resize(sizes_, size_);
  file_->read(sizes, std::span(bulk.wantedSizes).first(sizesInFile_));
  bulk.origins.resize(counts().elements);
  Bytes origins(originBytes_);
  file_->read(sizes + sizesInFile_ * sizeof(double), std::span(origins));
  unpack(origins, bulk.origins);
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
