// Functions, metrics and zone shapes of one's own, written in C++ and called from rule files by
// name.
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

/// A function of numbers. Points are handed over as two numbers, x and y.
struct UserFunction {
  std::string name;
  /// One letter for each argument: n number, a angle in radians, p point, v vector. At most eight
  /// numbers in all.
  std::string parameters;
  char result = 'n';  ///< n, a, or t for a truth value
  /// Nothing: no value at this match. Must be pure.
  std::function<std::optional<double>(std::span<const double>)> value;
};

/// A zone shape: makes a zone from the numbers that the rule hands over.
struct UserShape {
  std::string name;
  std::string parameters;  ///< as for functions
  std::function<AF2FreeZoneDef::Made(std::span<const double>)> make;
};

/// What rule files may call beyond the language. Names must not be those of built-in functions.
class AF2_EXPORT Registry {
 public:
  /// Each throws InputError on a name that is taken or no name, or on unknown letters.
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
