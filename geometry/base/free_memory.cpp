#include "geometry/base/free_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace af2::geometry {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

double availableOnMachine() {
  std::ifstream file("/proc/meminfo");
  std::string name;
  for (double kilobytes = 0; file >> name >> kilobytes; std::getline(file, name))
    if (name == "MemAvailable:") return 1024 * kilobytes;
  return kUnknown;
}

double leftOfLimit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
  double pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const double taken = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - taken);
}

}  // namespace

double freeMemory() { return std::min(availableOnMachine(), leftOfLimit()); }

void returnFreedMemory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

}  // namespace af2::geometry
