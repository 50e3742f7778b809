#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "scene/scene.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/auto_range.hpp"
#include "sim/core/drawable.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Colouring of a cloth by a quantity of its vertices.
struct ClothColoring {
  enum class By { material, strain, speed };
  By by = By::material;
  glm::vec2 range{0, 1};          ///< strain, or speed in m/s, of the first and the last colour
  AutoEnds autoEnds;              ///< ends of `range` that a first run of the scene measures
  std::vector<glm::vec3> colors;  ///< linear RGB stops of the colour map

  void describe(scene::Fields& fields);
  [[nodiscard]] bool used() const { return by != By::material; }
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges();
  /// Returns the object's material, white and without textures, so that the colour map shows its true
  /// colours. scene::HasOwnColors warns if the scene gives a colour, texture or skin.
  [[nodiscard]] static scene::Material materialOf(const scene::Object& object);
};

/// Edges of a cloth made of triangles, in the layout of glsl/cloth/color.comp.
struct ClothEdges {
  std::vector<glm::uvec4> vertices;  ///< for each drawn vertex: the index of its cloth vertex, the index of
                                     ///< its first edge, the number of its edges
  std::vector<glm::uvec4> edges;     ///< vertex at the other end; rest length in metres, as the bits of a
                                     ///< float
};

struct ClothColorKernel;

/// Computes the colours of a cloth's vertices.
class ClothColors {
 public:
  /// State of the cloth. `trends` is null if the constraints have none. `before` holds the positions one
  /// substep ago.
  struct State {
    const gl::Vec4Array* positions;
    const gl::Vec4Array* before;
    const gl::Vec4Array* velocities;
    const gl::Vec4Array* trends;
  };

  /// Prepares the colouring of a grid of `size` vertices with the rest distance `spacing` (metres).
  ClothColors(const std::string& name, const ClothColoring& coloring, glm::ivec2 size, float spacing,
              double substepSeconds, bool fast);
  /// Prepares the colouring of the drawn vertices of a mesh.
  ClothColors(const std::string& name, const ClothColoring& coloring, const ClothEdges& edges,
              double substepSeconds, bool fast);
  void update(const State& state) const;
  /// Sets the vertex colours and the colour scale of a surface.
  void applyTo(Surface& surface) const;

 private:
  ClothColors(const std::string& name, const ClothColoring& coloring, int count, double substepSeconds);

  ClothColoring coloring_;
  int count_;
  glm::ivec2 size_{1, 1};
  float perSpacing_ = 1;
  float perDt_;
  gl::WordsArray vertices_, edges_;  ///< empty for a cloth that is a grid
  gl::Vec4Array stops_, colors_;
  gl::Kernel<ClothColorKernel> kernel_;
};

}  // namespace simreel::sim
