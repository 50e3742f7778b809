#include "gl/vulkan_memory.hpp"

// Loads the Vulkan functions from the driver directly, without linking the Vulkan loader.
#define VK_NO_PROTOTYPES
#include <algorithm>
#include <array>
#include <dlfcn.h>
#include <utility>
#include <vulkan/vulkan_core.h>

namespace simreel::gl {

namespace {

// Returns an entry point of the NVIDIA library that EGL has already loaded. The library gives Vulkan's
// loader the same interface.
template <class F>
F entryOf(const char* name) {
  void* driver = dlopen("libEGL_nvidia.so.0", RTLD_NOW | RTLD_NOLOAD);
  return driver != nullptr ? reinterpret_cast<F>(dlsym(driver, name)) : nullptr;
}

class Instance {
 public:
  Instance() {
    const auto negotiate =
        entryOf<VkResult (*)(std::uint32_t*)>("vk_icdNegotiateLoaderICDInterfaceVersion");
    find_ = entryOf<PFN_vkGetInstanceProcAddr>("vk_icdGetInstanceProcAddr");
    std::uint32_t version = 5;
    if (find_ == nullptr || negotiate == nullptr || negotiate(&version) != VK_SUCCESS) return;
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    const auto create = get<PFN_vkCreateInstance>("vkCreateInstance");
    if (create == nullptr || create(&info, nullptr, &handle_) != VK_SUCCESS) handle_ = nullptr;
  }
  template <class F>
  [[nodiscard]] F get(const char* name) const {
    return reinterpret_cast<F>(find_(handle_, name));
  }
  [[nodiscard]] VkInstance handle() const { return handle_; }

 private:
  PFN_vkGetInstanceProcAddr find_ = nullptr;
  VkInstance handle_ = nullptr;
};

VkPhysicalDevice physicalDevice(const Instance& instance, const VulkanMemory::Uuid& wanted) {
  const auto list = instance.get<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
  const auto describe = instance.get<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2");
  std::array<VkPhysicalDevice, 64> devices{};
  std::uint32_t count = devices.size();
  if (list == nullptr || describe == nullptr ||
      list(instance.handle(), &count, devices.data()) < VK_SUCCESS)
    return nullptr;
  for (std::uint32_t i = 0; i < count; ++i) {
    VkPhysicalDeviceIDProperties ids{};
    ids.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &ids;
    describe(devices[i], &properties);
    if (std::equal(wanted.begin(), wanted.end(), std::begin(ids.deviceUUID))) return devices[i];
  }
  return nullptr;
}

}  // namespace

struct VulkanMemory::Device {
  Instance instance;
  VkDevice handle = nullptr;
  std::uint32_t memoryType = 0;
  PFN_vkAllocateMemory allocate = nullptr;
  PFN_vkFreeMemory free = nullptr;
  PFN_vkGetMemoryFdKHR fileOf = nullptr;

  [[nodiscard]] bool open(const Uuid& wanted) {
    if (instance.handle() == nullptr) return false;
    const VkPhysicalDevice physical = physicalDevice(instance, wanted);
    if (physical == nullptr) return false;
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const char* const extension = VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    const auto create = instance.get<PFN_vkCreateDevice>("vkCreateDevice");
    const auto memory =
        instance.get<PFN_vkGetPhysicalDeviceMemoryProperties>("vkGetPhysicalDeviceMemoryProperties");
    if (create == nullptr || memory == nullptr || create(physical, &info, nullptr, &handle) != VK_SUCCESS)
      return false;
    const auto find = instance.get<PFN_vkGetDeviceProcAddr>("vkGetDeviceProcAddr");
    if (find == nullptr) return false;
    allocate = reinterpret_cast<PFN_vkAllocateMemory>(find(handle, "vkAllocateMemory"));
    free = reinterpret_cast<PFN_vkFreeMemory>(find(handle, "vkFreeMemory"));
    fileOf = reinterpret_cast<PFN_vkGetMemoryFdKHR>(find(handle, "vkGetMemoryFdKHR"));
    VkPhysicalDeviceMemoryProperties properties{};
    memory(physical, &properties);
    while (memoryType < properties.memoryTypeCount &&
           properties.memoryTypes[memoryType].propertyFlags != VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT)
      ++memoryType;
    return memoryType < properties.memoryTypeCount && allocate != nullptr && free != nullptr &&
           fileOf != nullptr;
  }
};

VulkanMemory::VulkanMemory(std::unique_ptr<Device> device) : device_(std::move(device)) {}

VulkanMemory::~VulkanMemory() = default;

std::unique_ptr<VulkanMemory> VulkanMemory::of(const Uuid& device) {
  auto opened = std::make_unique<Device>();
  if (!opened->open(device)) return nullptr;
  return std::unique_ptr<VulkanMemory>(new VulkanMemory(std::move(opened)));
}

int VulkanMemory::exportMemory(std::size_t bytes) const {
  VkExportMemoryAllocateInfo exported{};
  exported.sType = VK_STRUCTURE_TYPE_EXPORT_MEMORY_ALLOCATE_INFO;
  exported.handleTypes = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.pNext = &exported;
  info.allocationSize = bytes;
  info.memoryTypeIndex = device_->memoryType;
  VkMemoryGetFdInfoKHR asked{};
  asked.sType = VK_STRUCTURE_TYPE_MEMORY_GET_FD_INFO_KHR;
  asked.handleType = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
  if (device_->allocate(device_->handle, &info, nullptr, &asked.memory) != VK_SUCCESS) return -1;
  int file = -1;
  if (device_->fileOf(device_->handle, &asked, &file) != VK_SUCCESS) file = -1;
  device_->free(device_->handle, asked.memory, nullptr);
  return file;
}

}  // namespace simreel::gl
