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

/// Conversion of a field to a solid. The levels divide the values into classes: a value in class k reaches
/// k levels.
struct SolidShape {
  glm::ivec2 size{1, 1};  ///< Size of the field in cells.
  std::vector<float> levels{
      0.5F};  ///< Values of the levels in ascending order, 1 to maxSolidLevels of them.
  std::vector<float> heights{0, 1};  ///< Height in metres of each class's face, ascending.
  float spacing = 1.0F;              ///< Distance between cells in metres; the field's centre is at (0, 0).
  float base = 1.0F;                 ///< Thickness in metres of the material below the lowest class.
  int outside = 0;                   ///< Index of the class assumed outside the field.
  bool ceiling = false;  ///< True to add a ceiling over class 0 at the height of class 1; requires one
                         ///< level and `outside` 1.
  float roof = 0.5F;     ///< Thickness in metres of the material above a ceiling.
};
inline constexpr int maxSolidLevels = 16;

/// Solid built from a field by marching squares on the GPU (glsl/contour): faces of its classes and walls
/// between them, drawn without readback. Buffers keep the size of earlier frames. If a frame needs larger
/// buffers, nothing is drawn and grow() reports it.
class Solid {
 public:
  /// Throws UserError(device), naming the limit, if a field of this size exceeds a limit of the device.
  Solid(const std::string& name, const SolidShape& shape);
  ~Solid();
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;
  Solid(Solid&&) noexcept;
  Solid& operator=(Solid&&) noexcept;

  /// Builds the solid of the field's current state with these class heights. Does not wait.
  void make(const Field& field, const std::vector<float>& heights);
  /// Waits for the counts of the latest make(). If the buffers were too small, enlarges them, rebuilds the
  /// solid and returns true. Throws UserError(device) if the device does not support buffers of that size.
  bool grow();

  /// Arguments of the latest make(), and the class of each sample (glsl/contour/samples.glsl); valid even
  /// if the buffers were too small.
  [[nodiscard]] const SolidShape& shape() const;
  [[nodiscard]] const std::vector<float>& heights() const;
  [[nodiscard]] const Field& field() const;
  [[nodiscard]] const gl::WordsArray& classes() const;
  [[nodiscard]] int rowElements() const;

  /// Returns the drawable without model matrix and material; its pointers are valid until the next make()
  /// or grow().
  [[nodiscard]] Surface surface() const;
  /// Returns four words for each group of sixteen samples: the numbers of contour points, of squares within
  /// one class and of triangles in all earlier groups; the fourth word is unused. Their values change
  /// whenever the contours change.
  [[nodiscard]] const gl::Buffer& tallies() const;

  /// Reads back the mesh; call after grow(). Waits for the GPU. Returns the vertices as the kernels write
  /// them, without UVs.
  [[nodiscard]] MeshTable mesh() const;
  /// Returns the mesh with UVs (sim/contour/unwrap.hpp).
  [[nodiscard]] MeshTable unwrapped() const;
  [[nodiscard]] ContourLines lines() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::sim
