#include "cli/meshing/measures_text.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/meshing/mesh_summary.h"

namespace af2::cli {
namespace {

using geometry::Distribution;
using geometry::LengthReference;
using geometry::MeshMeasures;
using geometry::VertexCount;
using Json = nlohmann::ordered_json;

const char* nameOf(LengthReference unit) {
  switch (unit) {
    case LengthReference::GivenSize:
      return "size";
    case LengthReference::WantedSizes:
      return "target size";
    case LengthReference::MedianLength:
      return "median length";
  }
  return "";
}

/// Four digits, in the width of a column.
std::string shortNumber(double value) {
  const bool isTiny = value != 0 && std::abs(value) < 0.001;
  return isTiny ? fmt::format("{:>7.1e}", value) : fmt::format("{:>7.4g}", value);
}

std::string rowOf(const std::string& name, const Distribution& values) {
  if (values.count == 0) return "";
  std::string row = fmt::format("{:<30}", name);
  for (const double value : {values.min, values.p1, values.p5, values.median, values.mean,
                             values.p95, values.p99, values.max})
    row += "  " + shortNumber(value);
  return row + "\n";
}

std::string shareOf(const VertexCount& count) {
  if (count.all == 0) return "0 of 0";
  return fmt::format("{} of {} ({:.2g} %)", grouped(count.irregular), grouped(count.all),
                     100.0 * static_cast<double>(count.irregular) / static_cast<double>(count.all));
}

std::string irregularText(const geometry::IrregularVertices& irregular) {
  std::string text = fmt::format(
      "irregular vertices             inside faces {}, at least {} necessary; on boundaries {}\n",
      shareOf(irregular.inner), grouped(irregular.least), shareOf(irregular.boundary));
  if (irregular.boundary.all == 0) return text;
  text += "  by edges to the boundary   ";
  for (std::size_t ring = 0; ring < irregular.rings.size(); ++ring)
    text += fmt::format(
        "  {}: {}/{}", ring + 1 < irregular.rings.size() ? std::to_string(ring) : "more",
        grouped(irregular.rings[ring].irregular), grouped(irregular.rings[ring].all));
  return text + "\n";
}

std::string meetingText(const geometry::MeetingFronts& meeting) {
  if (meeting.irregular.all == 0) return "";
  return fmt::format("  where fronts meet            {}; elsewhere {}\n",
                     shareOf(meeting.irregular), shareOf(meeting.irregularElsewhere));
}

std::string shapeText(const geometry::MeshShape& shape) {
  return fmt::format(
      "edges                          {}: {} free, {} non-manifold, {} between opposite "
      "orientations, {} folded\n"
      "surface                        {}, {} {}, Euler number {}\n",
      grouped(shape.edges), grouped(shape.freeEdges), grouped(shape.nonManifoldEdges),
      grouped(shape.turnedEdges), grouped(shape.foldedEdges), shape.isClosed() ? "closed" : "open",
      shape.components, shape.components == 1 ? "piece" : "pieces", shape.euler);
}

/// JSON has no number for infinity, which the aspect ratio of an element without area is.
Json numberJson(double value) {
  if (!std::isfinite(value)) return nullptr;
  return value;
}

Json jsonOf(const Distribution& values) {
  if (values.count == 0) return nullptr;
  return {{"min", numberJson(values.min)},   {"p1", numberJson(values.p1)},
          {"p5", numberJson(values.p5)},     {"median", numberJson(values.median)},
          {"mean", numberJson(values.mean)}, {"p95", numberJson(values.p95)},
          {"p99", numberJson(values.p99)},   {"max", numberJson(values.max)}};
}

Json jsonOf(const VertexCount& count) {
  return {{"vertices", count.all}, {"irregular", count.irregular}};
}

Json jsonOf(const geometry::IrregularVertices& irregular) {
  Json rings = Json::array();
  for (const VertexCount& ring : irregular.rings) rings.push_back(jsonOf(ring));
  return {{"inside", jsonOf(irregular.inner)},
          {"boundary", jsonOf(irregular.boundary)},
          {"least_inside", irregular.least},
          {"rings", rings}};
}

Json jsonOf(const geometry::MeetingFronts& meeting) {
  const auto part = [](const Distribution& jacobian, const VertexCount& irregular) {
    return Json{{"elements", jacobian.count},
                {"scaled_jacobian", jsonOf(jacobian)},
                {"vertices_inside", jsonOf(irregular)}};
  };
  return {{"there", part(meeting.jacobian, meeting.irregular)},
          {"elsewhere", part(meeting.jacobianElsewhere, meeting.irregularElsewhere)}};
}

Json jsonOf(const geometry::MeshShape& shape) {
  return {{"edges", shape.edges},
          {"free_edges", shape.freeEdges},
          {"non_manifold_edges", shape.nonManifoldEdges},
          {"turned_edges", shape.turnedEdges},
          {"folded_edges", shape.foldedEdges},
          {"pieces", shape.components},
          {"faces", shape.faces},
          {"regions", shape.regions},
          {"euler", shape.euler},
          {"closed", shape.isClosed()}};
}

}  // namespace

std::string measuresText(const MeshMeasures& measures) {
  std::string text =
      fmt::format("{} vertices, {} elements: {} triangles, {} quadrilaterals ({:.1f} %)\n",
                  grouped(measures.vertices), grouped(measures.elements()),
                  grouped(measures.triangles), grouped(measures.quads), 100 * measures.quadShare());
  text += fmt::format("{:<30}", "");
  for (const char* const column : {"min", "p1", "p5", "median", "mean", "p95", "p99", "max"})
    text += fmt::format("  {:>7}", column);
  text += "\n" + rowOf("quality", measures.quality) +
          rowOf("scaled Jacobian, quads", measures.quadJacobian) +
          rowOf("scaled Jacobian, triangles", measures.triangleJacobian) +
          rowOf("  where fronts meet, all", measures.meeting.jacobian) +
          rowOf("  elsewhere, all", measures.meeting.jacobianElsewhere) +
          rowOf("angles in degrees, quads", measures.quadAngles) +
          rowOf("angles in degrees, triangles", measures.triangleAngles) +
          rowOf("aspect ratio", measures.aspect) +
          rowOf(fmt::format("edge length / {}", nameOf(measures.lengthUnit)), measures.lengths) +
          rowOf("spokes off their directions", measures.spokes);
  return text + fmt::format("inverted elements              {}\n", grouped(measures.inverted)) +
         irregularText(measures.irregular) + meetingText(measures.meeting) +
         shapeText(measures.shape);
}

Json measuresJson(const MeshMeasures& measures) {
  return {
      {"vertices", measures.vertices},
      {"triangles", measures.triangles},
      {"quads", measures.quads},
      {"quad_share", measures.quadShare()},
      {"inverted", measures.inverted},
      {"quality", jsonOf(measures.quality)},
      {"scaled_jacobian",
       {{"quads", jsonOf(measures.quadJacobian)},
        {"triangles", jsonOf(measures.triangleJacobian)}}},
      {"angles",
       {{"quads", jsonOf(measures.quadAngles)}, {"triangles", jsonOf(measures.triangleAngles)}}},
      {"aspect", jsonOf(measures.aspect)},
      {"length_unit", nameOf(measures.lengthUnit)},
      {"median_length", measures.medianLength},
      {"lengths", jsonOf(measures.lengths)},
      {"spokes", jsonOf(measures.spokes)},
      {"irregular", jsonOf(measures.irregular)},
      {"fronts_meet", jsonOf(measures.meeting)},
      {"shape", jsonOf(measures.shape)}};
}

}  // namespace af2::cli
