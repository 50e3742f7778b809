#pragma once
#include "kernels/shader/shader.hpp"

#include <functional>
#include <optional>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Size of each memory of a kernel, in elements or texels.
struct KernelSizes {
  std::function<glm::ivec3(const kernels::Texture&)> texture;
  std::function<glm::ivec3(const kernels::Buffer&)> buffer;
  /// Returns true for an append or consume buffer.
  std::function<bool(const kernels::Buffer&)> counted;
};

/// Returns the default number of invocations of a kernel: the size of the first texture that it writes,
/// otherwise of the first buffer that it writes, otherwise of the first memory that it reads. A workgroup
/// of one invocation that does not read its index runs once. Returns nullopt if the size is ambiguous: a
/// kernel with workgroups along one axis writes a texture and a buffer, or a kernel with workgroups along
/// several axes writes a buffer of one axis. Workgroups of one invocation count as having one axis if they
/// read only x of the index.
[[nodiscard]] std::optional<glm::ivec3> usualThreads(const kernels::Kernel& kernel,
                                                     const KernelSizes& sizes);

/// Returns true if the kernel's workgroups extend along only one axis.
[[nodiscard]] bool isRow(const kernels::Kernel& kernel);

}  // namespace simreel::sim
