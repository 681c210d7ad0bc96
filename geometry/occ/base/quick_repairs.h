// OpenCASCADE's repair of shapes that readers have made, without needless copies. Not installed.
#pragma once

namespace af2::geometry {

/// Replacements of shapes by repaired ones are applied to whole solids and faces again and again,
/// for each wire of a face as well, and each time everything in them is copied first, to be thrown
/// away where nothing was replaced (docs/performance.md says how long that takes). From now on
/// OpenCASCADE's readers look first whether anything was. Does nothing if the program has set a
/// container of tools of its own.
void repairShapesQuickly();

}  // namespace af2::geometry
