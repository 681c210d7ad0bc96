#include "geometry/retry/withdrawn_requests.h"

namespace af2::geometry {

bool hasVainRequests(const Retrial& retrial, const FaceMeshes& state, std::size_t face) {
  return failed(state.meshes[face]) && retrial.requests.hasAny(face);
}

std::optional<std::size_t> withdrawRequests(Retrial& retrial, FaceMeshes&, std::size_t face) {
  retrial.requests.dropAll(face);
  return 0;
}

}  // namespace af2::geometry
