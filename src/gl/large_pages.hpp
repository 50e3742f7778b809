#pragma once
#include <cstddef>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Allocates GPU-only storage for a new buffer in the driver's largest pages. Returns false and leaves the
/// buffer unchanged if large pages or enough memory are not available. The contents are undefined.
/// NVIDIA's driver 580 maps storage from glNamedBufferStorage in small pages. Kernels that access more than
/// half a GiB of such storage spend half their time on address lookups (tools/bench/README.md). Memory
/// allocated through the driver's Vulkan API has large pages and can be imported into OpenGL
/// (GL_EXT_memory_object_fd). SIMREEL_LARGE_PAGES=no disables this.
[[nodiscard]] bool storeInLargePages(GLuint buffer, std::size_t bytes);

}  // namespace simreel::gl
