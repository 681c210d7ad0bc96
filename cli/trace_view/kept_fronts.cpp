#include "cli/trace_view/kept_fronts.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace af2::cli {
namespace {

using Position = std::tuple<double, double, double>;

/// The vertices of a mesh; each belongs to one front at most.
class FreeVertices {
 public:
  explicit FreeVertices(const geometry::ModelMesh& mesh) {
    for (const Point3& p : mesh.vertices) all_.emplace_back(p.x, p.y, p.z);
    std::ranges::sort(all_);
    isTaken_.assign(all_.size(), false);
  }

  std::vector<std::size_t> freeAmong(std::span<const Point3> points) const {
    std::vector<std::size_t> found;
    for (const Point3& p : points) {
      const Position at(p.x, p.y, p.z);
      const auto place = std::ranges::lower_bound(all_, at);
      const auto i = static_cast<std::size_t>(place - all_.begin());
      if (place != all_.end() && *place == at && !isTaken_[i]) found.push_back(i);
    }
    return found;
  }
  void take(const std::vector<std::size_t>& places) {
    for (const std::size_t i : places) isTaken_[i] = true;
  }

 private:
  std::vector<Position> all_;
  std::vector<bool> isTaken_;
};

std::span<const Point3> innerVertices(const ViewFront& front) {
  return std::span(front.places).subspan(std::min(front.given, front.places.size()));
}

/// Those that exist at the end.
std::size_t elementsOf(const FaceRecord& record, const ViewFront& front) {
  const auto number = &front - record.fronts.data();
  return static_cast<std::size_t>(std::ranges::count_if(record.elements, [&](const auto& element) {
    return element.death == kNever &&
           record.events[static_cast<std::size_t>(element.birth)].front == number;
  }));
}

/// elements  number of those that the face has in the mesh
void mark(FaceRecord& record, std::size_t elements, FreeVertices& vertices) {
  using Kept = ViewFront::Kept;
  std::vector<ViewFront*> closed;
  bool isAnyKept = false;
  // The last of several equal attempts is the one that was kept.
  for (auto front = record.fronts.rbegin(); front != record.fronts.rend(); ++front) {
    const auto inner = innerVertices(*front);
    const auto found = vertices.freeAmong(inner);
    if (front->edgesLeft == 0 && front->kept != Kept::No) closed.push_back(&*front);
    if (front->kept == Kept::No || inner.empty()) continue;
    const bool isKept = 2 * found.size() > inner.size();
    if (isKept) vertices.take(found);
    front->kept = isKept ? Kept::Yes : Kept::No;
    isAnyKept = isAnyKept || isKept;
  }
  if (isAnyKept || closed.empty()) return;
  const auto isOfSize = [&](const ViewFront* f) { return elementsOf(record, *f) == elements; };
  if (std::ranges::count_if(closed, isOfSize) == 1)
    closed = {*std::ranges::find_if(closed, isOfSize)};
  const bool isCertain = std::ranges::all_of(closed, [&](const ViewFront* front) {
    return std::ranges::equal(front->places, closed.front()->places);
  });
  for (ViewFront& front : record.fronts) front.kept = isCertain ? Kept::No : front.kept;
  for (ViewFront* front : closed)
    front->kept = !isCertain ? Kept::Unknown : front == closed.front() ? Kept::Yes : Kept::No;
}

void endOthers(FaceRecord& record) {
  using Kept = ViewFront::Kept;
  for (ViewElement& element : record.elements) {
    const auto f =
        static_cast<std::size_t>(record.events[static_cast<std::size_t>(element.birth)].front);
    const ViewFront& front = record.fronts[f];
    const bool isDiscarded =
        front.kept == Kept::No || (front.kept == Kept::Unknown && front.edgesLeft > 0);
    if (isDiscarded && element.death == kNever && f + 1 < record.fronts.size())
      element.death = record.fronts[f + 1].firstEvent;
  }
}

}  // namespace

void markKeptFronts(const geometry::ModelMesh& mesh, std::vector<FaceRecord*>& faces) {
  FreeVertices vertices(mesh);
  for (FaceRecord* face : faces) {
    const auto report = std::ranges::find(mesh.faces, face->face, &geometry::FaceReport::id);
    mark(*face, report == mesh.faces.end() ? 0 : report->elements, vertices);
    endOthers(*face);
  }
}

}  // namespace af2::cli
