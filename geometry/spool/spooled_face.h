// What takes the most memory of the mesh of a face, kept in a file.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/base/point.h"
#include "engine/mesh/mesh.h"
#include "geometry/spool/spool_file.h"

namespace af2::geometry {

/// Vertices inside a face, and its elements. Their corners are numbered: first the vertices of the
/// boundary of the face, then those inside.
struct FaceBulk {
  std::vector<Point3> inside;
  std::vector<double> wantedSizes;  ///< by vertex inside
  std::vector<Element> elements;
  std::vector<ElementOrigin> origins;  ///< by element
};

/// The bulk of one face in a file. Its room is given back when the last owner is gone.
class SpooledFace {
 public:
  struct Content {
    std::span<const Point3> inside;
    std::span<const double> wantedSizes;  ///< by vertex inside
    std::span<const Element> elements;
    std::span<const ElementOrigin> origins;
  };

  /// boundary  number of vertices of the boundary
  SpooledFace(std::shared_ptr<SpoolFile> file, const Content& content, std::size_t boundary);
  ~SpooledFace() { file_->release(place_); }
  SpooledFace(const SpooledFace&) = delete;
  SpooledFace& operator=(const SpooledFace&) = delete;

  std::size_t insideCount() const { return inside_; }
  std::size_t elementCount() const { return elements_; }
  std::size_t quadCount() const { return quads_; }
  /// By vertex of the boundary: whether an element has it.
  const std::vector<bool>& isUsed() const { return isUsed_; }
  const std::shared_ptr<SpoolFile>& file() const { return file_; }

  FaceBulk load() const;
  /// Only the vertices and the elements.
  FaceBulk loadShape() const;

 private:
  std::shared_ptr<SpoolFile> file_;
  std::size_t inside_, sizes_, elements_, quads_ = 0;
  std::vector<bool> isUsed_;
  SpoolFile::Place place_;
};

/// Numbers of elements in a file.
class SpooledFloats {
 public:
  SpooledFloats(std::shared_ptr<SpoolFile> file, std::span<const float> values);
  ~SpooledFloats() { file_->release(place_); }
  SpooledFloats(const SpooledFloats&) = delete;
  SpooledFloats& operator=(const SpooledFloats&) = delete;

  std::vector<float> load() const;

 private:
  std::shared_ptr<SpoolFile> file_;
  SpoolFile::Place place_;
};

}  // namespace af2::geometry
