// What takes the most memory of the mesh of a face, kept in a file.
// Not installed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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

/// What is known of a stored face without loading it: enough to make sense of its bytes. These are,
/// in this order, the vertices inside, the elements and the origins (packed.h), and the sizes.
struct StoredCounts {
  std::size_t inside = 0, elements = 0, quads = 0;
  /// By vertex of the boundary: whether an element has it.
  std::vector<bool> isUsed = {};
  std::size_t elementBytes = 0, originBytes = 0;
  std::size_t wantedSizes = 0, storedSizes = 0;  ///< none is stored if all are `size`
  double size = 0;

  /// So many bytes hold the vertices and the elements, or everything.
  std::size_t shapeBytes() const { return inside * sizeof(Point3) + elementBytes; }
  std::size_t allBytes() const { return shapeBytes() + originBytes + storedSizes * sizeof(double); }
};

/// The bulk of a face that has been put away.
class StoredFace {
 public:
  explicit StoredFace(StoredCounts counts) : counts_(std::move(counts)) {}
  virtual ~StoredFace() = default;
  StoredFace(const StoredFace&) = delete;
  StoredFace& operator=(const StoredFace&) = delete;

  const StoredCounts& counts() const { return counts_; }
  /// May be called from several threads at once. Throws InputError if it cannot be loaded.
  FaceBulk load() const;
  /// Only the vertices and the elements.
  FaceBulk loadShape() const;

  using UseBytes = std::function<void(std::span<const std::uint8_t>)>;
  /// Calls `use` with the first bytes of the face.
  virtual void read(std::size_t count, const UseBytes& use) const = 0;
  /// The face will soon be loaded: gets it from far away already.
  virtual void readAhead() const {}

 private:
  void takeShape(std::span<const std::uint8_t> bytes, FaceBulk& bulk) const;

  StoredCounts counts_;
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

  void read(std::size_t count, const UseBytes& use) const override;

 private:
  struct Packed;
  SpooledFace(std::shared_ptr<SpoolFile> file, const Content& content, Packed packed);

  std::shared_ptr<SpoolFile> file_;
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
