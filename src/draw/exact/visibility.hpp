#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Memory layout of a picture's depth keys and primitive ids, and the method that finds them. `separate`:
/// keys and ids are in separate buffers and are found in two passes. One read returns four keys or four
/// ids. `pairs`: the id and key of a sample are stored together and are found in two passes. `wholes`: like
/// `pairs`, but found in one pass with 64-bit atomics. All layouts give the same picture.
enum class SampleLayout { separate, pairs, wholes };
/// Returns the layout named by the environment variable SIMREEL_SAMPLE_LAYOUT, or else the best one for the
/// device. Throws UserError(usage) for an unknown name and UserError(device) if the device lacks the 64-bit
/// atomics of `wholes`.
[[nodiscard]] SampleLayout sampleLayout();
/// Properties of a visibility buffer, for kernels that read or write samples.
struct SampleKind {
  SampleLayout layout = SampleLayout::separate;
  bool parallel = false;  ///< true for orthographic views: keys are computed from depth by the parallel
                          ///< formula of draw/exact/depth.glsl
  auto operator<=>(const SampleKind&) const = default;
  bool operator==(SampleLayout other) const { return layout == other; }
};

// The following structs are groups of kernel inputs. Each declares the uniforms, buffers and defines of the
// GLSL include file named in its comment.

/// Uniforms, buffers and textures that glsl/draw/exact/sample_read.glsl declares.
template <gl::Access access>
struct SampleFields {
  gl::ResourceField<"nearestKeys", access> keys;
  gl::ResourceField<"nearestFours", access> keyFours;
  gl::ResourceField<"visibleIds", access> ids;
  gl::ResourceField<"visibleFours", access> idFours;
};
using SamplesRead = SampleFields<gl::Access::read>;
struct SampleVariant {
  gl::Choice<"SAMPLES", 1, 2, 4, 8, 16> samples;
  gl::Flag<"PAIRED"> paired;
};
/// Uniforms, buffers and textures that glsl/draw/exact/visible_sample.glsl declares. The results of the
/// kernels do not depend on the execution order, except that PASS 1 (ids) needs a barrier after PASS 0
/// (keys).
struct SampleTarget {
  gl::Ambient<"ViewBlock"> view;
  SampleFields<gl::Access::together> before;
  gl::Shared<"NearBlock"> nearest;
  gl::Shared<"IdBlock"> ids;
  gl::Uniform<"mapTexels", int> mapTexels;
  gl::Uniform<"firstKey", int> firstKey;
  gl::Uniform<"keyStride", int> keyStride;
};
struct TargetVariant {
  SampleVariant samples;
  gl::Flag<"ONE_PASS", "GL_ARB_gpu_shader_int64", "GL_NV_shader_atomic_int64"> wholes;
  gl::Choice<"PASS", 0, 1> pass;
  gl::Flag<"SUN_MAP"> sunMap;
  gl::Flag<"LAMP_MAP"> lampMap;
};
/// Defines of glsl/draw/exact/list_place.glsl, for kernels in which each invocation appends at most one
/// entry to a list. The device determines BALLOT.
struct ListVariant {
  gl::Flag<"BALLOT", "GL_KHR_shader_subgroup_basic", "GL_KHR_shader_subgroup_ballot"> ballot;
};
[[nodiscard]] ListVariant listVariant();
/// Defines of kernels in which each invocation rasterizes one primitive and may append it to a list.
struct LaneVariant {
  ListVariant list;
  gl::Flag<"BRANCHES"> branches;
};
[[nodiscard]] LaneVariant laneVariant();
/// Position of a shadow map in the key buffer, and its rasterization parameters.
struct MapPart {
  float slopeOffset = 0;  ///< distance (texels) over which the depth slope of a caster is measured; casters
                          ///< are moved away from the light by the depth change over this distance
  int side = 0;           ///< lamp map only: texels per side
  int firstKey = 0;       ///< lamp map only: index of the map's first key
  int keyStride = 0;      ///< lamp map only: number of keys between the starts of consecutive rows
};
/// One face of a lamp's shadow maps. It is rasterized like a picture, with its own view.
struct MapFace {
  const gl::Buffer* views = nullptr;
  std::size_t view = 0;  ///< offset (bytes) of the face's shader::ExactView in `views`
  MapPart part;
};
/// Returns the view block of a face, or an empty resource if the face has no views.
[[nodiscard]] gl::Resource viewOf(const MapFace& face);
/// Kinds of visibility buffers that kernels rasterize into.
enum class Target { picture, sunMap, lampMap };

