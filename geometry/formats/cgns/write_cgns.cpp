// CGNS files, in HDF5. One zone; a section of elements for each group of faces and each group of
// edges; groups that overlap are sub-regions, groups of edges boundary conditions of a type that
// the user gives.
#include <cgns_io.h>
#include <cgnslib.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.h"
#include "geometry/formats/element_vertices.h"
#include "geometry/formats/format_names.h"
#include "geometry/formats/writer_module.h"

namespace af2::geometry {
namespace {

constexpr NameLimits kCgnsNames{32, false};
constexpr int kCellDimension = 2, kPhysicalDimension = 3;

struct CgnsUnit {
  std::string_view name;
  CGNS_ENUMT(LengthUnits_t) length;
};
constexpr CgnsUnit kCgnsUnits[] = {{"mm", CGNS_ENUMV(Millimeter)},
                                   {"cm", CGNS_ENUMV(Centimeter)},
                                   {"m", CGNS_ENUMV(Meter)},
                                   {"inch", CGNS_ENUMV(Inch)},
                                   {"ft", CGNS_ENUMV(Foot)}};

void check(int code, const char* doing) {
  if (code != CG_OK)
    throw InputError(std::string("libcgns reports an error: ") + doing + ": " + cg_get_error());
}

class CgnsWriter {
 public:
  CgnsWriter(const GroupedMesh& grouped, const char* path)
      : grouped_(grouped), mesh_(grouped.mesh) {
    check(cg_set_file_type(CG_FILE_HDF5), "choosing HDF5");
    check(cg_open(path, CG_MODE_WRITE, &file_), "making the file");
    isOpen_ = true;
  }
  CgnsWriter(const CgnsWriter&) = delete;
  CgnsWriter& operator=(const CgnsWriter&) = delete;
  ~CgnsWriter() {
    if (isOpen_) cg_close(file_);
  }

  void write() {
    check(cg_base_write(file_, "Base", kCellDimension, kPhysicalDimension, &base_),
          "making the base");
    putUnit();
    if (!mesh_.vertices.empty()) {
      const cgsize_t sizes[3] = {static_cast<cgsize_t>(mesh_.vertices.size()),
                                 static_cast<cgsize_t>(mesh_.elements.size()), 0};
      check(cg_zone_write(file_, base_, "Zone", sizes, CGNS_ENUMV(Unstructured), &zone_),
            "making the zone");
      putVertices();
      putBlocks();
      putSubRegions();
      putLines();
    }
    tidyLabels();
    isOpen_ = false;
    check(cg_close(file_), "closing the file");
  }

 private:
  void putUnit() {
    const auto* const known = std::ranges::find(kCgnsUnits, mesh_.unit, &CgnsUnit::name);
    if (known == std::end(kCgnsUnits)) return;
    check(cg_goto(file_, base_, "end"), "writing the unit");
    check(cg_dataclass_write(CGNS_ENUMV(Dimensional)), "writing the unit");
    check(cg_units_write(CGNS_ENUMV(MassUnitsNull), known->length, CGNS_ENUMV(TimeUnitsNull),
                         CGNS_ENUMV(TemperatureUnitsNull), CGNS_ENUMV(AngleUnitsNull)),
          "writing the unit");
  }

  void putVertices() {
    for (const auto& [name, along] :
         {std::pair("CoordinateX", &Point3::x), std::pair("CoordinateY", &Point3::y),
          std::pair("CoordinateZ", &Point3::z)}) {
      std::vector<double> values;
      for (const Point3& p : mesh_.vertices) values.push_back(p.*along);
      int ignored = 0;
      check(cg_coord_write(file_, base_, zone_, CGNS_ENUMV(RealDouble), name, values.data(),
                           &ignored),
            "writing the vertices");
    }
  }

  void putBlocks() {
    placeOf_.resize(mesh_.elements.size());
    for (const ElementBlock& block : grouped_.blocks) {
      std::vector<cgsize_t> corners;
      for (const std::uint32_t e : block.elements) {
        placeOf_[e] = ++last_;
        append(mshVertices(mesh_, e), corners);
      }
      const auto triangle = mesh_.midsides.empty() ? CGNS_ENUMV(TRI_3) : CGNS_ENUMV(TRI_6);
      const auto quad = mesh_.midsides.empty() ? CGNS_ENUMV(QUAD_4) : CGNS_ENUMV(QUAD_8);
      putSection(sections_.add(nameOf(block.group)), block.isQuad ? quad : triangle,
                 block.elements.size(), corners);
    }
  }

