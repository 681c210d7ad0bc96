// Plane faces of a file that are certainly sound. Not installed.
#pragma once

class TopoDS_Face;

namespace af2::geometry {

/// Whether the repair of shapes (OpenCASCADE's ShapeFix_Face) certainly leaves the face as it is:
/// a plane one, bounded by lines and circles that lie in the plane and meet at shared vertices
/// within the tolerances, where no two of them come near each other elsewhere or enclose a small
/// angle, with its outer boundary counterclockwise and its holes clockwise. A face that this
/// function does not understand is not sound.
bool isSoundPlaneFace(const TopoDS_Face& face);

}  // namespace af2::geometry
