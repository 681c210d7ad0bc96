// Takes what readers find in a mesh file, and makes a mesh of it.
// Not installed.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "geometry/reading/field_cells.h"
#include "geometry/reading/read_mesh.h"

namespace af2::geometry {

/// The number of a vertex that a file gives as a number of any kind; far too large a number for
/// what is none, which then counts as a vertex that the file does not have.
inline std::uint64_t vertexNumber(double value) {
  constexpr std::uint64_t kNoVertex = std::uint64_t{1} << 40;
  return value >= 0 && value < static_cast<double>(kNoVertex) ? static_cast<std::uint64_t>(value)
                                                              : kNoVertex;
}

/// An id or type that a file gives as a number of any kind; 0 for what is none.
inline std::int32_t idNumber(double value) {
  return std::abs(value) < 2e9 ? static_cast<std::int32_t>(value) : 0;
}

class MeshBuilder {
 public:
  /// name  of the file, for messages
  /// field  takes arrays and solid cells, too, if it is given; then finishField ends the reading
  explicit MeshBuilder(std::string name, FieldCells* field = nullptr)
      : name_(std::move(name)), field_(field) {}

  /// Polygons with more than four corners become triangles: a surface may have them, a mesh not.
  void dividePolygons() { dividesPolygons_ = true; }

  const std::string& name() const { return name_; }
  std::size_t vertexCount() const { return result_.mesh.vertices.size(); }

  void addVertex(const Point3& p) { result_.mesh.vertices.push_back(p); }
  /// corners  numbers of vertices, counted from 0; they may be added later
  /// Throws InputError unless there are three or four corners, or more that may be divided.
  void addElement(std::span<const std::uint64_t> corners, std::int32_t face);
  void addLine(std::uint64_t from, std::uint64_t to, std::int32_t edge);
  /// kind  for a note, if solid cells are not wanted
  void addSolid(std::span<const std::uint64_t> corners, const std::string& kind) {
    field_ ? field_->add(corners, 3) : leaveOut(kind);
  }
  /// An array with one number for each vertex from `first` on; only if there is a field.
  void addValues(const std::string& array, std::size_t first, const std::vector<double>& values) {
    field_->addValues(array, first, values);
  }
  void noteOtherArray(const std::string& array) { field_->others.push_back(array); }
  bool hasField() const { return field_ != nullptr; }
  /// An element that is not one of a surface.
  void leaveOut(const std::string& kind) { ++leftOut_[kind]; }
  void noteSecondOrder() { isSecondOrder_ = true; }
  void setHasFaces() { result_.hasFaces = true; }
  /// The name of a face, if the file has one.
  void setFaceName(std::int32_t face, std::string name) { faceNames_[face] = std::move(name); }
  /// By vertex.
  void setWantedSizes(std::vector<double> sizes) { result_.mesh.wantedSizes = std::move(sizes); }

  [[noreturn]] void fail(const std::string& fault) const;

  /// Checks what was added, and gives it back.
  MeshFile finish();
  /// Checks what was added, and adds it to the field.
  void finishField();

 private:
  struct Polygon {
    std::vector<std::uint32_t> corners;
    std::int32_t face;
  };

  void checkNumbers() const;
  void addTrianglesOfPolygons();
  void mendElements();
  void writeNotes(std::size_t collapsed, std::size_t mended);
  void dropWrongSizes();
  void countFaces();

  std::string name_;
  FieldCells* field_;
  MeshFile result_;
  std::map<std::string, std::size_t> leftOut_;
  std::map<std::int32_t, std::string> faceNames_;
  std::vector<Polygon> polygons_;  // with more than four corners
  bool isSecondOrder_ = false, dividesPolygons_ = false;
};

}  // namespace af2::geometry
