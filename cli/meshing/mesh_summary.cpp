#include "cli/meshing/mesh_summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/place_text.h"
#include "geometry/mesh/fingerprint.h"

namespace af2::cli {
namespace {

using geometry::FaceReport;
using geometry::FaceStatus;

std::string closedText(const geometry::MeshQuality& quality) {
  if (quality.freeEdges == 0) return "closed";
  return fmt::format("open, {} free {}", grouped(quality.freeEdges),
                     quality.freeEdges == 1 ? "edge" : "edges");
}

/// Without the digits that rounding leaves of a zero.
std::string roughPlace(Point3 place) {
  const double least = 1e-9 * std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)});
  for (double* coordinate : {&place.x, &place.y, &place.z})
    if (std::abs(*coordinate) < least) *coordinate = 0;
  return textOf(place, 3);
}

std::string countText(const geometry::ModelMesh& mesh) {
  const std::size_t quads = quadCount(mesh);
  const auto asked = mesh.faces.size() - static_cast<std::size_t>(std::ranges::count(
                                             mesh.faces, FaceStatus::Skipped, &FaceReport::status));
  const auto done = std::ranges::count(mesh.faces, FaceStatus::Complete, &FaceReport::status);
  std::string text = fmt::format("faces {}/{}  {} vertices  {} triangles", done, asked,
                                 grouped(vertexCount(mesh)), grouped(elementCount(mesh) - quads));
  if (quads > 0) text += fmt::format("  {} quads", grouped(quads));
  return text;
}

/// Shares of the edges by length divided by wanted length; the first and last bins are merged.
std::string lengthsText(const geometry::LengthRatio& edges) {
  constexpr auto& kBounds = geometry::LengthRatio::kBounds;
  constexpr std::size_t kFirst = 2, kLast = 6;  // 0.5 and 2
  const auto total = std::accumulate(edges.histogram.begin(), edges.histogram.end(), 0.0);
  const auto share = [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += static_cast<double>(edges.histogram[i]);
    return total > 0 ? 100 * sum / total : 0;
  };
  std::string text = fmt::format("edge/size  <{} {:.1f} %", kBounds[kFirst], share(0, kFirst + 1));
  for (std::size_t i = kFirst; i < kLast; ++i)
    text += fmt::format("  {}-{} {:.1f} %", kBounds[i], kBounds[i + 1], share(i + 1, i + 2));
  return text +
         fmt::format("  >{} {:.1f} %", kBounds[kLast], share(kLast + 1, edges.histogram.size()));
}

std::string deviationText(const std::optional<geometry::Deviation>& deviation) {
  if (!deviation) return "";
  const std::string where =
      deviation->face > 0
          ? fmt::format(" (face {} at {})", deviation->face, roughPlace(deviation->place))
      : deviation->edge > 0
          ? fmt::format(" (edge {} at {})", deviation->edge, roughPlace(deviation->place))
          : "";
  return fmt::format("distance from the model {:.4g}{}\n", deviation->largest, where);
}

std::string secondsText(const geometry::StageSeconds& seconds) {
  const std::string contacts =
      seconds.contacts > 0 ? fmt::format("contacts {:.2f}  ", seconds.contacts) : "";
  return fmt::format(
      "seconds: read {:.2f}  {}edges {:.2f}  surface {:.2f}  optimize {:.2f}  write {:.2f}",
      seconds.read, contacts, seconds.edges, seconds.surface, seconds.optimize, seconds.write);
}

}  // namespace

std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t place = text.size(); place > 3; place -= 3) text.insert(place - 3, " ");
  return text;
}

std::string summaryText(const geometry::ModelMesh& mesh, const geometry::MeshQuality& quality) {
  if (elementCount(mesh) == 0)
    return fmt::format("{}\n{}\n", countText(mesh), secondsText(mesh.seconds));
  return fmt::format(
      "{}  {}\n"
      "quality min {:.3f} (face {} at {})  mean {:.3f}  angles {:.1f}-{:.1f} deg  fingerprint {}\n"
      "{}{}\n"
      "{}\n",
      countText(mesh), closedText(quality), quality.min, quality.worstFace,
      roughPlace(quality.worstPlace), quality.mean, quality.minAngle, quality.maxAngle,
      geometry::fingerprint(mesh), deviationText(mesh.deviation), lengthsText(quality.edges),
      secondsText(mesh.seconds));
}

