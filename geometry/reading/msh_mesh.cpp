// Gmsh's formats 2.2 and 4.1, text or binary. The face of an element is its surface entity.
#include <array>
#include <map>
#include <set>
#include <unordered_map>

#include "geometry/reading/formats.h"
#include "geometry/reading/number_stream.h"

namespace af2::geometry {
namespace {

/// A kind of element: its number in the format, how many corners and how many vertices it has.
struct MshKind {
  int type;
  std::size_t corners, vertices;
  bool isSolid = false;
};
constexpr MshKind kMshKinds[] = {
    {1, 2, 2},         {2, 3, 3},         {3, 4, 4},         {4, 4, 4, true},   {5, 8, 8, true},
    {6, 6, 6, true},   {7, 5, 5, true},   {8, 2, 3},         {9, 3, 6},         {10, 4, 9},
    {11, 4, 10, true}, {12, 8, 27, true}, {13, 6, 18, true}, {14, 5, 14, true}, {15, 1, 1},
    {16, 4, 8},        {17, 8, 20, true}, {18, 6, 15, true}, {19, 5, 13, true},
};

class MshReader {
 public:
  MshReader(const std::string& content, MeshBuilder& mesh)
      : in_(mesh.name(), content), mesh_(mesh) {}

  void read() {
    if (in_.word() != "$MeshFormat") mesh_.fail("is not a file of Gmsh: it has no $MeshFormat");
    readFormat();
    bool hasElements = false;
    for (std::string_view section = in_.word(); !section.empty(); section = in_.word()) {
      const std::string name(section);
      if (!name.starts_with('$')) in_.fail("expected a section such as $Nodes");
      in_.line();
      if (name == "$PhysicalNames") readPhysicalNames();
      if (name == "$Entities" && !isOld_) readEntities();
      if (name == "$NodeData" && mesh_.hasField()) readNodeData();
      if (name == "$ElementData" && mesh_.hasField()) mesh_.noteOtherArray("element data");
      if (name == "$Nodes") isOld_ ? readOldNodes() : readNodes();
      if (name == "$Elements") isOld_ ? readOldElements() : readElements();
      hasElements = hasElements || name == "$Elements";
      in_.skipPast("$End" + name.substr(1));
    }
    if (!hasElements) mesh_.fail("has no section $Elements; it may be truncated");
    mesh_.setHasFaces();
    for (const auto& [entity, group] : groupOf_)
      if (const auto name = names_.find(group); name != names_.end())
        mesh_.setFaceName(entity, name->second);
  }

 private:
  void readFormat() {
    const std::string version(in_.word("the version"));
    const bool isBinary = in_.number<int>(Coding::Text) == 1;
    if (in_.number<int>(Coding::Text) != 8) in_.fail("numbers must have 8 bytes");
    if (version != "4.1" && version != "2.2" && version != "2.1" && version != "2")
      in_.fail("version " + version + " cannot be read; write the file as 4.1 or 2.2");
    isOld_ = version.starts_with('2');
    in_.line();
    if (isBinary) {
      NumberStream ahead = in_;
      coding_ =
          ahead.number<std::int32_t>(Coding::LowFirst) == 1 ? Coding::LowFirst : Coding::HighFirst;
    }
    in_.skipPast("$EndMeshFormat");
  }

  /// Of groups of surfaces. Always text.
  void readPhysicalNames() {
    const std::size_t count = in_.count<std::uint64_t>(Coding::Text);
    for (std::size_t i = 0; i < count; ++i) {
      const auto dimension = in_.number<std::int32_t>(Coding::Text);
      const auto number = in_.number<std::int32_t>(Coding::Text);
      const std::string_view quoted = trimmed(in_.line());
      if (quoted.size() < 2) in_.fail("a physical group has no name");
      if (dimension == 2) names_[number] = quoted.substr(1, quoted.size() - 2);
    }
  }

  /// The first group of each surface.
  void readEntities() {
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = in_.count<std::uint64_t>(coding_);
    for (std::size_t dimension = 0; dimension < counts.size(); ++dimension)
      for (std::size_t i = 0; i < counts[dimension]; ++i) {
        const auto tag = in_.number<std::int32_t>(coding_);
        for (int bound = 0; bound < (dimension == 0 ? 3 : 6); ++bound) in_.number<double>(coding_);
        const std::size_t groups = in_.count<std::uint64_t>(coding_);
        for (std::size_t k = 0; k < groups; ++k) {
          const auto group = in_.number<std::int32_t>(coding_);
          if (dimension == 2 && k == 0) groupOf_[tag] = group;
        }
        if (dimension == 0) continue;
        const std::size_t bounds = in_.count<std::uint64_t>(coding_);
        for (std::size_t k = 0; k < bounds; ++k) in_.number<std::int32_t>(coding_);
      }
  }

  void addNode(std::uint64_t tag) {
    index_.try_emplace(tag, mesh_.vertexCount());
    const double x = in_.number<double>(coding_), y = in_.number<double>(coding_);
    mesh_.addVertex({x, y, in_.number<double>(coding_)});
  }

  void readNodes() {
    const std::size_t blocks = in_.count<std::uint64_t>(coding_);
    for (int skipped = 0; skipped < 3; ++skipped) in_.number<std::uint64_t>(coding_);
    for (std::size_t block = 0; block < blocks; ++block) {
      const auto dimension = in_.number<std::int32_t>(coding_);
      in_.number<std::int32_t>(coding_);
      const bool hasParameters = in_.number<std::int32_t>(coding_) != 0;
      std::vector<std::uint64_t> tags(in_.count<std::uint64_t>(coding_));
      for (std::uint64_t& tag : tags) tag = in_.number<std::uint64_t>(coding_);
      for (const std::uint64_t tag : tags) {
        addNode(tag);
        for (int i = 0; hasParameters && i < dimension; ++i) in_.number<double>(coding_);
      }
    }
  }

