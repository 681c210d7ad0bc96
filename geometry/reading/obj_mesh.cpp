// Wavefront OBJ files. Each group is a face; AF2 names them face_1, face_2, ...
#include <algorithm>
#include <map>

#include "geometry/base/words.h"
#include "geometry/reading/formats.h"

namespace af2::geometry {
namespace {

class ObjReader {
 public:
  ObjReader(const std::string& content, MeshBuilder& mesh)
      : words_(mesh.name(), content), mesh_(mesh) {}

  void read() {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (word == "v") mesh_.addVertex(words_.point());
      if (word == "f") addElement();
      if (word == "g" || word == "o") beginGroup(trimmed(words_.restOfLine()));
      if (word != "f" && word != "g" && word != "o") words_.skipLine();
    }
  }

 private:
  void addElement() {
    std::string rest(words_.restOfLine());
    std::ranges::replace(rest, '\\', ' ');
    std::vector<std::uint64_t> corners;
    for (const std::string_view word : wordsIn(rest)) corners.push_back(corner(word));
    mesh_.addElement(corners, face_);
  }
  /// "7/1/3" means vertex 7, "-1" the last one so far.
  std::uint64_t corner(std::string_view word) const {
    const auto number = numberIn<long>(word.substr(0, word.find('/')));
    const long count = static_cast<long>(mesh_.vertexCount());
    const long index = !number ? 0 : *number < 0 ? *number + count + 1 : *number;
    if (index < 1) words_.fail("'" + std::string(word) + "' is not the number of a vertex");
    return static_cast<std::uint64_t>(index - 1);
  }
  void beginGroup(std::string_view name) {
    constexpr std::string_view kPrefix = "face_";
    mesh_.setHasFaces();
    const auto number = name.starts_with(kPrefix)
                            ? numberIn<std::int32_t>(name.substr(kPrefix.size()))
                            : std::optional<std::int32_t>();
    const auto next = static_cast<std::int32_t>(others_.size()) + 1;
    face_ = number ? *number : -others_.try_emplace(std::string(name), next).first->second;
  }

  Words words_;
  MeshBuilder& mesh_;
  std::int32_t face_ = 0;                       // of what precedes the first group
  std::map<std::string, std::int32_t> others_;  // groups with other names: numbers below 0
};

}  // namespace

void readObjMesh(const std::string& content, MeshBuilder& mesh) { ObjReader(content, mesh).read(); }

}  // namespace af2::geometry
