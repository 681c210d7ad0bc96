#include "dsl/program/registry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dsl/program/builtins.h"
#include "dsl/program/steps.h"
#include "dsl/text/characters.h"
#include "dsl/text/keywords.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

void checkParameters(const std::string& name, const std::string& parameters) {
  constexpr int kMaxNumbers = 8;
  int numbers = 0;
  for (char c : parameters) {
    if (std::string("napv").find(c) == std::string::npos)
      throw InputError("registered function '" + name + "': unknown parameter kind '" +
                       std::string(1, c) + "'; use n, a, p or v");
    numbers += c == 'p' || c == 'v' ? 2 : 1;
  }
  if (numbers > kMaxNumbers)
    throw InputError("registered function '" + name + "': more than eight numbers");
}

}  // namespace

void Registry::checkName(const std::string& name) const {
  if (!isPlainName(name) || isReserved(name) || isBuiltin(name))
    throw InputError("'" + name + "' cannot be registered: not a free name of the rule language");
  if (functions_.contains(name) || metrics_.contains(name) || shapes_.contains(name))
    throw InputError("'" + name + "' is registered already");
}

void Registry::addFunction(UserFunction function) {
  checkName(function.name);
  checkParameters(function.name, function.parameters);
  if (!function.value || std::string("nat").find(function.result) == std::string::npos)
    throw InputError("registered function '" + function.name +
                     "': result n, a or t, and a callable");
  const std::string name = function.name;
  functions_[name] = std::make_shared<const UserFunction>(std::move(function));
}

void Registry::addMetric(std::string name, std::shared_ptr<const AF2ElementMetric> metric) {
  checkName(name);
  if (!metric) throw InputError("registered metric '" + name + "': no metric is given");
  metrics_[std::move(name)] = std::move(metric);
}

void Registry::addShape(UserShape shape) {
  checkName(shape.name);
  checkParameters(shape.name, shape.parameters);
  if (!shape.make) throw InputError("registered shape '" + shape.name + "': no callable is given");
  const std::string name = shape.name;
  shapes_[name] = std::make_shared<const UserShape>(std::move(shape));
}

double call(const UserFunction& function, const std::array<Node, Step::kMaxArguments>& arguments,
            std::span<const double> values) {
  std::array<double, Step::kMaxArguments> numbers{};
  std::size_t count = 0;
  for (Node node : arguments) {
    if (node < 0) break;
    numbers[count] = values[static_cast<std::size_t>(node)];
    if (std::isnan(numbers[count])) return numbers[count];
    ++count;
  }
  return function.value({numbers.data(), count}).value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace af2::dsl
