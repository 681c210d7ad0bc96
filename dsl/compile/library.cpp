#include "dsl/compile/library.h"

#include <algorithm>
#include <fstream>
#include <set>

#include "dsl/compile/extern_names.h"
#include "dsl/compile/standard_library.h"
#include "dsl/program/builtins.h"
#include "dsl/text/words.h"
#include "engine/base/stream_text.h"

namespace af2::dsl {

std::optional<std::string> readFile(const std::filesystem::path& path, std::string& fault) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    fault = "it is a folder";
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    fault = std::filesystem::exists(path, error) ? "it cannot be read" : "there is no such file";
    return std::nullopt;
  }
  std::string text = readRuleText(file);
  if (file.bad()) {
    fault = "it cannot be read";
    return std::nullopt;
  }
  return text;
}

std::string readRuleText(std::istream& in) { return restOf(in, ParseLimits{}.bytes + 1); }

const Module& Library::load(std::string name, std::string text) {
  modules_.push_back(std::make_unique<Module>(SourceText(std::move(name), std::move(text))));
  Module& module = *modules_.back();
  loading_.push_back(&module);
  module.parsed = parseFile(module.source, context_.diagnostics);
  for (const BrokenStretch& stretch : module.parsed.broken) {
    // Names inside a rule that could be read belong to that rule.
    const bool isInside = std::any_of(
        module.parsed.file.items.begin(), module.parsed.file.items.end(), [&](const Item& item) {
          return item.content.index() != 0 && item.span.begin <= stretch.span.begin &&
                 item.span.end >= stretch.span.end;
        });
    if (isInside) continue;
    const std::string_view written = module.source.text().substr(stretch.span.begin);
    module.hasBrokenImport =
        module.hasBrokenImport || written.starts_with("import") || written.starts_with("use");
    for (const std::string& broken : stretch.names)
      module.brokenNames.emplace(broken, stretch.span);
  }
  registerItems(module);
  loading_.pop_back();
  return module;
}

void Library::registerItems(Module& module) {
  for (const Item& item : module.parsed.file.items) {
    match(
        item.content, [&](const Import& c) { registerImport(module, c); },
        [&](const Constant& c) { registerConstant(module, c); },
        [&](const Function& c) { registerFunction(module, c.name, c.parameters, c.value, false); },
        [&](const Metric& c) { registerFunction(module, c.name, c.parameters, c.value, true); },
        [&](const Extern& c) { registerExtern(module, c); },
        [&](const Template& c) { registerTemplate(module, c); },
        // These items define no names for expressions.
        [](const AnyOf<std::monostate, Use, RuleSetBlock, Rule, Instance, Test, Property> auto&) {
        });
  }
}

bool Library::isFree(const Module& module, const Name& name, bool isFunction) {
  Span known;
  const Module* home = nullptr;
  if (isFunction) {
    if (isBuiltin(name.text)) {
      context_.tell(module, Code::DuplicateName, name.span,
                    "'" + name.text + "' is a function of the language", "choose another name");
      return false;
    }
    if (const auto f = module.functions.find(name.text); f != module.functions.end())
      known = f->second.span, home = f->second.home;
  } else {
    if (name.text == "q" || name.text == "class") {
      context_.tell(module, Code::DuplicateName, name.span,
                    "'" + name.text + "' is the quality level and cannot be given another meaning",
                    "choose another name");
      return false;
    }
    if (const auto c = module.constants.find(name.text); c != module.constants.end())
      known = c->second.span, home = c->second.home;
  }
  if (!home) return true;
  context_.tell(module, Code::DuplicateName, name.span,
                "'" + name.text + "' is given twice in this file", "choose another name",
                {{"first given here", placeOf(home->source, known)}});
  return false;
}

