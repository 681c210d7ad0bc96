#include "dsl/symbols/block_context.h"

#include <algorithm>

#include "dsl/syntax/lexer.h"
#include "dsl/syntax/syntax_errors.h"

namespace af2::dsl {
namespace {

using Statement = std::vector<Token>;

struct Block {
  BlockKind kind = BlockKind::File;
  Statement header;
  std::vector<Statement> statements;  ///< the complete statements
};

/// Whether a word may begin a statement on its own line, even if the previous statement has no end.
bool beginsStatement(const Token& token, BlockKind kind) {
  const bool isOpen = kind == BlockKind::Mirror || kind == BlockKind::Property;
  return token.kind == TokenKind::Name && !isOpen && findKeyword(kind, token.text);
}

BlockKind kindOf(const Statement& header) {
  if (header.empty()) return BlockKind::Meta;
  const Token& first = header.front();
  if (first.is("rule") || first.is("template")) return BlockKind::Rule;
  if (first.is("ruleset")) return BlockKind::RuleSet;
  if (first.is("test")) return BlockKind::Test;
  if (first.is("property")) return BlockKind::Property;
  return first.is("mirror") ? BlockKind::Mirror : BlockKind::Meta;
}

/// Names in the first parentheses after `from`.
void addParameters(const Statement& words, std::size_t from, std::vector<LocalName>& names) {
  std::size_t i = from;
  while (i < words.size() && !words[i].is("(")) ++i;
  for (++i; i < words.size() && !words[i].is(")"); ++i)
    if (words[i].kind == TokenKind::Name) names.push_back({words[i].text, SymbolKind::Parameter});
}

void addHeaderNames(const Statement& header, std::vector<LocalName>& names) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i].is("template") || header[i].is("for") || header[i].is("def") ||
        header[i].is("metric"))
      addParameters(header, i, names);
    const bool isVariable = header[0].is("property") && header[i].is("in") && i > 0;
    if (isVariable) names.push_back({header[i - 1].text, SymbolKind::Parameter});
  }
}

SymbolKind kindOf(NameRole role) {
  switch (role) {
    case NameRole::NewVertex:
      return SymbolKind::NewVertex;
    case NameRole::Value:
      return SymbolKind::Let;
    case NameRole::TestVertex:
      return SymbolKind::TestVertex;
    case NameRole::Vertex:
    case NameRole::ChainVertex:
    case NameRole::PlacedVertex:
    case NameRole::RuleVertex:
      return SymbolKind::Vertex;
    case NameRole::MirrorTitle:
    case NameRole::RuleTitle:
      return SymbolKind::Rule;
  }
  return SymbolKind::Vertex;
}

/// Whether the clause defines the name that is followed by `next`.
bool isDefinedBefore(const Token* next, NameRole role) {
  switch (role) {
    case NameRole::ChainVertex:
    case NameRole::TestVertex:
      return true;
    case NameRole::PlacedVertex:
      return next && next->is("(");
    case NameRole::NewVertex:
    case NameRole::Value:
      return next && next->is("=");
    case NameRole::Vertex:
    case NameRole::MirrorTitle:
    case NameRole::RuleTitle:
    case NameRole::RuleVertex:
      return false;
  }
  return false;
}

void addClauseNames(const Statement& words, BlockKind block, std::vector<LocalName>& names) {
  const Keyword* keyword = words.empty() ? nullptr : findKeyword(block, words[0].text);
  if (!keyword || !keyword->defines) return;
  int depth = 0;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i].is("(")) ++depth;
    if (words[i].is(")")) --depth;
    if (depth > 0 || words[i].kind != TokenKind::Name) continue;
    const Token* next = i + 1 < words.size() ? &words[i + 1] : nullptr;
    if (isDefinedBefore(next, *keyword->defines))
      names.push_back({words[i].text, kindOf(*keyword->defines)});
  }
}

std::string titleIn(const Statement& header, BlockKind kind) {
  std::string title;
  for (const Token& token : header) {
    if (token.kind != TokenKind::String) continue;
    title = token.text;
    if (kind != BlockKind::Property) return title;
  }
  return title;
}

class ContextReader {
 public:
  ContextReader(const SourceText& source, std::uint32_t offset)
      : source_(source), offset_(offset) {}

