// Writes a piece of front as a `test` block of the rule language.
#pragma once

#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/step/front_piece.h"

namespace af2::dsl {

struct PieceTest {
  std::string title;
  std::string remark;       ///< lines of a comment above the test; may be empty
  std::string expectation;  ///< after `expect `, without the semicolon
};

/// Names for the vertices of a piece: a and b for the base edge, p1, p2, ... for the others in the
/// order in which the test mentions them.
AF2_EXPORT std::vector<std::string> vertexNamesOf(const FrontPiece& piece);

/// The beginning of a rule file that takes over the rules of another file, for tests to follow.
AF2_EXPORT std::string testFileHead(const std::string& ruleFile, const std::string& ruleSet);

/// Coordinates are written with all digits, so that the test has exactly this piece of front.
AF2_EXPORT std::string testTextOf(const FrontPiece& piece, const PieceTest& test);

}  // namespace af2::dsl
