// The table of keywords: the words that begin an item of a file or a clause of a block.
//
// A row describes a clause, except for its syntax tree, its parser and its meaning. These parts use
// the table: the recovery of the parser, "did you mean", the form that a message shows for a broken
// clause, completion and hover in editors, the TextMate grammar, and the grammar in
// docs/language.md (tests compare the last two with the table).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace af2::dsl {

/// The kind of block in which a keyword is allowed.
enum class BlockKind { File, Rule, RuleSet, Test, Property, Mirror, Meta };

/// The meaning of a name in a clause.
enum class NameRole {
  Vertex,        ///< a vertex that is defined elsewhere
  ChainVertex,   ///< the same in a chain; a vertex without a position is defined there
  PlacedVertex,  ///< defined: a vertex with its position
  NewVertex,     ///< defined: a vertex that the rule makes
  Value,         ///< defined: a name for a value
  TestVertex,    ///< defined: a vertex of a test, with its position
  MirrorTitle,   ///< defined: the title of the mirror image
  RuleTitle,     ///< a rule
  RuleVertex,    ///< a vertex of the last named rule
};

/// What may follow a keyword, for completion.
enum class Follows {
  Nothing,           ///< a new name or title, or a block
  Expression,        ///< an expression, or one of the words of the row
  Words,             ///< one of the words of the row
  Vertices,          ///< vertices only
  VerticesAndForms,  ///< vertices, each with a tolerance after `~`
  Definitions,       ///< new names with expressions
  Header,            ///< several parts, each with its own choices
};

struct Keyword {
  BlockKind block = BlockKind::File;
  std::string_view word = {};
  std::string_view form = {};  ///< an example that can be read and printed; "..." stands for a body
  std::string_view otherForm = {};  ///< the second form, for a clause with two forms
  std::string_view grammar = {};    ///< in EBNF; empty: in the row before
  std::string_view help = {};       ///< one sentence
  std::string_view snippet = {};    ///< a template for editors that support snippets
  Follows follows = Follows::Expression;
  std::span<const std::string_view> words = {};  ///< other keywords that the clause may contain
  std::optional<NameRole> defines = {};          ///< the meaning of the names that it defines
  bool isReserved = false;                       ///< whether the word cannot be a name
};

/// All rows. Users see the rows of a block in this order.
std::span<const Keyword> keywords();
/// The first row of a word in a block; null if none has it.
const Keyword* findKeyword(BlockKind block, std::string_view word);
/// The words that begin an item or a clause in this block, without duplicates.
std::span<const std::string_view> keywordsOf(BlockKind block);

/// The form, or both forms, in backticks.
std::string shownForm(const Keyword& keyword);

/// Whether a word begins an item, or a clause of a rule, of a rule set or of a test.
bool isClauseWord(std::string_view word);

/// Words that cannot be names.
std::span<const std::string_view> reservedWords();
bool isReserved(std::string_view word);

// Sets of words that a clause can choose from, for the grammar, the compiler and completion.

template <std::size_t N>
using WordList = std::array<std::string_view, N>;

inline constexpr WordList<3> kElementKinds{"tri", "quad", "poly"};
inline constexpr WordList<3> kFolds{"max", "sum", "mean"};
inline constexpr WordList<2> kScaleUnits{"h", "base"};
inline constexpr WordList<2> kParities{"even", "any"};
inline constexpr WordList<3> kFinishes{"shape", "score", "none"};  ///< in the order of af2::Finish
/// The kinds of names that an `extern` declares, the types of their arguments and of their values.
inline constexpr WordList<3> kExternKinds{"function", "shape", "metric"};
inline constexpr WordList<4> kArgumentTypes{"number", "angle", "point", "vector"};
inline constexpr WordList<3> kResultTypes{"number", "angle", "truth"};
inline constexpr WordList<2> kFrontOrders{"by", "rows"};
inline constexpr WordList<2> kRowStarts{"smallest_turn", "oldest"};
inline constexpr WordList<7> kOutcomes{"rule", "new",   "front", "elements",
                                       "weld", "stuck", "score"};
/// Reasons for the refusal of a rule in tests. The reasons `zone hit by edge` and `zone hit by
/// vertex` have a separate syntax.
inline constexpr WordList<13> kReasons{"class", "pattern",   "require", "novalue",  "parity",
                                       "shape", "convexity", "clear",   "inverted", "weld",
                                       "score", "surface",   "beaten"};
inline constexpr WordList<3> kMetaKeys{"allow", "author", "note"};

}  // namespace af2::dsl
