#include "geometry/mesh/fingerprint.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <memory>
#include <span>
#include <type_traits>

namespace af2::geometry {
namespace {

/// The hash of values that come piece by piece.
class RunningHash {
 public:
  explicit RunningHash(XXH64_hash_t seed) { XXH64_reset(state_.get(), seed); }

  template <class T>
  void add(std::span<const T> values) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, Point3>,
                  "padding would be hashed");
    XXH64_update(state_.get(), values.data(), values.size_bytes());
  }
  XXH64_hash_t value() const { return XXH64_digest(state_.get()); }

 private:
  struct Free {
    void operator()(XXH64_state_t* state) const { XXH64_freeState(state); }
  };
  std::unique_ptr<XXH64_state_t, Free> state_{XXH64_createState()};
};

}  // namespace

std::string fingerprint(const ModelMesh& mesh) {
  RunningHash ofVertices(0);
  forEachSlice(mesh, [&](const MeshSlice& slice) { ofVertices.add(slice.vertices); });
  RunningHash ofElements(ofVertices.value());
  forEachSlice(mesh, [&](const MeshSlice& slice) { ofElements.add(slice.elements); });
  XXH64_hash_t hash = ofElements.value();
  std::string digits(16, '0');
  for (std::size_t i = digits.size(); i-- > 0; hash >>= 4)
    digits[i] = "0123456789abcdef"[hash & 15];
  return digits;
}

}  // namespace af2::geometry
