// What was tried to mesh a face, and why it came to nothing; the report of the face is made from
// it. Not installed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace af2::geometry {

/// Why one way to fill a face came to nothing.
enum class FillFaultKind {
  None,                ///< it did not: the mesh is complete and sound, or the run was cancelled
  NotFilled,           ///< there was nothing to begin with, so there is nothing to report
  CrossedBoundary,     ///< segments of the boundary cross
  BadParameters,       ///< the boundary in the parameters is not a boundary
  Stuck,               ///< no rule fits at some edges of the front; the details say where
  TooManyElements,     ///< far more than the sizes let expect
  TooManyCandidates,   ///< the front examined more than it may
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

/// Empty for none.
std::string textOf(const FillFault& fault);

enum class FaceStepKind {
  Note,         ///< what the boundary is like, which holds for all that is tried with it
  WayFailed,    ///< a way to fill the face
  FaceFailed,   ///< all of them, which the details tell
  WrongArea,    ///< the elements have another area than the face
  Crossings,    ///< `count` pairs of elements cross
  Remedy,       ///< was tried at `count` places, or at the face as a whole
  BudgetSpent,  ///< other remedies would have cost too much
};

/// One thing that is known of a face or was tried on it.
struct FaceStep {
  FaceStepKind kind = FaceStepKind::Note;
  std::string name;  ///< of the way or the remedy, as their tables have it
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

/// In the order of time.
using FaceHistory = std::vector<FaceStep>;

void addNotes(const std::vector<std::string>& notes, FaceHistory& history);
/// Adds what is not yet known of the face.
void addNew(FaceHistory&& steps, FaceHistory& history);

std::string textOf(const FaceStep& step);
std::vector<std::string> textsOf(const FaceHistory& history);

}  // namespace af2::geometry
