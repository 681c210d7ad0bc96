// Exceptions for WebAssembly: what compiled code calls to throw and to catch. Debian's C++ library
// for WASI is compiled without them, but knows which type catches which (can_catch). The interface
// is that of the Itanium C++ ABI for exceptions and of clang's -fwasm-exceptions.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

// The tag of all exceptions of C++: a pointer to the object goes with it.
__asm__(
    ".tagtype __cpp_exception i32\n"
    ".globl __cpp_exception\n"
    "__cpp_exception:\n");

namespace __cxxabiv1 {

/// Laid out as in the C++ library.
class __shim_type_info : public std::type_info {
 public:
  ~__shim_type_info() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown, void*& adjusted) const = 0;
};

}  // namespace __cxxabiv1

namespace {

/// In WebAssembly, destructors return the object.
using Destructor = void* (*)(void*);

/// Stands before each object that is thrown.
struct Thrown {
  const std::type_info* type = nullptr;
  Destructor destroy = nullptr;
  Thrown* next = nullptr;      ///< below this one among those that are being handled
  int handlers = 0;            ///< that have caught it and are not over
  bool isThrownAgain = false;  ///< by a handler: it does not end with it
  void* adjusted = nullptr;    ///< the object as its handler sees it
};
constexpr std::size_t kHeader = 32;
static_assert(sizeof(Thrown) <= kHeader);

Thrown* handled = nullptr;  // the innermost one comes first

Thrown* headerOf(void* object) {
  return reinterpret_cast<Thrown*>(static_cast<char*>(object) - kHeader);
}
void* objectOf(Thrown* thrown) { return reinterpret_cast<char*>(thrown) + kHeader; }

/// Reads the tables that the compiler makes for the handlers of a function.
class TableReader {
 public:
  explicit TableReader(const std::uint8_t* at) : at_(at) {}
  const std::uint8_t* place() const { return at_; }
  std::uint8_t byte() { return *at_++; }

  std::uintptr_t number() {
    std::uintptr_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const std::uint8_t part = byte();
      value |= static_cast<std::uintptr_t>(part & 0x7f) << shift;
      if (!(part & 0x80)) return value;
    }
  }

  std::intptr_t signedNumber() {
    std::uintptr_t value = 0;
    unsigned shift = 0;
    std::uint8_t part = 0;
    do {
      part = byte();
      value |= static_cast<std::uintptr_t>(part & 0x7f) << shift;
      shift += 7;
    } while (part & 0x80);
    if ((part & 0x40) && shift < 8 * sizeof value) value |= ~std::uintptr_t{0} << shift;
    return static_cast<std::intptr_t>(value);
  }

 private:
  const std::uint8_t* at_;
};

constexpr std::uint8_t kOmitted = 0xff;

/// The tables of one function.
struct HandlerTable {
  const std::uint8_t* sites = nullptr;
  const std::uint8_t* actions = nullptr;
  const std::uint8_t* types = nullptr;  ///< their end: type i is the i-th before

  explicit HandlerTable(const std::uint8_t* start) {
    TableReader reader(start);
    if (reader.byte() != kOmitted) std::abort();  // landing pads relative to something else
    if (reader.byte() != kOmitted) {
      const std::uintptr_t offset = reader.number();
      types = reader.place() + offset;
    }
    reader.byte();  // how places of calls are written: as numbers, always
    const std::uintptr_t length = reader.number();
    sites = reader.place();
    actions = sites + length;
  }

  const std::type_info* type(std::intptr_t index) const {
    return reinterpret_cast<const std::type_info* const*>(types)[-index];
  }
};

/// The first handler of a chain of actions that catches the object, by the number of its type; 0 if
/// only cleaning up is to be done.
std::intptr_t handlerFor(const HandlerTable& table, std::uintptr_t firstAction, Thrown& thrown) {
  if (firstAction == 0) return 0;
  const std::uint8_t* place = table.actions + (firstAction - 1);
  while (true) {
    TableReader reader(place);
    const std::intptr_t index = reader.signedNumber();
    const std::uint8_t* const next = reader.place();
    const std::intptr_t distance = reader.signedNumber();
    if (index > 0) {
      thrown.adjusted = objectOf(&thrown);
      const std::type_info* wanted = table.type(index);
      if (!wanted) return index;  // catch (...)
      const auto* shim = static_cast<const __cxxabiv1::__shim_type_info*>(wanted);
      const auto* own = static_cast<const __cxxabiv1::__shim_type_info*>(thrown.type);
      if (shim->can_catch(own, thrown.adjusted)) return index;
    }
    if (distance == 0) return 0;
    place = next + distance;
  }
}

}  // namespace

extern "C" {

/// Shared with compiled code: which call of which function was on its way, and which handler takes
/// over.
struct LandingPad {
  std::uintptr_t index;
  const std::uint8_t* table;
  std::uintptr_t selector;
};
LandingPad __wasm_lpad_context;

int _Unwind_CallPersonality(void* object) {
  LandingPad& pad = __wasm_lpad_context;
  pad.selector = 0;
  if (!pad.table) return 0;
  const HandlerTable table(pad.table);
  TableReader reader(table.sites);
  std::uintptr_t action = 0;
  for (std::uintptr_t i = 0; i <= pad.index; ++i) {
    reader.number();  // the landing pad itself
    action = reader.number();
  }
  pad.selector = static_cast<std::uintptr_t>(handlerFor(table, action, *headerOf(object)));
  return 0;
}

/// Named by functions with handlers; compiled code calls _Unwind_CallPersonality instead.
int __gxx_wasm_personality_v0(...) { std::abort(); }

void* __cxa_allocate_exception(std::size_t size) noexcept {
  void* const bytes = std::malloc(kHeader + size);
  if (!bytes) std::terminate();
  return objectOf(new (bytes) Thrown);
}

void __cxa_free_exception(void* object) noexcept { std::free(headerOf(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, Destructor destroy) {
  Thrown* const thrown = headerOf(object);
  thrown->type = type;
  thrown->destroy = destroy;
  __builtin_wasm_throw(0, object);
}

void* __cxa_begin_catch(void* object) noexcept {
  Thrown* const thrown = headerOf(object);
  thrown->isThrownAgain = false;
  if (thrown->handlers++ == 0) {
    thrown->next = handled;
    handled = thrown;
  }
  return thrown->adjusted;
}

void __cxa_end_catch() {
  Thrown* const thrown = handled;
  if (!thrown || --thrown->handlers > 0) return;
  handled = thrown->next;
  if (thrown->isThrownAgain) return;
  if (thrown->destroy) thrown->destroy(objectOf(thrown));
  std::free(thrown);
}

[[noreturn]] void __cxa_rethrow() {
  if (!handled) std::terminate();
  handled->isThrownAgain = true;
  __builtin_wasm_throw(0, objectOf(handled));
}

void* __cxa_get_exception_ptr(void* object) noexcept { return headerOf(object)->adjusted; }

void __clang_call_terminate(void*) { std::terminate(); }
}
