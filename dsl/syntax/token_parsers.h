// The building blocks of the grammar: parsers for words, and actions. For grammar.cpp alone.
#pragma once

#include <boost/spirit/home/x3.hpp>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <span>

#include "dsl/syntax/ast.h"
#include "dsl/syntax/lexer.h"
#include "dsl/syntax/syntax_errors.h"
#include "dsl/text/keywords.h"

namespace af2::dsl::parsers {

namespace x3 = boost::spirit::x3;
using It = const Token*;

// ---- words as parsers ---------------------------------------------------------------------------

template <class Derived, class Attribute>
struct TokenParser : x3::parser<Derived> {
  using attribute_type = Attribute;
  static bool const has_attribute = true;
};

struct Word : x3::parser<Word> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;
  explicit constexpr Word(const char* t) : text(t) {}
  const char* text;

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const&, RContext&, Attribute&) const {
    if (first == last || !first->is(text)) return false;
    ++first;
    return true;
  }
};

/// One of several words or symbols, with its span.
struct OneOf : TokenParser<OneOf, Name> {
  OneOf(std::initializer_list<std::string_view> w) : words(w) {}
  OneOf(std::span<const std::string_view> w) : words(w.begin(), w.end()) {}
  std::vector<std::string_view> words;

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const&, RContext&, Attribute& attribute) const {
    if (first == last) return false;
    for (const std::string_view text : words) {
      if (!first->is(text)) continue;
      x3::traits::move_to(Name{first->text, first->span}, attribute);
      ++first;
      return true;
    }
    return false;
  }
};

enum class Reserved { Refused, Allowed };

struct NameWord : TokenParser<NameWord, Name> {
  explicit constexpr NameWord(Reserved r) : reserved(r) {}
  Reserved reserved;

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const&, RContext&, Attribute& attribute) const {
    if (first == last || first->kind != TokenKind::Name) return false;
    if (reserved == Reserved::Refused && isReserved(first->text)) return false;
    x3::traits::move_to(Name{first->text, first->span}, attribute);
    ++first;
    return true;
  }
};

struct StringWord : TokenParser<StringWord, Name> {
  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const&, RContext&, Attribute& attribute) const {
    if (first == last || first->kind != TokenKind::String) return false;
    x3::traits::move_to(Name{first->text, first->span}, attribute);
    ++first;
    return true;
  }
};

struct NumberWord : TokenParser<NumberWord, Expr> {
  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const&, RContext&, Attribute& attribute) const {
    if (first == last || first->kind != TokenKind::Number) return false;
    Expr number;
    number.kind = first->isDoubtful ? ExprKind::Missing : ExprKind::Number;
    number.span = first->span;
    number.name = first->text;
    number.number = first->number;
    ++first;
    if (first != last && first->kind == TokenKind::Name && first->text == "deg") {
      if (number.kind == ExprKind::Number) number.kind = ExprKind::Angle;
      number.span = cover(number.span, first->span);
      ++first;
    }
    x3::traits::move_to(std::move(number), attribute);
    return true;
  }
};

struct IntegerWord : TokenParser<IntegerWord, int> {
  explicit constexpr IntegerWord(int l) : least(l) {}
  int least;

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const&, RContext&, Attribute& attribute) const {
    if (first == last || first->kind != TokenKind::Number) return false;
    if (first->text.find_first_not_of("0123456789") != std::string::npos || first->number > 1e6 ||
        first->number < least)
      return false;
    x3::traits::move_to(static_cast<int>(first->number), attribute);
    ++first;
    return true;
  }
};

/// Where a block must end if its brace is missing: at the next item or the end of the file.
struct BlockEnd : x3::parser<BlockEnd> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;
  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const&, RContext&, Attribute&) const {
    return first == last || first->kind == TokenKind::End || SyntaxErrors::beginsItem(first);
  }
};

