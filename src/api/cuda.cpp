#include "api/cuda.hpp"

#include "api/failure.hpp"

#include <algorithm>
#include <bit>
#include <dlfcn.h>
#include <utility>

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace simreel::api {

/// Copy of rows between two places, CUDA_MEMCPY2D of the driver.
struct Cuda::RowCopy {
  struct Place {
    std::size_t x = 0, y = 0;
    int memoryType = 2;  // CU_MEMORYTYPE_DEVICE
    void* host = nullptr;
    std::uint64_t device = 0;
    void* array = nullptr;
    std::size_t pitch = 0;
  };
  Place from, to;
  std::size_t width = 0, height = 0;
};

/// Functions of the CUDA driver (NVIDIA, "CUDA Driver API"), by the names of their present versions.
/// Results are 0 for success.
struct Cuda::Functions {
  int (*init)(unsigned flags);
  int (*glGetDevices)(unsigned* count, int* devices, unsigned maximum, int which);
  int (*retain)(void** context, int device);
  int (*release)(int device);
  int (*push)(void* context);
  int (*pop)(void** context);
  int (*synchronize)();
  int (*allocate)(std::uint64_t* memory, std::size_t bytes);
  int (*freeMemory)(std::uint64_t memory);
  int (*copy)(std::uint64_t to, std::uint64_t from, std::size_t bytes);
  int (*copyRows)(const RowCopy* copy);
  int (*registerBuffer)(void** resource, unsigned buffer, unsigned flags);
  int (*unregister)(void* resource);
  int (*map)(unsigned count, void** resources, void* stream);
  int (*unmap)(unsigned count, void** resources, void* stream);
  int (*pointer)(std::uint64_t* memory, std::size_t* bytes, void* resource);
  int (*nameError)(int result, const char** name);
};

namespace {

constexpr int allDevices = 1;         // CU_GL_DEVICE_LIST_ALL
constexpr unsigned readOnlyFlag = 1;  // CU_GRAPHICS_REGISTER_FLAGS_READ_ONLY

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  return function != nullptr;
}

/// Calls a function at the end of a block.
template <class Work>
class AtEnd {
 public:
  explicit AtEnd(Work work) : work_(std::move(work)) {}
  ~AtEnd() { work_(); }
  AtEnd(const AtEnd&) = delete;
  AtEnd& operator=(const AtEnd&) = delete;

 private:
  Work work_;
};

}  // namespace

Cuda::Cuda() {
  open();
}

void Cuda::open() {
  library_ = ::dlopen("libcuda.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr) {
    problem_ = "there is no CUDA driver (libcuda.so.1)";
    return;
  }
  functions_ = std::make_unique<Functions>();
  Functions& f = *functions_;
  const bool all =
      find(library_, "cuInit", f.init) && find(library_, "cuGLGetDevices_v2", f.glGetDevices) &&
      find(library_, "cuDevicePrimaryCtxRetain", f.retain) &&
      find(library_, "cuDevicePrimaryCtxRelease_v2", f.release) &&
      find(library_, "cuCtxPushCurrent_v2", f.push) && find(library_, "cuCtxPopCurrent_v2", f.pop) &&
      find(library_, "cuCtxSynchronize", f.synchronize) && find(library_, "cuMemAlloc_v2", f.allocate) &&
      find(library_, "cuMemFree_v2", f.freeMemory) && find(library_, "cuMemcpyDtoD_v2", f.copy) &&
      find(library_, "cuMemcpy2DUnaligned_v2", f.copyRows) &&
      find(library_, "cuGraphicsGLRegisterBuffer", f.registerBuffer) &&
      find(library_, "cuGraphicsUnregisterResource", f.unregister) &&
      find(library_, "cuGraphicsMapResources", f.map) &&
      find(library_, "cuGraphicsUnmapResources", f.unmap) &&
      find(library_, "cuGraphicsResourceGetMappedPointer_v2", f.pointer) &&
      find(library_, "cuGetErrorName", f.nameError);
  if (!all) {
    problem_ = "the CUDA driver is too old";
    return;
  }
  unsigned count = 0;
  if (f.init(0) != 0)
    problem_ = "the CUDA driver has no device";
  else if (f.glGetDevices(&count, &device_, 1, allDevices) != 0 || count == 0)
    problem_ = "OpenGL draws on no CUDA device";
  else if (f.retain(&context_, device_) != 0)
    problem_ = "the CUDA device cannot be opened";
}

