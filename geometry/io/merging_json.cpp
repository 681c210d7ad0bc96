#include "geometry/io/merging_json.h"

namespace af2::geometry {

using Json = nlohmann::ordered_json;

nlohmann::ordered_json toJson(const Merging& merging) {
  Json groups = Json::array(), kept = Json::array();
  for (const MergedGroup& group : merging.groups)
    groups.push_back({{"faces", group.faces},
                      {"smooth_edges", group.smoothEdges},
                      {"narrow_edges", group.narrowEdges},
                      {"deviation", group.deviation}});
  for (const Merging::Kept& face : merging.kept)
    kept.push_back({{"face", face.face}, {"reason", face.reason}});
  return {{"angle", merging.angle},       {"narrow", merging.narrow}, {"groups", groups},
          {"vertices", merging.vertices}, {"chains", merging.chains}, {"kept", kept}};
}

}  // namespace af2::geometry
