// Signature help: the parameters of the call that is being typed.
#include <algorithm>
#include <array>

#include "cli/lsp/server.h"
#include "dsl/symbols/block_context.h"
#include "dsl/symbols/word_help.h"

namespace af2::lsp {
namespace {

using dsl::Symbol;

/// "lerp(from, to, t)" with the positions of its parameters.
Json signatureOf(const std::string& usage, const std::string& meaning) {
  Json parameters = Json::array();
  const std::size_t open = usage.find('('), close = usage.rfind(')');
  if (open != std::string::npos && close != std::string::npos)
    for (std::size_t at = open + 1; at < close;) {
      const std::size_t end = std::min(usage.find(',', at), close);
      parameters.push_back({{"label", {at, end}}});
      at = end + 1;
      while (at < close && usage[at] == ' ') ++at;
    }
  Json signature{{"label", usage}, {"parameters", std::move(parameters)}};
  if (!meaning.empty()) signature["documentation"] = meaning;
  return signature;
}

std::string parametersOf(const std::vector<dsl::Name>& names) {
  std::string text;
  for (const dsl::Name& name : names) text += (text.empty() ? "" : ", ") + name.text;
  return "(" + text + ")";
}

std::optional<Json> signatureFor(const Analysis& analysis, const dsl::OpenCall& call) {
  const dsl::Module* home = &analysis.main();
  if (!call.qualifier.empty()) {
    const auto library = home->imports.find(call.qualifier);
    if (library == home->imports.end() || !library->second) return std::nullopt;
    home = library->second;
  }
  if (const auto f = home->functions.find(call.name); f != home->functions.end()) {
    const auto isIt = [&](const Symbol& s) {
      return s.home == f->second.home && s.definition == f->second.span;
    };
    const auto symbol = std::ranges::find_if(analysis.symbols.symbols(), isIt);
    const std::string doc = symbol == analysis.symbols.symbols().end() ? "" : symbol->doc;
    return signatureOf(call.name + parametersOf(*f->second.parameters), doc);
  }
  if (const auto t = home->templates.find(call.name); t != home->templates.end())
    return signatureOf(call.name + parametersOf(t->second.text->parameters), t->second.text->doc);
  const auto help = call.qualifier.empty() ? dsl::helpForBuiltin(call.name) : std::nullopt;
  if (!help) return std::nullopt;
  return signatureOf(std::string(help->usage), std::string(help->meaning));
}

std::optional<Json> signatureHelp(Session& session, const Json&, const Json& params) {
  const Place place = session.placeOf(params);
  const dsl::BlockContext context = contextAt(place.analysis->main().source, place.offset);
  if (context.isInComment || context.isInString) return Json(nullptr);
  for (auto call = context.calls.rbegin(); call != context.calls.rend(); ++call) {
    const auto signature = signatureFor(*place.analysis, *call);
    if (!signature) continue;
    std::size_t active = call->argument;
    const std::size_t count = (*signature)["parameters"].size();
    if (count > 0) active = std::min(active, count - 1);  // the last parameter may be repeated
    return Json{{"signatures", Json::array({*signature})},
                {"activeSignature", 0},
                {"activeParameter", active}};
  }
  return Json(nullptr);
}

constexpr std::array kMethods{Method{"textDocument/signatureHelp", signatureHelp}};

}  // namespace

std::span<const Method> signatureMethods() { return kMethods; }

}  // namespace af2::lsp
