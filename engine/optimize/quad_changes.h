// What it would bring to put other elements into the place of some, where there are quadrilaterals.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/mesh_topology.h"

namespace af2 {

/// Elements that could stand in the place of others.
struct Change {
  std::vector<std::size_t> places;
  std::vector<Element> elements;
};

/// How much distortion a change may bring, which smoothing is to take away.
struct Leniency {
  double worst;        ///< distortion of a new element; more only where there was more before
  double shapeWeight;  ///< of distortion, beside angles and triangles
};

/// Chooses among changes: counts for an element its distortion and whether it is a triangle, for a
/// vertex how far the ideal angles of its elements are from filling the angle there.
class QuadChanges {
 public:
  /// See tidyQuads.
  QuadChanges(MeshTopology& topology, const std::vector<double>& anglesAtFixed,
              std::optional<std::uint16_t> closingRule);

  const MeshTopology& topology() const { return topology_; }
  std::size_t elementCount() const { return mesh().elements.size(); }
  const Element& elementAt(std::size_t e) const { return mesh().elements[e]; }
  /// The vertices of an element from one of its corners on.
  std::vector<VertexId> from(Corner c) const;

  /// Whether it may be replaced.
  bool isOpen(std::size_t e) const { return isOpen_[e]; }
  double distortionAt(std::size_t e) const { return distortion_[e]; }
  double distortionOf(const Element& element) const;
  bool isRegular(VertexId v) const { return sum_[v.value] == wanted_[v.value]; }

  /// Whether something was replaced at its vertices since it was looked at last.
  bool isNews(std::size_t e) const;
  void look(std::size_t e) { lookedAt_[e] = ++clock_; }

  /// What a change lowers the sum of all costs by, distortion left out.
  double gainOf(const Change& change) const;
  double costOfDistortion(double distortion) const;
  /// Remembers the change if it is the best since the last apply().
  void offer(Change change, const Leniency& leniency);
  /// Makes the best change that was offered; false: there was none.
  bool apply();

 private:
  const Mesh& mesh() const { return topology_.mesh(); }
  void add(const Element& element, int sign);
  void open(std::optional<std::uint16_t> closingRule);
  double costOf(VertexId v, int sum) const;

  MeshTopology& topology_;
  std::vector<int> wanted_, sum_;     ///< by vertex: the angle there, and the ideal ones in all
  std::vector<std::uint8_t> isOpen_;  ///< by element
  std::vector<double> distortion_;    ///< by element
  std::uint32_t clock_ = 0;           ///< counts looks
  std::vector<std::uint32_t> changed_, lookedAt_;  ///< by vertex, by element
  Change best_;
  double bestGain_;
  mutable std::vector<std::pair<VertexId, int>> angles_;  ///< of gainOf
};

/// An element with three or four vertices.
Element elementOf(std::span<const VertexId> ring);
/// Whether no vertex is there twice.
bool areDifferent(std::span<const VertexId> vertices);

}  // namespace af2
