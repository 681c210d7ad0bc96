#include "cli/meshing/imprinted_model.h"

#include <fmt/core.h>

#include "geometry/occ/assembly/imprint.h"

namespace af2::cli {
namespace {

geometry::Overlaps overlapsOf(const std::string& word) {
  if (word == "first") return geometry::Overlaps::First;
  if (word == "last") return geometry::Overlaps::Last;
  if (word == "cut") return geometry::Overlaps::Cut;
  return geometry::Overlaps::Refuse;
}

}  // namespace

geometry::Model imprintedModel(const geometry::Model& model, const ImprintRequest& request,
                               const std::stop_token& stop) {
  if (!request.isAsked) return model;
  return geometry::imprintModel(model, {request.tolerance, overlapsOf(request.overlap),
                                        request.onlyEqual, kImprintSeconds, stop});
}

}  // namespace af2::cli
