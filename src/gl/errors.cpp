#include "gl/errors.hpp"

#include "base/error.hpp"

#include <epoxy/gl.h>

namespace simreel::gl {

namespace {

/// Throws UserError(device) if the device was reset (GL_KHR_robustness). Afterwards calls do nothing, and
/// reads return arbitrary values.
void checkReset(GLenum error) {
  const GLenum reset = glGetGraphicsResetStatus();
  if (reset == GL_NO_ERROR && error != GL_CONTEXT_LOST) return;
  if (reset == GL_GUILTY_CONTEXT_RESET)
    fail(ExitCode::device,
         "the driver has reset the device, because a kernel of this scene ran too long or failed; shorten "
         "its "
         "loops, or run fewer iterations per dispatch");
  fail(ExitCode::device,
       "the driver has reset the device, and this program has lost its data there; another program may be "
       "the "
       "reason; run again");
}

}  // namespace

void checkCalls() {
  const GLenum error = glGetError();
  checkReset(error);
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
