// A small rule file that tests ask the server about.
#pragma once

#include <algorithm>
#include <string>

namespace af2::lsp {

inline const std::string kRules = R"(af2 1;

## The height of the ideal triangle.
const H = 0.866;
## Beyond the middle.
def push(o, p, r, k) = lerp(o, mid(p, r), k);

ruleset "good" {
  elements tri;
}

## Two triangles fill the corner.
rule "right 120" quality 1 {
  front a -> b -> c;
  at    c (1.5, H);
  new   d = a + (c - b);
  zone  a, b, c, push(b, c, d, 1.1), d;
  tri   a b d, b c d;
  mirror "left 120" { at c ~ 2; }
}

rule "flat {k}" for (k, height) in (5, 0.5), (10, 0.3) quality k {
  let  m = mid(a, b);
  new  c = m + (0, height);
  zone a, b, c;
  tri  a b c;
}

test "a corner" {
  front  p (0, 0) -> r (1, 0) -> s (1.5, 0.866);
  expect rule "right 120" with c = s;
}

test "flat" {
  front p (0, 0) -> r (1, 0);
  class 5;
  expect rule "flat 5";
}
)";

/// The text with a mark at the n-th occurrence of a word, `into` bytes behind its beginning.
inline std::string at(const std::string& word, int n = 1, std::size_t into = 0) {
  std::size_t place = kRules.find(word);
  for (int i = 1; i < n; ++i) place = kRules.find(word, place + 1);
  std::string text = kRules;
  return text.insert(place + into, "|");
}

inline int lineOf(const std::string& word, int n = 1) {
  const std::string before = at(word, n);
  return static_cast<int>(std::count(before.begin(), before.begin() + before.find('|'), '\n'));
}

/// With every `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

inline bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace af2::lsp
