// Finds the parts of a model that touch, overlap or coincide.
#pragma once

#include "engine/base/export.h"
#include "geometry/mesh/contact.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

struct ContactOptions {
  /// Parts nearer than this touch, in the unit of the model. 0: a ten-millionth of its diagonal.
  double tolerance = 0;
  /// Pairs are compared, those that take least first, until they have this many faces together,
  /// counted again for each pair; a curved face counts for several plane ones. The work is so
  /// limited on any machine. 0: no limit.
  std::size_t maxFaces = 0;
  double secondsForPair = 20,
         seconds = 300;  ///< limits; pairs that reach one are ContactKind::Unknown
};

/// Solids, and sheets of faces that bound no solid, that have something in common without sharing
/// it: meshes of such parts do not match there. Parts that share the face, edge or vertex where
/// they meet are not listed.
///
/// Only parts whose boxes meet are compared, in a forked process: OpenCASCADE may crash or hang
/// over a pair, which is then ContactKind::Unknown.
AF2_EXPORT PartContacts findContacts(const Model& model, const ContactOptions& options = {});

}  // namespace af2::geometry
