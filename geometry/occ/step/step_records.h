// The text of a STEP file as records of words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace af2::geometry {

enum class StepKind : std::uint8_t {
  List,
  Label,
  Integer,
  Real,
  Enumeration,
  Text,
  Omitted,
  Derived
};

/// Words are views into the text of a file or into constants, with a zero after them.
struct StepValue {
  std::string_view word;  ///< as in the file, texts with their quotes; the label of a list
  StepKind kind;
};

/// An entity, a part of a complex one, or a list.
struct StepRecord {
  std::string_view label;  ///< `#12`; `#0` in the head and for the second part of a complex entity
                           ///< and those after it; `$1`, `$2`, ... for the lists in a part
  std::string_view type;   ///< the keyword; of a list the one before it, or kListType
  std::span<const StepValue> values;
};

inline constexpr std::string_view kListType = "/* (SUB) */";

/// The records of a text, in the order and with the labels that OpenCASCADE's parser of STEP files
/// gives them: lists come before the records that they are values of.
class StepRecords {
 public:
  /// text  must outlive this
  explicit StepRecords(std::string& text);

  /// Whether all of the text is plain: there are no errors, no scopes, no binary values, and no
  /// sections with parameters.
  bool arePlain() const { return arePlain_; }
  std::size_t headCount() const { return headCount_; }  ///< of the records, those of the head
  std::size_t count() const { return count_; }
  std::size_t valueCount() const { return valueCount_; }

  /// Calls `take` with all records of a plain text, one after the other. Words in the text get
  /// their zeros by this, so that it can be called only once. They and the labels of lists live as
  /// long as the text and this, the values until `take` returns.
  void forEach(const std::function<void(const StepRecord&)>& take);

 private:
  std::string& text_;
  bool arePlain_ = false;
  std::size_t headCount_ = 0, count_ = 0, valueCount_ = 0;
  std::deque<std::string> listLabels_;
};

}  // namespace af2::geometry
