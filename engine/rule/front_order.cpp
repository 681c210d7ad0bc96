#include "engine/rule/front_order.h"

#include "engine/base/error.h"

namespace af2 {

LayeredFrontOrder::LayeredFrontOrder(int level, int layerA, int layerB)
    : level_(level), layerA_(layerA), layerB_(layerB) {
  constexpr int kMax = 1000;  // keys are small whole numbers, used as indices
  for (int c : {level, layerA, layerB})
    if (c < 0 || c > kMax)
      throw InputError("front order: the coefficients must be between 0 and 1000");
}

}  // namespace af2
