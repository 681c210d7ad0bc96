#include "geometry/faceted/faceted_model.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "geometry/base/constants.h"
#include "geometry/charts/layout_charts.h"
#include "geometry/faceted/facet_surface.h"
#include "geometry/faceted/mesh_faceted.h"
#include "geometry/faceted/patch_limit.h"

namespace af2::geometry {
namespace {

constexpr double kRetryShare = 0.25;  // charts look through triangles

double diagonalOf(const Facets& facets) {
  Box3 box;
  for (const Point3& p : facets.vertices) box.add(p);
  return distance(box.low, box.high);
}

class ModelMaker {
 public:
  ModelMaker(std::shared_ptr<const PatchedFacets> patched, int threads, MadeFaces made)
      : shared_(std::move(patched)),
        patched_(*shared_),
        facets_(patched_.facets),
        made_(std::move(made)),
        known_(patched_.patches.size()),
        surfaces_(patched_.patches.size()) {
    forEachInParallel(surfaces_.size(), threads, [&](std::size_t i) {
      known_[i] = madeOf(patched_.patches[i]);
      if (known_[i])
        surfaces_[i] = known_[i]->surface;
      else
        surfaces_[i].emplace(patched_, patched_.patches[i], drawingOf(patched_.patches[i]));
    });
  }

  /// made  may be null
  DomainModel make(double growth, MadeFaces* made) {
    model_.name = facets_.name;
    model_.leastAtTurns = kMinAtPatchTurns;
    model_.retryShare = kRetryShare;
    model_.diagonal = diagonalOf(facets_);
    corner_.assign(facets_.vertices.size(), kNone);
    for (const FeatureCurve& curve : patched_.curves) addCurve(curve);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) addFace(i);
    if (made) *made = madeFaces();
    addLimits(growth);
    addCrossings();
    addGroups();
    model_.notes = facets_.notes;
    return std::move(model_);
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};

  /// It costs little for small patches; and large ones hardly need it.
  static FacetSurface::Drawing drawingOf(const Patch& patch) {
    constexpr std::size_t kMaxTriangles = 10000;
    return patch.triangles.size() <= kMaxTriangles ? FacetSurface::Drawing::IfPossible
                                                   : FacetSurface::Drawing::None;
  }

  std::size_t cornerAt(std::uint32_t v) {
    if (corner_[v] == kNone) {
      corner_[v] = model_.corners.size();
      model_.corners.push_back(facets_.vertices[v]);
    }
    return corner_[v];
  }

  void addCurve(const FeatureCurve& vertices) {
    DomainCurve curve;
    curve.id = static_cast<int>(model_.curves.size()) + 1;
    curve.first = cornerAt(vertices.front());
    curve.last = cornerAt(vertices.back());
    auto points = std::make_shared<std::vector<Point3>>();
    std::vector<std::uint32_t>& knots = knots_.emplace_back();
    for (const std::uint32_t v : vertices) {
      const Point3& p = facets_.vertices[v];
      const double step = points->empty() ? 0 : distance(points->back(), p);
      if (!points->empty() && step == 0) continue;
      curve.knots.push_back(points->empty() ? 0 : curve.knots.back() + step);
      points->push_back(p);
      knots.push_back(v);
    }
    curve.pointAt = [knots = curve.knots, points](double s) {
      const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, s);
      const auto i = static_cast<std::size_t>(above - knots.begin());
      const double within = (s - knots[i - 1]) / (knots[i] - knots[i - 1]);
      const Point3 &from = (*points)[i - 1], &to = (*points)[i];
      return within >= 1 ? to : from + within * (to - from);
    };
    curve.largest = largestOn(curve);
    model_.curves.push_back(std::move(curve));
  }

  /// Whatever the size, so that an arc does not become a single chord, along which elements would
  /// have to stand on edge. By quarters of the curve, in which noise does not count.
  static double largestOn(const DomainCurve& curve) {
    constexpr int kParts = 4;
    constexpr double kMaxTurn = 75 * kDegree;
    const double whole = curve.knots.back();
    double turn = 0;
    Point3 before;
    for (int i = 1; i <= kParts; ++i) {
      const Point3 chord =
          curve.pointAt(whole * i / kParts) - curve.pointAt(whole * (i - 1) / kParts);
      if (i > 1) turn += angleBetween(before, chord);
      before = chord;
    }
    turn *= kParts / (kParts - 1.0);
    const double parts = std::min(std::ceil(turn / kMaxTurn), kParts + 0.0);
    return parts > 1 ? whole / parts : DomainCurve::kNoLimit;
  }

  const MadeFaces::Face* madeOf(const Patch& patch) const {
    const auto made = made_.faces.find(facets_.triangles[patch.triangles.front()]);
    const bool isSame = made != made_.faces.end() && made->second.surface.isOf(patched_, patch);
    return isSame ? &made->second : nullptr;
  }

  MadeFaces madeFaces() const {
    MadeFaces made;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      made.faces.insert_or_assign(facets_.triangles[patched_.patches[i].triangles.front()],
                                  MadeFaces::Face{*surfaces_[i], model_.faces[i]});
    return made;
  }

