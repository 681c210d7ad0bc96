// Legacy VTK files with an unstructured grid, text or binary (high byte first).
#include "geometry/reading/formats.h"
#include "geometry/reading/number_stream.h"
#include "geometry/reading/vtk_cell.h"

namespace af2::geometry {
namespace {

double scalar(NumberStream& in, Coding coding, std::string_view type) {
  if (coding == Coding::Text) return in.number<double>(coding);
  if (type == "double") return in.number<double>(coding);
  if (type == "float") return static_cast<double>(in.number<float>(coding));
  if (type == "int") return static_cast<double>(in.number<std::int32_t>(coding));
  if (type == "unsigned_int") return static_cast<double>(in.number<std::uint32_t>(coding));
  if (type == "long" || type == "vtktypeint64" || type == "vtkIdType")
    return static_cast<double>(in.number<std::int64_t>(coding));
  if (type == "unsigned_char") return static_cast<double>(in.number<std::uint8_t>(coding));
  if (type == "char") return static_cast<double>(in.number<std::int8_t>(coding));
  in.fail("numbers of type '" + std::string(type) + "' are not known");
}

class VtkReader {
 public:
  VtkReader(const std::string& content, MeshBuilder& mesh)
      : in_(mesh.name(), content), mesh_(mesh) {}

  void read() {
    readHead();
    for (std::string_view section = in_.word(); !section.empty(); section = in_.word()) {
      if (section == "POINTS")
        readPoints();
      else if (section == "CELLS")
        readCells();
      else if (section == "CELL_TYPES")
        readTypes();
      else if (section == "CELL_DATA")
        hasCellData_ = true, in_.line();
      else if (section == "FIELD" && hasCellData_)
        readFields();
      else
        break;  // attributes that are not measured
    }
    if (types_.size() != cells_.size())
      mesh_.fail("has " + std::to_string(cells_.size()) + " cells and " +
                 std::to_string(types_.size()) + " types of cells; it may be truncated");
    for (std::vector<std::int32_t>* ids : {&faces_, &edges_})
      if (ids->size() != cells_.size()) ids->clear();  // of something else
    if (!faces_.empty()) mesh_.setHasFaces();
    for (std::size_t i = 0; i < cells_.size(); ++i)
      addVtkCell(mesh_, types_[i], cells_[i], faces_.empty() ? 1 : faces_[i],
                 edges_.empty() ? 0 : edges_[i]);
  }

 private:
  void readHead() {
    if (!in_.line().starts_with("# vtk DataFile Version ")) mesh_.fail("is not a legacy VTK file");
    in_.line();  // a title
    const std::string_view coding = in_.word("BINARY or ASCII");
    if (coding != "BINARY" && coding != "ASCII") in_.fail("expected BINARY or ASCII");
    coding_ = coding == "ASCII" ? Coding::Text : Coding::HighFirst;
    if (in_.word("DATASET") != "DATASET" || in_.word("a kind of data") != "UNSTRUCTURED_GRID")
      in_.fail("only files with 'DATASET UNSTRUCTURED_GRID' can be read");
  }

  void readPoints() {
    const std::size_t count = in_.count<std::uint64_t>(Coding::Text);
    const std::string type(in_.word("a type of numbers"));
    in_.line();
    for (std::size_t i = 0; i < count; ++i) {
      const double x = scalar(in_, coding_, type), y = scalar(in_, coding_, type);
      mesh_.addVertex({x, y, scalar(in_, coding_, type)});
    }
  }

  void readCells() {
    const std::size_t count = in_.count<std::uint64_t>(Coding::Text);
    in_.count<std::uint64_t>(Coding::Text);
    if (!trimmed(in_.line()).empty()) in_.fail("expected the end of the line");
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0) refuseNewForm();
      std::vector<std::uint64_t> corners(in_.count<std::int32_t>(coding_));
      for (std::uint64_t& corner : corners)
        corner = vertexNumber(in_.number<std::int32_t>(coding_));
      cells_.push_back(std::move(corners));
    }
  }
  /// From version 5.1 on, cells have two arrays.
  void refuseNewForm() {
    NumberStream ahead = in_;
    if (ahead.word() == "OFFSETS")
      in_.fail("cells as of version 5.1 cannot be read; write the file as version 4.2 or as .vtu");
  }

  void readTypes() {
    const std::size_t count = in_.count<std::uint64_t>(Coding::Text);
    in_.line();
    for (std::size_t i = 0; i < count; ++i) types_.push_back(in_.number<std::int32_t>(coding_));
  }

  void readFields() {
    in_.word("a name");
    const std::size_t arrays = in_.count<std::uint64_t>(Coding::Text);
    for (std::size_t i = 0; i < arrays; ++i) {
      const std::string name(in_.word("the name of an array"));
      const std::size_t parts = in_.count<std::uint64_t>(Coding::Text);
      const std::size_t count = in_.count<std::uint64_t>(Coding::Text);
      const std::string type(in_.word("a type of numbers"));
      in_.line();
      std::vector<std::int32_t> values;
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t part = 0; part < parts; ++part) {
          const double value = scalar(in_, coding_, type);
          if (part == 0 && (name == "face" || name == "edge")) values.push_back(idNumber(value));
        }
      if (name == "face") faces_ = std::move(values);
      if (name == "edge") edges_ = std::move(values);
    }
  }

  NumberStream in_;
  MeshBuilder& mesh_;
  Coding coding_ = Coding::Text;
  bool hasCellData_ = false;
  std::vector<std::vector<std::uint64_t>> cells_;
  std::vector<std::int32_t> types_, faces_, edges_;
};

}  // namespace

void readVtk(const std::string& content, MeshBuilder& mesh) { VtkReader(content, mesh).read(); }

}  // namespace af2::geometry
