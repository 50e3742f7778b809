#include "gl/errors.hpp"

#include "base/error.hpp"

#include <epoxy/gl.h>

namespace simreel::gl {

void checkCalls() {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  // OpenGL has one error flag per error type; the loop clears all of them.
  while (glGetError() != GL_NO_ERROR) {
  }
  if (error == GL_OUT_OF_MEMORY)
    fail(ExitCode::device, "the device has no memory left; make the scene or the picture smaller");
  fail(ExitCode::device,
       "the driver rejected a call (OpenGL error {:#x}); run again with --debug to see the reason", error);
}

}  // namespace simreel::gl
