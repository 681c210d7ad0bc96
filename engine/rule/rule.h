// A rule: where the front looks like this pattern and this free zone is empty, add these elements.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "engine/rule/binding.h"
#include "engine/rule/free_zone.h"
#include "engine/rule/point_transform.h"

namespace af2 {

/// The quadratic form xx dx^2 + xy dx dy + yy dy^2 that measures a deviation from a reference.
struct ToleranceForm {
  double xx = 1, xy = 0, yy = 1;
  double operator()(Point2 d) const { return xx * d.x * d.x + xy * d.x * d.y + yy * d.y * d.y; }
  /// Whether a vertex or an edge may deviate by this much from what the pattern wants.
  bool allows(Point2 deviation, double tolerance) const { return (*this)(deviation) <= tolerance; }
  bool operator==(const ToleranceForm&) const = default;
};

/// A value for each quality level, usually the same for all.
template <class T>
class ByLevel {
 public:
  ByLevel(T everywhere) : values_{std::move(everywhere)} {}
  /// values  by level; [0] is level 1; the last one applies to all higher levels; at least one
  explicit ByLevel(std::vector<T> values) : values_(std::move(values)) {
    while (values_.size() > 1 && values_.back() == values_[values_.size() - 2]) values_.pop_back();
  }

  const T& at(int level) const {
    const auto index = static_cast<std::size_t>(level - 1);
    return index < values_.size() ? values_[index] : values_.back();
  }
  /// From this level on the value is constant.
  int levelCount() const { return static_cast<int>(values_.size()); }
  bool operator==(const ByLevel&) const = default;

 private:
  std::vector<T> values_;
};

using ToleranceByLevel = ByLevel<ToleranceForm>;

/// The expected position of a vertex at each quality level.
class ReferenceByLevel : public ByLevel<Point2> {
 public:
  using ByLevel::ByLevel;
  ReferenceByLevel(double x = 0, double y = 0) : ByLevel(Point2{x, y}) {}
};

/// Where a vertex is sought that has no fixed expected position: within a distance of a place that
/// is computed from the vertices matched before.
struct NearPlace {
  std::shared_ptr<const AF2PointTransform> place;
  ByLevel<double> reach;  ///< the distance, in chart units, > 0
  bool operator==(const NearPlace&) const = default;
};

/// A front vertex that the rule wants. Vertices 0 and 1 are the ends a, b of the base edge, bound
/// without a test; their reference positions are (0, 0) and (1, 0).
struct PatternVertex {
  std::string name;
  ReferenceByLevel reference;
  /// Limits the deviation by the rule set's match tolerance. Without a value any position will do,
  /// which is allowed only for vertices of a chain that leads to them from a or b.
  std::optional<ToleranceByLevel> tolerance = ToleranceForm{};
  /// With a value, it decides instead of reference and tolerance, which then describe the usual
  /// match for tools. The place may depend on vertices with smaller numbers.
  std::optional<NearPlace> near = std::nullopt;
  bool operator==(const PatternVertex&) const = default;
};

/// A front edge from -> to that the rule wants; the unmeshed region lies to its left.
struct PatternEdge {
  int from = 0, to = 0;
  std::optional<ToleranceByLevel> slope =
      std::nullopt;  ///< tolerance on the deviation of the edge vector
  bool operator==(const PatternEdge&) const = default;
};

/// A new triangle or quadrilateral, counter-clockwise. Matched vertices come first in the
/// numbering, then the new ones.
struct RuleElement {
  std::array<std::int8_t, 4> corners{-1, -1, -1, -1};
  int size() const { return corners[3] < 0 ? 3 : 4; }
  bool operator==(const RuleElement&) const = default;
};

/// A rule's act on two neighbouring edges of the front: their far ends become one vertex.
struct RuleWeld {
  int from = 0, into = 0;  ///< matched vertices; `into` remains
  std::shared_ptr<const AF2PointTransform> place;
};

/// A rule's act where no other rule applies: a path of new edges from a vertex of the front across
/// its loop to another.
struct RulePath {
  /// How many edges the path should have; the nearest number that leaves even loops is taken.
  std::shared_ptr<const AF2BindingFunction> segments;
};

/// Where a rule was written.
struct RuleSource {
  std::string file;
  int line = 0;
  bool mirrored = false;
  bool operator==(const RuleSource&) const = default;
};

/// A rule as it is written, before it is checked.
struct RuleDefinition {
  std::string name;
  int firstLevel = 1;
  std::optional<int> lastLevel;
  std::vector<PatternVertex> vertices;  ///< at least a and b
  std::vector<PatternEdge> edges;       ///< the base edge 0 -> 1 first
  std::vector<std::string> newVertexNames;
  std::vector<std::shared_ptr<const AF2PointTransform>> newVertices;
  std::shared_ptr<const AF2FreeZoneDef> zone;
  std::vector<RuleElement> elements;
  std::optional<RuleWeld> weld;  ///< of a rule without elements
  /// Of a rule without elements: from vertex 0 to vertex 2, which may be any vertex of the loop.
  std::optional<RulePath> path;
  std::vector<std::shared_ptr<const AF2BindingFunction>> requirements;  ///< all must be nonzero
  std::shared_ptr<const AF2BindingFunction> cost;  ///< added to the score; null: no cost
  int priority = 0;                                ///< ties in score go to the smaller one
  RuleSource source;
};

/// An immutable, consistent rule. Derived data is computed once.
class AF2_EXPORT AF2Rule {
 public:
  static constexpr int kMaxVertices = 12;  ///< matched and new vertices together
  static constexpr int kMaxElements = 8;

  /// Throws InputError, naming the rule, if the definition contradicts itself: unknown or repeated
  /// vertices, an element edge used twice in one direction, a base edge that is not consumed, a
  /// union of elements that does not have one boundary walk, chains that branch, a weld of vertices
  /// that are not the far ends of two neighbouring edges.
  explicit AF2Rule(RuleDefinition definition);

  const RuleDefinition& definition() const { return definition_; }
  const std::string& name() const { return definition_.name; }
  int matchedCount() const { return static_cast<int>(definition_.vertices.size()); }
  int newCount() const { return static_cast<int>(definition_.newVertices.size()); }
  int vertexCount() const { return matchedCount() + newCount(); }
  bool makesElements() const { return !definition_.weld && !definition_.path; }
  /// Of a rule with a weld: the vertex between the two edges.
  int weldMiddle() const { return weldMiddle_; }
  bool appliesAt(int level) const {
    return level >= definition_.firstLevel && level <= definition_.lastLevel.value_or(level);
  }

  /// Pattern edges on the boundary of the new elements: they leave the front.
  const std::vector<PatternEdge>& consumedEdges() const { return consumed_; }
  /// Edges that join the front: the reversed boundary of the new elements without consumed edges.
  const std::vector<PatternEdge>& newEdges() const { return new_; }
  /// The vertices between a and b of the walk a -> ... -> b around the new elements, i.e. what
  /// replaces the base edge before opposite edges cancel.
  const std::vector<std::int8_t>& replacement() const { return replacement_; }

 private:
  RuleDefinition definition_;
  std::vector<PatternEdge> consumed_, new_;
  std::vector<std::int8_t> replacement_;
  int weldMiddle_ = -1;
};

}  // namespace af2
