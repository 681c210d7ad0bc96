// What takes the most memory of the mesh of a face, kept in a file.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
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

/// The bulk of a face that is not in memory.
class StoredFace {
 public:
  /// What is known without loading it.
  struct Counts {
    std::size_t inside = 0, elements = 0, quads = 0;
    /// By vertex of the boundary: whether an element has it.
    std::vector<bool> isUsed = {};
  };

  explicit StoredFace(Counts counts) : counts_(std::move(counts)) {}
  virtual ~StoredFace() = default;
  StoredFace(const StoredFace&) = delete;
  StoredFace& operator=(const StoredFace&) = delete;

  const Counts& counts() const { return counts_; }
  /// May be called from several threads at once. Throws InputError if it cannot be loaded.
  virtual FaceBulk load() const = 0;
  /// Only the vertices and the elements.
  virtual FaceBulk loadShape() const = 0;

 private:
  Counts counts_;
};

/// The bulk of one face in a file. Its room is given back when the last owner is gone.
class SpooledFace final : public StoredFace {
 public:
  struct Content {
    std::span<const Point3> inside;
    std::span<const double> wantedSizes;  ///< by vertex inside
    std::span<const Element> elements;
    std::span<const ElementOrigin> origins;
  };

  /// boundary  number of vertices of the boundary
  SpooledFace(std::shared_ptr<SpoolFile> file, const Content& content, std::size_t boundary);
  ~SpooledFace() override { file_->release(place_); }

  FaceBulk load() const override;
  FaceBulk loadShape() const override;

 private:
  std::shared_ptr<SpoolFile> file_;
  std::size_t elementBytes_, sizes_;
  double size_;  ///< of all vertices inside, if none is in the file
  std::size_t sizesInFile_, originBytes_;
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
