// Netgen's rule files (.rls) as written, with exact numbers and the place of every part.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dsl/text/diagnostic.h"
#include "dsl/text/source_text.h"

namespace af2::dsl {

/// The decimal numbers of a file, taken exactly.
using Exact = boost::multiprecision::cpp_rational;

/// One `0.5 X2`: a multiple of the deviation of a matched point from its reference.
struct RlsTerm {
  Exact coefficient;
  bool isX = true;
  int point = 0;  ///< from 1
  Span span;
};

/// (x, y) { terms of x } { terms of y }
struct RlsPoint {
  Exact x, y;
  std::array<std::vector<RlsTerm>, 2> rows;
  Span span;
};

struct RlsForm {
  std::array<Exact, 3> weights;
  Span span;
};

struct RlsMapPoint {
  Exact x, y;
  std::optional<RlsForm> form;
  bool isDeleted = false;
  Span span;
};

struct RlsLine {
  int from = 0, to = 0;  ///< numbers of points, from 1
  std::optional<RlsForm> form;
  bool isDeleted = false;
  Span span;
};

/// Numbers of points in parentheses: an element, an orientation, a new line.
struct RlsTuple {
  std::vector<int> points;
  Span span;
};

struct RlsRule {
  std::string name;
  Span span;  ///< of the name
  int quality = 1;
  Span qualitySpan;
  std::vector<RlsMapPoint> mapPoints;
  std::vector<RlsLine> mapLines;
  std::vector<RlsPoint> newPoints;
  std::vector<RlsTuple> newLines;
  std::vector<RlsPoint> freeArea, freeArea2;
  std::vector<RlsTuple> elements, orientations;
};

/// A finding about such a file.
inline Diagnostic rlsFinding(Code code, DiagnosticPlace place, std::string message,
                             std::string help) {
  Diagnostic d(code);
  d.message = std::move(message);
  d.place = std::move(place);
  d.help = std::move(help);
  return d;
}

/// Reads a whole file and reports all faults (I1, I2, I3). Text that Netgen silently ignores is
/// reported as a warning (I4). Rules with errors are left out.
std::vector<RlsRule> readRls(const SourceText& source, DiagnosticList& diagnostics);

}  // namespace af2::dsl
