#include "geometry/spool/spooled_face.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "geometry/spool/packed.h"

namespace af2::geometry {

namespace {

static_assert(sizeof(Point3) == 24, "padding would go to disk");

bool areAllTheSame(std::span<const double> values) {
  return std::ranges::all_of(values, [&](double value) { return value == values.front(); });
}

/// Copies values from bytes. Returns what follows them.
template <class T>
std::span<const std::uint8_t> take(std::span<const std::uint8_t> bytes, std::span<T> values) {
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size_bytes());
  return bytes.subspan(values.size_bytes());
}

}  // namespace

void StoredFace::takeShape(std::span<const std::uint8_t> bytes, FaceBulk& bulk) const {
  bulk.inside.resize(counts_.inside);
  bulk.elements.resize(counts_.elements);
  unpack(take(bytes, std::span(bulk.inside)), bulk.elements);
}

FaceBulk StoredFace::loadShape() const {
  FaceBulk bulk;
  read(counts_.shapeBytes(), [&](std::span<const std::uint8_t> bytes) { takeShape(bytes, bulk); });
  return bulk;
}

FaceBulk StoredFace::load() const {
  FaceBulk bulk;
  bulk.origins.resize(counts_.elements);
  bulk.wantedSizes.resize(counts_.wantedSizes, counts_.size);
  read(counts_.allBytes(), [&](std::span<const std::uint8_t> bytes) {
    takeShape(bytes, bulk);
    const auto rest = bytes.subspan(counts_.shapeBytes());
    unpack(rest, bulk.origins);
    take(rest.subspan(counts_.originBytes), std::span(bulk.wantedSizes).first(counts_.storedSizes));
  });
  return bulk;
}

struct SpooledFace::Packed {
  Bytes elements, origins;
  StoredCounts counts;

  Packed(const Content& content, std::size_t boundary)
      : elements(packed(content.elements)), origins(packed(content.origins)) {
    counts.inside = content.inside.size();
    counts.elements = content.elements.size();
    counts.isUsed.assign(boundary, false);
    for (const Element& element : content.elements) {
      counts.quads += element.isQuad();
      for (const VertexId v : element.vertices())
        if (v.value < boundary) counts.isUsed[v.value] = true;
    }
    counts.elementBytes = elements.size();
    counts.originBytes = origins.size();
    counts.wantedSizes = content.wantedSizes.size();
    if (counts.wantedSizes > 0) counts.size = content.wantedSizes.front();
    if (!areAllTheSame(content.wantedSizes)) counts.storedSizes = counts.wantedSizes;
  }
};

SpooledFace::SpooledFace(std::shared_ptr<SpoolFile> file, const Content& content,
                         std::size_t boundary)
    : SpooledFace(std::move(file), content, Packed(content, boundary)) {}

SpooledFace::SpooledFace(std::shared_ptr<SpoolFile> file, const Content& content, Packed packed)
    : StoredFace(std::move(packed.counts)), file_(std::move(file)) {
  place_ = file_->reserve(counts().allBytes());
  std::uint64_t at = place_.begin;
  const auto put = [&](const auto& values) {
    file_->write(at, values);
    at += values.size_bytes();
  };
  put(content.inside);
  put(std::span<const std::uint8_t>(packed.elements));
  put(std::span<const std::uint8_t>(packed.origins));
  put(content.wantedSizes.first(counts().storedSizes));
}

void SpooledFace::read(std::size_t count, const UseBytes& use) const {
  Bytes bytes(count);
  file_->read(place_.begin, std::span(bytes));
  use(bytes);
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
