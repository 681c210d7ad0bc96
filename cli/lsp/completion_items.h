// The words and names that can be inserted at a place, as a list of completions.
#pragma once

#include <string>
#include <vector>

#include "cli/lsp/session.h"
#include "dsl/symbols/block_context.h"

namespace af2::lsp {

/// Kinds with the numbers of the protocol.
enum class ItemKind {
  Function = 3,
  Field = 5,
  Variable = 6,
  Class = 7,
  Module = 9,
  Value = 12,
  Keyword = 14,
  File = 17,
  Reference = 18,
  Folder = 19,
  Constant = 21,
};

/// Collects items. They are sorted by distance: names of the block, of the file, of the language,
/// then keywords.
class ItemList {
 public:
  enum class Rank { Local = 1, File = 2, Language = 3, Word = 4 };

  ItemList(const Session& session, const Place& place, const dsl::BlockContext& context);

  /// Replaces the part of the word that has been typed.
  Json& add(Rank rank, ItemKind kind, const std::string& label, const std::string& detail = {},
            const std::string& meaning = {});
  void addWords(std::span<const std::string_view> words);
  void addWords(std::initializer_list<std::string_view> words) {
    addWords(std::span(words.begin(), words.size()));
  }
  /// The keywords that may begin a clause of a block, with their meaning; with a snippet if the
  /// editor supports snippets.
  void addKeywords(dsl::BlockKind block);

  const dsl::BlockContext& context() const { return context_; }
  const Place& place() const { return place_; }
  const Session& session() const { return session_; }
  Json take() { return {{"isIncomplete", false}, {"items", std::move(items_)}}; }

 private:
  const Session& session_;
  const Place& place_;
  const dsl::BlockContext& context_;
  TextMap map_;
  Json range_;
  Json items_ = Json::array();
};

/// Titles, paths and names inside quotes.
void addInString(ItemList& list);
/// Everything that an expression may use here.
void addExpression(ItemList& list);
/// Vertices of the rule or of the test around the place.
void addVertices(ItemList& list);
/// Vertices of another rule.
void addVerticesOfRule(ItemList& list, const std::string& title);
void addImports(ItemList& list);
void addTemplates(ItemList& list);
void addMetrics(ItemList& list);
/// The names after `lib.`, or the coordinates of a point.
void addMembers(ItemList& list, const std::string& owner);

}  // namespace af2::lsp
