#include "geometry/occ/surfaces/creases.h"

#include <cmath>
#include <optional>

#include "geometry/occ/surfaces/parameter_line.h"
#include "geometry/occ/surfaces/pinches.h"
#include "geometry/occ/surfaces/surface_breaks.h"

namespace af2::geometry {

namespace {

/// Chord between unit normals: about 32 degrees, as at seams.
constexpr double kSharp = 0.55;
/// A sharp turn within this length, as a share of the wanted size, is a crease.
constexpr double kWithin = 0.06;
/// Creases nearer to each other than this share of the wanted size are one.
constexpr double kApart = 0.15;
/// Distance from a kink at which the surface is evaluated, as a share of the range of a parameter.
constexpr double kBeside = 1e-7;

/// A crease, or the same on one line across the face.
struct Crease {
  double before, at, after;
  double turn;
};

/// The creases of a face across the lines in one direction.
class CreaseFinder {
 public:
  CreaseFinder(const GeneralSurface& surface, bool isInU, const std::vector<double>& breaks,
               const SplineSurface::Box& box, double size)
      : low_(isInU ? box.u1 : box.v1), high_(isInU ? box.u2 : box.v2), size_(size) {
    for (const double b : breaks)
      if (b > low_ + 10 * beside() && b < high_ - 10 * beside()) breaks_.push_back(b);
    const double from = isInU ? box.v1 : box.u1, to = isInU ? box.v2 : box.u2;
    const auto add = [&](double share, std::vector<ParameterLine>& lines) {
      lines.emplace_back(surface, isInU, from + share * (to - from));
    };
    for (const double share : {0.06, 0.28, 0.5, 0.72, 0.94}) add(share, lines_);
    for (const double share : {0.01, 0.99}) add(share, atSides_);
    if (!(size_ > 0)) return;
    const std::vector<double> parameters = samples();
    for (const ParameterLine& line : lines_) {
      std::vector<ParameterLine::Place>& places = sampled_.emplace_back();
      for (const double at : parameters) places.push_back(line.at(at));
    }
  }

  std::vector<Stretch> stretches() const {
    std::vector<Stretch> cut = cutAtCreases();
    if (size_ > 0)
      cutAtPinches(lines_, sampled_, kPinched * size_, {low_, high_, low_, high_}, cut);
    return cut;
  }

 private:
  std::vector<Stretch> cutAtCreases() const {
    const std::vector<Crease> atKinks = kinks();
    if (!(size_ > 0)) return cutAt(atKinks, low_, high_);
    const std::vector<std::vector<Crease>> byLine = tightTurnsByLine(atKinks);
    std::vector<Crease> all = tightTurns(byLine);
    all.insert(all.end(), atKinks.begin(), atKinks.end());
    std::vector<Stretch> cut = cutAt(all, calmFrom(low_, 1, byLine), calmFrom(high_, -1, byLine));
    return areCalm(cut) ? cut : cutAt(atKinks, low_, high_);
  }

  std::vector<Stretch> cutAt(std::vector<Crease> creases, double calmLow, double calmHigh) const {
    std::ranges::sort(creases, {}, &Crease::at);
    if (!mergeNear(creases)) creases.clear();
    while (!creases.empty() && isNear(low_, creases.front().at)) {
      calmLow = std::max(calmLow, creases.front().after);
      creases.erase(creases.begin());
    }
    while (!creases.empty() && isNear(creases.back().at, high_)) {
      calmHigh = std::min(calmHigh, creases.back().before);
      creases.pop_back();
    }
    if (creases.empty() && calmLow == low_ && calmHigh == high_) return {};
    return between(creases, calmLow, calmHigh);
  }

  /// Whether turns take up little of the face; else to leave them out would leave out its shape.
  bool areCalm(const std::vector<Stretch>& stretches) const {
    constexpr double kCalm = 0.75;  // of the length
    const ParameterLine& line = lines_[lines_.size() / 2];
    return std::ranges::all_of(stretches, [&](const Stretch& stretch) {
      return line.lengthBetween(stretch.calmLow, stretch.calmHigh) >=
             kCalm * line.lengthBetween(stretch.low, stretch.high);
    });
  }

  double beside() const { return kBeside * (high_ - low_); }

  std::vector<Stretch> between(const std::vector<Crease>& creases, double calmLow,
                               double calmHigh) const {
    std::vector<Stretch> stretches{{low_, high_, calmLow, calmHigh}};
    for (const Crease& crease : creases) {
      Stretch& before = stretches.back();
      Stretch after = before;
      before.high = justBefore(crease.at, high_ - low_);
      before.calmHigh = std::max(crease.before, before.calmLow);
      after.low = crease.at;
      after.calmLow = std::min(crease.after, after.calmHigh);
      stretches.push_back(after);
    }
    return stretches;
  }

