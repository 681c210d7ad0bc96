// Heat maps of the situations that a rule set covers.
#pragma once

#include <string>

#include "dsl/picture/canvas.h"
#include "dsl/proof/coverage.h"
#include "engine/base/export.h"

namespace af2::dsl {

/// Green: accepted at level 1; yellow to orange: at a later level; red: by no rule; white:
/// impossible situation. Returns the bytes of the file.
AF2_EXPORT std::string drawCoverage(const Coverage& coverage, const std::string& ruleSet,
                                    PictureFormat format);

}  // namespace af2::dsl
