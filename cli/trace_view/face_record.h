// What happened on one face of a run, in the order of time, for `af2 trace view`.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "engine/base/point.h"
#include "engine/optimize/finish_observer.h"

namespace af2::cli {

inline constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();

/// One step, the smoothing of a row, or one change after the front.
struct ViewEvent {
  /// Changes after the front have the value kFirstAct + FinishAct::Kind.
  enum Kind : std::uint8_t {
    kRefused,
    kApplied,
    kClosedWithoutRule,
    kTurnedRound,  ///< inverted elements were turned round before the front was finished
    kRow,
    kFirstAct
  };

  std::uint8_t kind = kRefused, level = 0;
  std::int32_t front = 0;
  std::int32_t rule = -1;       ///< kApplied: index in the rule set
  std::int32_t chart = -1;      ///< of a step: index of its chart; -1: the record has none
  std::uint32_t from = 0;       ///< of the base edge; else the vertex that moved or vanished
  std::uint32_t to = 0;         ///< of the base edge
  std::uint32_t moves = 0;      ///< how many vertices move
  float before = 0, after = 0;  ///< score and edges of the front; else the worst badness
};

/// Element or part of the mesh that existed for some time.
struct ViewElement {
  std::array<std::uint32_t, 4>
      corners{};                ///< vertices of the record; a triangle has kNoVertex last
  std::int32_t birth = 0;       ///< the event that made it
  std::int32_t death = kNever;  ///< the event that removed it
  static constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
};

/// A region, one of the pieces of a large region, or another attempt at one of them.
struct ViewFront {
  enum class Kept { Unknown, No, Yes };

  std::size_t firstVertex = 0, vertexCount = 0;  ///< of its mesh
  std::size_t given = 0;                         ///< the first vertices, which were given to it
  std::int32_t firstEvent = 0;
  std::size_t edgesLeft = 0;
  bool isFinished = false;     ///< whether changes after the front were seen
  std::vector<Point3> places;  ///< of the vertices of its mesh, at the end
  Kept kept = Kept::Unknown;   ///< whether the mesh of the face consists of its elements
};

struct FaceRecord {
  int face = 0;
  std::vector<ViewFront> fronts;
  std::vector<ViewEvent> events;
  std::vector<ViewElement> elements;
  std::vector<Point3> vertices;      ///< of one front after the other, where they were made
  std::vector<std::uint32_t> moved;  ///< the vertices that move, event by event
  std::vector<Point3> moves;         ///< where each of them moves
  std::vector<std::string> charts;   ///< of steps, see stepChart
  bool missesChanges = false;        ///< whether changes could not be assigned to a front
};

}  // namespace af2::cli
