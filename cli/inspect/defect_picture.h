// Pictures of a model: with its defects marked, or with what a mesh merges.
#pragma once

#include <string>
#include <vector>

#include "dsl/picture/canvas.h"
#include "geometry/occ/inspect/defects.h"

namespace af2::cli {

/// A text at a place of the model.
struct PictureLabel {
  Point3 place{};
  std::string text;
};

/// Draws the model's edges in grey, seen from one corner. Edges, faces and points with defects have
/// a colour for each kind of defect, which a legend explains. Returns the bytes of the file.
std::string drawDefects(const geometry::Model& model, const std::vector<geometry::Defect>& defects,
                        dsl::PictureFormat format, const std::vector<PictureLabel>& labels = {});

/// Draws the edges that the mesh follows as full lines, and those that it crosses as thin dashed
/// ones, in a colour for each group of faces that are meshed together; dots in the same colour mark
/// its faces. A legend lists the groups. Returns the bytes of the file.
std::string drawMerging(const geometry::Model& model, const geometry::Merging& merging,
                        dsl::PictureFormat format, const std::vector<PictureLabel>& labels = {});

}  // namespace af2::cli
