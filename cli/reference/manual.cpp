#include "cli/reference/manual.h"

#include <fmt/core.h>

#include "cli/reference/word_lists.h"

namespace af2::cli {
namespace {

/// A text as it is: man takes "-" for a hyphen, and lines that begin with "." or "'" for requests.
std::string plain(const std::string& text) {
  std::string made;
  for (const char character : text) {
    if (character == '-')
      made += "\\-";
    else if (character == '\\')
      made += "\\e";
    else
      made += character;
  }
  return made.starts_with('.') || made.starts_with('\'') ? "\\&" + made : made;
}

std::string header(const std::string& name, const std::string& summary,
                   const std::string& version) {
  return fmt::format(".TH {} 1 \"\" \"af2 {}\" \"AF2\"\n.SH NAME\n{} \\- {}\n", plain(name),
                     version, plain(name), plain(summary));
}

std::string withName(const CommandOption& option, const std::string& name) {
  std::string text = "\\fB" + plain(name) + "\\fR";
  if (!option.value.name.empty()) text += " \\fI" + plain(option.value.name) + "\\fR";
  return text;
}

std::string choicesText(const CommandOption& option) {
  if (option.value.choices.empty()) return "";
  return fmt::format(" (one of {})", joined(option.value.choices, ", "));
}

std::string optionText(const CommandOption& option) {
  std::string names;
  for (const std::string& name : option.names())
    names += (names.empty() ? "" : ", ") + withName(option, name);
  if (names.empty()) names = "\\fI" + plain(option.value.name) + "\\fR";
  return ".TP\n" + names + "\n" + plain(option.description + choicesText(option)) + "\n";
}

std::string synopsisOf(const std::string& words, const Command& command) {
  std::string text = "\\fB" + plain(words) + "\\fR";
  for (const CommandOption& argument : command.arguments) {
    const std::string name =
        "\\fI" + plain(argument.value.name) + "\\fR" + (argument.isRepeatable ? "..." : "");
    text += argument.value.isOptional ? " [" + name + "]" : " " + name;
  }
  return text + " [\\fIoptions\\fR]\n";
}

std::string listOf(const std::string& title, const std::vector<CommandOption>& options) {
  if (options.empty()) return "";
  std::string text = title;
  for (const CommandOption& option : options) text += optionText(option);
  return text;
}

std::string verbPage(const Command& verb, const std::string& version) {
  const std::string words = "af2 " + verb.name;
  std::string text = header("af2-" + verb.name, verb.summary, version) + ".SH SYNOPSIS\n";
  if (verb.parts.empty()) text += synopsisOf(words, verb);
  for (const Command& part : verb.parts)
    text +=
        (&part == &verb.parts.front() ? "" : ".br\n") + synopsisOf(words + " " + part.name, part);
  text += listOf(".SH ARGUMENTS\n", verb.arguments) + listOf(".SH OPTIONS\n", verb.options);
  for (const Command& part : verb.parts) {
    text += fmt::format(".SH {}\n{}\n", plain(words + " " + part.name), plain(part.summary));
    text += listOf("", part.arguments) + listOf("", part.options);
  }
  return text + ".SH SEE ALSO\n\\fBaf2\\fR(1)\n";
}

std::string programPage(const Command& program, const std::string& version,
                        const std::string& exitCodes) {
  std::string text = header("af2", "mesh surfaces with an advancing front", version);
  text += ".SH SYNOPSIS\n\\fBaf2\\fR \\fIVERB\\fR ...\n.SH DESCRIPTION\n" + plain(program.summary) +
          "\n.SH VERBS\n";
  for (const Command& verb : program.parts)
    text += fmt::format(".TP\n\\fBaf2\\-{}\\fR(1)\n{}\n", plain(verb.name), plain(verb.summary));
  text += listOf(".SH OPTIONS\n", program.options);
  return text + ".SH EXIT STATUS\n" + plain(exitCodes) + "\n";
}

}  // namespace

std::vector<ManualPage> manualPages(const Command& program, const std::string& version,
                                    const std::string& exitCodes) {
  std::vector<ManualPage> pages{{"af2", programPage(program, version, exitCodes)}};
  for (const Command& verb : program.parts)
    pages.push_back({"af2-" + verb.name, verbPage(verb, version)});
  return pages;
}

}  // namespace af2::cli
