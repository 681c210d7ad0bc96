// Shells of a file that certainly have their material inside. Not installed.
#pragma once

class TopoDS_Shell;

namespace af2::geometry {

/// Whether OpenCASCADE certainly makes a solid of the shell as it is: the shell is closed and in
/// one piece, each edge is used once in either direction, and a line that comes from outside enters
/// the shell where it first meets it, clearly inside a face. A shell that this function does not
/// understand is not one.
bool isOutwardShell(const TopoDS_Shell& shell);

}  // namespace af2::geometry
