// Reads JSON files and reports every error with its place. Not installed.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// A value of a JSON file and its place. All functions throw InputError, naming file and place, if
/// the value does not have the requested type or range.
class JsonValue {
 public:
  static JsonValue readFile(const std::filesystem::path& path);

  /// Throws unless this is an object with no other keys than these.
  void expectKeys(std::initializer_list<std::string_view> keys) const;
  bool has(const std::string& key) const { return json_->contains(key); }
  JsonValue at(const std::string& key) const;
  std::vector<JsonValue> elements() const;
  /// The members of an object, in the order of the file.
  std::vector<std::pair<std::string, JsonValue>> members() const;

  double number() const;
  double size() const;  ///< a number > 0
  std::size_t count() const;
  std::vector<double> numbers() const;
  Point3 point() const;  ///< from two or three numbers

  [[noreturn]] void fail(const std::string& fault) const;

 private:
  using Json = nlohmann::ordered_json;
  JsonValue(std::shared_ptr<const Json> file, const Json* json, std::string place)
      : file_(std::move(file)), json_(json), place_(std::move(place)) {}
  JsonValue inside(const Json& json, const std::string& step) const;

  std::shared_ptr<const Json> file_;
  const Json* json_;
  std::string place_;
};

}  // namespace af2::geometry
