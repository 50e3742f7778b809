#pragma once
#include "kernels/shader/shader.hpp"

#include <functional>
#include <optional>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Sizes of the memory of a kernel, in elements or texels.
struct KernelSizes {
  std::function<glm::ivec3(const kernels::Texture&)> texture;
  std::function<glm::ivec3(const kernels::Buffer&)> buffer;
  /// Returns true for an append or consume buffer.
  std::function<bool(const kernels::Buffer&)> counted;
};

/// Returns the default number of invocations of a kernel: the size of the first texture that it writes,
/// else of the first buffer that it writes, else of the first memory that it reads. A group of one thread
/// that does not read its index runs once. Returns nullopt if the size is ambiguous: a kernel with groups
/// along one axis that writes a texture and a buffer, or a buffer of one axis and groups with several axes.
/// Groups of one thread count as one axis if they read only x.
[[nodiscard]] std::optional<glm::ivec3> usualThreads(const kernels::Kernel& kernel,
                                                     const KernelSizes& sizes);

/// Returns true if groups of the kernel lie along one axis.
[[nodiscard]] bool isRow(const kernels::Kernel& kernel);

}  // namespace simreel::sim
