// What was tried to mesh a face, and why it failed; the basis of its report. Not installed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace af2::geometry {

/// Why one way to fill a face failed.
enum class FillFaultKind {
  None,                ///< no failure: the mesh is complete and sound, or the run was cancelled
  NotFilled,           ///< there was nothing to start from, so there is nothing to report
  CrossedBoundary,     ///< segments of the boundary cross
  BadParameters,       ///< the boundary is invalid in the parameters
  Stuck,               ///< no rule fits at some edges of the front; the details say where
  TooManyElements,     ///< far more than expected from the sizes
  TooMuchArea,         ///< the elements have more area than the face
  TooManyCandidates,   ///< the front examined more than it is allowed
  Unsound,             ///< the mesh does not pass its checks; the details say why
  FoldedInParameters,  ///< elements fold over in the parameters
  EveryWayFailed,      ///< the details name each
};

struct FillFault {
  FillFaultKind kind = FillFaultKind::None;
  std::string details;

  bool isNone() const { return kind == FillFaultKind::None; }
  bool operator==(const FillFault&) const = default;
};

/// The message of a fault; empty for None.
std::string textOf(const FillFault& fault);

enum class FaceStepKind {
  Note,         ///< a remark on the boundary, which applies to all that is tried with it
  WayFailed,    ///< one way to fill the face
  FaceFailed,   ///< all ways, which the details list
  WrongArea,    ///< the area of the elements differs from that of the face
  Crossings,    ///< `count` pairs of elements cross
  Remedy,       ///< a remedy was tried at `count` places, or at the face as a whole
  BudgetSpent,  ///< further remedies would have cost too much
};

/// One entry of the history: a fact about a face, or something that was tried on it.
struct FaceStep {
  FaceStepKind kind = FaceStepKind::Note;
  std::string name;  ///< of the way or the remedy, as in their tables
  FillFault fault;   ///< of the way
  std::string details;
  std::size_t count = 0;

  bool operator==(const FaceStep&) const = default;
};

FaceStep note(std::string details);
FaceStep failedWay(std::string name, FillFault fault);
FaceStep failedFace(std::string reason);
FaceStep crossingElements(std::size_t pairs);
FaceStep triedRemedy(std::string name, std::size_t places);

/// In chronological order.
using FaceHistory = std::vector<FaceStep>;

void addNotes(const std::vector<std::string>& notes, FaceHistory& history);
/// Adds the steps that the history does not contain yet.
void addNew(FaceHistory&& steps, FaceHistory& history);

std::string textOf(const FaceStep& step);
std::vector<std::string> textsOf(const FaceHistory& history);

}  // namespace af2::geometry
