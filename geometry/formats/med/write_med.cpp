// MED files, as SALOME and code_aster read them. Elements of one kind are a block; what groups they
// and lines belong to is told by families, one for each combination of groups.
#include <med.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/base/error.h"
#include "geometry/formats/element_vertices.h"
#include "geometry/formats/format_names.h"
#include "geometry/formats/writer_module.h"

namespace af2::geometry {
namespace {

constexpr NameLimits kMedGroupNames{MED_LNAME_SIZE, false};
constexpr std::size_t kMedMeshName = MED_NAME_SIZE;

void check(med_err code, const char* doing) {
  if (code < 0) throw InputError(std::string("libmedc reports an error: ") + doing);
}

std::string padded(std::string text, std::size_t size) {
  text.resize(size, ' ');
  return text;
}

/// Elements, or lines, of one kind: their numbers among all.
struct MedBlock {
  med_geometry_type type;
  std::vector<std::uint32_t> members;
};

class MedWriter {
 public:
  MedWriter(const GroupedMesh& grouped, const char* path)
      : grouped_(grouped), mesh_(grouped.mesh), file_(MEDfileOpen(path, MED_ACC_CREAT)) {
    check(static_cast<med_err>(file_ < 0 ? -1 : 0), "making the file");
    name_ = FormatNames({kMedMeshName, false}).add(mesh_.name.empty() ? "mesh" : mesh_.name);
  }
  MedWriter(const MedWriter&) = delete;
  MedWriter& operator=(const MedWriter&) = delete;
  ~MedWriter() {
    if (file_ >= 0) MEDfileClose(file_);
  }

  void write() {
    putMesh();
    putVertices();
    putFamily("FAMILLE_ZERO", 0, {});
    putLines();
    putElements();
    const med_idt file = file_;
    file_ = -1;
    check(MEDfileClose(file), "closing the file");
  }

 private:
  void putMesh() {
    check(MEDfileCommentWr(file_, "surface mesh by AF2"), "writing the comment");
    std::string axes, units;
    for (const char* axis : {"x", "y", "z"}) {
      axes += padded(axis, MED_SNAME_SIZE);
      units += padded(mesh_.unit, MED_SNAME_SIZE);
    }
    check(MEDmeshCr(file_, name_.c_str(), 3, 2, MED_UNSTRUCTURED_MESH, "surface mesh by AF2", "",
                    MED_SORT_DTIT, MED_CARTESIAN, axes.c_str(), units.c_str()),
          "making the mesh");
  }

  void putVertices() {
    std::vector<double> coordinates;
    for (const Point3& p : mesh_.vertices) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    if (coordinates.empty()) return;
    check(MEDmeshNodeCoordinateWr(file_, name_.c_str(), MED_NO_DT, MED_NO_IT, 0, MED_FULL_INTERLACE,
                                  static_cast<med_int>(mesh_.vertices.size()), coordinates.data()),
          "writing the vertices");
  }

  void putLines() {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < grouped_.lines.size(); ++i) all.push_back(i);
    const auto families = familiesOf(PhysicalGroup::kCurve, all.size());
    put({mesh_.midsides.empty() ? MED_SEG2 : MED_SEG3, all}, families, mesh_.elements.size(),
        [&](std::uint32_t i) { return mshVertices(grouped_.lines[i]); });
  }

  void putElements() {
    const bool isSecond = !mesh_.midsides.empty();
    MedBlock triangles{isSecond ? MED_TRIA6 : MED_TRIA3, {}};
    MedBlock quads{isSecond ? MED_QUAD8 : MED_QUAD4, {}};
    for (std::uint32_t e = 0; e < mesh_.elements.size(); ++e)
      (mesh_.elements[e].isQuad() ? quads : triangles).members.push_back(e);
    const auto families = familiesOf(PhysicalGroup::kSurface, mesh_.elements.size());
    for (const MedBlock& block : {triangles, quads})
      put(block, families, 0, [&](std::uint32_t e) { return mshVertices(mesh_, e); });
  }

  /// before  how many elements have numbers below those of the block
  template <class VerticesOf>
  void put(const MedBlock& block, const std::vector<med_int>& families, std::size_t before,
           VerticesOf verticesOf) {
    if (block.members.empty()) return;
    std::vector<med_int> corners, numbers, own;
    for (const std::uint32_t member : block.members) {
      for (const VertexId v : verticesOf(member))
        corners.push_back(static_cast<med_int>(v.value) + 1);
      numbers.push_back(static_cast<med_int>(before + member + 1));
      own.push_back(families[member]);
    }
    const auto count = static_cast<med_int>(block.members.size());
    const char* const mesh = name_.c_str();
    check(MEDmeshElementConnectivityWr(file_, mesh, MED_NO_DT, MED_NO_IT, 0, MED_CELL, block.type,
                                       MED_NODAL, MED_FULL_INTERLACE, count, corners.data()),
          "writing elements");
    check(MEDmeshEntityNumberWr(file_, mesh, MED_NO_DT, MED_NO_IT, MED_CELL, block.type, count,
                                numbers.data()),
          "writing numbers of elements");
    check(MEDmeshEntityFamilyNumberWr(file_, mesh, MED_NO_DT, MED_NO_IT, MED_CELL, block.type,
                                      count, own.data()),
          "writing families of elements");
  }

  /// By element or line: the number of its family. Makes the families.
  std::vector<med_int> familiesOf(std::int32_t dimension, std::size_t count) {
    using Groups = std::vector<std::string>;
    std::vector<Groups> combinations{{}};
    std::vector<std::size_t> of(count, 0);  // index in combinations
    for (const GroupMembers& group : grouped_.groups) {
      if (group.group.dimension != dimension) continue;
      const std::string name = groupNames_.add(group.name);
      std::map<std::size_t, std::size_t> extended;
      for (const std::uint32_t member : group.members) {
        const auto [found, isNew] = extended.try_emplace(of[member], combinations.size());
        if (isNew) {
          combinations.push_back(combinations[of[member]]);
          combinations.back().push_back(name);
        }
        of[member] = found->second;
      }
    }
    std::map<std::size_t, med_int> numbers{{0, 0}};
    for (const std::size_t used : std::set<std::size_t>(of.begin(), of.end())) {
      if (used == 0) continue;
      numbers[used] = --lastFamily_;
      putFamily("FAM_" + std::to_string(lastFamily_), lastFamily_, combinations[used]);
    }
    std::vector<med_int> families;
    for (const std::size_t combination : of) families.push_back(numbers.at(combination));
    return families;
  }

  void putFamily(const std::string& family, med_int number,
                 const std::vector<std::string>& groups) {
    std::string names;
    for (const std::string& group : groups) names += padded(group, MED_LNAME_SIZE);
    check(MEDfamilyCr(file_, name_.c_str(), family.c_str(), number,
                      static_cast<med_int>(groups.size()), names.c_str()),
          "writing groups");
  }

  const GroupedMesh& grouped_;
  const ModelMesh& mesh_;
  med_idt file_;
  std::string name_;
  FormatNames groupNames_{kMedGroupNames};
  med_int lastFamily_ = 0;  ///< those of elements are negative
};

}  // namespace

void writeMedFile(const GroupedMesh& mesh, const char* path) { MedWriter(mesh, path).write(); }

}  // namespace af2::geometry
