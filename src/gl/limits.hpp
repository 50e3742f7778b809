#pragma once
#include <cstdint>

namespace simreel::gl {

/// Limits of the current context that affect the program.
struct Limits {
  std::int64_t storageBlockBytes = 0;  ///< GL_MAX_SHADER_STORAGE_BLOCK_SIZE
  std::int64_t texelBufferTexels = 0;  ///< GL_MAX_TEXTURE_BUFFER_SIZE
  std::int32_t textureSize = 0;        ///< GL_MAX_TEXTURE_SIZE
  std::int32_t samples = 0;            ///< GL_MAX_SAMPLES
  std::int32_t groupsX = 0;            ///< GL_MAX_COMPUTE_WORK_GROUP_COUNT[0]
  std::int32_t groupsY = 0;      ///< GL_MAX_COMPUTE_WORK_GROUP_COUNT[1], much smaller on graphics cards
  std::int32_t sharedBytes = 0;  ///< GL_MAX_COMPUTE_SHARED_MEMORY_SIZE
  std::int32_t uniformAlignment = 256;  ///< GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT
  bool shuffle32 = false;   ///< true if subgroups of 32 with relative shuffle and vote are supported
                            ///< (GL_KHR_shader_subgroup)
  bool ballot = false;      ///< true if subgroup ballot operations are supported (GL_KHR_shader_subgroup)
  bool atomics64 = false;   ///< true if 64-bit atomic min is supported (GL_NV_shader_atomic_int64)
  float anisotropy = 1.0F;  ///< GL_MAX_TEXTURE_MAX_ANISOTROPY, or 1 if anisotropic filtering is not
                            ///< supported
};

/// Returns the limits of the current context, which are read once when the context is created.
[[nodiscard]] const Limits& limits();

}  // namespace simreel::gl
