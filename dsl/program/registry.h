// User-defined functions, metrics and zone shapes in C++, called from rule files by name.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "engine/base/export.h"
#include "engine/rule/element_metric.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl {

/// A function of numbers. A point is passed as two numbers, x and y.
struct UserFunction {
  std::string name;
  /// One letter for each argument: n number, a angle in radians, p point, v vector. At most eight
  /// numbers in all.
  std::string parameters;
  char result = 'n';  ///< n, a, or t for a truth value
  /// Returns nothing if there is no value at this match. Must be pure.
  std::function<std::optional<double>(std::span<const double>)> value;
};

/// A zone shape: makes a zone from the arguments in the rule.
struct UserShape {
  std::string name;
  std::string parameters;  ///< as for functions
  std::function<AF2FreeZoneDef::Made(std::span<const double>)> make;
};

/// The registered functions, metrics and shapes. Their names must differ from those of built-in
/// functions.
class AF2_EXPORT Registry {
 public:
  /// Each function throws InputError on a name that is in use or malformed, or on unknown letters.
  void addFunction(UserFunction function);
  void addMetric(std::string name, std::shared_ptr<const AF2ElementMetric> metric);
  void addShape(UserShape shape);

  const std::map<std::string, std::shared_ptr<const UserFunction>>& functions() const {
    return functions_;
  }
  const std::map<std::string, std::shared_ptr<const AF2ElementMetric>>& metrics() const {
    return metrics_;
  }
  const std::map<std::string, std::shared_ptr<const UserShape>>& shapes() const { return shapes_; }

 private:
  void checkName(const std::string& name) const;
  std::map<std::string, std::shared_ptr<const UserFunction>> functions_;
  std::map<std::string, std::shared_ptr<const AF2ElementMetric>> metrics_;
  std::map<std::string, std::shared_ptr<const UserShape>> shapes_;
};

}  // namespace af2::dsl
