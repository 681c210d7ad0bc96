#include "geometry/planar/poly_file.h"

#include <map>

#include "geometry/planar/word_file.h"

namespace af2::geometry {

namespace {

namespace fs = std::filesystem;

class PolyReader {
 public:
  explicit PolyReader(const fs::path& path) : path_(path) { domain_.name = path.string(); }

  PlanarDomain read() {
    WordFile file(path_);
    file.expectLine("the number of vertices");
    if (file.countAt(0, "number of vertices") == 0)
      readNodeFile();
    else
      readPoints(file);
    readSegments(file);
    readHoles(file);
    readRegions(file);
    return std::move(domain_);
  }

 private:
  void readNodeFile() {
    fs::path nodes = path_;
    nodes.replace_extension(".node");
    if (!fs::exists(nodes))
      throw InputError(domain_.name + ": contains no vertices, and there is no file " +
                       nodes.string() + " next to it that does");
    WordFile file(nodes);
    file.expectLine("the number of vertices");
    readPoints(file);
    domain_.pointLines.clear();  // lines of another file
  }

  void readPoints(WordFile& file) {
    const long count = file.countAt(0, "number of vertices");
    if (file.count() > 1 && file.whole(1, "dimension") != 2)
      file.fail("the dimension is not 2; only planar domains can be read from this format");
    for (long i = 0; i < count; ++i) {
      file.expectLine("vertex " + std::to_string(i + 1) + " of " + std::to_string(count));
      const long id = file.whole(0, "vertex number");
      if (!index_.try_emplace(id, static_cast<int>(i)).second)
        file.fail("vertex " + std::to_string(id) + " is defined a second time");
      domain_.points.push_back({file.number(1, "x"), file.number(2, "y")});
      domain_.pointLines.push_back(file.line());
    }
  }

  int pointAt(const WordFile& file, std::size_t word) const {
    const long id = file.whole(word, "vertex number");
    const auto found = index_.find(id);
    if (found != index_.end()) return found->second;
    file.fail("there is no vertex " + std::to_string(id) +
              (index_.empty() ? std::string()
                              : "; they are numbered " + std::to_string(index_.begin()->first) +
                                    " to " + std::to_string(index_.rbegin()->first)));
  }

  void readSegments(WordFile& file) {
    file.expectLine("the number of segments");
    const long count = file.countAt(0, "number of segments");
    const bool hasMarkers = file.count() > 1 && file.whole(1, "number of markers") > 0;
    for (long i = 0; i < count; ++i) {
      file.expectLine("segment " + std::to_string(i + 1) + " of " + std::to_string(count));
      PlanarDomain::Segment segment;
      segment.from = pointAt(file, 1);
      segment.to = pointAt(file, 2);
      if (hasMarkers && file.count() > 3)
        segment.marker = static_cast<int>(file.whole(3, "boundary marker"));
      segment.line = file.line();
      segment.edge = static_cast<int>(i) + 1;
      domain_.segments.push_back(segment);
    }
  }

  /// Each with an attribute, which names a group, and perhaps the largest area of a triangle.
  void readRegions(WordFile& file) {
    if (!file.next()) return;
    const long count = file.countAt(0, "number of regions");
    for (long i = 0; i < count; ++i) {
      file.expectLine("region " + std::to_string(i + 1) + " of " + std::to_string(count));
      const int domain = static_cast<int>(i) + 1;
      domain_.regionPoints.push_back({{file.number(1, "x"), file.number(2, "y")}, domain});
      if (file.count() < 4) continue;
      file.number(3, "attribute");
      domain_.domainNames[domain] = "region " + std::string(file.word(3));
      const double area = file.count() > 4 ? file.number(4, "largest area") : 0;
      if (area > 0) domain_.domainSizes[domain] = sideOfTriangle(area);
    }
  }

  static double sideOfTriangle(double area) { return std::sqrt(4 / std::sqrt(3.0) * area); }

  void readHoles(WordFile& file) {
    if (!file.next()) return;  // some programs leave out the line with the number of holes
    const long count = file.countAt(0, "number of holes");
    for (long i = 0; i < count; ++i) {
      file.expectLine("hole " + std::to_string(i + 1) + " of " + std::to_string(count));
      domain_.holes.push_back({file.number(1, "x"), file.number(2, "y")});
    }
  }

  fs::path path_;
  PlanarDomain domain_;
  std::map<long, int> index_;  // by vertex number, which may start at 0, at 1 or anywhere
};

}  // namespace

PlanarDomain readPoly(const fs::path& path) { return PolyReader(path).read(); }

}  // namespace af2::geometry
