#include "engine/optimize/ring_outline.h"

namespace af2 {

/// The side i is as long as the lines to both of its neighbours together.
std::optional<StarLines> starLines(const Outline& outline) {
  const std::size_t k = outline.size();
  if (k != 3 && k != 5) return std::nullopt;
  StarLines lines{};
  for (std::size_t i = 0; i < k; ++i) {
    int twice = 0;
    for (std::size_t step = 0; step < k; ++step)
      twice += (step % 2 == 0 ? 1 : -1) * outline[(i + 1 + 2 * step) % k].length;
    if (twice <= 0 || twice % 2 != 0) return std::nullopt;
    lines[i] = twice / 2;
  }
  return lines;
}

bool isGrid(const Outline& outline) {
  return outline.size() == 4 && outline[0].length == outline[2].length &&
         outline[1].length == outline[3].length;
}

Outline RingSides::whole() const {
  Outline outline;
  for (std::size_t i = 0; i < count(); ++i) outline.add(part(i, 0, lengthOf(i)));
  return outline;
}

std::array<Outline, 2> RingSides::partsOf(const FillingPlan::Cut& cut) const {
  std::array<Outline, 2> parts;
  parts[0].add(part(cut.from, cut.fromAt, lengthOf(cut.from)));
  for (std::size_t i = cut.from + 1; i < cut.to; ++i) parts[0].add(part(i, 0, lengthOf(i)));
  parts[0].add(part(cut.to, 0, cut.toAt));
  parts[0].add({Stretch::Line::CutBackwards, 0, cut.length});
  parts[1].add(part(cut.to, cut.toAt, lengthOf(cut.to)));
  for (std::size_t i = cut.to + 1; i < count() + cut.from; ++i)
    parts[1].add(part(i % count(), 0, lengthOf(i % count())));
  parts[1].add(part(cut.from, 0, cut.fromAt));
  parts[1].add({Stretch::Line::Cut, 0, cut.length});
  return parts;
}

}  // namespace af2
