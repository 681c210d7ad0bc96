// What a library must have so that `af2 --plugin FILE` can load it.
#pragma once

#include "dsl/program/registry.h"

#define AF2_PLUGIN_TEXT_OF(x) #x
#define AF2_PLUGIN_TEXT(x) AF2_PLUGIN_TEXT_OF(x)

// The release of AF2 and what the layout of the types of the standard library depends on. A plugin
// and the program that loads it share objects, so both must have been compiled with the same.
#define AF2_PLUGIN_INTERFACE \
  "af2 0.1, C++ ABI " AF2_PLUGIN_TEXT(__GXX_ABI_VERSION) "." AF2_PLUGIN_TEXT(_GLIBCXX_USE_CXX11_ABI)

/// Begins the definition of the entry point, which registers functions, metrics and shapes:
///
///   AF2_PLUGIN(registry) {
///     registry.addShape({.name = "egg", .parameters = "ppn", .make = makeEgg});
///   }
///
/// It is called once for each rule file that is loaded. An exception that it throws ends the
/// program with its text.
#define AF2_PLUGIN(registry)                                                             \
  extern "C" __attribute__((visibility("default"))) const char* af2_plugin_interface() { \
    return AF2_PLUGIN_INTERFACE;                                                         \
  }                                                                                      \
  extern "C" __attribute__((visibility("default"))) void af2_register(af2::dsl::Registry&(registry))
