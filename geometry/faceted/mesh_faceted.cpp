#include "geometry/faceted/mesh_faceted.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "geometry/base/constants.h"
#include "geometry/domain/face_memory.h"
#include "geometry/faceted/compared_mesh.h"
#include "geometry/faceted/cones.h"
#include "geometry/faceted/faceted_model.h"
#include "geometry/mesh/quality.h"

namespace af2::geometry {
namespace {

constexpr double kNarrow = 0.05;  // of the wanted size: of pieces that need not be flat
constexpr int kBriefly = 1;       // rounds of retries

double failedArea(const ModelMesh& mesh) {
  double area = 0;
  for (const FaceReport& face : mesh.faces)
    if (face.status == FaceStatus::Failed) area += face.area;
  return area;
}

bool namesFacesOrEdges(const MeshingOptions& options) {
  return !options.faces.empty() || !options.faceNames.empty() || !options.sizes.faceSizes.empty() ||
         !options.sizes.edgeSizes.empty() || !options.sizes.edgeNames.empty() ||
         !options.layers.empty() || !options.edgePoints.empty();
}

/// All edges of a patch, so that each of its triangles becomes one; none of a patch with too many.
std::set<FacetEdge> allEdges(const Facets& facets, const Patch& patch) {
  constexpr std::size_t kMost = 20000;
  std::set<FacetEdge> edges;
  if (patch.triangles.size() > kMost) return edges;
  for (const std::uint32_t t : patch.triangles)
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) edges.insert(edgeOf(facets.triangles, h));
  return edges;
}

void noteCuts(std::size_t count, ModelMesh& mesh) {
  mesh.notes.push_back(
      "patches that could not be meshed whole were cut into pieces; additional patches: " +
      std::to_string(count));
}

/// Whether more than the short tries are needed: meshes without smaller angles get only one.
bool isPoor(const ModelMesh& mesh) {
  return failedArea(mesh) > 0 || measureQuality(mesh).minAngle < kUselessAngle;
}

/// Whether elements that lean against the surface have small angles.
bool leans(const ModelMesh& mesh) {
  constexpr double kSmall = 8;  // degrees
  return std::ranges::any_of(mesh.faces,
                             [](const FaceReport& face) { return face.withoutRule.leaning > 0; }) &&
         measureQuality(mesh).minAngle < kSmall;
}

/// Meshes patches, and cuts those that fail into pieces that are ever flatter.
class CutMesher {
 public:
  /// made  the faces of the patches
  CutMesher(PatchedFacets patched, MadeFaces made, const FeatureLimits& limits,
            const AF2Algorithm& algorithm, const MeshingOptions& options)
      : best_{std::move(patched), {}},
        made_(std::move(made)),
        limits_(limits),
        algorithm_(algorithm),
        options_(options) {
    if (options.spool.when != SpoolRequest::When::Always) memory_ = std::make_shared<FaceMemory>();
  }

  ModelMesh mesh(const DomainModel& whole) {
    const std::size_t count = best_.patched.patches.size();
    best_.mesh = meshed(whole, kBriefly);
    const bool mayTryMore = !options_.strictRules;
    if (mayTryMore && (failedArea(best_.mesh) > 0 || leans(best_.mesh))) meshInPieces(whole);
    if (isPoor(best_.mesh) && !isHopeless_) meshOnceMore({});
    const std::size_t added = best_.patched.patches.size() - count;
    if (added > 0) noteCuts(added, best_.mesh);
    return std::move(best_.mesh);
  }

 private:
  struct State {
    PatchedFacets patched;
    ModelMesh mesh;
  };
  using BordersIn = std::function<std::set<FacetEdge>(const PatchedFacets&, const Patch&)>;

  /// rounds  of retries, at most; none: as many as the options allow
  ModelMesh meshed(DomainModel model, std::optional<int> rounds) const {
    MeshingOptions options = options_;
    if (rounds) options.mostRetries = std::min(*rounds, options_.mostRetries.value_or(*rounds));
    model.mayTilt = mayTilt_;
    model.memory = memory_;
    return meshDomain(model, algorithm_, options);
  }