void Library::registerConstant(Module& module, const Constant& item) {
  ProgramBuilder builder;
  ExpressionCompiler compiler(context_, module, ExpressionPlace::Constant, Algebra(builder, {}));
  const Value value = compiler.evaluate(item.value);
  if (!isFree(module, item.name, false)) return;
  ConstantName constant;
  constant.home = &module;
  constant.span = item.name.span;
  if (item.name.text == "a" || item.name.text == "b")
    context_.tell(
        module, Code::UnusedOrHiding, item.name.span,
        "in rules '" + item.name.text + "' is an end of the base edge, never this constant",
        "choose another name");
  const auto known = [&](Node node) {
    return node < 0 ? std::optional<double>(0) : builder.constantValue(node);
  };
  const auto number = known(value.number), x = known(value.at.x), y = known(value.at.y);
  if (!value.isAny() && value.type != Type::Shape && number && x && y) {
    constant.type = value.type;
    constant.number = *number;
    constant.x = *x;
    constant.y = *y;
  } else if (value.type == Type::Shape) {
    compiler.tell(Code::WrongType, item.value.span, "a constant cannot be a shape", "",
                  "make it a `def` of the points it needs");
  }
  if (value.type == Type::Geometric && !value.isVector()) constant.type = Type::Any;
  module.constants[item.name.text] = constant;
}

void Library::registerFunction(Module& module, const Name& name,
                               const std::vector<Name>& parameters, const Expr& body,
                               bool isMetric) {
  FunctionName function{&parameters, &body, isMetric, false, &module, name.span};
  std::set<std::string_view> seen;
  for (const Name& p : parameters)
    if (!seen.insert(p.text).second)
      context_.tell(module, Code::DuplicateName, p.span,
                    "the parameter '" + p.text + "' is given twice", "choose another name");
  if (isMetric && parameters.size() < 3)
    context_.tell(module, Code::ArgumentCount, name.span, "a metric needs three or four corners",
                  "its last three or four parameters are the corners");
  DiagnosticList found;
  CompileContext quiet{found, context_.registry, context_.stepsLeft};
  quiet.guesses = context_.mayGuess();
  ProgramBuilder builder;
  // A def can be called from anywhere, so its body may use everything.
  ExpressionCompiler compiler(quiet, module,
                              isMetric ? ExpressionPlace::Metric : ExpressionPlace::Rule,
                              Algebra(builder, {}));
  compiler.fade = [&builder] { return builder.constant(1); };
  const Value result = compiler.checkBody(function);
  const auto isBadMetric = [](const Value& v) { return !v.isAny() && v.type != Type::Number; };
  if (isMetric && isBadMetric(result))
    compiler.tell(Code::WrongType, body.span, "a metric must be a number",
                  "this is " + describe(result));
  function.isBroken = found.hasErrors();
  for (Diagnostic& d : found.take()) context_.diagnostics.add(std::move(d));
  if (isFree(module, name, true)) module.functions[name.text] = function;
}

void Library::registerExtern(Module& module, const Extern& item) {
  FunctionName function{&item.parameters, nullptr,       item.kind.text == "metric", false,
                        &module,          item.name.span};
  function.external = resolveExtern(context_, module, item);
  function.isBroken = !function.external;
  const auto known = module.functions.find(item.name.text);
  const bool isImported = known != module.functions.end() && known->second.home != &module;
  if (isImported && areDeclaredAlike(known->second, function)) return;
  if (isFree(module, item.name, true)) module.functions[item.name.text] = function;
}

void Library::registerTemplate(Module& module, const Template& item) {
  const auto known = module.templates.find(item.name.text);
  if (known != module.templates.end())
    return context_.tell(
        module, Code::DuplicateName, item.name.span,
        "the template '" + item.name.text + "' is given twice in this file", "choose another name",
        {{"first given here", placeOf(known->second.home->source, known->second.span)}});
  module.templates[item.name.text] = {&item, &module, item.name.span};
}

bool Library::isThere(const std::filesystem::path& path) const {
  std::error_code error;
  return (unsaved_ && unsaved_(path)) || std::filesystem::exists(path, error);
}

std::optional<std::string> Library::read(const std::filesystem::path& path,
                                         std::string& fault) const {
  if (unsaved_)
    if (auto text = unsaved_(path)) return text;
  // Pipes and devices are not read here, because they may never end; a caller can read them and
  // pass the text.
  std::error_code error;
  const bool isSpecial = std::filesystem::exists(path, error) &&
                         !std::filesystem::is_regular_file(path, error) &&
                         !std::filesystem::is_directory(path, error);
  if (!isSpecial) return readFile(path, fault);
  fault = "it is not a regular file";
  return std::nullopt;
}

