// Numbers in a STEP file that cannot be meant.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace af2::geometry {

/// The first number of each entity that no length, angle or weight can be: one above 1e100, the
/// cube of which is infinite, or what some compilers write for a result that is none, `-1.#IND`. By
/// the label of the entity, 17 for #17.
std::map<int, std::string> unusableNumbersOf(const std::filesystem::path& path);

}  // namespace af2::geometry