struct FileEnd : x3::parser<FileEnd> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;
  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const&, RContext&, Attribute&) const {
    return first == last || first->kind == TokenKind::End;
  }
};

/// Never matches.
struct Nothing : x3::parser<Nothing> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;
  template <class Context, class RContext, class Attribute>
  bool parse(It&, It const&, Context const&, RContext&, Attribute&) const {
    return false;
  }
};

struct ParsingTag;

/// The subject, or an expectation failure that names the missing part.
template <class Subject>
struct Need : x3::unary_parser<Subject, Need<Subject>> {
  using base = x3::unary_parser<Subject, Need<Subject>>;
  static bool const is_pass_through_unary = true;
  Need(Subject const& s, const char* w) : base(s), wanted(w) {}
  const char* wanted;

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const& context, RContext& rcontext,
             Attribute& attribute) const {
    if (this->subject.parse(first, last, context, rcontext, attribute)) return true;
    boost::throw_exception(x3::expectation_failure<It>(first, wanted));
  }
};

template <class Subject>
auto need(Subject const& subject, const char* wanted) {
  return Need<typename x3::extension::as_parser<Subject>::value_type>(x3::as_parser(subject),
                                                                      wanted);
}
inline Need<Word> need(const char* symbol) { return {Word(symbol), symbol}; }
inline Need<Word> need(const char* symbol, const char* wanted) { return {Word(symbol), wanted}; }

/// The ';' of a unit. If another unit clearly follows instead, the missing ';' is reported, but the
/// unit counts as complete, so that its content is compiled and checked.
template <SyntaxUnit unit>
struct UnitEnd : x3::parser<UnitEnd<unit>> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;
  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const& context, RContext&, Attribute&) const {
    if (first != last && first->is(";")) {
      ++first;
      return true;
    }
    if (first == last || !x3::get<ParsingTag>(context).get().tellMissingEnd(unit, first))
      boost::throw_exception(x3::expectation_failure<It>(first, ";"));
    return true;
  }
};

const UnitEnd<SyntaxUnit::Item> itemEnd;
const UnitEnd<SyntaxUnit::Clause> clauseEnd;
const UnitEnd<SyntaxUnit::Setting> settingEnd;
const UnitEnd<SyntaxUnit::TestClause> testClauseEnd;
const UnitEnd<SyntaxUnit::MirrorPart> mirrorPartEnd;

const auto word = [](const char* text) { return Word(text); };
const NameWord name(Reserved::Refused), anyName(Reserved::Allowed);
const StringWord string;
const NumberWord number;
const IntegerWord integer(0), ordinal(1);
const BlockEnd atBlockEnd;
const FileEnd atFileEnd;

// ---- actions ------------------------------------------------------------------------------------

/// Sets a member of the attribute of the rule.
template <class Class, class Member>
auto into(Member Class::*member) {
  return [member](auto& context) { x3::_val(context).*member = std::move(x3::_attr(context)); };
}

/// Appends to a list in the attribute of the rule.
template <class Class, class Member>
auto append(Member Class::*member) {
  return [member](auto& context) {
    (x3::_val(context).*member).push_back(std::move(x3::_attr(context)));
  };
}

template <class Class>
auto setFlag(bool Class::*member) {
  return [member](auto& context) { x3::_val(context).*member = true; };
}

const auto push = [](auto& context) { x3::_val(context).push_back(std::move(x3::_attr(context))); };
const auto assign = [](auto& context) { x3::_val(context) = std::move(x3::_attr(context)); };
const auto content = [](auto& context) {
  x3::_val(context).content = std::move(x3::_attr(context));
};

/// subject, subject, ...; the action is called for each.
template <class Subject, class Action>
auto list(Subject const& subject, Action action, const char* wanted) {
  return need(subject, wanted)[action] >> *(word(",") >> need(subject, wanted)[action]);
}

// ---- places and errors --------------------------------------------------------------------------