std::filesystem::path Library::findFile(const Module& from, const std::string& path) const {
  const std::filesystem::path wanted(path);
  if (wanted.is_absolute()) return wanted;
  const std::filesystem::path beside =
      std::filesystem::path(from.source.name()).parent_path() / wanted;
  if (isThere(beside)) return beside;
  for (const auto& folder : searchPaths_)
    if (isThere(folder / wanted)) return folder / wanted;
  return beside;
}

const Module* Library::import(Module& into, const Import& item) {
  const std::filesystem::path path = findFile(into, item.path.text);
  std::error_code error;
  std::string key = std::filesystem::weakly_canonical(path, error).string();
  if (error) key = path.string();
  const auto sameAs = [&](const Module* m) {
    std::error_code e;
    return std::filesystem::weakly_canonical(m->source.name(), e).string() == key;
  };
  const auto cycle = std::find_if(loading_.begin(), loading_.end(), sameAs);
  if (cycle != loading_.end()) {
    std::string chain;
    for (auto m = cycle; m != loading_.end(); ++m) chain += (*m)->source.name() + " -> ";
    context_.tell(into, Code::CircularUse, item.path.span, "this import forms a cycle",
                  "move what both files need into a third one",
                  {{"the cycle is " + chain + (*cycle)->source.name(), std::nullopt}});
    return nullptr;
  }
  if (const auto known = byPath_.find(key); known != byPath_.end()) return known->second;
  std::string fault;
  std::optional<std::string> text = read(path, fault);
  if (!text) text = standardFile(item.path.text);
  if (!text) {
    std::string chain;
    for (const Module* m : loading_) chain += m->source.name() + " -> ";
    std::vector<DiagnosticNote> notes;
    notes.push_back({"imported through " + chain + item.path.text, std::nullopt});
    context_.tell(into, Code::UnreadableFile, item.path.span,
                  "cannot import \"" + item.path.text + "\": " + fault,
                  item.path.text.find('\\') != std::string::npos
                      ? "folders are separated by '/'"
                      : "paths are relative to the folder of the importing file",
                  std::move(notes));
    return nullptr;
  }
  constexpr std::size_t kMaxFiles = 200;
  if (modules_.size() >= kMaxFiles) {
    context_.tell(into, Code::LimitExceeded, item.path.span,
                  "more than " + std::to_string(kMaxFiles) + " files are imported",
                  "join some of them");
    return nullptr;
  }
  const Module& module = load(path.lexically_normal().string(), std::move(*text));
  byPath_[key] = const_cast<Module*>(&module);
  return &module;
}

void Library::registerImport(Module& module, const Import& item) {
  const Module* imported = import(module, item);
  const std::string name =
      item.alias ? item.alias->text : std::filesystem::path(item.path.text).stem().string();
  const Span span = item.alias ? item.alias->span : item.path.span;
  if (item.alias && module.imports.contains(name))
    context_.tell(module, Code::DuplicateName, span, "'" + name + "' is given to two imports",
                  "choose another name");
  module.imports[name] = imported;
  module.hasBrokenImport = module.hasBrokenImport || (!imported && !item.alias);
  if (!imported) return;
  if (item.alias) return;
  const auto clash = [&](const std::string& text, const Module* home, Span at) {
    context_.tell(module, Code::DuplicateName, item.path.span,
                  "this import brings '" + text + "', which already exists",
                  "import it with its own name: `import \"" + item.path.text +
                      "\" as lib;`, and write lib." + text,
                  {{"first given here", placeOf(home->source, at)}});
  };
  for (const auto& [text, c] : imported->constants) {
    if (c.home != imported) continue;
    if (const auto [known, isNew] = module.constants.emplace(text, c);
        !isNew && known->second.home != c.home)
      clash(text, known->second.home, known->second.span);
  }
  for (const auto& [text, f] : imported->functions) {
    if (f.home != imported) continue;
    if (const auto [known, isNew] = module.functions.emplace(text, f);
        !isNew && known->second.home != f.home && !areDeclaredAlike(known->second, f))
      clash(text, known->second.home, known->second.span);
  }
  for (const auto& [text, t] : imported->templates)
    if (t.home == imported) module.templates.emplace(text, t);
}

}  // namespace af2::dsl
