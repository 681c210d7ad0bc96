// One rule of Netgen as geometry, in the frame of the base edge.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dsl/netgen/rls_file.h"

namespace af2::dsl {

/// An affine function of the matched points: in each row a constant and the weights of x and y of
/// vertex v at 2v and 2v + 1. a is at (0, 0) and b is on the x axis, so the weights of both
/// coordinates of a and of y of b have no effect; they are 0 here.
struct ExactMap {
  std::array<Exact, 2> constant;
  std::array<std::vector<Exact>, 2> weights;
  bool operator==(const ExactMap&) const = default;

  /// x and y have the same weights, so that the map is a sum of points, up to the constant.
  bool isPointSum() const;
};

/// The same placement, reflected so that a and b are swapped.
ExactMap mirrored(const ExactMap& map);

using ExactForm = std::array<Exact, 3>;

struct ClassicRule {
  struct Vertex {
    Exact x, y;
    ExactForm form{1, 0, 1};
  };
  struct Edge {
    int from = 0, to = 0;
    std::optional<ExactForm> slope;
  };
  struct Corner {
    ExactMap preferred, limiting;
  };

  std::string title;
  int quality = 1;
  std::vector<Vertex> matched;  ///< a, b, then the others in the order of the file
  std::vector<Edge> edges;      ///< the base first
  std::vector<ExactMap> added;
  std::vector<Corner> zone;
  std::vector<std::vector<int>> elements;        ///< new vertices are numbered after matched ones
  std::vector<std::array<int, 3>> orientations;  ///< must not be clockwise
  Span span;                                     ///< of the name in the file
  std::vector<std::string> remarks;              ///< for readers of the imported rule
};

/// The last quality level at which Netgen uses such rules.
inline constexpr int kLastClassicLevel = 200;

/// Converts a rule, and warns about contradictions and parts without effect (I5 to I8).
ClassicRule toClassicRule(const RlsRule& rule, const SourceText& source,
                          DiagnosticList& diagnostics);

}  // namespace af2::dsl
