// A plugin that was compiled for another release.
namespace af2::dsl {
class Registry;
}
extern "C" {
__attribute__((visibility("default"))) const char* af2_plugin_interface() { return "af2 9.9"; }
__attribute__((visibility("default"))) void af2_register(af2::dsl::Registry&) {}
}
