// Repairs faces that a reader took for the rest of their surface.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <functional>
#include <map>
#include <vector>

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// The rest of a surface that is closed around its axis and between two poles, such as a sphere: a
/// face with the same edges, on the other side of them, and with the opposite orientation. Null if
/// the boundary does not run once from pole to pole and back.
TopoDS_Face restOf(const TopoDS_Face& face);

/// Replacements for faces of a shell.
struct Rests {
  std::map<int, TopoDS_Face> faces;  ///< by index in the shell
  bool isShellForward = true;        ///< orientation of the shell after the replacement
};

/// Replaces faces of the shells by the rests that `choose` returns, also in groups and names.
/// Returns the number of faces that were replaced, counted in the result.
int replaceByRests(ReadShape& read, const std::vector<TopoDS_Shell>& shells,
                   const std::function<Rests(const TopoDS_Shell&)>& choose);

/// A reader may put edges on the seam of a surface on the wrong side of the seam. The loop then has
/// the wrong direction, the reader reverses it, and the face becomes the rest of its surface, in a
/// shell that faces inwards. Replaces such faces and adds a note. They are the faces whose
/// orientation relative to the file differs from that of at least two thirds of their shell.
///
/// isAsInFile  whether a face, regardless of its shell, has the orientation given in the file
void turnBackFaces(ReadShape& read, const std::function<bool(const TopoDS_Face&)>& isAsInFile);

}  // namespace af2::geometry
