// Finds invalid numbers in the text of a STEP file.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace af2::geometry {

/// The first number of each entity that cannot be a length, an angle or a weight: one above 1e100,
/// the cube of which is close to overflow, or `-1.#IND`, which some compilers write for NaN. By the
/// label of the entity, 17 for #17.
std::map<int, std::string> unusableNumbersIn(std::string_view text);

}  // namespace af2::geometry
