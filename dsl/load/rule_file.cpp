#include "dsl/load/rule_file.h"

#include <algorithm>
#include <utility>

#include "dsl/load/file_compiler.h"
#include "dsl/load/intended_findings.h"
#include "dsl/load/loaded_file.h"

namespace af2::dsl {
namespace {

/// To evaluate rules, their functions, shapes and metrics must be there.
void refuseMissing(CompileContext& context, const LoadedFile& file) {
  for (const MissingName& missing : file.missing) {
    Diagnostic d = missingImplementation(missing);
    context.diagnostics.add(std::move(d));
  }
}

bool isAllowed(const Diagnostic& d, const std::vector<Code>& allowed) {
  return d.severity == Severity::Warning &&
         std::find(allowed.begin(), allowed.end(), d.code) != allowed.end();
}

}  // namespace

std::string missingText(const LoadedFile& file) {
  if (file.missing.empty()) return {};
  std::string names;
  for (const MissingName& missing : file.missing)
    names += (names.empty() ? "'" : ", '") + missing.name + "'";
  return names + (file.missing.size() == 1 ? " is" : " are") +
         " declared, but nothing implements " + (file.missing.size() == 1 ? "it" : "them") +
         "; --plugin FILE loads a library that does";
}

LoadedRules loadRulesFromText(std::string name, std::string text, const LoadOptions& options) {
  static const Registry noRegistry;
  DiagnosticList diagnostics;
  CompileContext context{diagnostics, options.registry ? *options.registry : noRegistry};
  Library library(context, options.searchPaths, options.unsaved);
  library.load(std::move(name), std::move(text));
  auto file = std::make_shared<LoadedFile>();
  LoadedRules result;
  result.rules = FileCompiler(context, library, options).compile(*file);
  if (options.externs == Externs::Registered && !file->missing.empty()) {
    refuseMissing(context, *file);
    result.rules = nullptr;
  }
  file->modules = library.takeModules();
  result.file = std::move(file);
  result.diagnostics = diagnostics.take();
  std::erase_if(result.diagnostics, [&](const Diagnostic& d) {
    return isAllowed(d, options.allowed) || isMeantToBe(*result.file, d);
  });
  return result;
}

LoadedRules loadRules(const std::filesystem::path& path, const LoadOptions& options) {
  std::string fault;
  std::optional<std::string> text = readFile(path, fault);
  if (text) return loadRulesFromText(path.string(), std::move(*text), options);
  LoadedRules result;
  Diagnostic d(Code::UnreadableFile);
  d.message = "cannot read the rule file: " + fault;
  d.place.file = path.string();
  d.help = "check the path";
  result.diagnostics.push_back(std::move(d));
  auto file = std::make_shared<LoadedFile>();
  file->modules.push_back(std::make_unique<Module>(SourceText(path.string(), "")));
  result.file = std::move(file);
  return result;
}

}  // namespace af2::dsl
