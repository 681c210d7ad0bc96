// How much memory a run may take.
// Not installed.
#pragma once

namespace af2::geometry {

/// Bytes that this process can still take: what the machine has free, or less where the process is
/// limited (`ulimit -v`). Infinite where the system does not say.
double freeMemory();

/// Gives the system back what is free among what was freed, where the library of C keeps it.
void returnFreedMemory();

}  // namespace af2::geometry
