#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace simreel::gl {

/// Allocates GPU memory through Vulkan and exports it to OpenGL. It uses the already loaded OpenGL driver,
/// which includes Vulkan, so nothing needs to be installed.
class VulkanMemory {
 public:
  using Uuid = std::array<std::uint8_t, 16>;

  /// Opens the GPU with this UUID. Returns null if the driver is not NVIDIA's, or its Vulkan has no such
  /// GPU.
  static std::unique_ptr<VulkanMemory> of(const Uuid& device);
  ~VulkanMemory();
  VulkanMemory(VulkanMemory&&) = delete;
  VulkanMemory(const VulkanMemory&) = delete;
  VulkanMemory& operator=(VulkanMemory&&) = delete;
  VulkanMemory& operator=(const VulkanMemory&) = delete;

  /// Returns a file descriptor of `bytes` bytes of GPU memory; negative if memory is short. The memory is
  /// freed after its last user has released it.
  [[nodiscard]] int lend(std::size_t bytes) const;

 private:
  struct Device;
  explicit VulkanMemory(std::unique_ptr<Device> device);

  std::unique_ptr<Device> device_;
};

}  // namespace simreel::gl