  /// Where the normal jumps, on at least some of the lines: a kink may fade out.
  std::vector<Crease> kinks() const {
    constexpr int kMin = 2;
    std::vector<Crease> found;
    for (const double b : breaks_) {
      int count = 0;
      double largest = 0;
      for (const auto* lines : {&lines_, &atSides_}) {
        for (const ParameterLine& line : *lines) {
          const double turn = turnBetween(line.at(b - beside()), line.at(b + beside()));
          largest = std::max(largest, turn);
          if (turn > kSharp) ++count;
        }
      }
      if (count >= kMin) found.push_back({b - beside(), b, b + beside(), largest});
    }
    return found;
  }

  /// The creases that are at the same parameters on most lines.
  std::vector<Crease> tightTurns(const std::vector<std::vector<Crease>>& byLine) const {
    constexpr std::size_t kMax = 20;
    std::vector<Crease> found;
    for (std::size_t i = 0; i < 2; ++i)
      for (const Crease& crease : byLine[i]) {
        const auto isKnown = [&](const Crease& c) {
          return c.before <= crease.at && crease.at <= c.after;
        };
        if (!isInside(crease) || found.size() == kMax || std::ranges::any_of(found, isKnown))
          continue;
        if (const auto all = acrossLines(crease, byLine); all && !isShort(all->at))
          found.push_back(*all);
      }
    return found;
  }

  /// Whether the face goes on beyond both sides of a turn.
  bool isInside(const Crease& crease) const { return crease.before > low_ && crease.after < high_; }

  std::optional<Crease> acrossLines(Crease crease,
                                    const std::vector<std::vector<Crease>>& byLine) const {
    double low = crease.before, high = crease.after, sum = 0;
    int count = 0;
    for (const std::vector<Crease>& ofLine : byLine) {
      const auto same = std::ranges::find_if(
          ofLine, [&](const Crease& c) { return isInside(c) && c.before < high && c.after > low; });
      if (same == ofLine.end()) continue;
      low = std::max(low, same->before);
      high = std::min(high, same->after);
      crease.before = std::min(crease.before, same->before);
      crease.after = std::max(crease.after, same->after);
      sum += same->at;
      ++count;
    }
    if (count + 1 < static_cast<int>(byLine.size())) return std::nullopt;
    crease.at = std::clamp(sum / count, low, high);
    return crease;
  }

  /// Where to look: pieces between breaks may be tiny.
  std::vector<double> samples() const {
    constexpr int kSteps = 48;
    std::vector<double> at = breaks_;
    for (int i = 1; i < kSteps; ++i) at.push_back(low_ + (high_ - low_) * i / kSteps);
    at.push_back(low_ + beside());
    at.push_back(high_ - beside());
    std::ranges::sort(at);
    return at;
  }

  std::vector<std::vector<Crease>> tightTurnsByLine(const std::vector<Crease>& kinks) const {
    std::vector<std::vector<Crease>> byLine;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      byLine.push_back(tightTurnsOn(lines_[i], sampled_[i], kinks));
    return byLine;
  }

  std::vector<Crease> tightTurnsOn(const ParameterLine& line,
                                   const std::vector<ParameterLine::Place>& sampled,
                                   const std::vector<Crease>& kinks) const {
    std::vector<Crease> found;
    std::vector<double> ends{low_};
    for (const Crease& kink : kinks) ends.push_back(kink.at);
    ends.push_back(high_);
    for (std::size_t k = 1; k < ends.size(); ++k)
      addTightTurns(line, followed(line, sampled, ends[k - 1], ends[k]), found);
    return found;
  }

  /// Places along a line between kinks, so dense that it is known where it turns.
  std::vector<ParameterLine::Place> followed(const ParameterLine& line,
                                             const std::vector<ParameterLine::Place>& sampled,
                                             double from, double to) const {
    const double shortest = 0.1 * kWithin * size_;
    std::vector<ParameterLine::Place> places{line.at(from + beside())};
    for (const ParameterLine::Place& place : sampled)
      if (place.parameter > places.back().parameter && place.parameter < to - beside())
        follow(line, place, shortest, places);
    follow(line, line.at(to - beside()), shortest, places);
    return places;
  }

  /// The windows in which the line turns most, none of which overlap.
  void addTightTurns(const ParameterLine& line, const std::vector<ParameterLine::Place>& places,
                     std::vector<Crease>& found) const {
    const auto step = [&](std::size_t i) {
      return distance(places[i].position, places[i + 1].position);
    };
    Crease best{0, 0, 0, 0};
    double length = 0;  // from `first` to `last`
    for (std::size_t first = 0, last = 0; first + 1 < places.size(); ++first) {
      for (; last + 1 < places.size() && length + step(last) <= kWithin * size_; ++last)
        length += step(last);
      const double turn = turnBetween(places[first], places[last]);
      if (best.turn > 0 && places[first].parameter > best.after) {
        addCalm(line, best, found);
        best.turn = 0;
      }
      if (turn >= kSharp && turn > best.turn)
        best =
            Crease{places[first].parameter, (places[first].parameter + places[last].parameter) / 2,
                   places[last].parameter, turn};
      if (last > first)
        length -= step(first);
      else
        last = first + 1;
    }
    if (best.turn > 0) addCalm(line, best, found);
  }