inline Span spanOf(It first, It end) {
  return end == first ? Span{first->span.begin, first->span.begin}
                      : cover(first->span, (end - 1)->span);
}

/// Sets the span of the attribute of the rule.
template <class Subject>
struct Spanned : x3::unary_parser<Subject, Spanned<Subject>> {
  using base = x3::unary_parser<Subject, Spanned<Subject>>;
  static bool const is_pass_through_unary = true;
  explicit Spanned(Subject const& s) : base(s) {}

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const& context, RContext& value,
             Attribute& attribute) const {
    const It begin = first;
    if (!this->subject.parse(first, last, context, value, attribute)) return false;
    if constexpr (requires { value.span.begin; }) value.span = spanOf(begin, first);
    return true;
  }
};

template <class Subject>
auto spanned(Subject const& subject) {
  return Spanned<Subject>(subject);
}

/// subject, subject, ... of a clause. A part that cannot be read is reported, and the parser
/// continues with the next part; the clause still counts as broken.
template <class Subject>
struct Parts : x3::parser<Parts<Subject>> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;
  Parts(Subject const& s, SyntaxUnit u, ListPart p) : subject(s), unit(u), part(p) {}
  Subject subject;
  SyntaxUnit unit;
  ListPart part;

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const& context, RContext& rcontext,
             Attribute& attribute) const {
    SyntaxErrors& errors = x3::get<ParsingTag>(context).get();
    const It head = first - (part == ListPart::Expression && (first - 1)->is("by") ? 2 : 1);
    for (bool isBroken = false;; ++first) {
      const It begin = first;
      try {
        this->subject.parse(first, last, context, rcontext, attribute);
        if (!SyntaxErrors::mayEndList(unit, first))
          if (const It comma = errors.tellPart(unit, head, begin, first, part, ";"))
            first = comma, isBroken = true;
      } catch (x3::expectation_failure<It> const& x) {
        const It comma = errors.tellPart(unit, head, begin, x.where(), part, x.which());
        if (!comma) throw;
        first = comma, isBroken = true;
      }
      if (first != last && first->is(",")) continue;
      const bool isTold = SyntaxErrors::mayEndList(unit, first);
      if (isBroken)
        boost::throw_exception(x3::expectation_failure<It>(first, isTold ? kTold : ";"));
      return true;
    }
  }
};

template <class Subject, class Action>
auto parts(SyntaxUnit unit, ListPart part, Subject const& subject, Action action,
           const char* wanted) {
  const auto whole = need(subject, wanted)[action];
  return Parts<std::decay_t<decltype(whole)>>(whole, unit, part);
}

/// A broken unit is reported once and skipped up to the place where the next one can begin.
template <SyntaxUnit unit>
struct Recovering {
  template <class Context>
  x3::error_handler_result on_error(It& first, It const& last, x3::expectation_failure<It> const& x,
                                    Context const& context) {
    SyntaxErrors& errors = x3::get<ParsingTag>(context).get();
    first = errors.tellAndRecover(unit, first, x.where(), last, x.which());
    return x3::error_handler_result::accept;
  }
};

/// `{`. If a clause of a rule follows instead, the missing brace is reported and assumed.
struct OpenBrace : x3::parser<OpenBrace> {
  using attribute_type = x3::unused_type;
  static bool const has_attribute = false;
  explicit constexpr OpenBrace(bool t) : tells(t) {}
  bool tells;

  template <class Context, class RContext, class Attribute>
  bool parse(It& first, It const& last, Context const& context, RContext&, Attribute&) const {
    if (first == last) return false;
    if (first->is("{")) {
      ++first;
      return true;
    }
    const bool isMissing = first->startsLine && findKeyword(BlockKind::Rule, first->text) &&
                           first->kind == TokenKind::Name;
    if (isMissing && tells) x3::get<ParsingTag>(context).get().tellMissingBrace(first);
    return isMissing;
  }
};

}  // namespace af2::dsl::parsers
