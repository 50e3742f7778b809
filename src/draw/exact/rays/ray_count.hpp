#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <cstdint>

namespace simreel::draw {

struct CountRays;

/// While one lives, rays of pictures of quality "high" are counted, which makes the CPU wait for each step
/// of them: for `simreel bench`, after its times. One at a time, of the current context.
class RayCount {
 public:
  RayCount();
  ~RayCount();
  RayCount(const RayCount&) = delete;
  RayCount& operator=(const RayCount&) = delete;
  RayCount(RayCount&&) = delete;
  RayCount& operator=(RayCount&&) = delete;

  /// Of those that have been traced, the ones that went any way. 0 where no picture was of that quality.
  [[nodiscard]] std::uint64_t rays() const { return rays_; }

  /// The one that lives, or null.
  [[nodiscard]] static RayCount* current();
  /// Rays `first` to before `first + count` are about to be traced; they are written.
  void add(const gl::Texture& rays, int first, int count);
  /// So many are, that all go some way.
  void add(int count) { rays_ += static_cast<std::uint64_t>(count); }

 private:
  std::uint64_t rays_ = 0;
  gl::Buffer total_;
  gl::Kernel<CountRays> kernel_;
};

}  // namespace simreel::draw
