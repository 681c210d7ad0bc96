#include "geometry/meshing/chord_rounds.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "engine/base/place_text.h"
#include "geometry/check/sound_faces.h"
#include "geometry/deviation/thinned_mesh.h"
#include "geometry/mesh/fingerprint.h"

namespace af2::geometry {
namespace {

bool isBetter(const MeasuredMesh& one, const MeasuredMesh& other) {
  const auto failed = failedFaces(one.mesh), failedOfOther = failedFaces(other.mesh);
  if (failed != failedOfOther) return failed < failedOfOther;
  return one.deviations.excess < other.deviations.excess;
}

std::string placeOf(const Deviation& deviation) {
  const std::string where = deviation.face > 0 ? "face " + std::to_string(deviation.face)
                                               : "edge " + std::to_string(deviation.edge);
  return where + " near " + af2::textOf(deviation.place, 3);
}

DeviationTask taskOf(const FaceSource& source, const MeshingOptions& options,
                     const ModelMesh& mesh) {
  DeviationTask task;
  task.distanceFrom = [&](int face) { return source.distanceFrom(face); };
  task.boundOf = [&](int face) { return chordOnFace(options.sizes, face); };
  task.boundsOfSegments = boundsOfSegments(mesh, task.boundOf);
  task.threads = options.threads;
  return task;
}

std::set<int> facesAtFault(const MeshFaults& faults) {
  std::set<int> faces;
  for (const MeshFinding& finding : faults.findings) faces.insert(finding.face);
  for (const Crossing& crossing : faults.crossings)
    faces.insert(crossing.faces.begin(), crossing.faces.end());
  return faces;
}

/// Marks the vertices of some faces.
void keepVerticesOf(const ModelMesh& mesh, const std::set<int>& faces,
                    std::vector<std::uint8_t>& isKept) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (faces.contains(mesh.face[e]))
      for (const VertexId v : mesh.elements[e].vertices()) isKept[v.value] = 1;
}

void reportExcess(const MeshingOptions& options, MeasuredMesh& measured) {
  if (!(measured.deviations.excess > 1)) return;
  const std::string text = "the mesh is up to " + af2::textOf(measured.deviations.excess, 3) +
                           " times as far from the model as it may be; the largest distance is " +
                           af2::textOf(measured.deviations.largest.largest, 3) + ", at " +
                           placeOf(measured.deviations.largest);
  if (options.sizes.minSize > 0)
    measured.mesh.notes.push_back(text + ": the smallest size, " +
                                  af2::textOf(options.sizes.minSize, 3) +
                                  ", leaves no room for smaller elements");
  else
    measured.mesh.findings.push_back(
        text +
        ". Edges of the model may be as far from its surfaces; give a larger bound, or a smaller "
        "size there");
}

}  // namespace

MeasuredMesh measured(const FaceSource& source, const MeshingOptions& options, ModelMesh mesh,
                      EdgeCurves curves) {
  MeasuredMesh result{std::move(mesh), std::move(curves), {}};
  result.deviations =
      measureDeviations(result.mesh, result.curves, taskOf(source, options, result.mesh));
  result.mesh.deviation = result.deviations.largest;
  return result;
}

MeasuredMesh meshWithinChords(MeshingOptions options,
                              const std::function<MeasuredMesh(const MeshingOptions&)>& make) {
  constexpr int kMostRounds = 12, kMostInVain = 4;
  constexpr double kLeastAim = 0.05;  // more does not come from scatter
  constexpr double kMargin = 1.1;     // so that few rounds are enough
  std::optional<MeasuredMesh> best;
  std::string before;
  int inVain = 0;
  for (int round = 0; round < kMostRounds && inVain < kMostInVain; ++round) {
    MeasuredMesh next = make(options);
    std::vector<SizeSource> tooFar = std::move(next.deviations.tooFar);
    const std::map<int, double> scatter = next.deviations.scatter;
    const std::string made = fingerprint(next.mesh);
    ++inVain;
    if (!best || isBetter(next, *best)) {
      best = std::move(next);
      inVain = 0;
    }
    if ((tooFar.empty() && scatter.empty()) || options.stop.stop_requested()) break;
    bool isAimedLower = false;
    for (const auto& [face, ratio] : scatter) {
      const double aim = options.sizes.chords.aimOf(face);
      const double lower = std::max(kLeastAim, aim / (kMargin * ratio));
      options.sizes.chords.aims[face] = lower;
      isAimedLower = isAimedLower || lower < aim;
    }
    // Where sizes cannot become smaller either, the same mesh would come again and again.
    if (made == before && !isAimedLower) break;
    before = made;
    addSources(std::move(tooFar), options.sizes.minSize, options.sizes.sources);
  }
  reportExcess(options, *best);
  return *std::move(best);
}

void thinWithinChords(const FaceSource& source, const MeshingOptions& options,
                      MeasuredMesh& given) {
  constexpr int kMostTries = 6;
  const DeviationTask task = taskOf(source, options, given.mesh);
  ThinningLimits limits;
  limits.longest = options.sizes.size < source.diagonal() ? options.sizes.size
                                                          : std::numeric_limits<double>::infinity();
  limits.isKept.assign(given.mesh.vertices.size(), 0);
  for (int i = 0; i < kMostTries && !options.stop.stop_requested(); ++i) {
    ModelMesh mesh = given.mesh;
    EdgeCurves curves = given.curves;
    if (thin(mesh, curves, task, limits) == 0) return;
    const std::set<int> faulty = facesAtFault(faultsOf(mesh, source.mayCross(), options.threads));
    if (faulty.empty()) {
      given = measured(source, options, std::move(mesh), std::move(curves));
      return;
    }
    keepVerticesOf(given.mesh, faulty, limits.isKept);
  }
}

}  // namespace af2::geometry