  BlockContext read() {
    DiagnosticList ignored;
    const TokenList words = readTokens(source_, ignored);
    context_.word = {offset_, offset_};
    for (const Comment& comment : words.comments) {
      // Directly after its last character, typing still extends the comment.
      if (comment.span.begin < offset_ && offset_ <= comment.span.end) context_.isInComment = true;
    }
    for (const Token& token : words.tokens) {
      if (token.kind == TokenKind::End || token.span.begin >= offset_) break;
      if (isBeingWritten(token)) break;
      add(token, &token);
    }
    finish();
    return std::move(context_);
  }

 private:
  bool isBeingWritten(const Token& token) {
    if (token.kind == TokenKind::String) {
      const std::string_view text = source_.text();
      const bool isClosed =
          token.span.end > token.span.begin + 1 && text[token.span.end - 1] == '"';
      context_.isInString = offset_ < token.span.end || (!isClosed && offset_ == token.span.end);
      if (context_.isInString) context_.word = {token.span.begin + 1, offset_};
      return context_.isInString;
    }
    const bool isWord = token.kind == TokenKind::Name && offset_ <= token.span.end;
    if (isWord) context_.word = {token.span.begin, offset_};
    return isWord;
  }

  void add(const Token& token, const Token* inList) {
    Block& block = blocks_.back();
    if (token.startsLine && SyntaxErrors::beginsItem(inList) && !isRuleOfTemplate(token)) {
      blocks_.assign(1, Block{});
      statement_.clear();
    } else if (token.startsLine && beginsStatement(token, block.kind) && !isRuleOfTemplate(token)) {
      endStatement();
    }
    if (token.is("{")) {
      Block inner;
      inner.kind = kindOf(statement_);
      inner.header = std::move(statement_);
      blocks_.push_back(std::move(inner));
      statement_.clear();
    } else if (token.is("}")) {
      statement_.clear();
      if (blocks_.size() > 1) blocks_.pop_back();
    } else if (token.is(";")) {
      endStatement();
    } else {
      statement_.push_back(token);
    }
  }

  bool isRuleOfTemplate(const Token& token) const {
    return token.is("rule") && !statement_.empty() && statement_[0].is("template");
  }

  void endStatement() {
    if (!statement_.empty()) blocks_.back().statements.push_back(std::move(statement_));
    statement_.clear();
  }

  void finish() {
    for (const Block& block : blocks_) {
      if (block.kind == BlockKind::File) continue;
      if (block.kind == BlockKind::Rule)
        for (const char* end : {"a", "b"}) context_.names.push_back({end, SymbolKind::Vertex});
      addHeaderNames(block.header, context_.names);
      for (const Statement& s : block.statements) addClauseNames(s, block.kind, context_.names);
      const std::string title = titleIn(block.header, block.kind);
      if (!title.empty() && block.kind != BlockKind::Mirror) context_.title = title;
    }
    context_.block = blocks_.back().kind;
    if (context_.block == BlockKind::File)
      addHeaderNames(statement_, context_.names);
    else
      addClauseNames(statement_, context_.block, context_.names);
    dropDoubles();
    findCalls();
    context_.statement = std::move(statement_);
  }

  void dropDoubles() {
    std::vector<LocalName> once;
    for (LocalName& n : context_.names)
      if (std::ranges::find(once, n.name, &LocalName::name) == once.end()) once.push_back(n);
    context_.names = std::move(once);
  }

  void findCalls() {
    std::vector<OpenCall> open;  // a plain parenthesis is a call without a name
    for (std::size_t i = 0; i < statement_.size(); ++i) {
      const Token& token = statement_[i];
      if (token.is("(")) {
        OpenCall call;
        if (i > 0 && statement_[i - 1].kind == TokenKind::Name) call.name = statement_[i - 1].text;
        if (i > 2 && statement_[i - 2].is(".")) call.qualifier = statement_[i - 3].text;
        open.push_back(std::move(call));
      } else if (token.is(")")) {
        if (!open.empty()) open.pop_back();
      } else if (token.is(",") && !open.empty()) {
        ++open.back().argument;
      }
    }
    for (OpenCall& call : open)
      if (!call.name.empty()) context_.calls.push_back(std::move(call));
  }

  const SourceText& source_;
  std::uint32_t offset_;
  BlockContext context_;
  std::vector<Block> blocks_{Block{}};
  Statement statement_;
};

}  // namespace

BlockContext contextAt(const SourceText& source, std::uint32_t offset) {
  return ContextReader(source, offset).read();
}

}  // namespace af2::dsl
