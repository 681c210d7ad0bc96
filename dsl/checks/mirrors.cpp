// M1, M2: mirror images.
#include "dsl/checks/checks.h"

namespace af2::dsl {

void checkMirrors(const CheckedRules&, Findings&) {}

}  // namespace af2::dsl
