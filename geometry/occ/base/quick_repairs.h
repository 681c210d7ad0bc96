// OpenCASCADE's repair of shapes that readers have made, without needless work. Not installed.
#pragma once

namespace af2::geometry {

/// From now on OpenCASCADE's readers repair shapes with the same result in less time
/// (docs/performance.md says how much):
///
/// - Replacements of shapes by repaired ones are applied to whole solids and faces again and again,
///   for each wire of a face as well, and each time everything in them was copied first, to be
///   thrown away where nothing was replaced. They look first whether anything was.
/// - Plane faces of solids that are certainly sound are left out.
/// - Solids that certainly have their material inside are not asked on which side it is.
///
/// Does nothing if the program has set a container of tools of its own.
void repairShapesQuickly();

}  // namespace af2::geometry
