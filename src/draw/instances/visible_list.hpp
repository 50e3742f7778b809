#pragma once
#include "draw/instances/instance_shape.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

/// Kernels that pick the visible instances, for shapes with one level of detail or several.
struct CullPrograms {
  /// `sight`: defines that say who sees them (cull_instances.comp).
  CullPrograms(const gl::Defines& sight, int levels);
  gl::Program cull, count, total, list;
};

/// The visible ones of up to `capacity` instances, in the order of their slots within each level of
/// detail: bits, prefix sums over them, list. No atomics, so the order is the same every time.
class VisibleList {
 public:
  VisibleList(int capacity, int levels);

  /// Fills list and arguments. The uniforms of programs.cull that describe the instances are set, and
  /// their texel views bound.
  void fill(const CullPrograms& programs, const InstanceShape& shape) const;
  [[nodiscard]] int capacity() const { return capacity_; }
  [[nodiscard]] int levels() const { return levels_; }

  /// Visible slots, one word each.
  [[nodiscard]] const gl::Buffer& list() const { return list_.buffer; }
  /// Eight words a level: count, instanceCount, firstIndex, baseVertex, baseInstance, first place in the
  /// list, number visible, 0.
  [[nodiscard]] const gl::Buffer& arguments() const { return arguments_.buffer; }
  static constexpr int argumentBytes = 32;
  /// For a program that draws instances (draw/instances/instance.glsl); the arguments for the indirect draw
  /// too.
  void bind() const;

 private:
  struct Words {
    Words(const char* label, int count);
    gl::Buffer buffer;
    gl::Texture view;
  };
  int capacity_;
  int levels_;
  int words_;  ///< of one level: 32 slots each, a multiple of 64
  Words masks_, before_, blockCount_, blockFirst_, list_, arguments_;
};

}  // namespace simreel::draw
