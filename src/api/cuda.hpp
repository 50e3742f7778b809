#pragma once
#include "gl/buffer.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace simreel::api {

/// Block of equal rows that a copy takes from a buffer. Rows are `pitch` bytes apart in the buffer.
struct DeviceRows {
  std::size_t offset = 0;  ///< bytes from the start of the buffer to the first row
  std::size_t pitch = 0;
  std::size_t width = 0;  ///< bytes of a row
  std::size_t count = 0;  ///< number of rows
};

/// The CUDA driver, opened at run time, on the card of the current OpenGL context. It uses the card's
/// primary context, as PyTorch and JAX do. All functions but free() run on the thread of the OpenGL
/// context.
class Cuda : public std::enable_shared_from_this<Cuda> {
 public:
  /// Opens the driver. If that fails, problem() says why.
  Cuda();
  ~Cuda();
  Cuda(const Cuda&) = delete;
  Cuda& operator=(const Cuda&) = delete;

  /// Returns why CUDA cannot be used; empty if it can.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// Releases what depends on the OpenGL context. Must be called before that context is destroyed. Copies
  /// remain.
  void close() noexcept;
  /// Returns the number of the card among the CUDA devices.
  [[nodiscard]] int device() const { return device_; }
  /// Copies blocks of equally many rows from a buffer into new CUDA memory, in which row i of every block
  /// follows row i of the block before, without gaps. The memory is freed with its last owner on any
  /// thread. Waits for the copy. Throws Error(device).
  [[nodiscard]] std::shared_ptr<void> copyOf(const gl::Buffer& buffer,
                                             const std::vector<DeviceRows>& blocks);

 private:
  struct RowCopy;
  struct Functions;
  void open();
  void free(std::uint64_t memory) const noexcept;
  [[nodiscard]] std::shared_ptr<void> allocate(std::size_t bytes);
  void dropStaging() noexcept;
  void stage(const gl::Buffer& buffer, std::size_t offset, std::size_t bytes);
  void copyRows(std::uint64_t to, std::uint64_t from, std::size_t pitch, const DeviceRows& rows) const;
  void require(int result, const char* what) const;

  void* library_ = nullptr;
  std::unique_ptr<Functions> functions_;
  void* context_ = nullptr;
  int device_ = 0;
  std::string problem_;
  /// OpenGL buffer that CUDA has registered. State goes through it, because memory that comes from Vulkan
  /// cannot be registered. It stays as large as the largest copied array, because registering takes 1 ms.
  struct Staging {
    unsigned buffer = 0;
    std::size_t bytes = 0;
    void* resource = nullptr;
  };
  Staging staging_;
};

}  // namespace simreel::api
