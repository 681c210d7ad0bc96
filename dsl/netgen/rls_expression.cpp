#include "dsl/netgen/rls_expression.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace af2::dsl {
namespace {

/// A weighted sum of points plus a constant vector. It is stored twice, exactly and in doubles,
/// because the search needs the speed of doubles.
struct Sum {
  std::vector<Exact> exact;
  std::vector<double> rough;

  explicit Sum(std::vector<Exact> numbers) : exact(std::move(numbers)) {
    for (const Exact& number : exact) rough.push_back(number.convert_to<double>());
  }
};

/// The weight of a is 1 minus the other weights; its position is the origin.
Sum sumOf(const ExactMap& map) {
  const std::size_t count = map.weights[0].size() / 2;
  std::vector<Exact> numbers(count + 2);
  numbers[0] = 1;
  for (std::size_t v = 1; v < count; ++v) {
    numbers[v] = map.weights[0][2 * v];
    numbers[0] -= numbers[v];
  }
  numbers[count] = map.constant[0];
  numbers[count + 1] = map.constant[1];
  return Sum(std::move(numbers));
}

Sum combine(const Sum& one, const Exact& weight, const Sum& other, const Exact& otherWeight) {
  std::vector<Exact> numbers(one.exact.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = one.exact[i] * weight + other.exact[i] * otherWeight;
  return Sum(std::move(numbers));
}

bool isSmall(double x) { return std::abs(x) < 1e-9; }

/// The k with target = from + k * direction in the first `length` numbers.
template <class Direction>
std::optional<Exact> factor(const Sum& target, const Sum& from, const Direction& direction,
                            std::size_t length) {
  std::size_t pivot = length;
  for (std::size_t i = 0; i < length && pivot == length; ++i)
    if (!isSmall(direction.rough(i))) pivot = i;
  if (pivot == length) return std::nullopt;
  const double rough = (target.rough[pivot] - from.rough[pivot]) / direction.rough(pivot);
  for (std::size_t i = 0; i < length; ++i)
    if (!isSmall(target.rough[i] - from.rough[i] - rough * direction.rough(i))) return std::nullopt;
  const Exact k = (target.exact[pivot] - from.exact[pivot]) / direction.exact(pivot);
  for (std::size_t i = 0; i < length; ++i)
    if (target.exact[i] != from.exact[i] + k * direction.exact(i)) return std::nullopt;
  return k;
}

struct Difference {
  const Sum& from;
  const Sum& to;
  double rough(std::size_t i) const { return to.rough[i] - from.rough[i]; }
  Exact exact(std::size_t i) const { return to.exact[i] - from.exact[i]; }
};

std::string coordinates(const Exact& x, const Exact& y) {
  return "(" + numberText(x) + ", " + numberText(y) + ")";
}

/// The cost of a number: how hard it is to read.
int cost(const Exact& number) {
  const std::string text = numberText(number);
  return static_cast<int>(text.size()) + (text.find('/') != std::string::npos ? 6 : 0);
}

constexpr int kNameCost = 2;

struct Phrase {
  std::string text;
  Sum sum;
  int cost;
};

class Search {
 public:
  Search(Sum target, const std::vector<NamedPoint>& points)
      : target_(std::move(target)), weights_(target_.exact.size() - 2) {
    for (const NamedPoint& point : points) {
      if (point.map.isPointSum()) names_.push_back({point.name, sumOf(point.map), kNameCost});
    }
  }

  std::string best() {
    for (const Phrase& name : names_) offer(name);
    if (!best_.empty() && bestCost_ == kNameCost) return best_;
    parts_ = names_;
    addMiddles();
    for (std::size_t i = names_.size(); i < parts_.size(); ++i) offer(parts_[i]);
    offerParallelograms();
    offerLerps();
    offerShifts();
    offerNestedLerps();
    if (best_.empty()) offer({plainSum(), target_, 1000});
    return best_;
  }

 private:
  /// Accepts a phrase that is correct up to a constant vector, which is then appended.
  void offer(const Phrase& phrase) {
    for (std::size_t i = 0; i < weights_; ++i)
      if (!isSmall(phrase.sum.rough[i] - target_.rough[i])) return;
    for (std::size_t i = 0; i < weights_; ++i)
      if (phrase.sum.exact[i] != target_.exact[i]) return;
    const Exact dx = target_.exact[weights_] - phrase.sum.exact[weights_];
    const Exact dy = target_.exact[weights_ + 1] - phrase.sum.exact[weights_ + 1];
    const bool isExact = dx == 0 && dy == 0;
    const int price =
        phrase.cost +
        (bearsConstant(phrase) && phrase.cost > kNameCost + (isExact ? 0 : -1) ? 6 : 0) +
        (isExact ? 0 : 4 + af2::dsl::cost(dx) + af2::dsl::cost(dy));
    if (!best_.empty() && price >= bestCost_) return;
    best_ = isExact ? phrase.text : phrase.text + " + " + coordinates(dx, dy);
    bestCost_ = price;
  }

  /// Such a phrase may be correct by chance: its constant comes from a new vertex nearby.
  bool bearsConstant(const Phrase& phrase) const {
    return phrase.sum.exact[weights_] != 0 || phrase.sum.exact[weights_ + 1] != 0;
  }

  void addMiddles() {
    const Exact half(1, 2);
    const std::size_t n = names_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        parts_.push_back({"mid(" + names_[i].text + ", " + names_[j].text + ")",
                          combine(names_[i].sum, half, names_[j].sum, half), 6});
    if (n > 6) return;  // the number of subsets grows fast
    for (unsigned subset = 0; subset < (1u << n); ++subset) addCentroid(subset);
  }

  void addCentroid(unsigned subset) {
    std::vector<const Phrase*> members;
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (subset >> i & 1u) members.push_back(&names_[i]);
    if (members.size() < 3) return;
    std::vector<Exact> numbers(target_.exact.size());
    std::string text;
    for (const Phrase* member : members) {
      text += (text.empty() ? "centroid(" : ", ") + member->text;
      for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] += member->sum.exact[i];
    }
    for (Exact& number : numbers) number /= members.size();
    parts_.push_back(
        {text + ")", Sum(std::move(numbers)), 5 + 2 * static_cast<int>(members.size())});
  }

  void offerParallelograms() {
    for (const Phrase& p : names_)
      for (const Phrase& to : names_)
        for (const Phrase& from : names_) {
          if (&p == &to || &p == &from || &to == &from) continue;
          const auto k = factor(target_, p.sum, Difference{from.sum, to.sum}, weights_);
          if (!k || *k != 1) continue;
          const Sum step = combine(to.sum, 1, from.sum, -1);
          offer(
              {p.text + " + (" + to.text + " - " + from.text + ")", combine(p.sum, 1, step, 1), 8});
        }
  }

  void offerLerps() {
    for (const Phrase& p : parts_)
      for (const Phrase& q : parts_) {
        if (&p == &q) continue;
        for (std::size_t length : {weights_ + 2, weights_}) {
          const auto t = factor(target_, p.sum, Difference{p.sum, q.sum}, length);
          if (t) offerLerp(p, q, *t);
        }
      }
  }

  void offerLerp(const Phrase& p, const Phrase& q, const Exact& t) {
    const Sum sum = combine(p.sum, 1 - t, q.sum, t);
    const bool areNames = p.cost + q.cost == 2 * kNameCost;
    if (t == 2 && areNames) return offer({"2*" + q.text + " - " + p.text, sum, 7});
    offer({"lerp(" + p.text + ", " + q.text + ", " + numberText(t) + ")", sum,
           4 + p.cost + q.cost + af2::dsl::cost(t)});
  }

  void offerShifts() {
    for (const Phrase& start : parts_)
      for (const Phrase& from : names_)
        for (const Phrase& to : names_) {
          if (&from == &to) continue;
          const auto k = factor(target_, start.sum, Difference{from.sum, to.sum}, weights_);
          if (!k || *k <= 0) continue;
          const Sum step = combine(to.sum, *k, from.sum, -*k);
          const std::string times = *k == 1 ? "" : numberText(*k) + "*";
          offer({start.text + " + " + times + "(" + to.text + " - " + from.text + ")",
                 combine(start.sum, 1, step, 1),
                 7 + start.cost + (*k == 1 ? 0 : af2::dsl::cost(*k))});
        }
  }

  /// lerp(p, lerp(q, r, s), t): three points with any weights.
  void offerNestedLerps() {
    for (const Phrase& q : names_)
      for (const Phrase& r : names_) {
        if (&q == &r) continue;
        for (const Phrase& p : names_) {
          if (&p == &q || &p == &r) continue;
          const auto k = towards(p, q, r);
          if (!k) continue;
          const auto& [s, t] = *k;
          if (s <= 0 || s >= 1) continue;
          const Sum inner = combine(q.sum, 1 - s, r.sum, s);
          offer({"lerp(" + p.text + ", lerp(" + q.text + ", " + r.text + ", " + numberText(s) +
                     "), " + numberText(t) + ")",
                 combine(p.sum, 1 - t, inner, t), 14 + af2::dsl::cost(s) + af2::dsl::cost(t)});
        }
      }
  }

  /// s and t of the form above, if all three are matched points.
  std::optional<std::pair<Exact, Exact>> towards(const Phrase& p, const Phrase& q,
                                                 const Phrase& r) const {
    const auto indexOf = [&](const Phrase& name) {
      const auto i = static_cast<std::size_t>(&name - names_.data());
      return i < weights_ ? std::optional(i) : std::nullopt;
    };
    const auto i = indexOf(p), j = indexOf(q), k = indexOf(r);
    if (!i || !j || !k) return std::nullopt;
    for (std::size_t v = 0; v < weights_; ++v)
      if (v != *i && v != *j && v != *k && target_.exact[v] != 0) return std::nullopt;
    const Exact t = 1 - target_.exact[*i];
    if (t == 0) return std::nullopt;
    return std::pair(target_.exact[*k] / t, t);
  }

  std::string plainSum() const {
    std::string text = names_[0].text;
    for (std::size_t v = 1; v < weights_; ++v) {
      const Exact& w = target_.exact[v];
      if (w == 0) continue;
      const Exact size = w < 0 ? -w : w;
      text += (w < 0 ? " - " : " + ") + (size == 1 ? "" : numberText(size) + "*") + "(" +
              names_[v].text + " - " + names_[0].text + ")";
    }
    const Exact &x = target_.exact[weights_], &y = target_.exact[weights_ + 1];
    return x == 0 && y == 0 ? text : text + " + " + coordinates(x, y);
  }

  Sum target_;
  std::size_t weights_;  // how many numbers of a sum are weights of points
  std::vector<Phrase> names_, parts_;
  std::string best_;
  int bestCost_ = 0;
};

/// One coordinate, if x and y have different formulas.
std::string rowText(const ExactMap& map, std::size_t row, const std::vector<NamedPoint>& points) {
  std::string text;
  for (std::size_t i = 0; i < map.weights[row].size(); ++i) {
    const Exact& w = map.weights[row][i];
    if (w == 0) continue;
    const Exact size = w < 0 ? -w : w;
    text += text.empty() ? (w < 0 ? "-" : "") : (w < 0 ? " - " : " + ");
    text += (size == 1 ? "" : numberText(size) + "*") + points[i / 2].name + (i % 2 ? ".y" : ".x");
  }
  const Exact& constant = map.constant[row];
  if (text.empty()) return numberText(constant);
  if (constant == 0) return text;
  return text + (constant < 0 ? " - " : " + ") + numberText(constant < 0 ? -constant : constant);
}

}  // namespace

