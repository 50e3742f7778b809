#pragma once
#include "draw/instances/instance_shape.hpp"
#include "draw/instances/instance_values.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

/// Who sees the instances.
enum class Viewer { camera, sun, lamps };

/// How they are seen: fields of draw/instances/cull_instances.comp.
struct SightFields {
  InstanceFields instance;
  gl::Uniform<"pointPixels", float> pointPixels;
  gl::Uniform<"levelError", float> levelError;
};

struct CullInstances;
struct CountVisible;
struct TotalVisible;
struct ListVisible;

/// Kernels that pick the visible instances.
struct CullKernels {
  /// `lampDefines`: Lamps::shadowDefines().
  explicit CullKernels(const gl::Defines& lampDefines);
  gl::Kernels<CullInstances> cull;
  gl::Kernels<TotalVisible> total;
  gl::Kernel<CountVisible> count;
  gl::Kernel<ListVisible> list;
};

/// The visible ones of up to `capacity` instances, in the order of their slots within each level of
/// detail: bits, prefix sums over them, list. No atomics, so the order is the same every time.
class VisibleList {
 public:
  VisibleList(int capacity, int levels);

  /// Fills list and arguments. The frame's values and the viewer's maps are bound.
  void fill(CullKernels& kernels, Viewer viewer, const SightFields& sight,
            const InstanceShape& shape) const;
  [[nodiscard]] int capacity() const { return capacity_; }
  [[nodiscard]] int levels() const { return levels_; }

  /// Visible slots, one word each.
  [[nodiscard]] const gl::Buffer& list() const { return list_.buffer; }
  /// Eight words a level: count, instanceCount, firstIndex, baseVertex, baseInstance, first place in the
  /// list, number visible, 0.
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
  int words_;  ///< of one level: 32 slots each, a multiple of 64
  Words masks_, before_, blockCount_, blockFirst_, list_, arguments_;
};

}  // namespace simreel::draw
