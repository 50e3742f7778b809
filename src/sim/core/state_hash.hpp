#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/state_array.hpp"

#include <cstddef>
#include <string>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Part of a kernel interface: the uniforms declared in glsl/common/state_words.glsl.
struct StateWordsPart {
  gl::Uniform<"texels", int> texels;
  gl::Uniform<"planes", int> planes;
  gl::In<"words"> words;
  gl::In<"PlaneBlock"> planeWords;
};

struct StateHashKernel;

/// Binds a state array for kernels that use glsl/common/state_words.glsl, and owns the texture view of that
/// binding. Such kernels define PLANES for arrays stored in planes.
class StateWords {
 public:
  explicit StateWords(const StateArray& array);
  [[nodiscard]] StateWordsPart part() const;

 private:
  StateArray array_;
  gl::Texture view_;
};

/// Computes 128-bit hashes of state arrays on the GPU. Hashes are integer sums, so the order of workgroups
/// does not affect them.
class StateHash {
 public:
  StateHash();
  /// Adds the array's hash to the uvec4 at index `place` of `sums`. `number` is the zero-based index of the
  /// array among all hashed arrays, so that arrays of equal content hash differently. Writes of earlier
  /// dispatches must be visible (gl::barrier).
  void add(const gl::Buffer& array, std::size_t number, const gl::Buffer& sums, std::size_t place) const;
  void add(const StateArray& array, std::size_t number, const gl::Buffer& sums, std::size_t place) const;
  /// Formats a hash as 32 hexadecimal digits.
  [[nodiscard]] static std::string text(const glm::uvec4& hash);

 private:
  gl::Kernel<StateHashKernel> kernel_;
  mutable gl::Kernel<StateHashKernel>
      ofPlanes_;  ///< Kernel variant for arrays stored in planes; created on first use.
};

}  // namespace simreel::sim
