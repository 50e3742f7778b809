#pragma once
#include <cstdint>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Records which buffers and textures the typed kernels (gl::Kernel) of the current context have accessed
/// since the last barriers. Before a dispatch, a kernel issues the barriers that this log reports. Explicit
/// barriers are recorded if they are issued with AccessLog::barrier(), as gl::barrier() does. Accesses by a
/// gl::Program are not recorded, so code that uses a gl::Program must issue barriers.
class AccessLog {
 public:
  /// A buffer, or a texture with separate storage, identified by its OpenGL name.
  struct Memory {
    GLuint name = 0;
    bool texture = false;
  };

  /// Type of access. `together` means reads and writes whose order relative to each other does not matter
  /// (gl::Shared).
  enum class AccessKind { read, write, together };

  /// Returns the barrier bits that must be issued before an access of `memory` through `kind` (one bit of
  /// glMemoryBarrier), or 0 if no barrier is needed. An access waits for all earlier accesses of the other
  /// two types. A write also waits for earlier writes.
  [[nodiscard]] static GLbitfield needed(Memory memory, GLbitfield kind, AccessKind way);
  /// Records an access that the next dispatch makes.
  static void note(Memory memory, AccessKind way);
  /// Calls glMemoryBarrier and records the barrier.
  static void barrier(GLbitfield kinds);
};

}  // namespace simreel::gl