  void meshOnceMore(std::optional<int> rounds) {
    if (options_.stop.stop_requested()) return;
    ModelMesh again = meshed(modelOf(best_.patched, options_, &made_), rounds);
    if (!(failedArea(again) > failedArea(best_.mesh))) best_.mesh = std::move(again);
  }

  /// Pieces may have better elements than those that lean against the surface. The first tries are
  /// without retries, which take long where they are in vain.
  void meshInPieces(const DomainModel& whole) {
    State first = best_;
    mayTilt_ = false;
    best_.mesh = meshed(whole, 0);
    const double size = options_.sizes.size;
    cutIntoCones(45 * kDegree, size);
    cutIntoCones(25 * kDegree, size);
    cutIntoCones(10 * kDegree, kNarrow * size);
    mayTilt_ = true;
    meshOnceMore(kBriefly);
    const bool isInTriangles = cutIntoTriangles();
    if (isInTriangles) meshOnceMore(kBriefly);
    if (isBetter(first))
      best_ = std::move(first);
    else  // what fails in triangles, or has small angles there, does so in the file
      isHopeless_ = isInTriangles;
  }

  /// The curved patches that failed are in pieces; nothing if there is nothing to cut.
  std::optional<State> cut(const State& state, const BordersIn& bordersIn) {
    if (options_.stop.stop_requested()) return std::nullopt;
    std::set<FacetEdge> cuts;
    for (const FaceReport& face : state.mesh.faces)
      if (face.status == FaceStatus::Failed && face.surfaceType != "plane")
        cuts.merge(
            bordersIn(state.patched, state.patched.patches[static_cast<std::size_t>(face.id) - 1]));
    if (cuts.empty()) return std::nullopt;
    State next{cutPatches(state.patched, cuts, limits_), {}};
    if (next.patched.patches.size() == state.patched.patches.size()) return std::nullopt;
    next.mesh = meshed(modelOf(next.patched, options_, &made_), 0);
    return next;
  }

  bool isBetter(const State& state) const {
    const double own = failedArea(state.mesh), best = failedArea(best_.mesh);
    if (own != best || own > 0) return own < best;
    return measureQuality(state.mesh).minAngle > measureQuality(best_.mesh).minAngle;
  }

  void cutIntoCones(double angle, double size) {
    auto next = cut(best_, [&](const PatchedFacets& patched, const Patch& patch) {
      return coneBorders(patched, patch, angle, size);
    });
    if (next && isBetter(*next)) best_ = *std::move(next);
  }

  /// Triangles are flat, and elements within them cross nothing. First, patches beside them may
  /// fail in their place. Returns whether it helped.
  bool cutIntoTriangles() {
    constexpr int kMostTimes = 3;
    bool isAny = false;
    std::optional<State> state = best_;
    for (int i = 0; i < kMostTimes; ++i) {
      state = cut(*state, [](const PatchedFacets& patched, const Patch& patch) {
        return allEdges(patched.facets, patch);
      });
      if (!state) break;
      if (!isBetter(*state)) continue;
      best_ = *state;
      isAny = true;
    }
    return isAny;
  }

  State best_;
  MadeFaces made_;
  std::shared_ptr<FaceMemory> memory_;  ///< null: faces are to be on disk
  const FeatureLimits& limits_;
  const AF2Algorithm& algorithm_;
  const MeshingOptions& options_;
  bool mayTilt_ = true;
  bool isHopeless_ = false;
};

}  // namespace

ModelMesh meshFaceted(const Facets& facets, const AF2Algorithm& algorithm,
                      const MeshingOptions& options,
                      const std::function<void(const DomainModel&)>& check) {
  const FeatureLimits limits = featureLimitsFor(facets, options);
  PatchedFacets patched = findPatches(facets, limits);
  MadeFaces made;
  const DomainModel whole = modelOf(patched, options, &made);
  if (check) check(whole);
  if (namesFacesOrEdges(options)) {
    ModelMesh mesh = meshDomain(whole, algorithm, options);
    if (options.faces.empty() && options.faceNames.empty()) compareWithTriangles(facets, mesh);
    return mesh;
  }
  ModelMesh mesh =
      CutMesher(std::move(patched), std::move(made), limits, algorithm, options).mesh(whole);
  compareWithTriangles(facets, mesh);
  return mesh;
}

}  // namespace af2::geometry
