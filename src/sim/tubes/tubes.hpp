#pragma once
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/simulation.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Inputs of glsl/tubes/tube.comp.
struct TubeKernel {
  static constexpr auto file = "tubes/tube.comp";
  gl::Uniform<"lines", int> lines;
  gl::Uniform<"lineRoom", int> room;
  gl::Uniform<"radius", float> radius;
  gl::Uniform<"taperFirst", float> taperFirst;
  gl::Uniform<"taperLast", float> taperLast;
  gl::Uniform<"fade", float> fade;
  gl::Uniform<"paletteSize", int> paletteSize;
  gl::Uniforms<"circle", glm::vec2, 6> circle;
  gl::In<"points"> points;
  gl::In<"SpanBlock"> spans;
  gl::In<"palette"> palette;
  gl::Out<"vertices"> vertices;
  gl::Out<"normals"> normals;
  gl::Out<"colors"> colors;
};

/// Tubes around lines of points, as one mesh that a kernel writes in each frame.
class Tubes {
 public:
  static constexpr int sides = 6;

  /// Look of the tubes.
  struct Look {
    float radius = 0.01F;  ///< metres
    /// Number of points over which the tube widens from its first point and narrows to its last; 0: none.
    float taperFirst = 0, taperLast = 0;
    float fade = 0;  ///< fraction by which the colour is darker at the last point
  };

  Tubes() = default;
  /// Makes room for `lines` tubes of up to `points` points. `stops`: colours from w = 0 to w = 1 of a
  /// point; at least one.
  Tubes(const std::string& name, int lines, int points, const std::vector<glm::vec3>& stops, bool fast);

  /// Makes the mesh. `points`: x, y, z in metres and the place in the colours, `points` per line. `spans`:
  /// ivec4 per tube: x and y are the first and last point of its line, z is the line; there is no tube if y
  /// is below x.
  void make(const gl::Vec4Array& points, const gl::Buffer& spans, const Look& look);
  /// Returns the arguments of the indirect draw (five words), into which a kernel may write the number of
  /// indices to draw: indicesPerTube() for each tube.
  [[nodiscard]] const gl::Buffer& arguments() const { return arguments_; }
  [[nodiscard]] int indicesPerTube() const { return indexCount_ / std::max(lines_, 1); }
  /// Returns the surface; its pointers are valid as long as this object. The colours are a factor on the
  /// colour of the material.
  [[nodiscard]] Surface surface(const scene::Material& material) const;
  /// Reads the mesh back, without triangles that have no area.
  [[nodiscard]] MeshTable table() const;

  /// Returns the bytes of memory that tubes need.
  [[nodiscard]] static double bytesFor(int lines, int points) {
    return static_cast<double>(lines) * (points + 2) * sides * (3 * 16 + 8 + 24);
  }

 private:
  int lines_ = 0, points_ = 0;
  gl::Vec4Array vertices_, normals_, colors_, palette_;
  int paletteSize_ = 1;
  gl::Buffer uvs_, indices_, arguments_;
  gl::Texture uvView_;
  int indexCount_ = 0;
  std::vector<glm::vec2> circle_;
  gl::Kernel<TubeKernel> kernel_;
};

}  // namespace simreel::sim
