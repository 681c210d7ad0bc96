// OpenCASCADE's lexer of STEP files, given its text in blocks. Not installed.
#pragma once

namespace af2::geometry {

/// The lexer in OpenCASCADE's library was generated for people who type: it asks for one character
/// at a time, and reads what it has of a word again after each (docs/performance.md says how long
/// that takes). From now on it gets as many as it has room for, in the same way: by the
/// function that gives it one. Does nothing where the library is not built as expected, which costs
/// only time.
///
/// Returns whether the lexer gets blocks.
bool giveLexerBlocks();

}  // namespace af2::geometry
