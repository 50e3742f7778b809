#include "gl/vulkan_memory.hpp"

#include <dlfcn.h>
#include <utility>

namespace simreel::gl {

// What is called, as Vulkan's specification lays it out for C.
namespace vulkan {

using Result = std::int32_t;
using Object = void*;
using Function = void (*)();

enum Structure : std::int32_t {
  applicationInfo = 0,
  instanceInfo = 1,
  queueInfo = 2,
  deviceInfo = 3,
  memoryInfo = 5,
  properties2 = 1000059001,
  idProperties = 1000071004,
  exportInfo = 1000072002,
  fileInfo = 1000074002
};
constexpr std::uint32_t version11 = 1U << 22U | 1U << 12U;
constexpr std::uint32_t opaqueFile = 1;   // VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT
constexpr std::uint32_t deviceLocal = 1;  // VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT

struct ApplicationInfo {
  Structure type = applicationInfo;
  const void* next = nullptr;
  const char* name = "simreel";
  std::uint32_t version = 0;
  const char* engine = nullptr;
  std::uint32_t engineVersion = 0, apiVersion = version11;
};
struct InstanceInfo {
  Structure type = instanceInfo;
  const void* next = nullptr;
  std::uint32_t flags = 0;
  const ApplicationInfo* application = nullptr;
  std::uint32_t layers = 0;
  const char* const* layerNames = nullptr;
  std::uint32_t extensions = 0;
  const char* const* extensionNames = nullptr;
};
struct QueueInfo {
  Structure type = queueInfo;
  const void* next = nullptr;
  std::uint32_t flags = 0, family = 0, count = 1;
  const float* priorities = nullptr;
};
struct DeviceInfo {
  Structure type = deviceInfo;
  const void* next = nullptr;
  std::uint32_t flags = 0, queues = 1;
  const QueueInfo* queue = nullptr;
  std::uint32_t layers = 0;
  const char* const* layerNames = nullptr;
  std::uint32_t extensions = 0;
  const char* const* extensionNames = nullptr;
  const void* features = nullptr;
};
struct IdProperties {
  Structure type = idProperties;
  void* next = nullptr;
  VulkanMemory::Uuid device{}, driver{};
  std::uint8_t luid[8]{};
  std::uint32_t nodes = 0, luidValid = 0;
};
struct Properties2 {
  Structure type = properties2;
  void* next = nullptr;
  alignas(8) std::uint8_t properties[2048]{};  // VkPhysicalDeviceProperties: 824
};
struct MemoryProperties {
  struct Type {
    std::uint32_t flags, heap;
  };
  struct Heap {
    std::uint64_t bytes;
    std::uint32_t flags;
  };
  std::uint32_t typeCount = 0;
  Type types[32]{};
  std::uint32_t heapCount = 0;
  Heap heaps[16]{};
};
struct ExportInfo {
  Structure type = exportInfo;
  const void* next = nullptr;
  std::uint32_t kinds = opaqueFile;
};
struct MemoryInfo {
  Structure type = memoryInfo;
  const void* next = nullptr;
  std::uint64_t bytes = 0;
  std::uint32_t memoryType = 0;
};
struct FileInfo {
  Structure type = fileInfo;
  const void* next = nullptr;
  std::uint64_t memory = 0;
  std::uint32_t kind = opaqueFile;
};

// Of the library that EGL has loaded, with its loader's interface.
Function entryOf(const char* name) {
  void* driver = dlopen("libEGL_nvidia.so.0", RTLD_NOW | RTLD_NOLOAD);
  if (driver == nullptr) return nullptr;
  return reinterpret_cast<Function>(dlsym(driver, name));
}

class Instance {
 public:
  Instance() {
    const auto negotiate =
        reinterpret_cast<Result (*)(std::uint32_t*)>(entryOf("vk_icdNegotiateLoaderICDInterfaceVersion"));
    find_ = reinterpret_cast<Function (*)(Object, const char*)>(entryOf("vk_icdGetInstanceProcAddr"));
    std::uint32_t version = 5;
    if (find_ == nullptr || negotiate == nullptr || negotiate(&version) != 0) return;
    const ApplicationInfo application;
    InstanceInfo info;
    info.application = &application;
    const auto create = get<Result (*)(const InstanceInfo*, const void*, Object*)>("vkCreateInstance");
    if (create == nullptr || create(&info, nullptr, &handle_) != 0) handle_ = nullptr;
  }
  template <class F>
  [[nodiscard]] F get(const char* name) const {
    return reinterpret_cast<F>(find_(handle_, name));
  }
  [[nodiscard]] Object handle() const { return handle_; }

