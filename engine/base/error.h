// The three kinds of error that are thrown; rule files report diagnostics instead
// (dsl/text/diagnostic.h).
#pragma once

#include <stdexcept>
#include <string>

#include "engine/base/export.h"

namespace af2 {

/// The caller's input is unusable; the message names the input at fault.
class AF2_EXPORT InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The surface cannot answer a query at some point, e.g. it has no normal there.
class AF2_EXPORT GeometryError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An invariant of AF2 itself does not hold: a defect of this library.
class AF2_EXPORT InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void failCheck(const char* file, int line, const char* what) {
  throw InternalError(std::string(file) + ":" + std::to_string(line) + ": " + what);
}

}  // namespace af2

/// Throws InternalError unless `condition` holds; `what` says what should hold. Always enabled.
#define AF2_CHECK(condition, what) \
  ((condition) ? void() : ::af2::failCheck(__FILE__, __LINE__, what))
