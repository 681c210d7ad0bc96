// Which functions and classes of the shared library programs may call.
#pragma once

/// Makes a function or class visible in the shared library. Everything else is hidden, so that it
/// can change without breaking programs.
#define AF2_EXPORT __attribute__((visibility("default")))
