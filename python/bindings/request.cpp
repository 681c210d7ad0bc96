#include "python/bindings/request.h"

#include <af2/engine/error.h>
#include <af2/geometry/size_field.h>
#include <af2/geometry/size_file.h>

#include <algorithm>
#include <map>

#include "python/bindings/trace.h"

namespace af2::python {
namespace {

/// Sets `target` if the dictionary has the key.
template <class T>
void take(const py::dict& asked, const char* key, T& target) {
  if (asked.contains(key)) target = asked[key].cast<T>();
}

geometry::ChordBound chordFrom(const py::handle& pair) {
  const auto [value, isShare] = pair.cast<std::pair<double, bool>>();
  return {value, isShare};
}

void takeChords(const py::dict& asked, geometry::ChordBounds& chords) {
  if (asked.contains("chord")) chords.everywhere = chordFrom(asked["chord"]);
  if (asked.contains("face_chords"))
    for (const auto& [face, bound] : asked["face_chords"].cast<py::dict>())
      chords.faces[face.cast<int>()] = chordFrom(bound);
  if (asked.contains("part_chords"))
    for (const auto& [name, bound] : asked["part_chords"].cast<py::dict>())
      chords.parts.emplace_back(name.cast<std::string>(), chordFrom(bound));
}

void takeSizes(const py::dict& asked, const std::shared_ptr<Call>& call, geometry::Sizes& sizes) {
  take(asked, "size", sizes.size);
  take(asked, "min_size", sizes.minSize);
  take(asked, "max_size", sizes.maxSize);
  take(asked, "curvature", sizes.elementsPerTurn);
  take(asked, "proximity", sizes.elementsAcross);
  take(asked, "grading", sizes.growth);
  take(asked, "face_sizes", sizes.faceSizes);
  take(asked, "edge_sizes", sizes.edgeSizes);
  take(asked, "edge_names", sizes.edgeNames);
  if (asked.contains("size_file")) {
    geometry::SizeFile file =
        geometry::readSizeFile(asked["size_file"].cast<std::filesystem::path>());
    sizes.sources = std::move(file.sources);
    sizes.partSizes = std::move(file.parts);
    sizes.chords.parts = std::move(file.chords);
  }
  std::vector<std::string> fields;
  take(asked, "size_fields", fields);
  for (const std::string& field : fields)
    sizes.sources.cells.push_back(geometry::readSizeField(geometry::sizeFieldName(field)));
  // The last match counts.
  std::vector<std::pair<std::string, double>> parts;
  take(asked, "part_sizes", parts);
  sizes.partSizes.insert(sizes.partSizes.end(), parts.begin(), parts.end());
  takeChords(asked, sizes.chords);
  if (asked.contains("size_function"))
    sizes.function = sizesFrom(asked["size_function"].cast<py::object>(), call);
}

geometry::LayerRequest layersFrom(const py::dict& layers) {
  geometry::LayerRequest request;
  take(layers, "edges", request.edges);
  take(layers, "edge_names", request.edgeNames);
  take(layers, "faces", request.faces);
  take(layers, "face_names", request.faceNames);
  take(layers, "first", request.first);
  take(layers, "growth", request.growth);
  take(layers, "count", request.count);
  return request;
}

geometry::ChartKind chartFrom(const std::string& name) {
  const auto kind = geometry::chartKindOf(name);
  if (!kind) throw InputError("chart='" + name + "': choose one of " + geometry::chartNames());
  return *kind;
}

void takeOptions(const py::dict& asked, geometry::MeshingOptions& options) {
  take(asked, "faces", options.faces);
  take(asked, "face_names", options.faceNames);
  take(asked, "order", options.order);
  take(asked, "fewest", options.fewest);
  take(asked, "threads", options.threads);
  take(asked, "max_memory", options.maxMemory);
  take(asked, "coarsen", options.coarsen);
  take(asked, "optimize", options.optimize);
  take(asked, "strict_rules", options.strictRules);
  take(asked, "keep_boundary", options.keepBoundary);
  take(asked, "feature_angle", options.featureAngle);
  take(asked, "quads", options.quads.onlyQuads);
  take(asked, "depth", options.quads.depth);
  options.evenLoops = options.quads.onlyQuads;
  if (asked.contains("chart")) options.chart = chartFrom(asked["chart"].cast<std::string>());
  if (asked.contains("boundary"))
    for (const auto& [edge, points] : asked["boundary"].cast<py::dict>())
      options.edgePoints[edge.cast<int>()] = points3(points, "boundary");
  if (asked.contains("layers"))
    for (const auto& layers : asked["layers"].cast<py::list>())
      options.layers.push_back(layersFrom(layers.cast<py::dict>()));
}

FaceReference referenceFrom(const py::handle& face) {
  if (py::isinstance<py::str>(face)) return {0, face.cast<std::string>()};
  return {face.cast<int>()};
}

void takeModelChanges(const py::dict& asked, Request& request) {
  take(asked, "heal", request.heal);
  take(asked, "heal_tolerance", request.healTolerance);
  take(asked, "imprint", request.imprint);
  take(asked, "glue", request.glue);
  take(asked, "overlap", request.overlap);
  take(asked, "imprint_tolerance", request.imprintTolerance);
  take(asked, "periodic_directions", request.periodicDirections);
  if (asked.contains("periodic_pairs"))
    for (const auto& pair : asked["periodic_pairs"].cast<py::list>()) {
      const auto faces = pair.cast<py::tuple>();
      request.periodicPairs.emplace_back(referenceFrom(faces[0]), referenceFrom(faces[1]));
    }
  if (asked.contains("points")) request.points = points3(asked["points"], "points");
  if (asked.contains("curves"))
    for (const auto& curve : asked["curves"].cast<py::list>())
      request.curves.push_back(points3(curve, "curves"));
}

std::optional<geometry::MergeRequest> mergeFrom(const py::dict& asked) {
  if (!asked.contains("merge")) return std::nullopt;
  const auto merge = asked["merge"].cast<py::dict>();
  geometry::MergeRequest request;
  take(merge, "angle", request.angle);
  take(merge, "narrow", request.narrow);
  take(merge, "keep", request.keptEdges);
  take(merge, "keep_around", request.keptAround);
  return request;
}

std::function<void(const geometry::ModelProgress&)> progressFrom(
    py::object callable, const std::shared_ptr<Call>& call) {
  return [function = shared(std::move(callable)), call](const geometry::ModelProgress& progress) {
    call->back([&] { (*function)(progress); });
  };
}

}  // namespace

bool Request::asksByNumber() const {
  const auto isByNumber = [](const geometry::LayerRequest& layers) {
    return !layers.edges.empty() || !layers.faces.empty();
  };
  return !options.faces.empty() || !options.sizes.faceSizes.empty() ||
         !options.sizes.edgeSizes.empty() || !options.sizes.chords.faces.empty() ||
         !options.edgePoints.empty() || !periodicPairs.empty() ||
         (merge && !merge->keptEdges.empty()) || std::ranges::any_of(options.layers, isByNumber);
}

Request requestFrom(const py::dict& asked, const std::shared_ptr<Call>& call) {
  Request request;
  takeSizes(asked, call, request.options.sizes);
  takeOptions(asked, request.options);
  takeModelChanges(asked, request);
  request.merge = mergeFrom(asked);
  if (asked.contains("progress"))
    request.options.progress = progressFrom(asked["progress"].cast<py::object>(), call);
  if (asked.contains("trace"))
    request.options.observer = tracersFor(asked["trace"].cast<py::object>(), call);
  request.options.stop = call->token();
  request.call = call;
  return request;
}

}  // namespace af2::python