  /// Groups that are no section.
  void putSubRegions() {
    for (const GroupMembers& group : grouped_.groups) {
      if (group.group.dimension != PhysicalGroup::kSurface || isBlock(group.group.number)) continue;
      std::vector<cgsize_t> places;
      for (const std::uint32_t e : group.members) places.push_back(placeOf_[e]);
      std::ranges::sort(places);
      int ignored = 0;
      check(cg_subreg_ptset_write(file_, base_, zone_, regions_.add(group.name).c_str(),
                                  kCellDimension, CGNS_ENUMV(CellCenter), CGNS_ENUMV(PointList),
                                  static_cast<cgsize_t>(places.size()), places.data(), &ignored),
            "writing a group");
    }
  }

  void putLines() {
    for (const GroupMembers& group : grouped_.groups) {
      if (group.group.dimension != PhysicalGroup::kCurve) continue;
      const cgsize_t range[2] = {last_ + 1, last_ + static_cast<cgsize_t>(group.members.size())};
      last_ = range[1];
      std::vector<cgsize_t> ends;
      for (const std::uint32_t line : group.members)
        append(mshVertices(grouped_.lines[line]), ends);
      putSection(sections_.add(group.name),
                 mesh_.midsides.empty() ? CGNS_ENUMV(BAR_2) : CGNS_ENUMV(BAR_3),
                 group.members.size(), ends);
      const std::string name = conditions_.add(group.name);
      int condition = 0, ignored = 0;
      check(cg_family_write(file_, base_, name.c_str(), &ignored), "writing a boundary");
      check(cg_boco_write(file_, base_, zone_, name.c_str(), CGNS_ENUMV(FamilySpecified),
                          CGNS_ENUMV(PointRange), 2, range, &condition),
            "writing a boundary");
      check(cg_boco_gridlocation_write(file_, base_, zone_, condition, CGNS_ENUMV(EdgeCenter)),
            "writing a boundary");
      check(cg_goto(file_, base_, "Zone_t", zone_, "ZoneBC_t", 1, "BC_t", condition, "end"),
            "writing a boundary");
      check(cg_famname_write(name.c_str()), "writing a boundary");
    }
  }

  /// The last `count` elements.
  void putSection(const std::string& name, CGNS_ENUMT(ElementType_t) type, std::size_t count,
                  const std::vector<cgsize_t>& corners) {
    int ignored = 0;
    check(cg_section_write(file_, base_, zone_, name.c_str(), type,
                           last_ - static_cast<cgsize_t>(count) + 1, last_, 0, corners.data(),
                           &ignored),
          "writing elements");
  }

  /// libcgns writes what lies behind some labels in memory, too, which differs from run to run.
  void tidyLabels() {
    int tree = 0;
    double root = 0;
    check(cg_get_cgio(file_, &tree), "looking at the file");
    check(cg_root_id(file_, &root), "looking at the file");
    tidyLabelsBelow(tree, root);
  }
  void tidyLabelsBelow(int tree, double node) {
    int count = 0;
    check(cgio_number_children(tree, node, &count), "looking at the file");
    std::vector<double> children(static_cast<std::size_t>(count));
    if (count > 0)
      check(cgio_children_ids(tree, node, 1, count, &count, children.data()),
            "looking at the file");
    for (const double child : children) {
      char label[CGIO_MAX_LABEL_LENGTH + 1] = {};
      check(cgio_get_label(tree, child, label), "looking at the file");
      const std::string text = label;
      std::memset(label, 0, sizeof label);
      std::memcpy(label, text.data(), text.size());
      check(cgio_set_label(tree, child, label), "looking at the file");
      tidyLabelsBelow(tree, child);
      cgio_release_id(tree, child);
    }
  }

  static void append(const std::vector<VertexId>& vertices, std::vector<cgsize_t>& list) {
    for (const VertexId v : vertices) list.push_back(static_cast<cgsize_t>(v.value) + 1);
  }

  bool isBlock(std::int32_t group) const {
    return std::ranges::find(grouped_.blocks, group, &ElementBlock::group) != grouped_.blocks.end();
  }

  std::string nameOf(std::int32_t group) const {
    return std::ranges::find(grouped_.groups, PhysicalGroup{PhysicalGroup::kSurface, group},
                             &GroupMembers::group)
        ->name;
  }

  const GroupedMesh& grouped_;
  const ModelMesh& mesh_;
  int file_ = 0, base_ = 0, zone_ = 0;
  bool isOpen_ = false;
  cgsize_t last_ = 0;              ///< element so far
  std::vector<cgsize_t> placeOf_;  ///< by element
  FormatNames sections_{kCgnsNames}, regions_{kCgnsNames}, conditions_{kCgnsNames};
};

}  // namespace

void writeCgnsFile(const GroupedMesh& mesh, const char* path) { CgnsWriter(mesh, path).write(); }

}  // namespace af2::geometry
