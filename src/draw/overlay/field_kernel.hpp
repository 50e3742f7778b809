#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// Colours of a field, in the layout of glsl/draw/overlay/field_values.glsl.
class FieldColors {
 public:
  gl::Texture stops;  ///< colours of the colour map, RGBA32F texel view
  gl::Buffer stopBuffer;
  int stopCount = 0;
  /// Uploads the colours if they have changed. `wanted` must have at least one colour.
  void update(const std::vector<glm::vec3>& wanted);

 private:
  std::vector<glm::vec3> present_;
};

/// Uniforms, buffers and textures that glsl/draw/overlay/field_inputs.glsl declares.
struct FieldInputs {
  gl::In<"words"> words;
  gl::In<"stops"> stops;
  gl::Uniform<"cells", glm::ivec2> cells;
  gl::Uniform<"rowWords", int> rowWords;
  gl::Uniform<"firstWord", int> firstWord;
  gl::Uniform<"cellWords", int> cellWords;
  gl::Uniform<"stopCount", int> stopCount;
  gl::Uniform<"rangeLow", float> rangeLow;
  gl::Uniform<"rangeFactor", float> rangeFactor;
};
[[nodiscard]] FieldInputs fieldInputs(const sim::Field& field, const FieldColors& colors);
struct FieldVariant {
  gl::Choice<"CELLS", 0, 1, 2, 3> cells;  ///< storage format of the cells; values as in sim::Field::Cells
  gl::Flag<"CATEGORIES"> categories;
  gl::Flag<"COLORED"> colored;
};
[[nodiscard]] FieldVariant fieldVariant(const sim::Field& field, bool colored);

struct AverageField;

/// Averages the cells of a field into the texels of a texture of the same or a smaller size. The texture
/// holds values (R32F) or linear light (RGBA16F, with the relative value in alpha). The bits are the same
/// on every device. A texel averages at most 240 x 240 cells.
class FieldKernel {
 public:
  /// Writes mip level 0 of the texture.
  void average(const sim::Field& field, const FieldColors& colors, const gl::Texture& texture,
               bool colored);
  /// Max number of cells per texel along each axis. A texel sums up to 240^2 = 57,600 cells in loops;
  /// software drivers end loops after 65,535 iterations.
  static constexpr int maxReduction = 240;
  /// Returns a texture for a field. Each texel is the mean of `reduction` x `reduction` cells.
  [[nodiscard]] static gl::Texture texture(const sim::Field& field, int reduction, bool colored,
                                           int levels);

 private:
  gl::Kernels<AverageField> kernels_;
};

}  // namespace simreel::draw
