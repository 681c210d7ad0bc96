#include "dsl/netgen/rls_reader.h"

#include <optional>

namespace af2::dsl {
namespace {

/// A decimal number, taken exactly; nothing if it is too long or too large.
std::optional<Exact> exactValue(std::string_view text) {
  boost::multiprecision::cpp_int digits = 0, scale = 1;
  constexpr std::size_t kLongest = 32;
  constexpr int kLargestExponent = 30;
  const bool isNegative = text.front() == '-';
  if (text.front() == '-' || text.front() == '+') text.remove_prefix(1);
  const std::size_t mantissa = std::min(text.find_first_of("eE"), text.size());
  if (mantissa > kLongest || text.size() - mantissa > 4) return std::nullopt;
  bool isFraction = false;
  for (char c : text.substr(0, mantissa)) {
    if (c == '.') {
      isFraction = true;
      continue;
    }
    digits = digits * 10 + (c - '0');
    if (isFraction) scale *= 10;
  }
  int exponent = 0;
  if (mantissa < text.size()) exponent = std::stoi(std::string(text.substr(mantissa + 1)));
  if (exponent > kLargestExponent || exponent < -kLargestExponent) return std::nullopt;
  for (int i = 0; i < exponent; ++i) digits *= 10;
  for (int i = 0; i > exponent; --i) scale *= 10;
  return Exact(isNegative ? -digits : digits, scale);
}

}  // namespace

void RlsReader::tell(Code code, Span span, std::string message, std::string help,
                     std::string label) {
  Diagnostic d = rlsFinding(code, placeOf(source_, span), std::move(message), std::move(help));
  d.label = std::move(label);
  d.rule = about_;
  if (d.severity == Severity::Error) isSound_ = false;
  diagnostics_.add(std::move(d));
}

std::string RlsReader::shown(const RlsToken& token) {
  if (token.kind == RlsTokenKind::End) return "the end of the file";
  return "'" + std::string(token.text.substr(0, 40)) + "'";
}

void RlsReader::unreadable(const std::string& wanted) {
  tell(Code::NetgenSyntax, now().span, "expected " + wanted + ", found " + shown(now()),
       "a clause is a keyword and its parts, each followed by ';'");
  throw Unreadable{};
}

void RlsReader::expect(std::string_view sign) {
  if (!now().is(sign)) unreadable("'" + std::string(sign) + "'");
  next();
}

Exact RlsReader::number() {
  if (now().kind != RlsTokenKind::Number) unreadable("a number");
  const std::optional<Exact> value = exactValue(now().text);
  if (!value) {
    tell(Code::NetgenContradiction, now().span, "this number is too long or too large",
         "numbers have at most 30 digits and exponents from -30 to 30");
    throw Unreadable{};
  }
  next();
  return *value;
}

int RlsReader::wholeNumber(const std::string& what) {
  const RlsToken token = now();
  const Exact value = number();
  if (denominator(value) != 1 || value < -1000000 || value > 1000000) {
    tell(Code::NetgenContradiction, token.span, what + " is a whole number, not " + shown(token),
         "");
    throw Unreadable{};
  }
  return numerator(value).convert_to<int>();
}

}  // namespace af2::dsl
