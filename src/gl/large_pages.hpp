#pragma once
#include <cstddef>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Gives a new buffer GPU-only storage in the driver's largest pages. Returns false and leaves the buffer
/// unchanged if large pages are not available or memory is short. The contents are undefined.
///
/// NVIDIA's driver 580 maps storage from glNamedBufferStorage in small pages: kernels that access more than
/// half a GiB of it spend half their time on address lookups (tools/bench/README.md). Memory allocated
/// through the driver's Vulkan API has large pages and can be imported into OpenGL
/// (GL_EXT_memory_object_fd). SIMREEL_LARGE_PAGES=no switches this off.
[[nodiscard]] bool storeInLargePages(GLuint buffer, std::size_t bytes);

}  // namespace simreel::gl
