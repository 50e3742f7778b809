#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace simreel::gl {

/// Allocates GPU memory through Vulkan and exports it to OpenGL. Uses the already loaded OpenGL driver,
/// which includes Vulkan, so no additional library is needed.
class VulkanMemory {
 public:
  using Uuid = std::array<std::uint8_t, 16>;

  /// Opens the GPU with this UUID. Returns null if the driver is not NVIDIA's, or if its Vulkan does not
  /// have this GPU.
  static std::unique_ptr<VulkanMemory> of(const Uuid& device);
  ~VulkanMemory();
  VulkanMemory(VulkanMemory&&) = delete;
  VulkanMemory(const VulkanMemory&) = delete;
  VulkanMemory& operator=(VulkanMemory&&) = delete;
  VulkanMemory& operator=(const VulkanMemory&) = delete;

  /// Returns a file descriptor for `bytes` bytes of GPU memory, or a negative number on failure, for
  /// example if there is not enough memory. The memory is freed when no object uses it any more.
  [[nodiscard]] int exportMemory(std::size_t bytes) const;

 private:
  struct Device;
  explicit VulkanMemory(std::unique_ptr<Device> device);

  std::unique_ptr<Device> device_;
};

}  // namespace simreel::gl