void Cuda::close() noexcept {
  dropStaging();
}

Cuda::~Cuda() {
  if (context_ != nullptr) functions_->release(device_);
  // The library stays loaded, because others may use it.
}

void Cuda::require(int result, const char* what) const {
  if (result == 0) return;
  const char* name = nullptr;
  functions_->nameError(result, &name);
  fail(ErrorKind::device,
       fmt::format("{}: CUDA reports {}", what,
                   name == nullptr ? fmt::format("error {}", result) : std::string(name)));
}

void Cuda::free(std::uint64_t memory) const noexcept {
  void* previous = nullptr;
  if (functions_->push(context_) != 0) return;
  functions_->freeMemory(memory);
  functions_->pop(&previous);
}

std::shared_ptr<void> Cuda::allocate(std::size_t bytes) {
  std::uint64_t memory = 0;
  require(functions_->allocate(&memory, bytes), "a copy of a state array does not fit on the card");
  return {std::bit_cast<void*>(static_cast<std::uintptr_t>(memory)),
          [owner = shared_from_this(), memory](void*) { owner->free(memory); }};
}

void Cuda::dropStaging() noexcept {
  void* previous = nullptr;
  if (staging_.resource != nullptr && functions_->push(context_) == 0) {
    functions_->unregister(staging_.resource);
    functions_->pop(&previous);
  }
  if (staging_.buffer != 0) glDeleteBuffers(1, &staging_.buffer);
  staging_ = {};
}

/// Copies a part of a buffer to the start of the staging buffer. Mapping that buffer waits for the copy.
void Cuda::stage(const gl::Buffer& buffer, std::size_t offset, std::size_t bytes) {
  if (staging_.bytes < bytes) {
    dropStaging();
    glCreateBuffers(1, &staging_.buffer);
    glNamedBufferData(staging_.buffer, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_COPY);
    require(functions_->registerBuffer(&staging_.resource, staging_.buffer, readOnlyFlag),
            "an OpenGL buffer cannot be shared");
    staging_.bytes = bytes;
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(buffer.name(), staging_.buffer, static_cast<GLintptr>(offset), 0,
                           static_cast<GLsizeiptr>(bytes));
}

void Cuda::copyRows(std::uint64_t to, std::uint64_t from, std::size_t pitch, const DeviceRows& rows) const {
  constexpr const char* failure = "a state array cannot be copied on the card";
  if (rows.pitch == pitch) return require(functions_->copy(to, from, rows.width * rows.count), failure);
  RowCopy copy;
  copy.from.device = from;
  copy.from.pitch = rows.pitch;
  copy.to.device = to;
  copy.to.pitch = pitch;
  copy.width = rows.width;
  copy.height = rows.count;
  require(functions_->copyRows(&copy), failure);
}

std::shared_ptr<void> Cuda::copyOf(const gl::Buffer& buffer, const std::vector<DeviceRows>& blocks) {
  const Functions& f = *functions_;
  std::size_t begin = SIZE_MAX, end = 0, pitch = 0;
  for (const DeviceRows& rows : blocks) {
    begin = std::min(begin, rows.offset);
    end = std::max(end, rows.offset + (rows.count - 1) * rows.pitch + rows.width);
    pitch += rows.width;
  }
  require(f.push(context_), "a state array cannot be copied on the card");
  const AtEnd popped([&] {
    void* previous = nullptr;
    f.pop(&previous);
  });
  stage(buffer, begin, end - begin);
  require(f.map(1, &staging_.resource, nullptr), "an OpenGL buffer cannot be mapped");
  const AtEnd unmapped([&] { f.unmap(1, &staging_.resource, nullptr); });
  std::uint64_t from = 0;
  std::size_t mapped = 0;
  require(f.pointer(&from, &mapped, staging_.resource), "an OpenGL buffer has no address");
  std::shared_ptr<void> made = allocate(pitch * blocks.front().count);
  std::uint64_t to = std::bit_cast<std::uintptr_t>(made.get());
  for (const DeviceRows& rows : blocks) {
    copyRows(to, from + rows.offset - begin, pitch, rows);
    to += rows.width;
  }
  require(f.synchronize(), "a state array cannot be copied on the card");
  return made;
}

}  // namespace simreel::api
