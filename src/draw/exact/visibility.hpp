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

/// How a picture's keys and numbers lie in memory, and are found. `apart`: keys and numbers by themselves,
/// found in two passes; four samples of either are one read. `pairs`: both of a sample together, in two
/// passes. `wholes`: the same in one pass by 64-bit atomics. The result is the same.
enum class SampleLayout { apart, pairs, wholes };
/// What suits the device, or what SIMREEL_SAMPLE_LAYOUT names. Throws UserError: usage for another word,
/// device where it lacks the atomics.
[[nodiscard]] SampleLayout sampleLayout();
/// What whoever reads or writes samples of a picture has to know of them.
struct SampleKind {
  SampleLayout layout = SampleLayout::apart;
  bool parallel = false;  ///< seen along parallel rays: keys are of depths, as shader::ExactView has them
  auto operator<=>(const SampleKind&) const = default;
  bool operator==(SampleLayout other) const { return layout == other; }
};

// Groups of fields, one for each of the files that they name, and of their defines.

/// glsl/draw/exact/sample_read.glsl.
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
/// glsl/draw/exact/visible_sample.glsl. What its kernels find does not depend on their order, but for the
/// numbers (PASS 1), which come behind a barrier.
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
/// glsl/draw/exact/list_place.glsl: kernels that list one thing an invocation, as suits the device.
struct ListVariant {
  gl::Flag<"BALLOT", "GL_KHR_shader_subgroup_basic", "GL_KHR_shader_subgroup_ballot"> ballot;
};
[[nodiscard]] ListVariant listVariant();
/// The same, of those that draw one thing an invocation.
struct LaneVariant {
  ListVariant list;
  gl::Flag<"BRANCHES"> branches;
};
[[nodiscard]] LaneVariant laneVariant();
/// Where a shadow map lies among the keys, and how it is drawn.
struct MapPart {
  float slopeOffset = 0;  ///< texels by whose slope what casts shadows is moved away
  int side = 0;           ///< of a lamp's map: texels on a side,
  int firstKey = 0;       ///< its first key,
  int keyStride = 0;      ///< and how many there are from a row to the next
};
/// A lamp's shadow map to draw, seen as a picture is.
struct MapFace {
  const gl::Buffer* views = nullptr;
  std::size_t view = 0;  ///< where its shader::ExactView is (bytes)
  MapPart part;
};
/// The view block of a face, or none.
[[nodiscard]] gl::Resource viewOf(const MapFace& face);
/// Pictures and maps that samples are drawn into.
enum class Target { picture, sunMap, lampMap };

struct ClearSamples;

/// What is nearest at each sample of a picture: a key that is less the nearer it is, and the number of the
/// primitive; or of a shadow map the keys alone. 8 bytes a sample.
class Visibility {
 public:
  static constexpr std::size_t sampleBytes = 8;
  /// Most samples of one, on this device.
  static std::size_t maxSamples();
  Visibility() = default;
  /// `samples`: 1, 2, 4, 8 or 16. `ids`: a picture's, as sampleLayout() says. Throws UserError(device)
  /// beyond the device's limits.
  /// `parallel`: as SampleKind has it.
  Visibility(const std::string& label, glm::ivec2 size, int samples, bool ids, bool parallel = false);

  /// Nothing is visible yet.
  void clear() const;

  template <gl::Access access = gl::Access::read>
  [[nodiscard]] SampleFields<access> read() const {
    return {.keys = nearView_, .keyFours = nearFours_, .ids = idView_, .idFours = idFours_};
  }
  /// For kernels that draw into it. `view`: the view block, unless that is bound.
  [[nodiscard]] SampleTarget target(const MapPart& part, const gl::Resource& view = {}) const;
  [[nodiscard]] SampleVariant variant() const {
    return {.samples = samples_, .paired = layout_ != SampleLayout::apart};
  }
  /// Of what draws into it.
  [[nodiscard]] TargetVariant variant(Target target, int pass) const;
  [[nodiscard]] const gl::Buffer& nearestBuffer() const { return near_; }
  [[nodiscard]] const gl::Buffer& idBuffer() const { return ids_; }

  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] SampleKind layout() const { return {layout_, parallel_}; }
  /// Keys, or both where they lie together.
  [[nodiscard]] const gl::Texture& nearKeys() const { return nearView_; }
  /// The numbers, where they lie apart.
  [[nodiscard]] const gl::Texture& numbers() const { return idView_; }
  /// Waits for the device and copies out: `samples` a pixel, row by row from the top.
  [[nodiscard]] std::vector<GLuint> readKeys() const;
  [[nodiscard]] std::vector<GLuint> readNumbers() const;

 private:
  glm::ivec2 size_{0};
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::vector<GLuint> everyOther(std::size_t first) const;

  int samples_ = 1;
  SampleLayout layout_ = SampleLayout::apart;
  bool parallel_ = false;
  gl::Buffer near_;  ///< keys; where they lie together, numbers too
  gl::Buffer ids_;
  gl::Texture nearView_, nearFours_, idView_, idFours_;
  gl::Kernel<ClearSamples> clear_;
};

/// The longest side (pixels) of the box of a triangle that an invocation best draws alone on this device:
/// software drivers work through all the lanes of a group anyway, cards want more of them. Of one that
/// sixteen invocations draw; 0: none is.
int smallTriangle();
int smallCopyTriangle();  ///< of copies, whose corners are made anew for each use
int mediumTriangle();
/// The same of balls, whose every sample is a ray, and of glows; of those of medium size a group draws one.
int smallBall();
int smallGlow();
int mediumBall();
/// How many large ones are best clipped for all that draw them: none on cards, which wait for each kernel's
/// end.
int fansOfTriangles();

/// Invocations, `items` at least, of a kernel whose groups of 64 stand in rows of at most 32,768.
[[nodiscard]] glm::ivec2 inRows(int items);

}  // namespace simreel::draw
