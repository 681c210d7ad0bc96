// Stands in for the header of oneTBB of this name.
#pragma once

#include <tbb/serial.h>
