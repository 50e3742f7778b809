#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <cstdint>

namespace simreel::draw {

struct CountRays;

/// Counts the rays of path-traced pictures while an object of this class exists. During this time the CPU
/// waits for each step, so `simreel bench` counts rays only after its timings. At most one object may exist
/// at a time. It belongs to the current context.
class RayCount {
 public:
  RayCount();
  ~RayCount();
  RayCount(const RayCount&) = delete;
  RayCount& operator=(const RayCount&) = delete;
  RayCount(RayCount&&) = delete;
  RayCount& operator=(RayCount&&) = delete;

  /// Returns the number of rays with a length above 0 that were traced; 0 without path tracing.
  [[nodiscard]] std::uint64_t rays() const { return rays_; }

  /// Returns the existing object, or null.
  [[nodiscard]] static RayCount* current();
  /// Counts the rays from `first` to first + count - 1 whose length is above 0. The rays must already be
  /// written.
  void add(const gl::Texture& rays, int first, int count);
  /// Counts `count` rays, all with a length above 0.
  void add(int count) { rays_ += static_cast<std::uint64_t>(count); }

 private:
  std::uint64_t rays_ = 0;
  gl::Buffer total_;
  gl::Kernel<CountRays> kernel_;
};

}  // namespace simreel::draw
