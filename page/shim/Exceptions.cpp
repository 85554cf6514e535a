#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

// Debian's libc++abi for WebAssembly is built without exceptions, and without the unwinder. What code compiled with
// -fwasm-exceptions calls stands here.
//   source   WebAssembly tool conventions, EHScopes and the C++ exception handling ABI of Itanium, levels 2 and 3

__asm__(
    ".globl __cpp_exception\n"
    ".tagtype __cpp_exception i32\n"
    "__cpp_exception:\n");

namespace __cxxabiv1 {

/// The part of libc++abi's private type information that decides what a handler catches.
class __shim_type_info : public std::type_info {
 public:
  ~__shim_type_info() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown_type, void*& adjusted) const = 0;
};

}  // namespace __cxxabiv1

namespace {

using Type = __cxxabiv1::__shim_type_info;

/// Lies before each thrown object; its address is what travels.
struct alignas(16) Exception {
  const Type* type;
  void* (*destroy)(void*);  // destructors return their object here
  void* adjusted;    // the object as the handler's type
  int handlers;      // that are running; negative while it is thrown again
  Exception* below;  // in the stack of those caught

  void* Object() { return this + 1; }
};

Exception* caught = nullptr;

std::uint64_t Unsigned(const std::uint8_t*& bytes) {
  std::uint64_t value = 0;
  for (int shift = 0;; shift += 7) {
    const std::uint8_t byte = *bytes++;
    value |= std::uint64_t{byte & 0x7fu} << shift;
    if ((byte & 0x80) == 0) return value;
  }
}

std::int64_t Signed(const std::uint8_t*& bytes) {
  std::int64_t value = 0;
  for (int shift = 0;;) {
    const std::uint8_t byte = *bytes++;
    value |= std::int64_t{byte & 0x7f} << shift;
    shift += 7;
    if ((byte & 0x80) == 0) return byte & 0x40 ? value - (std::int64_t{1} << shift) : value;
  }
}

/// The tables of a function that catches: for each landing pad a chain of actions, and the types that they name.
struct Tables {
  const std::uint8_t *sites, *actions, *types;

  explicit Tables(const std::uint8_t* at) {
    constexpr std::uint8_t omitted = 0xff;
    if (*at++ != omitted) std::abort();  // no function here begins elsewhere than at its own beginning
    const bool has_types = *at++ != omitted;
    const std::uint64_t to_types = has_types ? Unsigned(at) : 0;
    types = at + to_types;
    ++at;  // how sites are encoded: always as unsigned LEB128
    const std::uint64_t length = Unsigned(at);
    sites = at;
    actions = at + length;
  }

  /// The first action of a landing pad; null for one that only cleans up.
  const std::uint8_t* ActionOf(std::uintptr_t pad) const {
    for (const std::uint8_t* site = sites; site < actions;) {
      const std::uint64_t index = Unsigned(site), action = Unsigned(site);
      if (index == pad) return action == 0 ? nullptr : actions + (action - 1);
    }
    return nullptr;
  }

  const Type* TypeAt(std::int64_t index) const { return reinterpret_cast<const Type* const*>(types)[-index]; }
};

/// The number of the handler that catches the exception at a landing pad, or 0.
std::uintptr_t Selected(const Tables& tables, std::uintptr_t pad, Exception& exception) {
  const std::uint8_t* action = tables.ActionOf(pad);
  while (action) {
    const std::int64_t index = Signed(action);
    const std::uint8_t* const offset_at = action;
    if (index > 0) {
      void* object = exception.Object();
      const Type* const type = tables.TypeAt(index);
      if (!type || type->can_catch(exception.type, object)) {
        exception.adjusted = object;
        return static_cast<std::uintptr_t>(index);
      }
    }
    const std::int64_t offset = Signed(action);
    action = offset == 0 ? nullptr : offset_at + offset;
  }
  return 0;
}

}  // namespace

extern "C" {

/// What the compiler's landing pads write and read.
struct {
  std::uintptr_t pad;
  const std::uint8_t* tables;
  std::uintptr_t selector;
} __wasm_lpad_context;

int _Unwind_CallPersonality(void* exception) {
  __wasm_lpad_context.selector =
      Selected(Tables(__wasm_lpad_context.tables), __wasm_lpad_context.pad, *static_cast<Exception*>(exception));
  return 0;
}

int __gxx_wasm_personality_v0() { return 0; }

void* __cxa_allocate_exception(std::size_t size) {
  void* const memory = std::malloc(sizeof(Exception) + size);
  if (!memory) std::abort();
  return static_cast<Exception*>(memory) + 1;
}

void __cxa_free_exception(void* object) { std::free(static_cast<Exception*>(object) - 1); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Exception* const exception = static_cast<Exception*>(object) - 1;
  *exception = {static_cast<const Type*>(type), destroy, object, 0, nullptr};
  __builtin_wasm_throw(0, exception);
}

void* __cxa_get_exception_ptr(void* thrown) { return static_cast<Exception*>(thrown)->adjusted; }

void* __cxa_begin_catch(void* thrown) {
  Exception* const exception = static_cast<Exception*>(thrown);
  exception->handlers = std::abs(exception->handlers) + 1;
  if (exception != caught) {
    exception->below = caught;
    caught = exception;
  }
  return exception->adjusted;
}

void __cxa_end_catch() {
  Exception* const exception = caught;
  if (!exception) return;
  const bool is_thrown_again = exception->handlers < 0;
  exception->handlers += is_thrown_again ? 1 : -1;
  if (exception->handlers != 0) return;
  caught = exception->below;
  if (is_thrown_again) return;
  if (exception->destroy) exception->destroy(exception->Object());
  std::free(exception);
}

[[noreturn]] void __cxa_rethrow() {
  if (!caught) std::terminate();
  caught->handlers = -caught->handlers;
  __builtin_wasm_throw(0, caught);
}

}  // extern "C"

// The library's own do not throw either.
void* operator new(std::size_t size) {
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  if (size <= SIZE_MAX - step)
    if (void* const memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return operator new(size); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return operator new(size, alignment); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size > 0 ? size : 1); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size > 0 ? size : 1); }