std::string healingText(const std::optional<geometry::Healing>& healing) {
  if (!healing) return "";
  std::string text = healing->tolerance > 0
                         ? fmt::format("healed with tolerance {:.3g}:", healing->tolerance)
                         : "healed:";
  text += healing->changes.empty() ? " nothing changed\n" : "\n";
  for (const geometry::HealedChange& change : healing->changes) {
    text += fmt::format("  {} x {}", change.count, change.what);
    if (change.place) text += ", e.g. at " + textOf(*change.place);
    text += "\n";
  }
  for (const std::string& step : healing->undone) text += fmt::format("  {}\n", step);
  return text;
}

std::string imprintText(const std::optional<geometry::Imprinting>& imprinting) {
  if (!imprinting || !imprinting->undone.empty()) return "";
  std::string text =
      fmt::format("imprinted {} {} with tolerance {:.3g}: {} {}\n", imprinting->parts,
                  imprinting->parts == 1 ? "part" : "parts", imprinting->tolerance,
                  imprinting->interfaces, imprinting->interfaces == 1 ? "interface" : "interfaces");
  for (const std::string& change : imprinting->changes) text += fmt::format("  {}\n", change);
  return text;
}

std::string mergeText(const std::optional<geometry::Merging>& merging) {
  if (!merging) return "";
  std::size_t faces = 0, edges = 0;
  double deviation = 0;
  for (const geometry::MergedGroup& group : merging->groups) {
    faces += group.faces.size();
    edges += group.smoothEdges.size() + group.narrowEdges.size();
    deviation = std::max(deviation, group.deviation);
  }
  std::string text = fmt::format(
      "merged {} faces into {}, without {} edges and {} vertices; at most {:.3g} from the model\n",
      faces, merging->groups.size(), edges, merging->vertices.size(), deviation);
  if (!merging->kept.empty())
    text += fmt::format("note: {} {} meshed one by one instead of merged, e.g. face {}: {}\n",
                        merging->kept.size(), merging->kept.size() == 1 ? "face was" : "faces were",
                        merging->kept.front().face, merging->kept.front().reason);
  return text;
}

std::string imprintFault(const std::optional<geometry::Imprinting>& imprinting) {
  if (!imprinting || imprinting->undone.empty()) return "";
  return "the parts of the model were not made to share faces: " + imprinting->undone;
}

std::string unitText(const geometry::ModelMesh& mesh) {
  constexpr std::array kMillimetre{"mm", "millimetre", "millimeter"};
  std::string unit = mesh.fileUnit;
  std::ranges::transform(unit, unit.begin(), [](unsigned char c) { return std::tolower(c); });
  if (mesh.unit.empty() || unit.empty() || std::ranges::count(kMillimetre, unit) > 0) return "";
  return fmt::format("note: lengths in the file are in {}; here, sizes and coordinates are in {}\n",
                     mesh.fileUnit, mesh.unit);
}

std::string notesText(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += fmt::format("note: {}\n", note);
  return text;
}

std::string withoutRuleText(const geometry::ModelMesh& mesh) {
  constexpr std::size_t kMaxListed = 5;
  const geometry::WithoutRuleCounts all = elementsWithoutRule(mesh);
  if (all.total() == 0) return "";
  std::vector<const FaceReport*> faces;
  for (const FaceReport& face : mesh.faces)
    if (face.withoutRule.total() > 0) faces.push_back(&face);
  std::ranges::stable_sort(faces, std::greater<>(),
                           [](const FaceReport* face) { return face->withoutRule.total(); });
  std::string kinds, list;
  for (const auto& [name, count] :
       {std::pair{"closing", all.closing}, {"fan", all.fan}, {"leaning", all.leaning}})
    if (count > 0) kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", name, grouped(count));
  for (const FaceReport* face : std::span(faces).first(std::min(faces.size(), kMaxListed)))
    list += fmt::format("{}face {}: {}", list.empty() ? "" : ", ", face->id,
                        grouped(face->withoutRule.total()));
  if (faces.size() > kMaxListed) list += fmt::format(" and {} more", faces.size() - kMaxListed);
  return fmt::format("af2: {} of {} elements were made without a rule ({}); {}\n",
                     grouped(all.total()), grouped(elementCount(mesh)), kinds, list);
}

