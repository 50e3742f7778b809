#pragma once
#include "gl/buffer.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace simreel::api {

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
  /// Returns the number of the card among the CUDA devices.
  [[nodiscard]] int device() const { return device_; }
  /// Copies a part of a buffer into new CUDA memory, which is freed with its last owner on any thread.
  /// Waits for the copy. Throws Error(device).
  [[nodiscard]] std::shared_ptr<void> copyOf(const gl::Buffer& buffer, std::size_t offset,
                                             std::size_t bytes);

 private:
  struct Functions;
  void open();
  void free(std::uint64_t memory) const noexcept;
  void require(int result, const char* what) const;

  void* library_ = nullptr;
  std::unique_ptr<Functions> functions_;
  void* context_ = nullptr;
  int device_ = 0;
  std::string problem_;
};

}  // namespace simreel::api
