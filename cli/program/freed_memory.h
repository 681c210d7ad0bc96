// How the process deals with memory that has been freed.
#pragma once

#include <malloc.h>

namespace af2::cli {

/// Keeps freed memory for what comes next. By default glibc returns it to the system from 128 kB
/// on, piece after piece and face after face of a mesh, and each page costs a page fault when it is
/// needed again. These are the limits to which glibc raises them itself when a block of 32 MB is
/// freed. To be called before other threads start.
inline void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kLargestKept = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, kLargestKept);
  mallopt(M_TRIM_THRESHOLD, 2 * kLargestKept);
#endif
}

}  // namespace af2::cli
