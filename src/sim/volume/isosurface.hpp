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

/// Values of the cells of a volume: floats, rows along x that begin with whole elements of four words,
/// layers of rows.
struct VolumeValues {
  const gl::Texture* words = nullptr;  ///< RGBA32UI texel view
  int rowWords = 0;                    ///< from one row to the next, a multiple of four
  int firstWord = 0;                   ///< of cell (0, 0, 0), a multiple of four
};

struct IsosurfaceShape {
  glm::ivec3 size{1, 1, 1};  ///< cells
  float spacing = 1.0F;      ///< m between them
  glm::vec3 middle{0};       ///< m
  bool closed = true;  ///< what is around the volume lies outside; else the surface ends at its borders
  bool cubes = false;  ///< cells at the level or above are cubes; else the values pass the level smoothly
  [[nodiscard]] glm::vec3 corner() const { return middle - 0.5F * spacing * glm::vec3(size - 1); }
};

/// How a second field colours it: linear RGB, evenly from the lowest value to the highest.
struct IsosurfaceTint {
  VolumeValues values;
  glm::vec2 range{0, 1};
};

/// Where the values of a volume pass a level, as a surface: marching cubes on the GPU (glsl/volume), or the
/// squares between cells that are inside and those that are not; drawn
/// without a readback, with normals from the gradient. Memory keeps the size that a frame needed: one that
/// needs more draws nothing, which grow() notices. What is at the level or above is inside.
class Isosurface {
 public:
  /// `colors`: of a tint; empty: it has none. Throws UserError(device) naming the limit that a volume of
  /// this size is beyond.
  Isosurface(const std::string& name, const IsosurfaceShape& shape, const std::vector<glm::vec3>& colors);
  ~Isosurface();
  Isosurface(const Isosurface&) = delete;
  Isosurface& operator=(const Isosurface&) = delete;
  Isosurface(Isosurface&&) noexcept;
  Isosurface& operator=(Isosurface&&) noexcept;

  /// The surface of the values as they are now. Waits for nothing.
  void make(const VolumeValues& values, float level, const IsosurfaceTint& tint);
  /// As Solid::grow.
  bool grow();

  /// Everything but model and material; the pointers live until make() or grow().
  [[nodiscard]] Surface surface() const;
  /// Read back; after grow(). Waits for the GPU.
  [[nodiscard]] MeshTable mesh() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::sim