  /// Adds a crease, with the places on both sides where the surface no longer turns.
  void addCalm(const ParameterLine& line, Crease crease, std::vector<Crease>& found) const {
    const auto before = calmBeside(line, crease.before, -1);
    const auto after = calmBeside(line, crease.after, 1);
    if (!before || !after) return;
    crease.before = *before;
    crease.after = *after;
    found.push_back(crease);
  }

  /// On from a place in a crease to where the surface no longer turns as tightly, or as far as a
  /// crease may reach.
  std::optional<double> calmBeside(const ParameterLine& line, double parameter,
                                   int direction) const {
    constexpr int kSteps = 20;
    constexpr double kCalm = 0.04;  // turn in a step
    const double step = 0.25 * kWithin * size_;
    ParameterLine::Place here = line.at(parameter);
    for (int i = 0; i < kSteps; ++i) {
      const double speed = line.speedAt(here.parameter);
      if (!(speed > 0)) return std::nullopt;
      const double next = here.parameter + direction * step / speed;
      if (!(next > low_ && next < high_)) return direction > 0 ? high_ : low_;
      const ParameterLine::Place there = line.at(next);
      if (turnBetween(here, there) < kCalm) return next;
      here = there;
    }
    return std::nullopt;
  }

  /// Where the face ends in the middle of a tight turn, the end of that; else `end`.
  double calmFrom(double end, int direction, const std::vector<std::vector<Crease>>& byLine) const {
    double farthest = end;
    std::size_t count = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto calm = calmOnLine(lines_[i], end, direction, byLine[i]);
      if (!calm || !(*calm > low_ && *calm < high_)) continue;
      ++count;
      farthest = direction > 0 ? std::max(farthest, *calm) : std::min(farthest, *calm);
    }
    constexpr std::size_t kMin = 2;  // elsewhere the turn may be beyond the end
    return count < kMin || isShort(end) ? end : farthest;
  }

  /// Whether a line across is shorter than some elements, as near a pole.
  bool isShort(double parameter) const {
    constexpr double kMin = 4;  // of the size
    double sum = 0;
    for (std::size_t i = 1; i < lines_.size(); ++i)
      sum += distance(lines_[i - 1].at(parameter).position, lines_[i].at(parameter).position);
    return sum < kMin * size_;
  }

  std::optional<double> calmOnLine(const ParameterLine& line, double end, int direction,
                                   const std::vector<Crease>& turns) const {
    for (const Crease& turn : turns) {
      if (direction > 0 && isNear(low_, turn.at)) return turn.after;
      if (direction < 0 && isNear(turn.at, high_)) return turn.before;
    }
    // The rest of a turn, however small, may be next to it.
    constexpr double kStillTurns = 0.25;
    const double start = end + direction * beside();
    const double speed = line.speedAt(start);
    if (!(speed > 0)) return std::nullopt;
    const double next = start + direction * kWithin / 4 * size_ / speed;
    if (!(next > low_ && next < high_) || turnBetween(line.at(start), line.at(next)) < kStillTurns)
      return std::nullopt;
    return calmBeside(line, next, direction);
  }

  /// Between creases there is to be room for elements: those without are one, unless it would be
  /// too wide.
  bool mergeNear(std::vector<Crease>& creases) const {
    if (!(size_ > 0) || creases.empty()) return true;
    std::vector<Crease> merged;
    for (const Crease& crease : creases) {
      if (merged.empty() || !isNear(merged.back().at, crease.at)) {
        merged.push_back(crease);
        continue;
      }
      Crease& last = merged.back();
      if (crease.turn > last.turn) last.at = crease.at, last.turn = crease.turn;
      last.before = std::min(last.before, crease.before);
      last.after = std::max(last.after, crease.after);
      if (!isNear(last.before, last.after)) return false;
    }
    creases = std::move(merged);
    return true;
  }

  /// Whether there is no room for elements between two parameters.
  bool isNear(double from, double to) const {
    return lines_[lines_.size() / 2].lengthBetween(from, to) <= kApart * size_;
  }

  double low_, high_, size_;
  std::vector<double> breaks_;
  std::vector<ParameterLine> lines_, atSides_;
  std::vector<std::vector<ParameterLine::Place>> sampled_;  ///< by line, if there is a size
};

}  // namespace

FaceCells cellsOf(const GeneralSurface& surface, const Handle(Geom_Surface) & definition,
                  const SplineSurface::Box& box, double size) {
  if (!(box.u1 < box.u2 && box.v1 < box.v2)) return {};
  const GeomAdaptor_Surface adaptor(definition);
  const auto inU = breaksOf(adaptor, true, box.u1, box.u2);
  const auto inV = breaksOf(adaptor, false, box.v1, box.v2);
  FaceCells cells{CreaseFinder(surface, true, inU, box, size).stretches(),
                  CreaseFinder(surface, false, inV, box, size).stretches()};
  if (cells.u.empty() && cells.v.empty()) return {};
  if (cells.u.empty()) cells.u = {{box.u1, box.u2, box.u1, box.u2}};
  if (cells.v.empty()) cells.v = {{box.v1, box.v2, box.v1, box.v2}};
  return cells;
}

}  // namespace af2::geometry
