#pragma once
#include <epoxy/egl.h>
#include <epoxy/gl.h>

/// Counts GL calls during its lifetime by replacing libepoxy's function pointers.
class GlCalls {
 public:
  GlCalls() {
    count = 0;
    install(true);
  }
  ~GlCalls() { install(false); }
  GlCalls(const GlCalls&) = delete;
  GlCalls& operator=(const GlCalls&) = delete;
  GlCalls(GlCalls&&) = delete;
  GlCalls& operator=(GlCalls&&) = delete;

  static inline long count = 0;

 private:
  /// Replacement for one libepoxy function pointer, which counts calls.
  template <auto* Pointer>
  struct Counted;
  template <class Result, class... Args, Result (**Pointer)(Args...)>
  struct Counted<Pointer> {
    static inline Result (*before)(Args...) = nullptr;
    static inline Result (*driver)(Args...) = nullptr;
    static Result call(Args... args) {
      ++count;
      return driver(args...);
    }
    static void install(bool on, const char* name) {
      if (on) {
        // The driver's function is not read from the variable. Before the first call, the variable holds
        // libepoxy's resolver, which overwrites the variable.
        driver = reinterpret_cast<Result (*)(Args...)>(eglGetProcAddress(name));
        before = *Pointer;
      }
      *Pointer = on ? &call : before;
    }
  };

  /// Counts the functions that the passes of src/draw call in a frame, and functions that would wait or
  /// copy.
  static void install(bool on) {
#define COUNT_CALLS(function) Counted<&epoxy_##function>::install(on, #function)
    COUNT_CALLS(glBindBuffer);
    COUNT_CALLS(glBindBufferBase);
    COUNT_CALLS(glBindBufferRange);
    COUNT_CALLS(glBindFramebuffer);
    COUNT_CALLS(glBindImageTexture);
    COUNT_CALLS(glBindTextureUnit);
    COUNT_CALLS(glBindVertexArray);
    COUNT_CALLS(glClearNamedFramebufferfv);
    COUNT_CALLS(glClientWaitSync);
    COUNT_CALLS(glDisable);
    COUNT_CALLS(glDispatchCompute);
    COUNT_CALLS(glDrawArrays);
    COUNT_CALLS(glDrawElements);
    COUNT_CALLS(glDrawElementsIndirect);
    COUNT_CALLS(glEnable);
    COUNT_CALLS(glFinish);
    COUNT_CALLS(glFlush);
    COUNT_CALLS(glGetNamedBufferSubData);
    COUNT_CALLS(glMemoryBarrier);
    COUNT_CALLS(glNamedBufferSubData);
    COUNT_CALLS(glProgramUniform1f);
    COUNT_CALLS(glProgramUniform1i);
    COUNT_CALLS(glProgramUniform1ui);
    COUNT_CALLS(glProgramUniform2f);
    COUNT_CALLS(glProgramUniform2i);
    COUNT_CALLS(glProgramUniform3f);
    COUNT_CALLS(glProgramUniform4f);
    COUNT_CALLS(glProgramUniformMatrix4fv);
    COUNT_CALLS(glReadPixels);
    COUNT_CALLS(glTextureParameteri);
    COUNT_CALLS(glUseProgram);
    COUNT_CALLS(glVertexArrayElementBuffer);
    COUNT_CALLS(glViewport);
#undef COUNT_CALLS
  }
};
