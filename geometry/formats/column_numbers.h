// Numbers in as many columns as a format has for them.
// Not installed.
#pragma once

#include <cstddef>
#include <string>

namespace af2::geometry {

/// The shortest text that reads back as the same number; if that is longer than `columns` (at least
/// 8), the one with the most digits that is not.
std::string numberInColumns(double value, std::size_t columns);

/// The same as Nastran writes real numbers: with a decimal point, and no letter before the
/// exponent.
std::string nastranNumber(double value, std::size_t columns);

}  // namespace af2::geometry
