#include "geometry/mpi/partition/part_labels.h"

#include <map>

#include "geometry/formats/msh_groups.h"

namespace af2::mpi {

using geometry::LineElement;
using geometry::ModelMesh;

PartLabels labelsOf(const ModelMesh& mesh, std::span<const LineElement> lines) {
  const geometry::MshGroups groups(mesh, {lines, {}, false}, {});
  PartLabels labels;
  for (const geometry::FaceReport& face : mesh.faces)
    labels.faces.push_back({face.id, groups.ofFace(face.id)});
  std::map<std::int32_t, std::int32_t> ofEdges;
  for (const LineElement& line : lines) ofEdges[line.edge] = groups.of(line);
  for (const auto& [edge, group] : ofEdges) labels.edges.push_back({edge, {group}});
  for (const auto& [group, name] : groups.names())
    labels.names.push_back({group.dimension, group.number, name});
  return labels;
}

}  // namespace af2::mpi
