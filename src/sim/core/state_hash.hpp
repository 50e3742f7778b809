#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/state_array.hpp"

#include <cstddef>
#include <string>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// What glsl/common/state_words.glsl is given, a part of a kernel's interface.
struct StateWordsPart {
  gl::Uniform<"texels", int> texels;
  gl::Uniform<"planes", int> planes;
  gl::In<"words"> words;
  gl::In<"PlaneBlock"> planeWords;
};

struct StateHashKernel;

/// A state array as kernels of glsl/common/state_words.glsl read it, for as long as it lives; PLANES is
/// defined for arrays that are in planes.
class StateWords {
 public:
  explicit StateWords(const StateArray& array);
  [[nodiscard]] StateWordsPart part() const;

 private:
  StateArray array_;
  gl::Texture view_;
};

/// 128-bit hashes of state arrays, made on the GPU: sums of integers, so no order of work groups changes
/// them.
class StateHash {
 public:
  StateHash();
  /// Adds the array's hash to uvec4 number `place` of `sums`. `number` is the array's place among all that
  /// are hashed, from 0: it tells arrays of equal content apart. Writes of earlier dispatches must be
  /// visible (gl::barrier).
  void add(const gl::Buffer& array, std::size_t number, const gl::Buffer& sums, std::size_t place) const;
  void add(const StateArray& array, std::size_t number, const gl::Buffer& sums, std::size_t place) const;
  /// 32 hexadecimal digits.
  [[nodiscard]] static std::string text(const glm::uvec4& hash);

 private:
  gl::Kernel<StateHashKernel> kernel_;
  mutable gl::Kernel<StateHashKernel> ofPlanes_;  ///< made for the first array that is in planes
};

}  // namespace simreel::sim
