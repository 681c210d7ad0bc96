#include "dsl/lexer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace af2::dsl {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isNameStart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isNamePart(char c) { return isNameStart(c) || isDigit(c); }
bool isOther(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// Longest first, so that `<=` is not read as `<` and `=`.
constexpr std::array<std::string_view, 29> kSymbols{
    "->", "=>", "..", "<=", ">=", "==", "!=", "<", ">", "=", "+", "-", "*", "/", "^",
    "(",  ")",  "{",  "}",  ",",  ";",  ":",  ".", "~", "|", "&", "!", "[", "]"};

class Lexer {
 public:
  Lexer(const SourceText& source, DiagnosticList& diagnostics)
      : source_(source), text_(source.text()), diagnostics_(diagnostics) {}

  TokenList read() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    while (at_ < text_.size()) readOne();
    add(TokenKind::End, at_, "");
    return std::move(result_);
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  static Span spanOf(std::size_t from, std::size_t to) {
    return {static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to)};
  }

  void tell(const char* code, std::size_t from, std::size_t to, std::string message,
            std::string help) {
    isDoubtful_ = true;
    Diagnostic d;
    d.code = code;
    d.message = std::move(message);
    d.place = placeOf(source_, spanOf(from, to));
    d.help = std::move(help);
    diagnostics_.add(std::move(d));
  }

  void add(TokenKind kind, std::size_t from, std::string text, double number = 0) {
    Token token{kind, spanOf(from, at_), std::move(text), number, std::move(doc_), lineIsEmpty_};
    token.isDoubtful = std::exchange(isDoubtful_, false);
    doc_.clear();
    lineIsEmpty_ = false;
    result_.tokens.push_back(std::move(token));
  }

  void readOne() {
    const char c = peek();
    if (c == '\n') {
      ++at_;
      lineIsEmpty_ = true;
    } else if (c == ' ' || c == '\t' || c == '\r') {
      ++at_;
    } else if (c == '#') {
      readComment();
    } else if (c == '"') {
      readString();
    } else if (isNameStart(c)) {
      readName();
    } else if (isDigit(c) || (c == '.' && isDigit(peek(1)))) {
      readNumber();
    } else {
      readSymbol();
    }
  }

  void readComment() {
    const std::size_t from = at_;
    while (at_ < text_.size() && peek() != '\n') ++at_;
    std::string text(text_.substr(from, at_ - from));
    while (!text.empty() && (text.back() == '\r' || text.back() == ' ' || text.back() == '\t'))
      text.pop_back();
    if (text.starts_with("##") && lineIsEmpty_) {
      std::string_view line = std::string_view(text).substr(2);
      if (line.starts_with(' ')) line.remove_prefix(1);
      if (!doc_.empty()) doc_ += '\n';
      doc_ += line;
    } else if (lineIsEmpty_) {
      doc_.clear();  // a plain comment parts a doc comment from what follows
    }
    const auto length = text.size();
    result_.comments.push_back({spanOf(from, from + length), std::move(text), lineIsEmpty_});
  }

  void readName() {
    const std::size_t from = at_;
    while (isNamePart(peek())) ++at_;
    if (isOther(peek())) {
      while (isNamePart(peek()) || isOther(peek())) ++at_;
      tell("L1", from, at_, "a name may hold only the letters a-z, A-Z, digits and '_'",
           "write the name without accents and special characters");
    }
    add(TokenKind::Name, from, std::string(text_.substr(from, at_ - from)));
  }

  /// digits, a fraction, an exponent; `1..30` is the number 1 and then `..`.
  void readNumber() {
    const std::size_t from = at_;
    while (isDigit(peek())) ++at_;
    if (peek() == '.' && isDigit(peek(1))) {
      ++at_;
      while (isDigit(peek())) ++at_;
    }
    const bool hasExponent =
        (peek() == 'e' || peek() == 'E') &&
        (isDigit(peek(1)) || ((peek(1) == '+' || peek(1) == '-') && isDigit(peek(2))));
    if (hasExponent) {
      at_ += 2;
      while (isDigit(peek())) ++at_;
    }
    const std::size_t end = at_;
    if (!checkNumberEnd(from)) return;
    addNumber(from, end);
  }

  /// Whether a number may end here; otherwise tells, and adds a number in its place.
  bool checkNumberEnd(std::size_t from) {
    const bool runsOn =
        (isNameStart(peek()) && !isUnit()) || isOther(peek()) || (peek() == '.' && peek(1) != '.');
    if (!runsOn) return true;
    while (isNamePart(peek()) || isOther(peek()) || (peek() == '.' && peek(1) != '.')) ++at_;
    const std::string written(text_.substr(from, at_ - from));
    tell("L2", from, at_, "'" + written + "' is not a number",
         "numbers are written 12, 1.5, .5 or 2e-3; angles 60deg");
    add(TokenKind::Number, from, written, 1);
    return false;
  }

  bool isUnit() const {
    return text_.substr(at_).starts_with("deg") && !isNamePart(peek(3)) && !isOther(peek(3));
  }

  void addNumber(std::size_t from, std::size_t end) {
    const std::string_view digits = text_.substr(from, end - from);
    double value = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (parsed.ec != std::errc() || !std::isfinite(value)) {
      const bool isTiny = value == 0 && digits.find("e-") != std::string_view::npos;
      tell("L2", from, end,
           "the number " + std::string(digits.substr(0, 40)) +
               (isTiny ? " is too small" : " is too large"),
           "the size of a number must lie between about 1e-300 and 1e300");
      value = 1;
    }
    add(TokenKind::Number, from, std::string(digits), value);
  }

  void readString() {
    const std::size_t from = at_++;
    std::string value;
    while (at_ < text_.size() && peek() != '"' && peek() != '\n') {
      if (peek() == '\\') {
        if (peek(1) == '"' || peek(1) == '\\') {
          value += peek(1);
          at_ += 2;
          continue;
        }
        tell("L4", at_, at_ + 2, "unknown escape in a string",
             "only \\\" and \\\\ have a meaning after a backslash");
      }
      value += text_[at_++];
    }
    if (peek() == '"' && at_ < text_.size()) {
      ++at_;
    } else {
      // Nearly always the closing quote is missing; `{` or `;` at the end then belong to the text
      // around the string and are given back to it.
      const std::size_t lineEnd = at_;
      while (at_ > from + 1 &&
             (peek() == '\n' || peek() == '\0' || peek() == ' ' || peek() == '\r'))
        --at_;
      if (peek() == '{' || peek() == ';') {
        while (at_ > from + 1 && text_[at_ - 1] == ' ') --at_;
      } else {
        at_ = lineEnd;
      }
      value = std::string(text_.substr(from + 1, at_ - from - 1));
      tell("L3", from, at_, "this string is not closed", "end it with \" on the same line");
    }
    add(TokenKind::String, from, std::move(value));
  }

  void readSymbol() {
    const std::size_t from = at_;
    const std::string_view rest = text_.substr(at_);
    for (std::string_view symbol : kSymbols) {
      if (!rest.starts_with(symbol)) continue;
      if (symbol == "!" || symbol == "[" || symbol == "]") break;
      at_ += symbol.size();
      add(TokenKind::Symbol, from, std::string(symbol));
      return;
    }
    readUnknown();
  }

  void readUnknown() {
    const std::size_t from = at_;
    const auto isKnown = [&](char c) {
      return isNamePart(c) || c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '#' ||
             c == '"' || std::string_view("-=<>.+*/^(){},;:~|&").find(c) != std::string_view::npos;
    };
    do ++at_;
    while (at_ < text_.size() && !isKnown(text_[at_]));
    const std::string_view written = text_.substr(from, at_ - from);
    tell("L1", from, at_,
         "unknown character" +
             std::string(written.size() > 1 && !isOther(written[0]) ? "s " : " ") + shown(written),
         helpFor(written));
  }

  static std::string shown(std::string_view written) {
    std::string result = "'";
    for (char c : written.substr(0, 24)) {
      if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f)
        result += c;
      else
        result += '?';
    }
    return result + "'";
  }

  static std::string helpFor(std::string_view written) {
    if (written[0] == '!') return "write `not` for the opposite, `!=` for unequal";
    if (written[0] == '[' || written[0] == ']') return "points and vectors are written (x, y)";
    if (written[0] == '%') return "write the remainder out; `%` has no meaning here";
    if (written[0] == '\'') return "strings stand in double quotes";
    return "delete it; the language uses plain ASCII outside of strings and comments";
  }

  const SourceText& source_;
  std::string_view text_;
  DiagnosticList& diagnostics_;
  TokenList result_;
  std::size_t at_ = 0;
  std::string doc_;
  bool lineIsEmpty_ = true;
  bool isDoubtful_ = false;
};

}  // namespace

TokenList readTokens(const SourceText& source, DiagnosticList& diagnostics) {
  return Lexer(source, diagnostics).read();
}

}  // namespace af2::dsl
