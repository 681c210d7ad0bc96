// Pictures of single steps: a piece of front, and what one rule did there or why it was refused.
#pragma once

#include <string>
#include <vector>

#include "dsl/picture/canvas.h"
#include "dsl/run/explain.h"
#include "engine/base/export.h"
#include "engine/rule/rule_set.h"
#include "engine/step/front_piece.h"

namespace af2::dsl {

/// What is drawn besides the piece of front.
struct PieceCaption {
  std::string title;
  std::vector<std::string> lines;  ///< below the title; long lines are broken
  /// Title of the rule that is shown; empty: the rule that was applied, else the one that came
  /// farthest.
  std::string rule;
};

struct PiecePictureOptions {
  double width = 720, height = 620;  ///< in pixels
  bool names = true;                 ///< of the vertices
};

/// The front around the base edge, in the frame of the base edge. For the rule that was applied:
/// its pattern, zone, new elements and new front. For a refused rule: the vertices that it matched,
/// or most likely means, its zone, what hit the zone, and the reason in words.
///
/// names      of the vertices of the piece
/// explained  the step at this piece, from explainStep
///
/// Returns the bytes of the file. Throws InputError if there is no rule of the wanted title.
AF2_EXPORT std::string drawPiece(const RuleSet& rules, const FrontPiece& piece,
                                 const std::vector<std::string>& names,
                                 const StepExplanation& explained, const PieceCaption& caption,
                                 PictureFormat format, const PiecePictureOptions& options = {});

}  // namespace af2::dsl
