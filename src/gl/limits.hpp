#pragma once
#include <cstdint>

namespace simreel::gl {

/// Limits of the current context that the program runs into.
struct Limits {
  std::int64_t storageBlockBytes = 0;   ///< GL_MAX_SHADER_STORAGE_BLOCK_SIZE
  std::int64_t texelBufferTexels = 0;   ///< GL_MAX_TEXTURE_BUFFER_SIZE
  std::int32_t textureSize = 0;         ///< GL_MAX_TEXTURE_SIZE
  std::int32_t samples = 0;             ///< GL_MAX_SAMPLES
  std::int32_t groupsX = 0;             ///< GL_MAX_COMPUTE_WORK_GROUP_COUNT[0]
  std::int32_t groupsY = 0;             ///< and [1], which on graphics cards is smaller by far
  std::int32_t sharedBytes = 0;         ///< GL_MAX_COMPUTE_SHARED_MEMORY_SIZE
  std::int32_t uniformAlignment = 256;  ///< GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT
  bool shuffle32 = false;   ///< subgroups of 32 that exchange registers (GL_KHR_shader_subgroup)
  bool ballot = false;      ///< subgroups whose invocations count themselves (GL_KHR_shader_subgroup)
  bool atomics64 = false;   ///< atomic minimum of 64-bit words (GL_NV_shader_atomic_int64)
  float anisotropy = 1.0F;  ///< GL_MAX_TEXTURE_MAX_ANISOTROPY, 1 where it is missing
};

/// Of the current context; read once when the context is made.
[[nodiscard]] const Limits& limits();

}  // namespace simreel::gl