struct ClearSamples;

/// Visibility buffer: for each sample of a picture, the depth key (smaller is nearer) and the primitive id
/// of the nearest primitive. Takes 8 bytes per sample. Shadow maps have only keys.
class Visibility {
 public:
  static constexpr std::size_t sampleBytes = 8;
  /// Returns the max number of samples of a visibility buffer on this device.
  static std::size_t maxSamples();
  Visibility() = default;
  /// `samples`: 1, 2, 4, 8 or 16 per pixel. `ids`: true for pictures, whose layout is sampleLayout(); false
  /// for shadow maps. `parallel`: as in SampleKind. Throws UserError(device) if a device limit is exceeded.
  Visibility(const std::string& label, glm::ivec2 size, int samples, bool ids, bool parallel = false);

  /// Marks all samples as empty.
  void clear() const;

  template <gl::Access access = gl::Access::read>
  [[nodiscard]] SampleFields<access> read() const {
    return {.keys = nearView_, .keyFours = nearFours_, .ids = idView_, .idFours = idFours_};
  }
  /// Returns the shader inputs of kernels that rasterize into this buffer. `view`: the view block; empty if
  /// it is already bound.
  [[nodiscard]] SampleTarget target(const MapPart& part, const gl::Resource& view = {}) const;
  [[nodiscard]] SampleVariant variant() const {
    return {.samples = samples_, .paired = layout_ != SampleLayout::separate};
  }
  /// Returns the defines of kernels that rasterize into this buffer.
  [[nodiscard]] TargetVariant variant(Target target, int pass) const;
  [[nodiscard]] const gl::Buffer& nearestBuffer() const { return near_; }
  [[nodiscard]] const gl::Buffer& idBuffer() const { return ids_; }

  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] SampleKind layout() const { return {layout_, parallel_}; }
  /// Returns the texel view of the keys, or of key and id pairs for the paired layouts.
  [[nodiscard]] const gl::Texture& nearKeys() const { return nearView_; }
  /// Returns the texel view of the ids. Only for the layout `separate`.
  [[nodiscard]] const gl::Texture& numbers() const { return idView_; }
  /// Waits for the GPU and returns a copy of the keys, or of the ids: samples() values per pixel, row by
  /// row from the top.
  [[nodiscard]] std::vector<GLuint> readKeys() const;
  [[nodiscard]] std::vector<GLuint> readNumbers() const;

 private:
  glm::ivec2 size_{0};
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::vector<GLuint> everyOther(std::size_t first) const;

  int samples_ = 1;
  SampleLayout layout_ = SampleLayout::separate;
  bool parallel_ = false;
  gl::Buffer near_;  ///< keys; in paired layouts, id and key pairs
  gl::Buffer ids_;
  gl::Texture nearView_, nearFours_, idView_, idFours_;
  gl::Kernel<ClearSamples> clear_;
};

/// Max side (pixels) of a triangle's bounding box up to which one invocation rasterizes the triangle
/// (small), or sixteen invocations do (medium; 0 if the medium step is not used). The values are tuned for
/// the device. Software drivers execute all lanes of a workgroup anyway, while GPUs need more invocations.
int smallTriangle();
int smallCopyTriangle();  ///< Same limit for small triangles of mesh copies. It is larger because each use
                          ///< of a triangle transforms the corners again.
int mediumTriangle();
/// Same limits for balls, which need a ray per sample, and for glows. One workgroup handles a medium ball
/// or glow.
int smallBall();
int smallGlow();
int mediumBall();
/// Returns the number of large triangles that are clipped once for all workgroups that rasterize them.
/// Returns 0 on GPUs, where an extra dispatch for clipping costs more than it saves.
int fansOfTriangles();

/// Returns the dispatch size (invocations in x and y) for at least `items` items: workgroups of 64
/// invocations in rows of at most 32,768 workgroups.
[[nodiscard]] glm::ivec2 inRows(int items);

}  // namespace simreel::draw
