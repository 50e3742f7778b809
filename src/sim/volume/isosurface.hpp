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

/// Cell values of a volume: floats in rows along x, each of which starts at a multiple of four words; rows
/// form layers.
struct VolumeValues {
  const gl::Texture* words = nullptr;  ///< values as an RGBA32UI texel view
  int rowWords = 0;                    ///< number of words from one row to the next, a multiple of four
  int firstWord = 0;                   ///< index of the word of cell (0, 0, 0), a multiple of four
};

struct IsosurfaceShape {
  glm::ivec3 size{1, 1, 1};  ///< number of cells
  float spacing = 1.0F;      ///< distance between cells in metres
  glm::vec3 middle{0};       ///< centre in metres
  bool closed = true;  ///< true: everything outside the volume counts as outside the surface; false: the
                       ///< surface ends at the borders
  bool cubes = false;  ///< true: cells at or above the level are drawn as cubes; false: smooth surface
  [[nodiscard]] glm::vec3 corner() const { return middle - 0.5F * spacing * glm::vec3(size - 1); }
};

/// Second field that colours the surface: linear RGB, linear from the lowest value to the highest.
struct IsosurfaceTint {
  VolumeValues values;
  glm::vec2 range{0, 1};
};

/// Surface on which the values of a volume equal a level: marching cubes on the GPU (glsl/volume), or the
/// squares between inside and outside cells. Cells at or above the level are inside. Normals come from the
/// gradient. Drawn without readback: the buffers keep their size, and a frame that needs more draws nothing
/// until grow() enlarges them.
class Isosurface {
 public:
  /// `colors`: for a tint; empty: none. Throws UserError(device), naming the limit, if a volume of this
  /// size exceeds it.
  Isosurface(const std::string& name, const IsosurfaceShape& shape, const std::vector<glm::vec3>& colors);
  ~Isosurface();
  Isosurface(const Isosurface&) = delete;
  Isosurface& operator=(const Isosurface&) = delete;
  Isosurface(Isosurface&&) noexcept;
  Isosurface& operator=(Isosurface&&) noexcept;

  /// Dispatches the computation of the surface from the current values. Does not wait.
  void make(const VolumeValues& values, float level, const IsosurfaceTint& tint);
  /// Enlarges the buffers if they were too small; see Solid::grow().
  bool grow();

  /// Returns a surface without model and material; its pointers are valid until the next make() or grow().
  [[nodiscard]] Surface surface() const;
  /// Reads the mesh back; call after grow(). Waits for the GPU.
  [[nodiscard]] MeshTable mesh() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::sim
