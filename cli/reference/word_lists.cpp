#include "cli/reference/word_lists.h"

namespace af2::cli {

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::vector<std::string> optionNames(const Command& command) {
  std::vector<std::string> all;
  for (const CommandOption& option : command.options)
    for (const std::string& name : option.names()) all.push_back(name);
  return all;
}

std::vector<std::string> partNames(const Command& command) {
  std::vector<std::string> names;
  for (const Command& part : command.parts) names.push_back(part.name);
  return names;
}

std::string escaped(const std::string& text, const std::string& characters) {
  std::string made;
  for (const char character : text) {
    if (characters.find(character) != std::string::npos) made += '\\';
    made += character;
  }
  return made;
}

}  // namespace af2::cli
