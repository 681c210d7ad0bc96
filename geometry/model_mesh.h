// The mesh of a whole model: the meshes of its faces, joined at the shared vertices of their edges.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/mesh.h"
#include "engine/point.h"

namespace af2::geometry {

enum class FaceStatus { Complete, Failed, Cancelled, Skipped };

/// How the meshing of one face of the model went.
struct FaceReport {
  int id = 0;               ///< 1, 2, ... in the order of the model
  std::string name;         ///< from the file, may be empty
  std::string surfaceType;  ///< "plane", "cylinder", ...
  FaceStatus status = FaceStatus::Complete;
  std::size_t elements = 0;
  double seconds = 0;
  double area = 0;     ///< of the CAD face, model units squared
  std::string reason;  ///< where and why, when it failed
};

/// A piece of a divided model edge. `uses` is how often the faces that were asked for run along it:
/// 2 inside a closed shell and along a seam, 1 at its border.
struct EdgeSegment {
  VertexId from, to;
  int edge = 0;  ///< id of the model edge, 1, 2, ...
  int uses = 0;
  bool operator==(const EdgeSegment&) const = default;
};

/// Seconds spent in each stage of a run.
struct StageSeconds {
  double read = 0, edges = 0, surface = 0, optimize = 0, write = 0;
};

struct ModelMesh {
  std::vector<Point3> vertices;
  /// By vertex: the edge length that was asked for there, before anything spread from short edges
  /// of the model; may be empty.
  std::vector<double> wantedSizes;
  std::vector<Element> elements;
  std::vector<std::int32_t> face;   ///< by element: id of the model face
  std::vector<std::uint16_t> rule;  ///< by element: index in ruleNames
  std::vector<std::string> ruleNames;
  std::vector<EdgeSegment> segments;
  std::vector<FaceReport> faces;
  /// What the last checks found that is not on one face; empty: nothing.
  std::vector<std::string> findings;
  StageSeconds seconds;
};

}  // namespace af2::geometry
