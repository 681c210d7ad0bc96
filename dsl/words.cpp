#include "dsl/words.h"

#include <algorithm>
#include <array>

namespace af2::dsl {
namespace {

constexpr std::array<std::string_view, 10> kItems{
    "import", "use", "const", "def", "metric", "ruleset", "rule", "template", "test", "property"};
constexpr std::array<std::string_view, 14> kClauses{
    "front", "at",   "slope",   "let",  "new",      "zone", "tri",
    "quad",  "poly", "require", "cost", "priority", "meta", "mirror"};
constexpr std::array<std::string_view, 10> kSettings{
    "elements", "match", "fade", "score", "accept", "front", "classes", "scale", "parity", "meta"};
constexpr std::array<std::string_view, 6> kTests{"front", "point", "base",
                                                 "class", "size",  "expect"};

/// Clause words that read naturally as names of values (cost, priority, meta) or are functions
/// (poly) are not reserved.
constexpr std::array<std::string_view, 32> kReserved{
    "import", "use",      "const",   "def",    "metric", "ruleset", "rule",   "template",
    "test",   "property", "front",   "at",     "slope",  "let",     "new",    "zone",
    "tri",    "quad",     "require", "mirror", "weld",   "quality", "expect", "for",
    "and",    "or",       "not",     "if",     "then",   "else",    "in",     "when"};

/// Number of single-letter changes, swaps of neighbours counting as one.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::span<const std::string_view> itemWords() { return kItems; }
std::span<const std::string_view> clauseWords() { return kClauses; }
std::span<const std::string_view> settingWords() { return kSettings; }
std::span<const std::string_view> testWords() { return kTests; }

bool isReserved(std::string_view word) {
  return std::find(kReserved.begin(), kReserved.end(), word) != kReserved.end();
}

std::string nearest(std::string_view written, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 64;  // the distance costs the product of the lengths
  if (written.size() > kLongest) return {};
  std::string best;
  std::size_t bestDistance = written.size() <= 2 ? 1 : written.size() <= 5 ? 2 : 3;
  ++bestDistance;
  for (const std::string& word : known) {
    if (word.size() > kLongest || word == written) continue;
    const std::size_t distance = editDistance(written, word);
    if (distance < bestDistance && distance < std::max(written.size(), word.size())) {
      best = word;
      bestDistance = distance;
    }
  }
  return best;
}

std::string didYouMean(std::string_view written, const std::vector<std::string>& known) {
  const std::string word = nearest(written, known);
  return word.empty() ? std::string() : "did you mean '" + word + "'?";
}

}  // namespace af2::dsl
