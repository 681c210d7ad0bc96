// Evaluates replacements of elements by others, for meshes with quadrilaterals.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"

namespace af2 {

/// Elements that could replace others.
struct Change {
  std::vector<std::size_t> places;
  std::vector<Element> elements;
};

/// How much distortion a change may add; smoothing is to reduce it later.
struct Leniency {
  double worst;        ///< largest distortion of a new element, unless an old one was worse
  double shapeWeight;  ///< weight of distortion relative to angles and triangles
};

/// Chooses among changes by their cost. An element costs its distortion, and more if it is a
/// triangle; a vertex costs the difference between the sum of its elements' ideal angles and the
/// angle there.
class QuadChanges {
 public:
  /// See tidyQuads.
  QuadChanges(MeshTopology& topology, const std::vector<double>& anglesAtFixed,
              std::optional<std::uint16_t> closingRule, ActRecorder* recorder);

  /// From now on a mesh of sound quadrilaterals alone gets no triangles.
  void keepQuads() { keepsQuads_ = !hasTriangles_; }

  const MeshTopology& topology() const { return topology_; }
  std::size_t elementCount() const { return mesh().elements.size(); }
  const Element& elementAt(std::size_t e) const { return mesh().elements[e]; }
  /// The vertices of an element, starting at one of its corners.
  std::vector<VertexId> from(Corner c) const;

  /// Whether the element may be replaced.
  bool isOpen(std::size_t e) const { return isOpen_[e]; }
  double distortionAt(std::size_t e) const { return distortion_[e]; }
  double distortionOf(const Element& element) const;
  bool isRegular(VertexId v) const { return sum_[v.value] == wanted_[v.value]; }

  /// Whether anything changed at the element's vertices since the last look.
  bool isNews(std::size_t e) const;
  void look(std::size_t e) { lookedAt_[e] = ++clock_; }

  /// How much a change lowers the sum of all costs except distortion.
  double gainOf(const Change& change) const;
  double costOfDistortion(double distortion) const;
  /// Remembers the change if it is the best since the last apply().
  void offer(Change change, const Leniency& leniency);
  /// Applies the best change that was offered; returns false if there was none.
  bool apply(FinishAct::Kind kind);

 private:
  const Mesh& mesh() const { return topology_.mesh(); }
  bool isSoundAt(std::size_t e) const { return std::isfinite(distortion_[e]); }
  void add(const Element& element, int sign);
  void open(std::optional<std::uint16_t> closingRule);
  double costOf(VertexId v, int sum) const;

  MeshTopology& topology_;
  ActRecorder* recorder_;
  bool hasTriangles_ = false, keepsQuads_ = false;
  std::vector<int> wanted_, sum_;     ///< by vertex: the angle there, the sum of ideal angles
  std::vector<std::uint8_t> isOpen_;  ///< by element
  std::vector<double> distortion_;    ///< by element
  std::uint32_t clock_ = 0;           ///< counts looks, as a time stamp
  std::vector<std::uint32_t> changed_, lookedAt_;  ///< by vertex, by element
  Change best_;
  double bestGain_;
  mutable std::vector<std::pair<VertexId, int>> angles_;  ///< temporary of gainOf
};

/// An element with three or four vertices.
Element elementOf(std::span<const VertexId> ring);
/// Whether no vertex occurs twice.
bool areDifferent(std::span<const VertexId> vertices);

}  // namespace af2
