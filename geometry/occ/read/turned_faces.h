// Faces that a reader took for the rest of their surface.
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
/// face with the same edges, on the other side of them, that looks to the other side, too. Null if
/// the boundary does not run once from pole to pole and back.
TopoDS_Face restOf(const TopoDS_Face& face);

/// What is to be put in place of faces of a shell.
struct Rests {
  std::map<int, TopoDS_Face> faces;  ///< by index in the shell
  bool isShellForward = true;        ///< how the shell with them is oriented
};

/// Puts the rests that `choose` finds in the place of faces of the shells, also in groups and for
/// names. Returns how many.
int replaceByRests(ReadShape& read, const std::vector<TopoDS_Shell>& shells,
                   const std::function<Rests(const TopoDS_Shell&)>& choose);

/// A reader that finds the edges of a face on the seam of its surface may take them for those on
/// the other side of it. It then sees the loop run the wrong way round, turns it, and so has the
/// rest of the surface, in a shell that looks inwards. Puts that right for faces that are turned
/// against what the file says while most of their shell is not, and tells of it.
///
/// isAsInFile  whether a face of a shell, by itself, looks to the side that the file says
void turnBackFaces(ReadShape& read, const std::function<bool(const TopoDS_Face&)>& isAsInFile);

}  // namespace af2::geometry
