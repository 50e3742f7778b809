#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <map>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// Colours of a field as glsl/draw/overlay/field_values.glsl reads them.
class FieldColors {
 public:
  gl::Texture stops;  ///< RGBA32F texel view
  gl::Buffer stopBuffer;
  int stopCount = 0;
  /// Copies the colours unless they are there already. At least one.
  void update(const std::vector<glm::vec3>& wanted);

 private:
  std::vector<glm::vec3> present_;
};

/// What is defined for a shader that reads this kind of field.
[[nodiscard]] gl::Defines fieldDefines(const sim::Field& field, bool colored);
/// Sets uniforms and texture units (0 and 1) of a shader that reads this field.
void setField(const gl::Program& program, const sim::Field& field, const FieldColors& colors);

/// Averages a whole field into a texture of any smaller or equal size: values (R32F), or linear light
/// (RGBA16F, the value's place in the range in alpha). The same bits on every device. A texel sums up at
/// most 240 x 240 cells.
class FieldKernel {
 public:
  /// Writes level 0.
  void average(const sim::Field& field, const FieldColors& colors, const gl::Texture& texture,
               bool colored);
  /// Greatest number of cells per texel on a side: loops of a software driver end after 65,535 rounds.
  static constexpr int maxReduction = 240;
  /// A texture for fields of this size, cells averaged by `reduction` on a side.
  [[nodiscard]] static gl::Texture texture(const sim::Field& field, int reduction, bool colored,
                                           int levels);

 private:
  std::map<int, gl::Program> programs_;
};

}  // namespace simreel::draw
