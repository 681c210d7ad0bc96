// Mends what OpenCASCADE's reader of STEP files refuses although its meaning is plain.
#pragma once

#include <string>

namespace af2::geometry {

/// Mends the text of a STEP file. OpenCASCADE would lose the entities, and with them faces, in
/// which
/// * a complex entity leaves out its name: `REPRESENTATION_ITEM()` becomes
///   `REPRESENTATION_ITEM('')`;
/// * the exponent of a real has a small letter, as scripts write it: `1e-7` becomes `1.E-7`.
///
/// It would refuse a file that begins with the mark of UTF-8, which is left out.
void mendStepText(std::string& text);

}  // namespace af2::geometry
