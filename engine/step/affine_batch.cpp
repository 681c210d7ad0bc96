#include "engine/step/affine_batch.h"

namespace af2 {

void AffineBatch::add(const AffinePointTransform& transform, int matchedCount) {
  rows.resize(static_cast<std::size_t>(matchedCount - 1));
  constantX[count] = transform.constant().x;
  constantY[count] = transform.constant().y;
  for (const AffinePointTransform::Term& t : transform.terms()) {
    if (t.vertex == 0) continue;  // a is the origin of the chart
    Row& row = rows[static_cast<std::size_t>(t.vertex - 1)];
    row.xx[count] = t.xx;
    row.yy[count] = t.yy;
    row.xy[count] = t.xy;
    row.yx[count] = t.yx;
    isMixed = isMixed || t.xy != 0 || t.yx != 0;
  }
  ++count;
}

namespace {

/// As many sums at a time as fit into registers, so that the loop only reads rows.
template <int kSlots, bool kIsMixed>
void evaluateSlots(const AffineBatch& batch, const Point2* matched, double* x, double* y) {
  double sumX[kSlots], sumY[kSlots];
  for (int k = 0; k < kSlots; ++k) sumX[k] = batch.constantX[k], sumY[k] = batch.constantY[k];
  for (const AffineBatch::Row& row : batch.rows) {
    const Point2 p = *++matched;
    for (int k = 0; k < kSlots; ++k) {
      if constexpr (kIsMixed) {
        sumX[k] += row.xx[k] * p.x + row.xy[k] * p.y;
        sumY[k] += row.yx[k] * p.x + row.yy[k] * p.y;
      } else {
        sumX[k] += row.xx[k] * p.x;
        sumY[k] += row.yy[k] * p.y;
      }
    }
  }
  for (int k = 0; k < kSlots; ++k) x[k] = sumX[k], y[k] = sumY[k];
}

template <int kSlots>
void evaluateSlots(const AffineBatch& batch, const Point2* matched, double* x, double* y) {
  if (batch.isMixed)
    evaluateSlots<kSlots, true>(batch, matched, x, y);
  else
    evaluateSlots<kSlots, false>(batch, matched, x, y);
}

}  // namespace

void AffineBatch::evaluate(const Point2* matched, double* x, double* y) const {
  static_assert(kCapacity == 8);
  if (count <= 2) return evaluateSlots<2>(*this, matched, x, y);
  if (count <= 4) return evaluateSlots<4>(*this, matched, x, y);
  if (count <= 6) return evaluateSlots<6>(*this, matched, x, y);
  evaluateSlots<8>(*this, matched, x, y);
}

}  // namespace af2
