#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"

#include <cstddef>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// What is nearest at each sample of a picture: a key that is less the nearer it is, and the number of the
/// primitive; or of a shadow map the keys alone. 8 bytes a sample.
class Visibility {
 public:
  static constexpr std::size_t sampleBytes = 8;
  /// Most samples of one, on this device.
  static std::size_t maxSamples();
  Visibility() = default;
  /// `samples`: 1, 2, 4, 8 or 16. Throws UserError(device) beyond the device's limits.
  Visibility(const std::string& label, glm::ivec2 size, int samples, bool ids);

  /// Nothing is visible yet.
  void clear() const;
  /// For kernels that draw, and for those that read.
  void bind() const;

  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] int samples() const { return samples_; }
  [[nodiscard]] const gl::Texture& nearKeys() const { return nearView_; }
  /// 32-bit words, `samples` a pixel, row by row from the top.
  [[nodiscard]] const gl::Buffer& nearBuffer() const { return near_; }
  [[nodiscard]] const gl::Buffer& idBuffer() const { return ids_; }

 private:
  glm::ivec2 size_{0};
  int samples_ = 1;
  bool withIds_ = false;
  gl::Buffer near_, ids_;
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
/// software drivers work through all the lanes of a group anyway, cards want more of them.
int smallTriangle();

/// Runs `items` invocations of a kernel whose groups of 64 stand in rows of at most 32,768.
void dispatchRows(const gl::Program& program, int items);

}  // namespace simreel::draw
