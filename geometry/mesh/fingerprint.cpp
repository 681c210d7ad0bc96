#include "geometry/mesh/fingerprint.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <type_traits>

namespace af2::geometry {
namespace {

template <class T>
XXH64_hash_t hashOf(const std::vector<T>& values, XXH64_hash_t seed) {
  static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, Point3>,
                "padding would be hashed");
  return XXH64(values.data(), values.size() * sizeof(T), seed);
}

}  // namespace

std::string fingerprint(const ModelMesh& mesh) {
  XXH64_hash_t hash = hashOf(mesh.elements, hashOf(mesh.vertices, 0));
  std::string digits(16, '0');
  for (std::size_t i = digits.size(); i-- > 0; hash >>= 4)
    digits[i] = "0123456789abcdef"[hash & 15];
  return digits;
}

}  // namespace af2::geometry
