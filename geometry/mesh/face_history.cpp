#include "geometry/mesh/face_history.h"

#include <algorithm>
#include <utility>

namespace af2::geometry {

std::string textOf(const FillFault& fault) {
  switch (fault.kind) {
    case FillFaultKind::None:
      return "";
    case FillFaultKind::NotFilled:
      return "not filled";
    case FillFaultKind::CrossedBoundary:
      return "segments of the boundary cross";
    case FillFaultKind::TooManyElements:
      return "far more elements than fit the area: " + fault.details +
             "; either the rules let elements overlap (see 'af2 check'), or the boundary does not "
             "enclose a region";
    case FillFaultKind::TooMuchArea:
      return "elements overlap: " + fault.details +
             "; either the rules let them (see 'af2 check'), or these charts do not fit the "
             "surface";
    case FillFaultKind::TooManyCandidates:
      return "the front examined too many candidates, so it was stopped: " + fault.details;
    case FillFaultKind::FoldedInParameters:
      return "elements fold in the parameters";
    case FillFaultKind::BadParameters:
    case FillFaultKind::Stuck:
    case FillFaultKind::Unsound:
    case FillFaultKind::EveryWayFailed:
      break;
  }
  return fault.details;
}

FaceStep note(std::string details) {
  FaceStep step;
  step.details = std::move(details);
  return step;
}

FaceStep failedWay(std::string name, FillFault fault) {
  FaceStep step;
  step.kind = FaceStepKind::WayFailed;
  step.name = std::move(name);
  step.fault = std::move(fault);
  return step;
}

FaceStep failedFace(std::string reason) {
  FaceStep step = note(std::move(reason));
  step.kind = FaceStepKind::FaceFailed;
  return step;
}

FaceStep crossingElements(std::size_t pairs) {
  FaceStep step;
  step.kind = FaceStepKind::Crossings;
  step.count = pairs;
  return step;
}

FaceStep triedRemedy(std::string name, std::size_t places) {
  FaceStep step;
  step.kind = FaceStepKind::Remedy;
  step.name = std::move(name);
  step.count = places;
  return step;
}

void addNotes(const std::vector<std::string>& notes, FaceHistory& history) {
  for (const std::string& details : notes) history.push_back(note(details));
}

void addNew(FaceHistory&& steps, FaceHistory& history) {
  const std::size_t known = history.size();
  for (FaceStep& step : steps) {
    const auto end = history.begin() + static_cast<std::ptrdiff_t>(known);
    if (std::find(history.begin(), end, step) == end) history.push_back(std::move(step));
  }
}

std::string textOf(const FaceStep& step) {
  switch (step.kind) {
    case FaceStepKind::Note:
    case FaceStepKind::FaceFailed:
      break;
    case FaceStepKind::WayFailed:
      return step.name + ": " + textOf(step.fault);
    case FaceStepKind::WrongArea:
      return "the area of the elements differs from that of the face";
    case FaceStepKind::Crossings:
      return std::to_string(step.count) + " pairs of elements cross here";
    case FaceStepKind::Remedy:
      return step.name + (step.count > 0 ? " at " + std::to_string(step.count) + " places" : "");
    case FaceStepKind::BudgetSpent:
      return "not every remedy was tried: retries of failed faces have used up their budget";
  }
  return step.details;
}

std::vector<std::string> textsOf(const FaceHistory& history) {
  std::vector<std::string> texts;
  for (const FaceStep& step : history) texts.push_back(textOf(step));
  return texts;
}

}  // namespace af2::geometry
