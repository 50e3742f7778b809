#pragma once
#include "gl/element_array.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/simulation.hpp"

#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Settings for the conversion of a field to a solid. The levels divide the field values into classes: a
/// value is in class k if it is at or above k levels.
struct SolidShape {
  glm::ivec2 size{1, 1};  ///< Size of the field in cells.
  std::vector<float> levels{
      0.5F};  ///< Values of the levels in ascending order. There are 1 to maxSolidLevels levels.
  std::vector<float> heights{0, 1};  ///< Height in metres of the face of each class, ascending.
  float spacing = 1.0F;              ///< Distance between cells in metres; the field's centre is at (0, 0).
  float base = 1.0F;                 ///< Thickness in metres of the material below the lowest class.
  int outside = 0;                   ///< Index of the class assumed outside the field.
  bool ceiling = false;  ///< True to add a ceiling over class 0 at the height of class 1. Requires exactly
                         ///< one level, and `outside` must be 1.
  float roof = 0.5F;     ///< Thickness in metres of the material above a ceiling.
};
inline constexpr int maxSolidLevels = 16;

/// Solid built from a field by marching squares on the GPU (glsl/contour): the faces of its classes and the
/// walls between them, drawn without readback. Buffers keep the size of earlier frames. If a frame needs
/// larger buffers, nothing is drawn and grow() reports that.
class Solid {
 public:
  /// Throws UserError(device), naming the limit, if a field of this size exceeds a limit of the device.
  Solid(const std::string& name, const SolidShape& shape);
  ~Solid();
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;
  Solid(Solid&&) noexcept;
  Solid& operator=(Solid&&) noexcept;

  /// Builds the solid of the field's current state with the given class heights. Does not wait for the GPU.
  void make(const Field& field, const std::vector<float>& heights);
  /// Waits for the counts of the latest make(). If the buffers were too small, enlarges them, rebuilds the
  /// solid and returns true. Throws UserError(device) if the device does not support buffers of that size.
  bool grow();

  /// Return the arguments of the latest make(), and the class of each sample (glsl/contour/samples.glsl).
  /// They are valid even if the buffers were too small.
  [[nodiscard]] const SolidShape& shape() const;
  [[nodiscard]] const std::vector<float>& heights() const;
  [[nodiscard]] const Field& field() const;
  [[nodiscard]] const gl::WordsArray& classes() const;
  [[nodiscard]] int rowElements() const;

  /// Returns the drawable, whose model matrix and material are not set. Its pointers are valid until the
  /// next make() or grow().
  [[nodiscard]] Surface surface() const;
  /// Returns four words for each group of sixteen samples. The first three are totals over all earlier
  /// groups: contour points, squares within one class, and triangles. The fourth word is unused. The words
  /// change whenever the contours change.
  [[nodiscard]] const gl::Buffer& tallies() const;

  /// Reads back the mesh and waits for the GPU; call it after grow(). Returns the vertices as the kernels
  /// write them, without UVs.
  [[nodiscard]] MeshTable mesh() const;
  /// Returns the mesh with UVs (sim/contour/unwrap.hpp).
  [[nodiscard]] MeshTable unwrapped() const;
  [[nodiscard]] ContourLines lines() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::sim
