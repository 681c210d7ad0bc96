// WebAssembly rounds to nearest only. CGAL names the other ways and, with CGAL_ALWAYS_ROUND_TO_NEAREST, does not
// use them.
#pragma once

#include_next <fenv.h>

#define FE_UPWARD 1
#define FE_DOWNWARD 2
#define FE_TOWARDZERO 3
