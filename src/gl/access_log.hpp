#pragma once
#include <cstdint>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Accesses of buffers and textures by typed kernels (gl::Kernel) since the last barriers, in dispatches of
/// the current context. A kernel asks for the barriers it needs before it reads or writes; explicit
/// barriers count where they come by AccessLog::barrier, as gl::barrier() does. It knows nothing of what a
/// gl::Program accesses: code around those makes its barriers itself.
class AccessLog {
 public:
  /// A buffer or a texture of its own memory, by the driver's name.
  struct Memory {
    GLuint name = 0;
    bool texture = false;
  };

  /// `together`: reads and writes that need no order among themselves (gl::Shared).
  enum class Way { read, write, together };

  /// The barrier bits to be issued before `memory` is accessed the way that `kind` says (one bit of
  /// glMemoryBarrier); 0 where none is due. Each way waits for all others, writes for writes, too.
  [[nodiscard]] static GLbitfield needed(Memory memory, GLbitfield kind, Way way);
  /// Notes an access of the dispatch that comes next.
  static void note(Memory memory, Way way);
  /// glMemoryBarrier.
  static void barrier(GLbitfield kinds);
};

}  // namespace simreel::gl
