#include "geometry/meshing/mesh_faces.h"

#include <optional>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/base/place_text.h"
#include "geometry/mesh/narrow_places.h"
#include "geometry/meshing/check_options.h"
#include "geometry/meshing/chord_rounds.h"
#include "geometry/meshing/face_crew.h"
#include "geometry/meshing/face_run.h"
#include "geometry/meshing/finer_faces.h"
#include "geometry/sizes/coarser_sizes.h"
#include "geometry/sizes/too_many.h"

namespace af2::geometry {

namespace {

/// Places narrower than the elements across them get sizes of their own. Narrow places are between
/// any two faces, so that all are meshed for this.
void addNarrowPlaces(FaceSource& source, const AF2Algorithm& algorithm, MeshingOptions& options) {
  const double across = std::exchange(options.sizes.elementsAcross, 0);
  MeshingOptions first = options;
  first.faces.clear();
  first.optimize = false;
  first.order = 1;
  first.evenLoops = false;  // narrow places are the same with the option and without
  if (options.progress)
    first.progress = [&options](const ModelProgress& now) {
      ModelProgress none;  // of the mesh that is asked for
      none.faces = now.faces;
      none.workTotal = now.workTotal;
      options.progress(none);
    };
  first.observer = {};
  first.sizes.chords = {};
  first.layers.clear();  // they are not narrow places of the model
  const ModelMesh coarse = meshOnce(source, algorithm, first).mesh;
  addSources(narrowPlaces(coarse, across, options.threads),
             leastForLimits(options.sizes.size, options.sizes.minSize), options.sizes.sources);
}

/// Does what the leader of the crew decides, as often as it meshes the faces.
ModelMesh follow(CrewFollower& crew, FaceSource& source, const AF2Algorithm& algorithm,
                 const MeshingOptions& options) {
  while (const std::optional<RunChange> change = crew.nextRun()) {
    const MeshingOptions own = withChange(options, *change);
    followOnce(source, algorithm, own, crew);
  }
  return crew.reports();
}

/// Finds narrow places first, keeps to the bounds on the distance from the model, and takes smaller
/// sizes where faces fail. The seconds are those of all meshes that were made.
ModelMesh meshWithin(FaceSource& source, const AF2Algorithm& algorithm, MeshingOptions options) {
  if (options.sizes.elementsAcross > 0) addNarrowPlaces(source, algorithm, options);
  StageSeconds spent;
  const auto make = [&](const MeshingOptions& asked) {
    MeasuredMesh made = meshOnce(source, algorithm, asked);
    spent.edges += made.mesh.seconds.edges;
    spent.surface += made.mesh.seconds.surface;
    spent.optimize += made.mesh.seconds.optimize;
    return made;
  };
  const auto within = [&](const MeshingOptions& asked) {
    if (!asked.sizes.chords.areGiven()) return make(asked).mesh;
    MeasuredMesh measured = meshWithinChords(asked, make);
    if (asked.fewest) thinWithinChords(source, asked, measured);
    return std::move(measured.mesh);
  };
  ModelMesh mesh = meshFinerWhereFailed(source, std::move(options), within);
  mesh.seconds = spent;
  return mesh;
}

/// With sizes that are larger than those that are asked for, if these need too much memory.
ModelMesh meshWithinMemory(FaceSource& source, const AF2Algorithm& algorithm,
                           MeshingOptions options) {
  constexpr double kMost = 1e6;  // then something else is wrong
  bool isTooLarge = false;
  for (double factor = 1;;) {
    try {
      ModelMesh mesh = meshWithin(source, algorithm, options);
      if (factor > 1)
        mesh.notes.push_back("the sizes that were asked for need too much memory: all are " +
                             af2::textOf(factor, 4) + " times as large");
      if (isTooLarge)
        mesh.notes.emplace_back(
            "the mesh needs more memory than there is: its faces were put on "
            "disk one by one");
      return mesh;
    } catch (const TooManyElements& error) {
      if (options.spool.when == SpoolRequest::When::IfNeeded && !options.crew &&
          error.fitSpooled() && whyNotSpooled(options).empty()) {
        options.spool.when = SpoolRequest::When::Always;
        isTooLarge = true;
        continue;
      }
      if (!options.coarsen || options.crew || factor > kMost) throw;
      factor *= error.factor();
      options.sizes = timesAsLarge(std::move(options.sizes), error.factor());
    }
  }
}

}  // namespace

ModelMesh meshFaces(FaceSource& source, const AF2Algorithm& algorithm,
                    const MeshingOptions& options) {
  checkOptions(source, options);
  ModelMesh mesh;
  // One arena for all stages: a thread that has to change arenas comes late to the next stage.
  withThreads(options.threads, [&] {
    MeshingOptions own = optionsFor(source, options);
    own.threads = 0;  // as many as the arena has
    if (own.crew && own.crew->follower()) {
      mesh = follow(*own.crew->follower(), source, algorithm, own);
      return;
    }
    mesh = meshWithinMemory(source, algorithm, own);
    if (own.crew && own.crew->leader()) own.crew->leader()->endModel(mesh);
  });
  return mesh;
}

}  // namespace af2::geometry
