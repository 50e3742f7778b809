#pragma once
#include <cstdint>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Records which buffers and textures the typed kernels (gl::Kernel) of the current context have accessed
/// since the last barriers. Before a dispatch, a kernel issues the barriers that this log reports. Explicit
/// barriers are recorded if they go through AccessLog::barrier, as gl::barrier() does. The log does not
/// record accesses by a gl::Program: code around a gl::Program issues its own barriers.
class AccessLog {
 public:
  /// A buffer, or a texture with its own storage, identified by its OpenGL name.
  struct Memory {
    GLuint name = 0;
    bool texture = false;
  };

  /// `together`: reads and writes that need no order among themselves (gl::Shared).
  enum class Way { read, write, together };

  /// Returns the barrier bits to issue before an access of `memory` through `kind` (one bit of
  /// glMemoryBarrier); 0 if no barrier is due. An access waits for all accesses of the other two ways; a
  /// write also waits for writes.
  [[nodiscard]] static GLbitfield needed(Memory memory, GLbitfield kind, Way way);
  /// Records an access by the next dispatch.
  static void note(Memory memory, Way way);
  /// Calls glMemoryBarrier and records the barrier.
  static void barrier(GLbitfield kinds);
};

}  // namespace simreel::gl