  void readElements() {
    const std::size_t blocks = in_.count<std::uint64_t>(coding_);
    for (int skipped = 0; skipped < 3; ++skipped) in_.number<std::uint64_t>(coding_);
    for (std::size_t block = 0; block < blocks; ++block) {
      in_.number<std::int32_t>(coding_);
      const auto entity = in_.number<std::int32_t>(coding_);
      const MshKind& kind = kindOf(in_.number<std::int32_t>(coding_));
      const std::size_t count = in_.count<std::uint64_t>(coding_);
      for (std::size_t i = 0; i < count; ++i) {
        in_.number<std::uint64_t>(coding_);
        add<std::uint64_t>(kind, entity);
      }
    }
  }

  void readOldNodes() {
    const std::size_t count = in_.count<std::uint64_t>(Coding::Text);
    in_.line();
    for (std::size_t i = 0; i < count; ++i)
      addNode(static_cast<std::uint64_t>(in_.number<std::int32_t>(coding_)));
  }

  /// In binary files several elements share a head.
  void readOldElements() {
    const std::size_t count = in_.count<std::uint64_t>(Coding::Text);
    in_.line();
    for (std::size_t done = 0; done < count;) {
      if (coding_ == Coding::Text) in_.number<std::int32_t>(coding_);
      const MshKind& kind = kindOf(in_.number<std::int32_t>(coding_));
      const std::size_t same = coding_ == Coding::Text ? 1 : in_.count<std::int32_t>(coding_);
      const std::size_t tags = in_.count<std::int32_t>(coding_);
      if (same == 0) in_.fail("a block has no elements");
      for (std::size_t i = 0; i < same; ++i, ++done) {
        if (coding_ != Coding::Text) in_.number<std::int32_t>(coding_);
        std::int32_t entity = 1, group = 0;
        for (std::size_t tag = 0; tag < tags; ++tag) {
          const auto value = in_.number<std::int32_t>(coding_);
          if (tag == 0) group = value;
          if (tag == 1) entity = value;
        }
        if (kind.corners >= 3 && !kind.isSolid) groupOf_.try_emplace(entity, group);
        add<std::int32_t>(kind, entity);
      }
    }
  }

  /// The first time step counts, which comes first.
  void readNodeData() {
    std::string name;
    const std::size_t names = in_.count<std::uint64_t>(Coding::Text);
    in_.line();
    for (std::size_t i = 0; i < names; ++i) {
      const std::string_view quoted = trimmed(in_.line());
      if (name.empty() && quoted.size() >= 2) name = quoted.substr(1, quoted.size() - 2);
    }
    for (std::size_t i = in_.count<std::uint64_t>(Coding::Text); i > 0; --i)
      in_.number<double>(Coding::Text);
    std::vector<std::int64_t> numbers(in_.count<std::uint64_t>(Coding::Text));
    for (std::int64_t& number : numbers) number = in_.number<std::int64_t>(Coding::Text);
    in_.line();
    if (numbers.size() < 3) in_.fail("node data must have a time step, components and a count");
    if (numbers[1] != 1) return mesh_.noteOtherArray(name);
    std::vector<double> values(mesh_.vertexCount(), FieldCells::kMissing);
    for (std::int64_t i = 0; i < numbers[2]; ++i) {
      const auto tag = static_cast<std::uint64_t>(in_.number<std::int32_t>(coding_));
      const double value = in_.number<double>(coding_);
      if (const auto node = index_.find(tag); node != index_.end()) values[node->second] = value;
    }
    if (withData_.insert(name).second) mesh_.addValues(name, 0, values);
  }

  const MshKind& kindOf(int type) const {
    const auto* const kind = std::ranges::find(kMshKinds, type, &MshKind::type);
    if (kind == std::end(kMshKinds))
      in_.fail("elements of type " + std::to_string(type) + " cannot be read");
    return *kind;
  }

  /// Reads the vertices of one element.
  template <class Tag>
  void add(const MshKind& kind, std::int32_t entity) {
    std::vector<std::uint64_t> corners;
    for (std::size_t i = 0; i < kind.vertices; ++i) {
      const Tag tag = in_.number<Tag>(coding_);
      if (i >= kind.corners) continue;
      const auto known = index_.find(static_cast<std::uint64_t>(tag));
      if (known == index_.end())
        in_.fail("an element has the vertex " + std::to_string(tag) + ", which is not in $Nodes");
      corners.push_back(known->second);
    }
    if (kind.isSolid)
      return mesh_.addSolid(corners,
                            "solid elements (Gmsh type " + std::to_string(kind.type) + ")");
    if (kind.corners == 2) mesh_.addLine(corners[0], corners[1], entity);
    if (kind.corners < 3) return;
    if (kind.vertices > kind.corners) mesh_.noteSecondOrder();
    mesh_.addElement(corners, entity);
  }

  NumberStream in_;
  MeshBuilder& mesh_;
  Coding coding_ = Coding::Text;
  bool isOld_ = false;
  std::unordered_map<std::uint64_t, std::uint64_t> index_;  // of vertices, by tag
  std::set<std::string> withData_;
  std::map<std::int32_t, std::string> names_;     // of groups of surfaces
  std::map<std::int32_t, std::int32_t> groupOf_;  // by surface
};

}  // namespace

void readMsh(const std::string& content, MeshBuilder& mesh) { MshReader(content, mesh).read(); }

}  // namespace af2::geometry
