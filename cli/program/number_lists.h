// Lists of numbers as they are typed on the command line.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace af2::cli {

/// "3,7-9" gives {3, 7, 8, 9}: sorted, without repetition, all >= 1. Throws UsageError, which names
/// `option`.
std::vector<int> parseIds(const std::string& option, const std::string& text);

/// Faces, or edges, as they are typed: "3,7-9,inlet,bolt*". What begins with a digit is a number or
/// a range.
struct FaceList {
  std::vector<int> ids;            ///< sorted, without repetition
  std::vector<std::string> names;  ///< in their order
};
FaceList parseFaces(const std::string& option, const std::string& text,
                    const std::string& what = "face");

/// Sizes by number, and by name in the order in which they were given.
struct FaceSizeList {
  std::map<int, double> byId;
  std::vector<std::pair<std::string, double>> byName;
};
/// Items such as "3,7-9=0.1" or "inlet=0.1"; a name may have '=' in it. Throws UsageError.
FaceSizeList parseFaceSizes(const std::string& option, const std::vector<std::string>& texts,
                            const std::string& what = "face");

/// A number > 0. Throws UsageError, which names `option` and says what the number is.
double parsePositive(const std::string& option, const std::string& text, const std::string& what);
double parseSize(const std::string& option, const std::string& text);

}  // namespace af2::cli
