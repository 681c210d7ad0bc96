#include "geometry/meshing/finer_faces.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/place_text.h"

namespace af2::geometry {
namespace {

using MakeMesh = std::function<ModelMesh(const MeshingOptions&)>;

/// Faces that failed although they are given few elements: fine ones fail for other reasons, and
/// would take long.
std::vector<int> coarseFailures(const FaceSource& source, const ModelMesh& mesh) {
  constexpr double kFewElements = 1000;
  std::vector<int> faces;
  for (const FaceReport& face : mesh.faces)
    if (face.status == FaceStatus::Failed && face.cause == FailureCause::Unknown &&
        source.workOn(face.id) < kFewElements)
      faces.push_back(face.id);
  return faces;
}

/// Only the faces, and only to see whether they can be meshed.
MeshingOptions optionsAlone(const MeshingOptions& options, const std::vector<int>& faces) {
  MeshingOptions alone = options;
  alone.faces = faces;
  alone.faceNames.clear();
  alone.progress = {};
  alone.observer = {};
  alone.order = 1;
  alone.sizes.chords = {};
  alone.fewest = false;
  alone.spool.when = SpoolRequest::When::Never;
  return alone;
}

/// Those of the faces that can be meshed alone, by id, with a share of their sizes, and what these
/// are then.
std::map<int, double> sizesWith(double share, const std::vector<int>& faces,
                                const MeshingOptions& options, const MakeMesh& make) {
  MeshingOptions tried = optionsAlone(options, faces);
  for (const int face : faces)
    tried.sizes.faceSizes[face] = share * wantedOnFace(options.sizes, face);
  std::map<int, double> found;
  for (const FaceReport& face : make(tried).faces)
    if (face.status == FaceStatus::Complete) found[face.id] = tried.sizes.faceSizes.at(face.id);
  return found;
}

/// By face: the largest of the smaller sizes with which it can be meshed alone. The middle is tried
/// first, so that hopeless faces are tried twice only.
std::map<int, double> sizesThatWork(const MeshingOptions& options, const std::vector<int>& faces,
                                    const MakeMesh& make) {
  constexpr double kMore = 1. / 2, kMiddle = 1. / 4, kLess = 1. / 8;
  std::map<int, double> found;
  const auto addThose = [&](double share, const auto& which) {
    std::vector<int> tried;
    for (const int face : faces)
      if (which(face) && share * wantedOnFace(options.sizes, face) >= options.sizes.minSize)
        tried.push_back(face);
    if (tried.empty() || options.stop.stop_requested()) return;
    for (const auto& [face, size] : sizesWith(share, tried, options, make)) found[face] = size;
  };
  addThose(kMiddle, [](int) { return true; });
  const std::map<int, double> inTheMiddle = found;
  addThose(kLess, [&](int face) { return !inTheMiddle.contains(face); });
  addThose(kMore, [&](int face) { return inTheMiddle.contains(face); });
  return found;
}

std::string noteOf(const std::map<int, double>& sizes) {
  constexpr std::size_t kMostNamed = 5;
  std::string text = "could not be meshed with the size that was asked for: ";
  std::size_t named = 0;
  for (const auto& [face, size] : sizes) {
    if (named == kMostNamed) break;
    text +=
        (named++ > 0 ? ", face " : "face ") + std::to_string(face) + " has " + af2::textOf(size, 3);
  }
  if (sizes.size() > named) text += " and " + std::to_string(sizes.size() - named) + " more";
  return text;
}

}  // namespace

ModelMesh meshFinerWhereFailed(const FaceSource& source, MeshingOptions options,
                               const MakeMesh& make) {
  constexpr int kLeastRetries = 2;  // who asks for fewer has other tries in mind
  ModelMesh mesh = make(options);
  if (options.strictRules || options.mostRetries.value_or(kLeastRetries) < kLeastRetries ||
      options.stop.stop_requested())
    return mesh;
  const std::vector<int> failed = coarseFailures(source, mesh);
  if (failed.empty()) return mesh;
  const std::map<int, double> sizes = sizesThatWork(options, failed, make);
  if (sizes.empty() || options.stop.stop_requested()) return mesh;
  for (const auto& [face, size] : sizes) options.sizes.faceSizes[face] = size;
  ModelMesh finer = make(options);
  if (options.stop.stop_requested() || failedFaces(finer) >= failedFaces(mesh)) return mesh;
  finer.notes.push_back(noteOf(sizes));
  return finer;
}

}  // namespace af2::geometry
