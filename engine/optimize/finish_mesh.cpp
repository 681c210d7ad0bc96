#include "engine/optimize/finish_mesh.h"

#include "engine/base/error.h"
#include "engine/optimize/score_finishing.h"

namespace af2 {

OptimizeReport finishMesh(Mesh& mesh, const MeshBoundary& boundary, const FinishTask& task,
                          const OptimizeOptions& options) {
  OptimizeOptions own = options;
  if (!own.quads.depth) own.quads.depth = task.rules.definition().cleanDepth;
  switch (task.rules.definition().finish) {
    case Finish::Shape:
      return optimizeMesh(mesh, boundary, task.charts, own);
    case Finish::Score:
      return finishByScore(mesh, boundary, task, options);
    case Finish::None:
      return {};
  }
  throw InternalError("a rule set has an unknown way to finish meshes");
}

}  // namespace af2
