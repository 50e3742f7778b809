#pragma once
#include <cstddef>

#include <epoxy/gl.h>

namespace simreel::gl {

/// Gives a new buffer storage that only the GPU uses, in pages as large as the driver has. False where
/// there is no way to have them, or not so much memory: then the buffer is as it was. What it holds is
/// undefined.
///
/// NVIDIA's driver 580 maps what glNamedBufferStorage gives in small pages: kernels that go through more
/// than half a GiB of it look up addresses at half the time (tools/bench/README.md). What its Vulkan half
/// allocates is not, and may be lent to OpenGL (GL_EXT_memory_object_fd). SIMREEL_LARGE_PAGES=no does
/// without.
[[nodiscard]] bool storeInLargePages(GLuint buffer, std::size_t bytes);

}  // namespace simreel::gl
