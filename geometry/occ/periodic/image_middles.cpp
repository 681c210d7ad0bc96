#include "geometry/occ/periodic/image_middles.h"

#include <algorithm>
#include <map>

#include "geometry/occ/periodic/face_map.h"
#include "geometry/occ/periodic/image_mesh.h"

namespace af2::geometry {
namespace {

/// The images of the sides of a face.
class SideImages {
 public:
  explicit SideImages(const PeriodicPair& pair) {
    for (const auto& [second, first] : pair.vertices) images_[first] = second;
  }
  bool has(const SideEnds& side) const {
    return images_.contains(side.first) && images_.contains(side.second);
  }
  SideEnds of(const SideEnds& side) const {
    return std::minmax(images_.at(side.first), images_.at(side.second));
  }

 private:
  std::map<VertexId, VertexId> images_;
};

/// The same element on both faces of a pair.
struct ElementImage {
  std::size_t first, second;        ///< the elements
  std::vector<std::size_t> sideOf;  ///< by side of the first: that of the second
};

std::vector<ElementImage> elementImages(const ModelMesh& mesh, const PeriodicPair& pair) {
  const SideImages images(pair);
  const std::vector<std::size_t> first = elementsOfFace(mesh, pair.first),
                                 second = elementsOfFace(mesh, pair.second);
  std::vector<ElementImage> all;
  for (std::size_t k = 0; k < first.size(); ++k) {
    ElementImage& image = all.emplace_back(ElementImage{first[k], second[k], {}});
    const std::vector<SideEnds> there = sidesOf(mesh.elements[second[k]]);
    for (const SideEnds& side : sidesOf(mesh.elements[first[k]]))
      image.sideOf.push_back(
          static_cast<std::size_t>(std::ranges::find(there, images.of(side)) - there.begin()));
  }
  return all;
}

}  // namespace

MiddlesByFace groupedByFace(const ModelMesh& mesh, const std::vector<SideMiddles>& middles) {
  MiddlesByFace byFace;
  for (std::size_t e = 0; e < middles.size(); ++e) byFace[mesh.face[e]].push_back(middles[e]);
  return byFace;
}

void makeImagesOfMiddles(ModelMesh& mesh, const PeriodicPair& pair, MiddlesByFace& middles) {
  const FaceMap map(pair.transform);
  const SideImages images(pair);
  std::vector<SideMiddles> there;
  for (const ElementImage& image : elementImages(mesh, pair)) {
    const SideMiddles& here = middles.at(pair.first)[there.size()];
    SideMiddles& mapped = there.emplace_back();
    for (std::size_t i = 0; i < image.sideOf.size(); ++i) mapped[image.sideOf[i]] = map.at(here[i]);
  }
  middles[pair.second] = std::move(there);

  std::map<SideEnds, Point3> onEdges;
  for (const EdgeSegment& segment : mesh.segments)
    if (const SideEnds side = std::minmax(segment.from, segment.to); images.has(side))
      onEdges[images.of(side)] = map.at(segment.middle);
  for (EdgeSegment& segment : mesh.segments)
    if (const auto image = onEdges.find(std::minmax(segment.from, segment.to));
        image != onEdges.end())
      segment.middle = image->second;
}

std::vector<std::pair<SideEnds, SideEnds>> imagesOfSides(const ModelMesh& mesh) {
  std::vector<std::pair<SideEnds, SideEnds>> sides;
  for (const PeriodicPair& pair : mesh.periodic) {
    const SideImages images(pair);
    for (const std::size_t e : elementsOfFace(mesh, pair.first))
      for (const SideEnds& side : sidesOf(mesh.elements[e]))
        sides.emplace_back(side, images.of(side));
  }
  return sides;
}

void addMidsides(ModelMesh& mesh) {
  for (PeriodicPair& pair : mesh.periodic) {
    std::map<VertexId, VertexId> midsides;
    for (const ElementImage& image : elementImages(mesh, pair))
      for (std::size_t i = 0; i < image.sideOf.size(); ++i)
        midsides[mesh.midsides[image.first][i]] = mesh.midsides[image.second][image.sideOf[i]];
    for (const auto& [own, image] : midsides) pair.vertices.emplace_back(image, own);
  }
}

}  // namespace af2::geometry
