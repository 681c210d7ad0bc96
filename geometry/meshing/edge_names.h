// Edges of a model by the names of boundaries, faces and groups. Not installed.
#pragma once

#include <string>
#include <vector>

#include "geometry/meshing/face_source.h"

namespace af2::geometry {

/// The ids, ascending, of the edges of all boundaries whose name matches the pattern, of edges that
/// faces or groups with such a name use once. A boundary without a name is called by its number,
/// such as "boundary 3".
///
/// Throws InputError if there are none.
std::vector<int> edgesNamed(const FaceSource& source, const std::string& pattern);

/// The edges that at least one of the faces uses once, ascending.
std::vector<int> edgesAround(const FaceSource& source, const std::vector<int>& faces);

/// The requests by ids only.
///
/// Throws InputError, which names the request, for heights and numbers that are not possible, for
/// names and ids that the model does not have, and for edges that are on none of the faces.
std::vector<LayerRequest> layersById(const FaceSource& source, std::vector<LayerRequest> requests);

}  // namespace af2::geometry