  void addFace(std::size_t index) {
    const MadeFaces::Face* known = known_[index];
    model_.faces.push_back(known ? known->face : faceOf(*surfaces_[index]));
    model_.faces.back().loops = patched_.patches[index].loops;
  }

  static DomainFace faceOf(const FacetSurface& surface) {
    DomainFace face;
    face.area = surface.area();
    if (const auto plane = surface.plane()) {
      face.surfaceType = "plane";
      face.area = surface.projectedArea();
      const auto flat = std::make_shared<const FlatSurface>(*plane);
      face.surface = flat;
      face.nearest = [flat](const Point3& p) { return flat->pointAt(p); };
      face.canBeCut = true;
    } else {
      face.surfaceType = "facets";
      face.surface = std::make_shared<const LayoutCharts<FacetSurface>>(surface);
      face.nearest = [surface](const Point3& p) { return surface.nearest(p); };
    }
    return face;
  }

  void addLimits(double growth) {
    std::vector<PatchFace> faces;
    std::vector<bool> isBesideCurved(model_.curves.size(), false);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const DomainFace& face = model_.faces[i];
      faces.push_back({*surfaces_[i], face.surface->isPlane()});
      if (faces.back().isPlane) continue;
      for (const auto& loop : face.loops)
        for (const CurveUse& use : loop) isBesideCurved[use.curve] = true;
    }
    for (std::size_t c = 0; c < knots_.size(); ++c)
      if (!isBesideCurved[c]) knots_[c].clear();
    model_.curvatureLimits = [shared = shared_, faces = std::move(faces), knots = std::move(knots_),
                              growth](const DomainSize& size) {
      return limitsOfPatches(shared->facets, faces, knots, size, growth);
    };
  }

  void addCrossings() {
    std::vector<int> faceOf(facets_.triangles.size(), 0);
    for (std::size_t i = 0; i < patched_.patches.size(); ++i)
      for (const std::uint32_t t : patched_.patches[i].triangles)
        faceOf[t] = static_cast<int>(i) + 1;
    model_.crossings = [shared = shared_, faceOf = std::move(faceOf)] {
      std::vector<FacesCross> crossings;
      for (const auto& [triangles, place] : shared->crossed->of(shared->facets))
        crossings.push_back({{faceOf[triangles[0]], faceOf[triangles[1]]}, place});
      return crossings;
    };
  }

  /// A patch is of the part that its first triangle is of.
  void addGroups() {
    if (facets_.group.empty()) return;
    std::vector<std::size_t> groupOf;  // by part; parts may have the same name
    for (const std::string& name : facets_.groupNames) {
      const auto known = std::ranges::find(model_.groups, name, &FaceGroup::name);
      groupOf.push_back(static_cast<std::size_t>(known - model_.groups.begin()));
      if (known == model_.groups.end()) model_.groups.push_back({name, GroupKind::Part, {}});
    }
    for (std::size_t i = 0; i < patched_.patches.size(); ++i)
      model_.groups[groupOf[facets_.group[patched_.patches[i].triangles.front()]]].faces.push_back(
          static_cast<int>(i) + 1);
    std::erase_if(model_.groups,
                  [](const FaceGroup& group) { return group.name.empty() || group.faces.empty(); });
  }

  std::shared_ptr<const PatchedFacets> shared_;
  const PatchedFacets& patched_;
  const Facets& facets_;
  const MadeFaces made_;                               // before
  std::vector<const MadeFaces::Face*> known_;          // by patch; null: it is new
  std::vector<std::optional<FacetSurface>> surfaces_;  // by patch
  std::vector<std::size_t> corner_;                    // by vertex of the facets
  std::vector<std::vector<std::uint32_t>> knots_;      // by curve: vertices of the facets
  DomainModel model_;
};

}  // namespace

FeatureLimits featureLimitsFor(const Facets& facets, const MeshingOptions& options) {
  constexpr double kSpeck = 0.05, kLooseEnd = 0.5, kOfModel = 0.125;
  if (!(options.featureAngle > 0 && options.featureAngle < 180))
    throw InputError("the feature angle must be between 0 and 180 degrees");
  const double most = std::min(options.sizes.size, kOfModel * diagonalOf(facets));
  const double visible = options.fewest ? most : std::min(options.sizes.size, diagonalOf(facets));
  return {options.featureAngle * kDegree, kLooseEnd * visible, kSpeck * visible,
          [size = DomainSize(options.sizes), most](const Point3& p) { return size.at(p, most); }};
}

DomainModel modelOf(PatchedFacets patched, const MeshingOptions& options, MadeFaces* made) {
  return ModelMaker(std::make_shared<const PatchedFacets>(std::move(patched)), options.threads,
                    made ? std::move(*made) : MadeFaces())
      .make(options.sizes.growth, made);
}

DomainModel facetedModel(const Facets& facets, const MeshingOptions& options) {
  return modelOf(findPatches(facets, featureLimitsFor(facets, options)), options);
}

}  // namespace af2::geometry
