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

/// How a field becomes a solid. Values are cut by levels into classes: class k reaches k of them.
struct SolidShape {
  glm::ivec2 size{1, 1};             ///< cells of the field
  std::vector<float> levels{0.5F};   ///< ascending, 1 to maxSolidLevels
  std::vector<float> heights{0, 1};  ///< m, one a class, of its face; ascending
  float spacing = 1.0F;              ///< m between cells; the field's middle is at (0, 0)
  float base = 1.0F;                 ///< m of material below the lowest class
  int outside = 0;                   ///< class of what is around the field
  bool ceiling = false;              ///< over class 0, at the height of class 1; one level, outside 1
  float roof = 0.5F;                 ///< m of material above a ceiling
};
inline constexpr int maxSolidLevels = 16;

/// A field as a solid: faces of its classes and the walls between them, by marching squares on the GPU
/// (glsl/contour), drawn without a readback. Memory keeps the size that a frame needed: one that needs more
/// draws nothing, which grow() notices.
class Solid {
 public:
  /// Throws UserError(device) naming the limit that a field of this size is beyond.
  Solid(const std::string& name, const SolidShape& shape);
  ~Solid();
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;
  Solid(Solid&&) noexcept;
  Solid& operator=(Solid&&) noexcept;

  /// The solid of the field as it is now, with these heights of the classes. Waits for nothing.
  void make(const Field& field, const std::vector<float>& heights);
  /// Waits until the latest make() has counted. Where its memory was too small, gets more, makes it again
  /// and returns true. Throws UserError(device) where the device has no buffer that large.
  bool grow();

  /// What the latest make() was told, and the class of each sample (glsl/contour/samples.glsl), which are
  /// right even where the solid lacked memory.
  [[nodiscard]] const SolidShape& shape() const;
  [[nodiscard]] const std::vector<float>& heights() const;
  [[nodiscard]] const Field& field() const;
  [[nodiscard]] const gl::WordsArray& classes() const;
  [[nodiscard]] int rowElements() const;

  /// Everything but model and material; the pointers live until make() or grow().
  [[nodiscard]] Surface surface() const;
  /// Four words that change with the contours: how many points, squares of one class and triangles there
  /// are before each sixteen samples.
  [[nodiscard]] const gl::Buffer& tallies() const;

  /// Read back; after grow(). Waits for the GPU. Vertices as the kernels leave them, without uvs.
  [[nodiscard]] MeshTable mesh() const;
  /// The same with uvs (sim/contour/unwrap.hpp).
  [[nodiscard]] MeshTable unwrapped() const;
  [[nodiscard]] ContourLines lines() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::sim
