#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
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
/// Defines of all that reads or writes such samples.
[[nodiscard]] gl::Defines definesOf(const SampleKind& kind);

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
  /// For kernels that draw, and for those that read.
  void bind() const;

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
  gl::Program clear_;
};

/// Where a shadow map lies among the keys, and how it is drawn.
struct MapPart {
  float slopeOffset = 0;  ///< texels by whose slope what casts shadows is moved away
  int side = 0;           ///< of a lamp's map: texels on a side,
  int firstKey = 0;       ///< its first key,
  int keyStride = 0;      ///< and how many there are from a row to the next
  /// Sets what glsl/draw/exact/visible_sample.glsl and raster_triangle.glsl read.
  void set(const gl::Program& program) const {
    program.set("slopeOffset", slopeOffset);
    program.set("firstKey", firstKey);
    program.set("keyStride", keyStride);
  }
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
/// Defines of kernels that draw or list one thing an invocation, as suits the device.
[[nodiscard]] gl::Defines laneDefines();
/// Of kernels that list one thing an invocation (glsl/draw/exact/list_place.glsl), as suits the device.
void addBallot(gl::Defines& defines);

/// Runs `items` invocations of a kernel whose groups of 64 stand in rows of at most 32,768.
void dispatchRows(const gl::Program& program, int items);

}  // namespace simreel::draw
