// Names of groups as a format allows them, each given once.
// Not installed.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace af2::geometry {

/// Which names a format can hold.
struct NameLimits {
  std::size_t longest = 80;  ///< bytes
  /// Letters, digits, hyphens and underscores only, a letter first, and capitals do not count.
  bool isWord = false;
};

class FormatNames {
 public:
  explicit FormatNames(const NameLimits& limits) : limits_(limits) {}

  /// The name that stands for `name`. What the format cannot hold becomes an underscore; a name
  /// that is taken gets a number.
  std::string add(const std::string& name);

 private:
  std::string allowed(const std::string& name) const;
  bool take(const std::string& name);

  NameLimits limits_;
  std::set<std::string> taken_;
};

}  // namespace af2::geometry
