#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace simreel::gl {

/// A GPU's memory by way of Vulkan, as far as that is needed to lend some to OpenGL. Asks the OpenGL driver
/// that is loaded, which brings Vulkan with it, so there is nothing to install.
class VulkanMemory {
 public:
  using Uuid = std::array<std::uint8_t, 16>;

  /// Of the GPU with that number; null where the driver is not NVIDIA's, or its Vulkan has no such GPU.
  static std::unique_ptr<VulkanMemory> of(const Uuid& device);
  ~VulkanMemory();
  VulkanMemory(VulkanMemory&&) = delete;
  VulkanMemory(const VulkanMemory&) = delete;
  VulkanMemory& operator=(VulkanMemory&&) = delete;
  VulkanMemory& operator=(const VulkanMemory&) = delete;

  /// A file descriptor of so many bytes of the GPU's own memory, which is freed when nobody holds it any
  /// more; below 0: there is no such memory left.
  [[nodiscard]] int lend(std::size_t bytes) const;

 private:
  struct Device;
  explicit VulkanMemory(std::unique_ptr<Device> device);

  std::unique_ptr<Device> device_;
};

}  // namespace simreel::gl
