#include "geometry/meshing/edge_names.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/base/error.h"
#include "engine/base/place_text.h"
#include "geometry/layers/layer_heights.h"
#include "geometry/meshing/part_sizes.h"

namespace af2::geometry {
namespace {

std::vector<std::string> faceNamesOf(const FaceSource& source) {
  std::vector<std::string> names;
  for (int face = 1; face <= source.faceCount(); ++face)
    names.push_back(source.reportOf(face).name);
  return names;
}

bool isCalled(const EdgeGroup& boundary, const std::string& pattern) {
  const std::string number = "boundary " + std::to_string(boundary.number);
  return fitsPattern(boundary.name.empty() ? number : boundary.name, pattern);
}

/// Checks one request and replaces its names.
class LayerResolver {
 public:
  LayerResolver(const FaceSource& source, LayerRequest& request)
      : source_(source), request_(request) {}

  void resolve() {
    checkHeights();
    for (const int edge : request_.edges) checkId("edge", edge, source_.edgeCount());
    for (const int face : request_.faces) checkId("face", face, source_.faceCount());
    request_.faces = withFacesCalled(std::move(request_.faces), request_.faceNames,
                                     faceNamesOf(source_), source_.groups());
    std::set<int> edges(request_.edges.begin(), request_.edges.end());
    for (const std::string& name : request_.edgeNames)
      for (const int edge : edgesNamed(source_, name)) edges.insert(edge);
    if (request_.edges.empty() && request_.edgeNames.empty())
      for (const int edge : edgesAround(source_, request_.faces)) edges.insert(edge);
    if (edges.empty()) fail("there are no edges for them");
    checkAreOnFaces();
    request_.edges.assign(edges.begin(), edges.end());
    request_.edgeNames.clear();
    request_.faceNames.clear();
  }

 private:
  [[noreturn]] static void fail(const std::string& fault) { throw InputError("layers: " + fault); }

  static void checkId(const std::string& kind, int id, int count) {
    if (id >= 1 && id <= count) return;
    fail("there is no " + kind + " " + std::to_string(id) + "; the model has " + kind + "s 1 to " +
         std::to_string(count));
  }

  void checkHeights() const {
    const auto require = [](bool isSo, const char* fault) {
      if (!isSo) fail(fault);
    };
    require(request_.first > 0 && std::isfinite(request_.first),
            "the height of the first layer must be greater than 0");
    require(request_.growth > 0 && std::isfinite(request_.growth),
            "the growth, the ratio of the heights of successive layers, must be greater than 0");
    require(request_.count >= 1 && request_.count <= kMaxLayers,
            "there can be 1 to 1000 of them along an edge");
    const LayerHeights heights{request_.first, request_.growth, request_.count};
    const double all = heights.tops().back();
    if (all < source_.diagonal()) return;
    fail(std::to_string(request_.count) + " layers would be " + af2::textOf(all, 4) +
         " high together, but the whole model is only " + af2::textOf(source_.diagonal(), 4) +
         " large; ask for a smaller first layer, growth or number");
  }

  void checkAreOnFaces() const {
    if (request_.faces.empty()) return;
    std::set<int> around;
    for (const int face : request_.faces)
      for (const int edge : source_.edgeIdsOf(face)) around.insert(edge);
    for (const int edge : request_.edges)
      if (!around.contains(edge))
        fail("edge " + std::to_string(edge) + " is not an edge of the faces that are to get them");
  }

  const FaceSource& source_;
  LayerRequest& request_;
};

}  // namespace

std::vector<int> edgesAround(const FaceSource& source, const std::vector<int>& faces) {
  std::set<int> around;
  for (const int face : faces) {
    const std::vector<int> edges = source.edgeIdsOf(face);
    for (const int edge : edges)
      if (std::ranges::count(edges, edge) == 1) around.insert(edge);
  }
  return {around.begin(), around.end()};
}

std::vector<int> edgesNamed(const FaceSource& source, const std::string& pattern) {
  std::set<int> edges;
  for (const EdgeGroup& boundary : source.boundaries())
    if (isCalled(boundary, pattern)) edges.insert(boundary.edges.begin(), boundary.edges.end());
  const std::vector<int> faces = facesCalled(pattern, faceNamesOf(source), source.groups());
  for (const int edge : edgesAround(source, faces)) edges.insert(edge);
  if (edges.empty())
    throw InputError("there are no edges called '" + pattern +
                     "': it is the name neither of a boundary nor of a face or group (see af2 "
                     "inspect)");
  return {edges.begin(), edges.end()};
}

std::vector<LayerRequest> layersById(const FaceSource& source, std::vector<LayerRequest> requests) {
  for (LayerRequest& request : requests) LayerResolver(source, request).resolve();
  return requests;
}

}  // namespace af2::geometry
