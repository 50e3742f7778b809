// Makes calls of OpenGL and EGL fail. simreel calls every entry point through epoxy's function pointer with
// the name of the entry point. This file replaces that pointer. A failing call does nothing, returns its
// failure value, and makes glGetError return GL_OUT_OF_MEMORY, as the specification requires.
#include "calls.hpp"

#include <atomic>
#include <cstring>
#include <dlfcn.h>
#include <type_traits>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace {

std::atomic<GLenum> pendingError = GL_NO_ERROR;
std::atomic<EGLint> pendingEglError = EGL_SUCCESS;

void* realAddress(const char* name) {
  static void* const library = ::dlopen("libEGL.so.1", RTLD_NOW);
  using Ask = void* (*)(const char*);
  static const auto ask = reinterpret_cast<Ask>(::dlsym(library, "eglGetProcAddress"));
  if (void* direct = std::strncmp(name, "egl", 3) == 0 ? ::dlsym(library, name) : nullptr) return direct;
  return ask(name);
}

template <class Pointer, int id>
struct Wrapper;

template <class Result, class... Arguments, int id>
struct Wrapper<Result (*)(Arguments...), id> {
  static inline const char* name = nullptr;
  static inline faults::Class what = faults::Class::gl;

  static Result call(Arguments... arguments) {
    static auto* const real = reinterpret_cast<Result (*)(Arguments...)>(realAddress(name));
    const bool asksError = std::strcmp(name, "glGetError") == 0 || std::strcmp(name, "eglGetError") == 0;
    if constexpr (!std::is_void_v<Result>)
      if (asksError) {
        const auto mine = what == faults::Class::gl
                              ? static_cast<long>(pendingError.exchange(GL_NO_ERROR))
                              : static_cast<long>(pendingEglError.exchange(EGL_SUCCESS));
        if (mine != (what == faults::Class::gl ? long{GL_NO_ERROR} : long{EGL_SUCCESS}))
          return reinterpret(mine);
        return real(arguments...);
      }
    if (!faults::fails(what, name, __builtin_return_address(0), false)) {
      const faults::InDriver inDriver;
      return real(arguments...);
    }
    if (what == faults::Class::gl)
      pendingError = GL_OUT_OF_MEMORY;
    else
      pendingEglError = EGL_BAD_ALLOC;
    if constexpr (!std::is_void_v<Result>)
      return reinterpret(std::strcmp(name, "glClientWaitSync") == 0 ? long{GL_WAIT_FAILED} : 0L);
  }

 private:
  static Result reinterpret(long value) {
    if constexpr (std::is_pointer_v<Result>)
      return nullptr;
    else if constexpr (!std::is_void_v<Result>)
      return static_cast<Result>(value);
  }
};

}  // namespace

#define CALL(variable, entry, kind)                                                   \
  namespace {                                                                         \
  using Of_##variable = Wrapper<decltype(variable), __COUNTER__>;                     \
  [[maybe_unused]] const bool named_##variable =                                      \
      (Of_##variable::name = entry, Of_##variable::what = faults::Class::kind, true); \
  }                                                                                   \
  decltype(variable) variable = &Of_##variable::call;
#include "gl_calls.inc"
