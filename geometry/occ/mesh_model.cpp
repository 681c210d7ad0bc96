#include "geometry/occ/mesh_model.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <numeric>

#include "engine/error.h"
#include "engine/stopwatch.h"
#include "geometry/narrow_places.h"
#include "geometry/occ/edge_division.h"
#include "geometry/occ/face_area.h"
#include "geometry/occ/face_mesher.h"
#include "geometry/occ/face_surface.h"
#include "geometry/occ/parallel.h"
#include "geometry/occ/sizing.h"
#include "geometry/sound_faces.h"

namespace af2::geometry {

namespace {

std::vector<int> facesAskedFor(const Model& model, const ModelMeshingOptions& options) {
  std::vector<int> faces = options.faces;
  if (faces.empty()) {
    faces.resize(static_cast<std::size_t>(model.faceCount()));
    std::iota(faces.begin(), faces.end(), 1);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  for (const int face : faces)
    if (face < 1 || face > model.faceCount())
      throw InputError("face " + std::to_string(face) + ": the model has faces 1 to " +
                       std::to_string(model.faceCount()));
  return faces;
}

/// Adds up how far the faces have come and tells it, one caller at a time.
class ProgressSum {
 public:
  ProgressSum(const ModelMeshingOptions& options, const std::vector<double>& work)
      : options_(options), work_(work), elements_(work.size(), 0) {
    sum_.faces = static_cast<int>(work.size());
    for (const double w : work) sum_.workTotal += w;
  }

  void advance(std::size_t index, std::size_t elements) {
    const std::lock_guard lock(mutex_);
    update(index, elements, std::min(static_cast<double>(elements), 0.99 * work_[index]));
    tell();
  }
  void finish(std::size_t index, std::size_t elements) {
    const std::lock_guard lock(mutex_);
    update(index, elements, work_[index]);
    ++sum_.facesDone;
    tell();
  }

 private:
  void update(std::size_t index, std::size_t elements, double done) {
    sum_.elements += elements - elements_[index].count;
    sum_.workDone += done - elements_[index].done;
    elements_[index] = {elements, done};
  }
  void tell() const {
    if (options_.progress) options_.progress(sum_);
  }

  struct Part {
    Part(std::size_t c = 0, double d = 0) : count(c), done(d) {}
    std::size_t count;
    double done;
  };
  const ModelMeshingOptions& options_;
  const std::vector<double>& work_;
  std::vector<Part> elements_;
  ModelProgress sum_;
  std::mutex mutex_;
};

/// Joins the meshes of faces. Vertices that no element uses are left out.
class Assembly {
 public:
  Assembly(const DividedEdges& divided, const ModelSizes& sizes)
      : divided_(divided), sizes_(sizes) {}

  ModelMesh join(std::vector<FaceMesh>& faces) {
    numberBoundary(faces);
    for (FaceMesh& face : faces) add(face);
    addSegments(faces);
    takeSizesOfEdges();
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kUnused = 0xffffffffu;

  void numberBoundary(const std::vector<FaceMesh>& faces) {
    ids_.assign(divided_.points.size(), kUnused);
    for (const FaceMesh& face : faces)
      for (const Element& element : face.elements)
        for (const VertexId v : element.vertices())
          if (v.value < face.boundary.size()) ids_[face.boundary[v.value]] = 0;
    for (std::size_t i = 0; i < ids_.size(); ++i)
      if (ids_[i] != kUnused) ids_[i] = addVertex(divided_.points[i]);
  }

  std::uint32_t addVertex(const Point3& position) {
    mesh_.vertices.push_back(position);
    mesh_.wantedSizes.push_back(std::numeric_limits<double>::infinity());
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }

  void add(FaceMesh& face) {
    const std::size_t boundaryCount = face.boundary.size();
    const std::size_t base = mesh_.vertices.size();
    mesh_.vertices.insert(mesh_.vertices.end(), face.inside.begin(), face.inside.end());
    mesh_.wantedSizes.insert(
        mesh_.wantedSizes.end(),
        face.wantedSizes.end() - static_cast<std::ptrdiff_t>(face.inside.size()),
        face.wantedSizes.end());
    for (std::size_t i = 0; i < boundaryCount && !face.wantedSizes.empty(); ++i) {
      const std::uint32_t id = ids_[face.boundary[i]];
      if (id != kUnused)
        mesh_.wantedSizes[id] = std::min(mesh_.wantedSizes[id], face.wantedSizes[i]);
    }
    for (Element element : face.elements) {
      for (VertexId& v : element.corners) {
        if (v.isNone()) continue;
        v = v.value < boundaryCount ? VertexId(ids_[face.boundary[v.value]])
                                    : VertexId(base + v.value - boundaryCount);
      }
      mesh_.elements.push_back(element);
      mesh_.face.push_back(face.report.id);
    }
    mesh_.rule.insert(mesh_.rule.end(), face.rule.begin(), face.rule.end());
    mesh_.faces.push_back(std::move(face.report));
  }

  void addSegments(const std::vector<FaceMesh>& faces) {
    std::vector<std::vector<int>> uses;
    for (const DividedEdge& edge : divided_.edges)
      uses.emplace_back(edge.points.empty() ? 0 : edge.points.size() - 1, 0);
    for (const FaceMesh& face : faces)
      for (const SegmentUse& use : face.uses)
        ++uses[static_cast<std::size_t>(use.edge) - 1][use.segment];
    for (std::size_t e = 0; e < uses.size(); ++e)
      for (std::size_t i = 0; i < uses[e].size(); ++i)
        if (uses[e][i] > 0) addSegment(e, i, uses[e][i]);
  }

  void addSegment(std::size_t edge, std::size_t i, int uses) {
    const std::vector<std::uint32_t>& points = divided_.edges[edge].points;
    mesh_.segments.push_back({VertexId(ids_[points[i]]), VertexId(ids_[points[i + 1]]),
                              static_cast<int>(edge) + 1, uses});
  }

  /// Along an edge with a size of its own those of its faces do not count.
  void takeSizesOfEdges() {
    if (sizes_.edgeSizes.empty()) return;
    for (const EdgeSegment& segment : mesh_.segments) {
      const auto own = sizes_.edgeSizes.find(segment.edge);
      if (own == sizes_.edgeSizes.end()) continue;
      for (const VertexId v : {segment.from, segment.to})
        mesh_.wantedSizes[v.value] = bounded(sizes_, own->second);
    }
  }

  const DividedEdges& divided_;
  const ModelSizes& sizes_;
  std::vector<std::uint32_t> ids_;
  ModelMesh mesh_;
};

class ModelMesher {
 public:
  ModelMesher(const Model& model, const AF2Algorithm& algorithm, ModelMeshingOptions options)
      : model_(model), algorithm_(algorithm), options_(std::move(options)) {}

  ModelMesh mesh() {
    const std::vector<int> faces = facesAskedFor(model_, options_);
    const std::vector<double> areas = areasOf(faces);
    const std::vector<double> work = workOf(faces, areas);
    const Stopwatch edgesWatch;
    options_.sizes =
        spreadSizes(model_.shape(), std::move(options_.sizes), options_.threads, options_.stop);
    divided_ = divideEdges(model_.shape(), options_.sizes, options_.threads, options_.stop,
                           options_.edgePoints);
    const double edgeSeconds = edgesWatch.seconds();

    const Stopwatch facesWatch;
    std::vector<FaceMesh> meshes = meshFaces(faces, areas, work);
    const double optimizeShare = shareOfOptimizing(meshes);
    ModelMesh mesh = Assembly(divided_, options_.sizes).join(meshes);
    for (const AF2Rule& rule : algorithm_.rules().rules()) mesh.ruleNames.push_back(rule.name());
    mesh.ruleNames.push_back("closing");  // what closes a stuck front
    mesh.seconds.edges = edgeSeconds;
    const double surfaceSeconds = facesWatch.seconds();
    mesh.seconds.optimize = optimizeShare * surfaceSeconds;
    mesh.seconds.surface = surfaceSeconds - mesh.seconds.optimize;
    mesh.findings = keepSoundFaces(mesh);
    return mesh;
  }

 private:
  /// Faces are meshed and optimised one beside the other; the time is shared out by what each took.
  static double shareOfOptimizing(const std::vector<FaceMesh>& meshes) {
    double all = 0, optimizing = 0;
    for (const FaceMesh& mesh : meshes) {
      all += mesh.report.seconds;
      optimizing += mesh.optimizeSeconds;
    }
    return all > 0 ? optimizing / all : 0;
  }

  std::vector<FaceMesh> meshFaces(const std::vector<int>& faces, const std::vector<double>& areas,
                                  const std::vector<double>& work) {
    ProgressSum progress(options_, work);
    std::vector<FaceMesh> meshes(faces.size());
    const std::vector<std::size_t> order = largestFirst(work);
    forEachInParallel(faces.size(), options_.threads, [&](std::size_t k) {
      const std::size_t i = order[k];
      const FaceMeshingContext context{model_.shape(), algorithm_, options_, divided_,
                                       [&](const Progress& p) { progress.advance(i, p.elements); }};
      meshes[i] = options_.stop.stop_requested() ? cancelled(faces[i])
                                                 : meshFace(context, faces[i], areas[i], work[i]);
      meshes[i].report.area = areas[i];
      progress.finish(i, meshes[i].elements.size());
    });
    return meshes;
  }

  FaceMesh cancelled(int face) const {
    FaceMesh mesh;
    mesh.report.id = face;
    mesh.report.name = model_.faceName(face);
    mesh.report.surfaceType = model_.surfaceType(face);
    mesh.report.status = FaceStatus::Cancelled;
    return mesh;
  }

  std::vector<double> areasOf(const std::vector<int>& faces) const {
    std::vector<double> areas(faces.size(), 0);
    forEachInParallel(faces.size(), options_.threads, [&](std::size_t i) {
      if (!options_.stop.stop_requested()) areas[i] = areaOf(model_.shape(), faces[i]);
    });
    return areas;
  }

  std::vector<double> workOf(const std::vector<int>& faces,
                             const std::vector<double>& areas) const {
    std::vector<double> work(faces.size(), 1);
    forEachInParallel(faces.size(), options_.threads, [&](std::size_t i) {
      if (!(areas[i] > 0) || options_.stop.stop_requested()) return;
      work[i] +=
          expectedElements(options_.sizes, faces[i], model_.shape().surface(faces[i]), areas[i]);
    });
    refuseTooMany(std::accumulate(work.begin(), work.end(), 0.0));
    return work;
  }

  /// Vertices and elements have 32-bit numbers.
  static void refuseTooMany(double elements) {
    constexpr double kMostElements = 2e9;
    if (elements > kMostElements)
      throw InputError("the size asks for about " +
                       std::to_string(static_cast<long long>(elements / 1e9)) +
                       " thousand million elements; ask for a larger size");
  }

  static std::vector<std::size_t> largestFirst(const std::vector<double>& work) {
    std::vector<std::size_t> order(work.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return work[a] > work[b]; });
    return order;
  }

  const Model& model_;
  const AF2Algorithm& algorithm_;
  ModelMeshingOptions options_;
  DividedEdges divided_;
};

}  // namespace

ModelMesh meshModel(const Model& model, const AF2Algorithm& algorithm,
                    const ModelMeshingOptions& options) {
  checkSizes(options.sizes, model);
  for (const auto& [edge, points] : options.edgePoints)
    if (edge < 1 || edge > model.edgeCount())
      throw InputError("points for edge " + std::to_string(edge) + ": the model has edges 1 to " +
                       std::to_string(model.edgeCount()));
  if (options.sizes.elementsAcross == 0) return ModelMesher(model, algorithm, options).mesh();
  ModelMeshingOptions finer = options;
  finer.sizes.elementsAcross = 0;
  ModelMeshingOptions first = finer;
  first.faces.clear();  // narrow places are between any two
  first.optimize = false;
  first.progress = {};
  first.observer = {};
  const ModelMesh coarse = ModelMesher(model, algorithm, std::move(first)).mesh();
  addSources(narrowPlaces(coarse, options.sizes.elementsAcross),
             leastForLimits(options.sizes.size, options.sizes.minSize), finer.sizes.sources);
  return ModelMesher(model, algorithm, std::move(finer)).mesh();
}

}  // namespace af2::geometry
