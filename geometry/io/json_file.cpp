#include "geometry/io/json_file.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "geometry/base/words.h"

namespace af2::geometry {

JsonValue JsonValue::readFile(const std::filesystem::path& path) {
  const std::string content = contentOf(path);
  try {
    auto file = std::make_shared<const Json>(Json::parse(content));
    const Json* root = file.get();
    return {std::move(file), root, path.string() + ": "};
  } catch (const nlohmann::json::exception& error) {
    const std::string text = error.what();  // "[json.exception...] parse error at line 2, ..."
    throw InputError(path.string() + ": is not valid JSON: " + text.substr(text.find(']') + 2));
  }
}

JsonValue JsonValue::inside(const Json& json, const std::string& step) const {
  return {file_, &json, place_ + step};
}

void JsonValue::fail(const std::string& fault) const { throw InputError(place_ + fault); }

void JsonValue::expectKeys(std::initializer_list<std::string_view> keys) const {
  std::string known;
  for (const std::string_view key : keys) known += (known.empty() ? "" : ", ") + std::string(key);
  if (!json_->is_object()) fail("should be an object with " + known);
  for (const auto& [key, value] : json_->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      fail("'" + key + "' is not known here; there are: " + known);
}

JsonValue JsonValue::at(const std::string& key) const {
  if (!has(key)) fail("'" + key + "' is missing");
  return inside((*json_)[key], key + ": ");
}

std::vector<JsonValue> JsonValue::elements() const {
  if (!json_->is_array()) fail("should be a list");
  std::vector<JsonValue> values;
  for (const Json& value : *json_)
    values.push_back(inside(value, std::to_string(values.size() + 1) + ": "));
  return values;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
  if (!json_->is_object()) fail("should be an object");
  std::vector<std::pair<std::string, JsonValue>> values;
  for (const auto& [key, value] : json_->items())
    values.emplace_back(key, inside(value, key + ": "));
  return values;
}

double JsonValue::number() const {
  if (!json_->is_number()) fail("should be a number");
  return json_->get<double>();
}

double JsonValue::size() const {
  const double value = number();
  if (!(value > 0) || !std::isfinite(value)) fail("a size is a number greater than 0");
  return value;
}

std::size_t JsonValue::count() const {
  if (!json_->is_number_unsigned()) fail("should be a whole number, 0 or more");
  return json_->get<std::size_t>();
}

std::vector<double> JsonValue::numbers() const {
  std::vector<double> values;
  if (!json_->is_array()) fail("should be a list of numbers");
  values.reserve(json_->size());
  for (const Json& value : *json_) {
    if (!value.is_number()) fail("should be a list of numbers");
    values.push_back(value.get<double>());
  }
  return values;
}

Point3 JsonValue::point() const {
  const std::vector<double> x = numbers();
  if (x.size() != 2 && x.size() != 3) fail("a point has two or three coordinates");
  return {x[0], x[1], x.size() > 2 ? x[2] : 0};
}

}  // namespace af2::geometry