namespace {

std::string oddLoopText(const FaceReport::OddLoop& odd) {
  std::string text = fmt::format("; loop {} of its boundary has {} edges", odd.loop, odd.segments);
  const auto& [from, to, sizes] = odd.longest;
  if (sizes > 0)
    text += fmt::format(": divide the one from {} to {}, which is {:.2g} sizes long",
                        textOf(from, 6), textOf(to, 6), sizes);
  return text;
}

}  // namespace

std::string trianglesText(const geometry::ModelMesh& mesh) {
  constexpr std::size_t kShown = 5;
  std::size_t faces = 0;
  std::string text;
  for (const FaceReport& face : mesh.faces) {
    if (face.triangles == 0 || ++faces > kShown) continue;
    const bool isOne = face.triangles == 1;
    text +=
        fmt::format("{}face {} ({} triangle{}{}", text.empty() ? "" : ", ", face.id, face.triangles,
                    isOne ? " at " : "s, one of them at ", textOf(face.firstTriangle, 3));
    for (const FaceReport::OddLoop& odd : face.oddLoops) text += oddLoopText(odd);
    if (face.triangles > face.oddLoops.size())
      text += "; elements cannot change enough to join them";
    text += ")";
  }
  if (faces == 0) return "";
  if (faces > kShown) text += fmt::format(" and {} more", faces - kShown);
  return mesh.name + ": triangles remain, which --elements quad does not accept: " + text;
}

std::string failureText(const geometry::ModelMesh& mesh) {
  std::string text;
  for (const FaceReport& face : mesh.faces) {
    if (face.status != FaceStatus::Failed) continue;
    const std::string name = face.name.empty() ? "" : fmt::format(" \"{}\"", face.name);
    text += fmt::format("af2: face {}{} ({}) failed: {}\n", face.id, name, face.surfaceType,
                        face.reason);
  }
  return text;
}

namespace {

struct LayersPlace {
  int face;
  const geometry::LayersAlongEdge* along;
};

std::string fewerText(const LayersPlace& place) {
  const geometry::LayersAlongEdge& along = *place.along;
  const std::string range = along.fewest == along.most
                                ? std::to_string(along.fewest)
                                : fmt::format("{} to {}", along.fewest, along.most);
  return fmt::format("edge {} of face {} ({} of {}, on {} of {} segments, the fewest at {})",
                     along.edge, place.face, range, along.asked, along.fewer, along.segments,
                     textOf(along.place, 3));
}

std::string thinnerText(const LayersPlace& place) {
  const geometry::LayersAlongEdge& along = *place.along;
  return fmt::format("edge {} of face {} (down to {:.0f} % of the heights, on {} of {} segments)",
                     along.edge, place.face, 100 * along.thinnest, along.thinner, along.segments);
}

/// "; fewer than asked along 2 of them: ..., ..."; empty if there are no places.
std::string placesText(const std::vector<LayersPlace>& places, std::string_view what,
                       std::string (*textOf)(const LayersPlace&)) {
  constexpr std::size_t kShown = 5;
  if (places.empty()) return "";
  std::string text = fmt::format("; {} than asked along {} of them: ", what, places.size());
  for (std::size_t i = 0; i < std::min(places.size(), kShown); ++i)
    text += (i > 0 ? ", " : "") + textOf(places[i]);
  if (places.size() > kShown) text += fmt::format(" and {} more", places.size() - kShown);
  return text;
}

}  // namespace

std::string layersText(const geometry::ModelMesh& mesh) {
  std::size_t edges = 0, elements = 0;
  std::vector<LayersPlace> fewer, thinner;
  for (const geometry::FaceReport& face : mesh.faces) {
    elements += face.layerElements;
    edges += face.layers.size();
    for (const geometry::LayersAlongEdge& along : face.layers) {
      if (along.fewer > 0) fewer.push_back({face.id, &along});
      if (along.thinner > 0) thinner.push_back({face.id, &along});
    }
  }
  if (edges == 0) return "";
  std::string text = fmt::format("layers: {} elements along {} edge{} of faces", grouped(elements),
                                 edges, edges == 1 ? "" : "s");
  if (fewer.empty() && thinner.empty()) return text + ", everywhere as asked\n";
  std::ranges::stable_sort(fewer, {}, [](const LayersPlace& place) { return place.along->fewest; });
  std::ranges::stable_sort(thinner, {}, [](const LayersPlace& at) { return at.along->thinnest; });
  return text + placesText(fewer, "fewer", fewerText) +
         placesText(thinner, "thinner", thinnerText) + "\n";
}

}  // namespace af2::cli
