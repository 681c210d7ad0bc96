// A library that is no plugin.
extern "C" __attribute__((visibility("default"))) int af2_nothing() { return 0; }