 private:
  Function (*find_)(Object, const char*) = nullptr;
  Object handle_ = nullptr;
};

Object physicalDevice(const Instance& instance, const VulkanMemory::Uuid& wanted) {
  const auto list = instance.get<Result (*)(Object, std::uint32_t*, Object*)>("vkEnumeratePhysicalDevices");
  const auto describe = instance.get<void (*)(Object, Properties2*)>("vkGetPhysicalDeviceProperties2");
  std::uint32_t count = 64;
  Object devices[64]{};
  if (list == nullptr || describe == nullptr || list(instance.handle(), &count, devices) < 0)
    return nullptr;
  for (std::uint32_t i = 0; i < count; ++i) {
    IdProperties ids;
    Properties2 properties;
    properties.next = &ids;
    describe(devices[i], &properties);
    if (ids.device == wanted) return devices[i];
  }
  return nullptr;
}

}  // namespace vulkan

struct VulkanMemory::Device {
  vulkan::Instance instance;
  vulkan::Object handle = nullptr;
  std::uint32_t memoryType = 0;
  vulkan::Result (*allocate)(vulkan::Object, const vulkan::MemoryInfo*, const void*,
                             std::uint64_t*) = nullptr;
  void (*free)(vulkan::Object, std::uint64_t, const void*) = nullptr;
  vulkan::Result (*fileOf)(vulkan::Object, const vulkan::FileInfo*, int*) = nullptr;

  [[nodiscard]] bool open(const Uuid& wanted) {
    if (instance.handle() == nullptr) return false;
    const vulkan::Object physical = vulkan::physicalDevice(instance, wanted);
    if (physical == nullptr) return false;
    const float priority = 1;
    vulkan::QueueInfo queue;
    queue.priorities = &priority;
    const char* const extension = "VK_KHR_external_memory_fd";
    vulkan::DeviceInfo info;
    info.queue = &queue;
    info.extensions = 1;
    info.extensionNames = &extension;
    const auto create = instance.get<vulkan::Result (*)(vulkan::Object, const vulkan::DeviceInfo*,
                                                        const void*, vulkan::Object*)>("vkCreateDevice");
    const auto memory = instance.get<void (*)(vulkan::Object, vulkan::MemoryProperties*)>(
        "vkGetPhysicalDeviceMemoryProperties");
    if (create == nullptr || memory == nullptr || create(physical, &info, nullptr, &handle) != 0)
      return false;
    const auto find =
        instance.get<vulkan::Function (*)(vulkan::Object, const char*)>("vkGetDeviceProcAddr");
    if (find == nullptr) return false;
    allocate = reinterpret_cast<decltype(allocate)>(find(handle, "vkAllocateMemory"));
    free = reinterpret_cast<decltype(free)>(find(handle, "vkFreeMemory"));
    fileOf = reinterpret_cast<decltype(fileOf)>(find(handle, "vkGetMemoryFdKHR"));
    vulkan::MemoryProperties properties;
    memory(physical, &properties);
    while (memoryType < properties.typeCount && properties.types[memoryType].flags != vulkan::deviceLocal)
      ++memoryType;
    return memoryType < properties.typeCount && allocate != nullptr && free != nullptr && fileOf != nullptr;
  }
};

VulkanMemory::VulkanMemory(std::unique_ptr<Device> device) : device_(std::move(device)) {}

VulkanMemory::~VulkanMemory() = default;

std::unique_ptr<VulkanMemory> VulkanMemory::of(const Uuid& device) {
  auto opened = std::make_unique<Device>();
  if (!opened->open(device)) return nullptr;
  return std::unique_ptr<VulkanMemory>(new VulkanMemory(std::move(opened)));
}

int VulkanMemory::lend(std::size_t bytes) const {
  const vulkan::ExportInfo exported;
  vulkan::MemoryInfo info;
  info.next = &exported;
  info.bytes = bytes;
  info.memoryType = device_->memoryType;
  vulkan::FileInfo asked;
  if (device_->allocate(device_->handle, &info, nullptr, &asked.memory) != 0) return -1;
  int file = -1;
  if (device_->fileOf(device_->handle, &asked, &file) != 0) file = -1;
  device_->free(device_->handle, asked.memory, nullptr);
  return file;
}

}  // namespace simreel::gl
