#include "dsl/proof/rule_graph.h"

#include <algorithm>
#include <cmath>

#include "dsl/program/compiled_forms.h"
#include "dsl/program/shape_program.h"

namespace af2::dsl {
namespace {

double rounded(double x) { return std::round(x * 1e12) / 1e12 + 0.0; }

}  // namespace

RuleGraph::RuleGraph(const RuleSet& rules, const AF2Rule& rule, int level,
                     const MatchDomain& domain)
    : rules_(rules), rule_(rule.definition()), level_(level), domain_(domain) {
  addVertices();
  for (const auto& transform : rule_.newVertices) placed_.push_back(import(*transform));
  for (const auto& requirement : rule_.requirements) {
    const Node truth = importTruth(*requirement);
    if (truth < 0) continue;  // a condition that the graph cannot represent excludes no match
    truths_.push_back(truth);
    addConsequences(truth, facts_);
  }
  addZones();
}

// ---- nodes -------------------------------------------------------------------------------------

/// Stores the form of a node, which may be new.
Node RuleGraph::keep(Node node) {
  const auto index = static_cast<std::size_t>(node);
  if (index < forms_.size()) return node;
  forms_.resize(index + 1);
  steps_.resize(index + 1);
  const auto value = builder_.constantValue(node);
  if (value && std::isfinite(*value))
    forms_[index].constant = *value;
  else
    forms_[index].terms[node] = 1;
  return node;
}

LinearForm RuleGraph::formOf(Op op, std::span<const Node> arguments, Node node) const {
  const LinearForm own{0, {{node, 1.0}}};
  const auto value = [&](std::size_t i) {
    const auto constant = builder_.constantValue(arguments[i]);
    return constant && std::isfinite(*constant) ? constant : std::nullopt;
  };
  switch (op) {
    case Op::Add:
    case Op::Subtract:
      return sumOf(1, form(arguments[0]), op == Op::Add ? 1 : -1, form(arguments[1]));
    case Op::Negate:
      return sumOf(-1, form(arguments[0]), 0, {});
    case Op::Multiply:
      if (value(0)) return sumOf(*value(0), form(arguments[1]), 0, {});
      if (value(1)) return sumOf(*value(1), form(arguments[0]), 0, {});
      return own;
    case Op::Divide:
      if (value(1) && *value(1) != 0) return sumOf(1 / *value(1), form(arguments[0]), 0, {});
      return own;
    default:
      return own;
  }
}

Node RuleGraph::make(Op op, std::vector<Node> arguments, int index) {
  if (op == Op::Multiply) std::ranges::sort(arguments);
  const Node node = builder_.make(op, arguments, index);
  const bool isNew = static_cast<std::size_t>(node) >= forms_.size();
  keep(node);
  if (builder_.constantValue(node)) return node;
  if (isNew) {
    Step& step = steps_[static_cast<std::size_t>(node)];
    step.op = op;
    step.index = index;
    std::copy(arguments.begin(), arguments.end(), step.arguments.begin());
  }
  return nodeOf(formOf(op, arguments, node));
}

/// The unique node of an affine sum. Sums whose coefficients differ only by rounding share a node.
Node RuleGraph::nodeOf(const LinearForm& form) {
  if (form.terms.empty()) return constant(form.constant);
  if (form.constant == 0 && form.terms.size() == 1 && form.terms.begin()->second == 1)
    return form.terms.begin()->first;
  std::vector<std::pair<Node, double>> key{{-1, rounded(form.constant)}};
  for (const auto& [node, c] : form.terms) key.push_back({node, rounded(c)});
  const auto known = sums_.find(key);
  if (known != sums_.end()) return known->second;
  Node sum = -1;
  for (const auto& [node, c] : form.terms) {
    const Node term = c == 1 ? node : keep(builder_.multiply(constant(c), node));
    sum = sum < 0 ? term : keep(builder_.add(sum, term));
  }
  if (form.constant != 0) sum = keep(builder_.add(sum, constant(form.constant)));
  forms_[static_cast<std::size_t>(sum)] = form;
  sums_[std::move(key)] = sum;
  return sum;
}

NodePair RuleGraph::between(NodePair p, NodePair q, double t) {
  const Node share = constant(t), rest = constant(1 - t);
  return {add(multiply(rest, p.x), multiply(share, q.x)),
          add(multiply(rest, p.y), multiply(share, q.y))};
}

Node RuleGraph::cross(NodePair u, NodePair v) {
  return subtract(multiply(u.x, v.y), multiply(u.y, v.x));
}

Node RuleGraph::dot(NodePair u, NodePair v) { return add(multiply(u.x, v.x), multiply(u.y, v.y)); }

Node RuleGraph::turn(NodePair p, NodePair q, NodePair r) {
  if (p == q || q == r || r == p) return constant(0);
  // The same form for all cyclic orders of the three points.
  const auto first = [](NodePair a, NodePair b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  while (first(q, p) || first(r, p)) {
    const NodePair last = p;
    p = q;
    q = r;
    r = last;
  }
  return cross(difference(q, p), difference(r, p));
}

// ---- import ------------------------------------------------------------------------------------

/// The vector from a chain vertex to its neighbour.
NodePair RuleGraph::toPrevious(int vertex, bool isPrevious) {
  for (const PatternEdge& edge : rule_.edges) {
    const int here = isPrevious ? edge.to : edge.from, there = isPrevious ? edge.from : edge.to;
    if (here == vertex)
      return difference(placed_[static_cast<std::size_t>(there)],
                        placed_[static_cast<std::size_t>(vertex)]);
  }
  return {};
}

Node RuleGraph::importStep(const Step& step, const std::vector<Node>& imported) {
  const auto argument = [&](std::size_t i) {
    return imported[static_cast<std::size_t>(step.arguments[i])];
  };
  const auto point = [&](std::size_t i) { return NodePair{argument(2 * i), argument(2 * i + 1)}; };
  // The same function of the same nodes has the same value, whatever it is.
  const auto unknown = [&] {
    Step of = step;
    for (Node& node : of.arguments)
      if (node >= 0) node = imported[static_cast<std::size_t>(node)];
    const auto [at, isNew] = unknowns_.try_emplace(of.key());
    if (isNew) at->second = make(Op::Unknown, {}, static_cast<int>(unknowns_.size()));
    return at->second;
  };
  switch (step.op) {
    case Op::Constant:
      return constant(step.constant);
    case Op::CoordinateX:
      return placed_[static_cast<std::size_t>(step.index)].x;
    case Op::CoordinateY:
      return placed_[static_cast<std::size_t>(step.index)].y;
    case Op::Level:
      return constant(level_);
    case Op::SizeAt:
      return constant(1);
    case Op::Turn: {
      const NodePair next = toPrevious(step.index, false), previous = toPrevious(step.index, true);
      if (next.x < 0 || previous.x < 0) return unknown();
      return make(Op::Sweep, {next.x, next.y, previous.x, previous.y});
    }
    case Op::LeftTurn:
      return make(Op::Less, {constant(0), turn(point(0), point(1), point(2))});
    case Op::NotRightTurn:
      return make(Op::LessEqual, {constant(0), turn(point(0), point(1), point(2))});
    default:
      break;
  }
  const Operation& operation = operationOf(step.op);
  const bool isFact = operation.needs == Needs::Front && operation.arguments == 0;
  if (!isFact && !isArithmetic(step.op)) return unknown();
  std::vector<Node> arguments;
  for (int i = 0; i < operation.arguments; ++i)
    arguments.push_back(argument(static_cast<std::size_t>(i)));
  return make(step.op, std::move(arguments), isFact ? step.index : 0);
}

std::vector<Node> RuleGraph::import(const Program& program) {
  std::vector<Node> imported, results;
  for (const Step& step : program.steps()) imported.push_back(importStep(step, imported));
  for (const Node node : program.results())
    results.push_back(imported[static_cast<std::size_t>(node)]);
  return results;
}

NodePair RuleGraph::import(const AF2PointTransform& transform) {
  if (const auto* expression = dynamic_cast<const ExpressionTransform*>(&transform)) {
    const auto at = import(expression->program());
    return {at[0], at[1]};
  }
  const auto* affine = dynamic_cast<const AffinePointTransform*>(&transform);
  if (!affine) throw Unknown{};
  NodePair at{constant(affine->constant().x), constant(affine->constant().y)};
  const auto plus = [&](Node sum, double c, Node node) {
    return c == 0 ? sum : add(sum, multiply(constant(c), node));
  };
  for (const auto& term : affine->terms()) {
    const NodePair v = placed_[static_cast<std::size_t>(term.vertex)];
    at.x = plus(plus(at.x, term.xx, v.x), term.xy, v.y);
    at.y = plus(plus(at.y, term.yx, v.x), term.yy, v.y);
  }
  return at;
}

Node RuleGraph::importTruth(const AF2BindingFunction& function) {
  const auto* expression = dynamic_cast<const ExpressionFunction*>(&function);
  return expression ? import(expression->program()).front() : -1;
}

// ---- the match ---------------------------------------------------------------------------------

Interval RuleGraph::rangeOf(const PatternVertex& vertex, char axis) const {
  const double reference =
      axis == 'x' ? vertex.reference.at(level_).x : vertex.reference.at(level_).y;
  double reach = domain_.farthestVertex;
  if (vertex.near) {
    reach = 4 * domain_.farthestVertex;  // its place sets a bound as a fact
  } else if (vertex.tolerance) {
    const ToleranceForm& w = vertex.tolerance->at(level_);
    const double det = w.xx * w.yy - 0.25 * w.xy * w.xy;
    const double own = axis == 'x' ? w.xx : w.yy, other = axis == 'x' ? w.yy : w.xx;
    reach = 4 * domain_.farthestVertex;  // if the form sets no bound
    if (det > 1e-9 && own > 0)
      reach = std::min(reach, std::sqrt(rules_.matchTolerance(level_) * other / det));
    reach *= 1 + 1e-12;
  }
  return {reference - reach, reference + reach};
}

/// tolerance - (xx dx^2 + xy dx dy + yy dy^2) >= 0
void RuleGraph::addTolerance(const ToleranceForm& form, NodePair d) {
  Node sum = constant(rules_.matchTolerance(level_));
  const auto minus = [&](double w, Node p, Node q) {
    if (w != 0) sum = subtract(sum, multiply(constant(w), multiply(p, q)));
  };
  minus(form.xx, d.x, d.x);
  minus(form.xy, d.x, d.y);
  minus(form.yy, d.y, d.y);
  facts_.push_back(sum);
}

/// reach^2 - |at - place|^2 >= 0; nothing about a place that the graph cannot represent.
void RuleGraph::addNear(const NearPlace& near, NodePair at) {
  try {
    const NodePair d = difference(at, import(*near.place));
    const double reach = near.reach.at(level_);
    facts_.push_back(subtract(constant(reach * reach), dot(d, d)));
  } catch (const Unknown&) {
  }
}

void RuleGraph::addVertices() {
  const bool isScaled = rules_.definition().unit == ChartUnit::BaseLength;
  const Node zero = constant(0);
  placed_.push_back({zero, zero});
  placed_.push_back({isScaled ? constant(1) : keep(builder_.coordinate(1, 'x')), zero});
  if (!isScaled) variables_.push_back({Op::CoordinateX, 1, domain_.baseLengths});
  for (std::size_t i = 2; i < rule_.vertices.size(); ++i) {
    const PatternVertex& vertex = rule_.vertices[i];
    const int index = static_cast<int>(i);
    const NodePair at{keep(builder_.coordinate(index, 'x')), keep(builder_.coordinate(index, 'y'))};
    placed_.push_back(at);
    variables_.push_back({Op::CoordinateX, index, rangeOf(vertex, 'x')});
    variables_.push_back({Op::CoordinateY, index, rangeOf(vertex, 'y')});
    const Point2 place = vertex.reference.at(level_);
    const NodePair reference{constant(place.x), constant(place.y)};
    if (vertex.near)
      addNear(*vertex.near, at);
    else if (vertex.tolerance)
      addTolerance(vertex.tolerance->at(level_), difference(at, reference));
  }
  for (const PatternEdge& edge : rule_.edges) {
    if (!edge.slope) continue;
    const auto from = static_cast<std::size_t>(edge.from), to = static_cast<std::size_t>(edge.to);
    const Point2 reference =
        rule_.vertices[to].reference.at(level_) - rule_.vertices[from].reference.at(level_);
    addTolerance(edge.slope->at(level_),
                 difference(difference(placed_[to], placed_[from]),
                            {constant(reference.x), constant(reference.y)}));
  }
}

// ---- the zone ----------------------------------------------------------------------------------

GraphShape RuleGraph::shapeOf(const ShapeValue& shape, const std::vector<Node>& numbers,
                              std::size_t& next) {
  GraphShape result;
  result.kind = shape.kind;
  result.arcs = shape.arcs;
  for (std::size_t i = 0; i < shape.points.size(); ++i, next += 2)
    result.points.push_back({numbers[next], numbers[next + 1]});
  for (std::size_t i = 0; i < shape.numbers.size(); ++i) result.numbers.push_back(numbers[next++]);
  for (const auto& part : shape.parts) result.parts.push_back(shapeOf(*part, numbers, next));
  return result;
}

void RuleGraph::addZones() {
  if (const auto* list = dynamic_cast<const ConvexPolygonZoneDef*>(rule_.zone.get())) {
    GraphShape shape;
    const double t = list->fade(level_);
    for (const auto& corner : list->corners()) {
      const NodePair preferred = import(*corner.preferred);
      shape.points.push_back(corner.limiting ? between(import(*corner.limiting), preferred, t)
                                             : preferred);
    }
    zones_.push_back({std::move(shape), {}, {}});
  } else if (const auto* free = dynamic_cast<const ShapeZoneDef*>(rule_.zone.get())) {
    std::vector<Node> untruths;
    for (const auto& alternative : free->alternatives()) {
      const auto numbers = import(alternative.shape->program());
      std::size_t next = 0;
      GraphZone zone{shapeOf(alternative.shape->shape(), numbers, next), {}, untruths};
      const Node when = alternative.when ? importTruth(*alternative.when) : -1;
      if (when >= 0) {
        zone.truths.push_back(when);
        untruths.push_back(when);
      }
      zones_.push_back(std::move(zone));
    }
  } else {
    zones_.push_back({});
  }
}

// ---- conditions --------------------------------------------------------------------------------

void RuleGraph::addConsequences(Node truth, std::vector<Node>& facts) {
  const Step step = steps_[static_cast<std::size_t>(truth)];
  const Node a = step.arguments[0], b = step.arguments[1];
  if (step.op == Op::And) {
    addConsequences(a, facts);
    addConsequences(b, facts);
  } else if (step.op == Op::Less || step.op == Op::LessEqual) {
    facts.push_back(subtract(b, a));
    // An angle of at most a half turn means that its sides turn left, which is easier to use.
    const Step& angle = steps_[static_cast<std::size_t>(a)];
    const auto most = constantValue(b);
    constexpr double kHalfTurn = 3.141592653589793;
    if (angle.op == Op::Sweep && most && *most <= kHalfTurn)
      facts.push_back(cross({angle.arguments[0], angle.arguments[1]},
                            {angle.arguments[2], angle.arguments[3]}));
  } else if (step.op == Op::Not) {
    addOpposites(a, facts);
  }
}

void RuleGraph::addOpposites(Node untruth, std::vector<Node>& facts) {
  const Step step = steps_[static_cast<std::size_t>(untruth)];
  const Node a = step.arguments[0], b = step.arguments[1];
  if (step.op == Op::Or) {
    addOpposites(a, facts);
    addOpposites(b, facts);
  } else if (step.op == Op::Less || step.op == Op::LessEqual) {
    facts.push_back(subtract(a, b));
  } else if (step.op == Op::Not) {
    addConsequences(a, facts);
  }
}

}  // namespace af2::dsl
