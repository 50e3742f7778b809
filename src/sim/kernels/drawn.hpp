#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/simulation.hpp"
#include "sim/kernels/finite.hpp"
#include "sim/kernels/gather.hpp"
#include "sim/kernels/ground.hpp"
#include "sim/kernels/level.hpp"
#include "sim/kernels/memory.hpp"

#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {

struct NormalKernel;

/// Draws the memory of a user's kernels. Copies members into the layout of drawables.
class KernelDrawn {
 public:
  KernelDrawn(const std::string& name, const KernelPlan& plan, const KernelFinite& finite,
              const scene::Material& material, double frameSeconds);
  ~KernelDrawn();
  KernelDrawn(const KernelDrawn&) = delete;
  KernelDrawn& operator=(const KernelDrawn&) = delete;

  /// Copies from memory at `time` (seconds). Call it after KernelStore::settle().
  void update(const KernelStore& store, double time);
  /// Enlarges the buffers of the level surface if they were too small (Simulation::grow).
  bool grow() { return level_ && level_->grow(); }
  void publish(Drawables& drawables) const;
  /// Returns the terrain, or null if no terrain is drawn.
  [[nodiscard]] KernelGround* ground() { return ground_ ? &*ground_ : nullptr; }
  /// Read back from the GPU. points() returns the drawn points, or if none exist, the vertices. mesh()
  /// returns everything that is drawn as one mesh, including the copies of a mesh file.
  [[nodiscard]] PointTable points() const;
  [[nodiscard]] std::optional<MeshTable> mesh() const;

 private:
  [[nodiscard]] Instances instances() const;
  [[nodiscard]] MeshTable surfaceMesh() const;
  void makeSurface(const KernelStore& store);
  void makeFaces(const std::vector<unsigned>& indices, std::size_t vertices);
  void updateField(const KernelStore& store);

  std::string name_;
  const KernelPlan& plan_;
  const KernelFinite& finite_;
  scene::Material material_;
  KernelGather gather_;
  gl::Kernel<NormalKernel> normal_;
  bool made_ = false;
  gl::Vec4Array vertices_, normals_, places_, speeds_, turns_, cells_;
  gl::Buffer indices_, uvs_, ranges_, faces_;
  gl::Texture uvView_, words_;
  int indexCount_ = 0;
  bool quaternions_ = false;  ///< true if `turns_` has quaternions, false if it has directions
  std::optional<KernelGround> ground_;
  std::optional<KernelLevel> level_;
  std::vector<unsigned> triangles_;
  std::vector<glm::vec2> textureCoordinates_;
  std::vector<glm::vec3> pointColors_, fieldColors_;
  Field field_;
};

}  // namespace simreel::sim
