// Which functions and classes programs may call.
#pragma once

/// Marks what the shared library lets programs call. Everything else of it is hidden, so that it
/// can change without breaking a program.
#define AF2_EXPORT __attribute__((visibility("default")))
