// The command line is wrong.
#pragma once

#include <stdexcept>

namespace af2::cli {

/// The message is one line that names the option at fault and the way out.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace af2::cli
