#pragma once
#include "draw/instances/instance_shape.hpp"
#include "draw/instances/instance_values.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

/// Viewers for which instances are culled.
enum class Viewer { camera, sun, lamps };

/// Uniforms, buffers and textures that draw/instances/cull_instances.comp declares.
struct SightFields {
  InstanceFields instance;
  gl::Uniform<"pointPixels", float> pointPixels;
  gl::Uniform<"levelError", float> levelError;
};

struct CullInstances;
struct CountVisible;
struct TotalVisible;
struct ListVisible;

/// Kernels that list the visible instances.
struct CullKernels {
  /// `lampDefines`: result of Lamps::shadowDefines().
  explicit CullKernels(const gl::Defines& lampDefines);
  gl::Kernels<CullInstances> cull;
  gl::Kernels<TotalVisible> total;
  gl::Kernel<CountVisible> count;
  gl::Kernel<ListVisible> list;
};

/// List of the visible instances among up to `capacity`, ordered by level of detail and then by index. It
/// is built from bit masks and prefix sums without atomics, so the order is always the same.
class VisibleList {
 public:
  VisibleList(int capacity, int levels);

  /// Fills the list and the draw arguments. The frame's values and the viewer's maps must be bound.
  void fill(CullKernels& kernels, Viewer viewer, const SightFields& sight,
            const InstanceShape& shape) const;
  [[nodiscard]] int capacity() const { return capacity_; }
  [[nodiscard]] int levels() const { return levels_; }

  /// Returns the indices of the visible instances, one word each.
  [[nodiscard]] const gl::Buffer& list() const { return list_.buffer; }
  /// Returns eight words per level: count, instanceCount, firstIndex, baseVertex, baseInstance, index of
  /// the first list entry, number of visible instances, 0.
  [[nodiscard]] const gl::Buffer& arguments() const { return arguments_.buffer; }
  static constexpr int argumentBytes = 32;
  [[nodiscard]] ListFields fields(int level) const;
  /// Binds the arguments for an indirect draw.
  void bind() const;

 private:
  struct Words {
    Words(const char* label, int count);
    gl::Buffer buffer;
    gl::Texture view;
  };
  int capacity_;
  int levels_;
  int words_;  ///< mask words per level, 32 instances per word; a multiple of 64
  Words masks_, before_, blockCount_, blockFirst_, list_, arguments_;
};

}  // namespace simreel::draw
