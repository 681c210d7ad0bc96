#include "dsl/compile/extern_names.h"

#include <array>
#include <string_view>
#include <utility>

namespace af2::dsl {
namespace {

/// The letters of the registry for the types of the language.
constexpr std::array<std::pair<char, std::string_view>, 5> kTypes{
    {{'n', "number"}, {'a', "angle"}, {'p', "point"}, {'v', "vector"}, {'t', "truth"}}};

char letterOf(std::string_view type) {
  for (const auto& [letter, word] : kTypes)
    if (word == type) return letter;
  return kTypes[0].first;
}

std::string typesText(std::string_view letters) {
  std::string text;
  for (const char given : letters)
    for (const auto& [letter, word] : kTypes)
      if (letter == given) text += (text.empty() ? "" : ", ") + std::string(word);
  return "(" + text + ")";
}

/// As it is declared: "function heat(point) : number".
std::string textOf(const UserFunction& f) {
  const std::string result = typesText({&f.result, 1});
  return "function " + f.name + typesText(f.parameters) + " : " +
         result.substr(1, result.size() - 2);
}
std::string textOf(const UserShape& s) { return "shape " + s.name + typesText(s.parameters); }

/// What is registered under a name, as it is declared; empty: nothing.
std::string registeredAs(const Registry& registry, const std::string& name) {
  if (const auto f = registry.functions().find(name); f != registry.functions().end())
    return textOf(*f->second);
  if (const auto s = registry.shapes().find(name); s != registry.shapes().end())
    return textOf(*s->second);
  return registry.metrics().contains(name) ? "metric " + name : std::string();
}

class UnknownMetric final : public AF2ElementMetric {
 public:
  std::optional<double> badness(std::span<const Point2>) const override { return std::nullopt; }
};

/// One declaration.
class Declaration {
 public:
  Declaration(CompileContext& context, const Module& module, const Extern& item)
      : context_(context), module_(module), item_(item) {
    for (const Name& type : item.parameters) letters_ += letterOf(type.text);
  }

  std::shared_ptr<const ExternName> resolve() {
    if (!isWellFormed() || !fitsTheRegistry()) return nullptr;
    auto external = std::make_shared<ExternName>();
    external->isMissing = registeredAs(context_.registry, item_.name.text).empty();
    if (external->isMissing)
      standIn(*external);
    else
      takeRegistered(*external);
    return external;
  }

 private:
  bool is(std::string_view kind) const { return item_.kind.text == kind; }

  bool isWellFormed() {
    const bool wantsList = !is("metric"), wantsResult = is("function");
    if (item_.hasList != wantsList || item_.result.has_value() != wantsResult)
      return tell(Code::UnexpectedText,
                  is("function") ? "a function needs the types of its arguments and of its value"
                  : is("shape")  ? "a shape needs the types of its arguments, and has no value"
                                 : "a metric is declared by its name alone",
                  is("function") ? "it is written `extern function heat(point) : number;`"
                  : is("shape")  ? "it is written `extern shape egg(point, point, number);`"
                                 : "it is written `extern metric my_metric;`");
    std::size_t numbers = 0;
    for (const char letter : letters_) numbers += letter == 'p' || letter == 'v' ? 2 : 1;
    if (numbers <= kMaxNumbers) return true;
    return tell(Code::ArgumentCount, "the arguments are more than eight numbers",
                "a point or a vector counts as two");
  }

  bool fitsTheRegistry() {
    const std::string registered = registeredAs(context_.registry, item_.name.text);
    if (registered.empty() || registered == declared()) return true;
    return tell(Code::WrongType, "'" + item_.name.text + "' is registered otherwise",
                "the program or plugin registers `" + registered + "`");
  }

  bool tell(Code code, std::string message, std::string help) {
    context_.tell(module_, code, item_.name.span, std::move(message), std::move(help));
    return false;
  }

  std::string declared() const {
    if (is("function")) return textOf(function());
    return is("shape") ? textOf(shape()) : "metric " + item_.name.text;
  }

  UserFunction function() const {
    return {item_.name.text, letters_, item_.result ? letterOf(item_.result->text) : 'n',
            [](std::span<const double>) { return std::optional<double>(); }};
  }
  UserShape shape() const {
    return {item_.name.text, letters_, [](std::span<const double>) {
              return AF2FreeZoneDef::Made{nullptr, Refusal::NoValue};
            }};
  }

  void standIn(ExternName& external) const {
    if (is("function")) external.function = std::make_shared<const UserFunction>(function());
    if (is("shape")) external.shape = std::make_shared<const UserShape>(shape());
    if (is("metric")) external.metric = std::make_shared<const UnknownMetric>();
  }

  void takeRegistered(ExternName& external) const {
    const Registry& registry = context_.registry;
    const std::string& name = item_.name.text;
    if (is("function")) external.function = registry.functions().at(name);
    if (is("shape")) external.shape = registry.shapes().at(name);
    if (is("metric")) external.metric = registry.metrics().at(name);
  }

  static constexpr std::size_t kMaxNumbers = 8;  ///< of a registered function

  CompileContext& context_;
  const Module& module_;
  const Extern& item_;
  std::string letters_;
};

}  // namespace

bool areDeclaredAlike(const FunctionName& one, const FunctionName& other) {
  if (!one.external || !other.external) return false;
  const auto isAlike = [](const auto& a, const auto& b) {
    return a && b ? textOf(*a) == textOf(*b) : !a && !b;
  };
  return isAlike(one.external->function, other.external->function) &&
         isAlike(one.external->shape, other.external->shape) &&
         !one.external->metric == !other.external->metric;
}

std::shared_ptr<const ExternName> resolveExtern(CompileContext& context, const Module& module,
                                                const Extern& item) {
  return Declaration(context, module, item).resolve();
}

}  // namespace af2::dsl
