#include "geometry/meshing/face_crew.h"

#include <utility>

namespace af2::geometry {

RunChange changeOf(const MeshingOptions& options) {
  return {options.faces,           options.sizes.faceSizes, options.sizes.sources,
          options.sizes.chords,    options.optimize,        options.evenLoops,
          !options.layers.empty(), options.order,           options.spool.when,
          options.spool.where};
}

MeshingOptions withChange(MeshingOptions options, const RunChange& change) {
  options.faces = change.faces;
  options.sizes.faceSizes = change.faceSizes;
  options.sizes.sources = change.sources;
  options.sizes.chords = change.chords;
  options.sizes.elementsAcross = 0;  // their places are among the sources
  options.optimize = change.optimize;
  options.evenLoops = change.evenLoops;
  options.order = change.order;
  options.spool.when = change.keepFaces;
  options.spool.where = change.keptIn;
  if (!change.hasLayers) options.layers.clear();
  return options;
}

}  // namespace af2::geometry
