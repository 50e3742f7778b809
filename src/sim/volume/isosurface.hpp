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

/// Cell values of a volume: floats in rows along x. Each row starts at a multiple of four words.
/// Consecutive rows form layers.
struct VolumeValues {
  const gl::Texture* words = nullptr;  ///< values as an RGBA32UI texel view
  int rowWords = 0;                    ///< number of words from the start of a row to the start of the
                                       ///< next, a multiple of four
  int firstWord = 0;                   ///< index of the word of cell (0, 0, 0), a multiple of four
};

struct IsosurfaceShape {
  glm::ivec3 size{1, 1, 1};  ///< number of cells
  float spacing = 1.0F;      ///< distance between cells in metres
  glm::vec3 middle{0};       ///< centre in metres
  bool closed = true;  ///< true if everything outside the volume counts as outside the surface; false if
                       ///< the surface ends at the borders
  bool cubes = false;  ///< true if cells at or above the level are drawn as cubes; false for a smooth
                       ///< surface
  [[nodiscard]] glm::vec3 corner() const { return middle - 0.5F * spacing * glm::vec3(size - 1); }
};

/// Second field that colours the surface. The linear RGB colours are interpolated from the lowest value to
/// the highest.
struct IsosurfaceTint {
  VolumeValues values;
  glm::vec2 range{0, 1};
};

/// Surface on which the values of a volume equal a level. It is computed by marching cubes on the GPU
/// (glsl/volume), or consists of the squares between inside and outside cells. Cells at or above the level
/// are inside. Normals come from the gradient. The surface is drawn without readback: the buffers keep
/// their size, and a frame that needs more memory draws nothing until grow() enlarges the buffers.
class Isosurface {
 public:
  /// `colors` are the colours of a tint; empty if none exists. Throws UserError(device), naming the
  /// limit, if a volume of this size exceeds a limit of the device.
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

  /// Returns a surface whose model matrix and material are not set. Its pointers are valid until the next
  /// make() or grow().
  [[nodiscard]] Surface surface() const;
  /// Reads back the mesh; call it after grow(). Waits for the GPU.
  [[nodiscard]] MeshTable mesh() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::sim
