// Choices of the page, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace af2::playground {

/// {"name", "label"} of each.
template <class Choice>
nlohmann::json choicesJson(std::span<const Choice> all) {
  nlohmann::json list = nlohmann::json::array();
  for (const Choice& choice : all)
    list.push_back({{"name", std::string(choice.name)}, {"label", std::string(choice.label)}});
  return list;
}

}  // namespace af2::playground
