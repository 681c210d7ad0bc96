// The piece of front of a test.
#pragma once

#include <cstddef>
#include <optional>

#include "engine/step/front_piece.h"

namespace af2::dsl {

/// A chain that begins at the end of another chain continues it.
void joinChains(FrontPiece& piece);

/// The free angle at a vertex, in radians. Nothing at the ends of chains.
std::optional<double> turnAt(const FrontPiece& piece, std::size_t vertex);

}  // namespace af2::dsl
