#include "sim/kernels/threads.hpp"

#include <algorithm>

namespace simreel::sim {

namespace {

bool isSingle(const kernels::Kernel& kernel) {
  return kernel.threads[0] * kernel.threads[1] * kernel.threads[2] == 1;
}

}  // namespace

bool isRow(const kernels::Kernel& kernel) {
  return isSingle(kernel) ? kernel.axes == 1 : kernel.threads[1] == 1 && kernel.threads[2] == 1;
}

std::optional<glm::ivec3> usualThreads(const kernels::Kernel& kernel, const KernelSizes& sizes) {
  const bool single = isSingle(kernel), row = isRow(kernel);
  if (single && kernel.axes == 0) return glm::ivec3(1);
  const auto written = [](const auto& memory) { return memory.writes; };
  if (row && std::any_of(kernel.textures.begin(), kernel.textures.end(), written) &&
      std::any_of(kernel.buffers.begin(), kernel.buffers.end(), written))
    return std::nullopt;
  for (const bool writes : {true, false}) {
    for (const kernels::Texture& texture : kernel.textures) {
      if (texture.writes != writes) continue;
      const glm::ivec3 size = sizes.texture(texture);
      // This is ambiguous, because the kernel may loop over the layers.
      if (texture.type == "2DArray" && size.z > 1 && kernel.threads[2] == 1) return std::nullopt;
      if (single && row) return std::nullopt;
      return size;
    }
    for (const kernels::Buffer& buffer : kernel.buffers) {
      // The number of elements of a counted buffer is not known yet.
      if (buffer.writes != writes || (writes && sizes.counted(buffer)) || !buffer.counterOf.empty() ||
          !buffer.previousOf.empty())
        continue;
      const glm::ivec3 size = sizes.buffer(buffer);
      const int count = size.x * size.y * size.z;
      // One-dimensional workgroups process the elements of a grid as a flat array.
      if (row) return glm::ivec3(count, 1, 1);
      if (size.y == 1 && count > 1) return std::nullopt;
      return size;
    }
  }
  return single ? std::nullopt : std::optional(glm::ivec3(1));
}

}  // namespace simreel::sim