std::string numberText(const Exact& number) {
  using boost::multiprecision::cpp_int;
  cpp_int digits = numerator(number), rest = denominator(number);
  constexpr int kMaxPlaces = 60;
  int places = 0;
  for (; rest != 1 && places < kMaxPlaces && (rest % 2 == 0 || rest % 5 == 0); ++places) {
    const Exact scaled(digits * 10, rest);
    digits = numerator(scaled);
    rest = denominator(scaled);
  }
  if (rest != 1) return "(" + numerator(number).str() + "/" + denominator(number).str() + ")";
  const bool isNegative = digits < 0;
  std::string text = cpp_int(isNegative ? -digits : digits).str();
  if (places > 0) {
    if (text.size() <= static_cast<std::size_t>(places))
      text.insert(0, static_cast<std::size_t>(places) + 1 - text.size(), '0');
    text.insert(text.size() - static_cast<std::size_t>(places), 1, '.');
  }
  return (isNegative ? "-" : "") + text;
}

std::string pointExpression(const ExactMap& map, const std::vector<NamedPoint>& points) {
  for (const NamedPoint& point : points)
    if (point.map == map) return point.name;
  if (map.isPointSum()) return Search(sumOf(map), points).best();
  return points[0].name + " + (" + rowText(map, 0, points) + ", " + rowText(map, 1, points) + ")";
}

}  // namespace af2::dsl
