// What the playground answers to the requests of its page, apart from HTTP.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/playground/language.h"
#include "cli/playground/parameters.h"
#include "cli/playground/rule_file.h"
#include "cli/playground/turns.h"

namespace af2::playground {

class Answers {
 public:
  Answers(lsp::Surroundings surroundings, RuleFile file, bool watches);

  /// {name, path, text, version, fault, watches, keywords, domains, sizes, seconds}
  Json file() const;
  /// {version, imports}: changes with the file on disk, and with the files that it imports.
  Json state();

  // Each takes the text as the page has it. The answer is {overtaken: true} if the same page has
  // sent a newer request of this kind meanwhile; `page` and `run` say which one is newer.
  Json diagnostics(const std::string& text, const Parameters& parameters);
  Json checks(const std::string& text, const Parameters& parameters);
  Json rules(const std::string& text, const Parameters& parameters);
  Json tests(const std::string& text, const Parameters& parameters);
  /// Parameters `domain`, `size`, `color` (rule or quality) and `optimize` (0 or 1).
  Json mesh(const std::string& text, const Parameters& parameters);
  /// Parameters `line` and `character`, as the language server protocol counts them.
  Json completion(const std::string& text, const Parameters& parameters);
  Json hover(const std::string& text, const Parameters& parameters);
  /// {changed, version}; parameters `basis`, the version that was edited, and `overwrite` (0 or 1).
  Json save(const std::string& text, const Parameters& parameters);

  /// All runs stop, and those that begin later.
  void end() { turns_.end(); }

 private:
  Json askAt(const std::string& text, const Parameters& parameters, const char* method);

  lsp::Surroundings surroundings_;
  RuleFile file_;
  bool watches_;
  Language language_;
  Turns turns_;
  std::mutex saving_;
};

/// Thrown if the parameters of a request are wrong.
struct BadRequest : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace af2::playground
