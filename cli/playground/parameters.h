// The parameters of a request of the page.
#pragma once

#include <string>

namespace af2::playground {

/// By name; empty if it is not given.
class Parameters {
 public:
  virtual ~Parameters() = default;
  virtual std::string operator[](const char* name) const = 0;
};

}  // namespace af2::playground
