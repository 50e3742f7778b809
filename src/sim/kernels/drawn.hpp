#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/simulation.hpp"
#include "sim/kernels/memory.hpp"

#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {

struct GatherKernel;
struct NormalKernel;

/// Draws the memory of a user's kernels: copies members into the layout of drawables.
class KernelDrawn {
 public:
  KernelDrawn(const std::string& name, const KernelPlan& plan, const scene::Material& material);
  ~KernelDrawn();
  KernelDrawn(const KernelDrawn&) = delete;
  KernelDrawn& operator=(const KernelDrawn&) = delete;

  /// Copies from memory. Call after KernelStore::settle().
  void update(const KernelStore& store);
  void publish(Drawables& drawables) const;
  /// Reads the drawn points or mesh back from the GPU.
  [[nodiscard]] PointTable points() const;
  [[nodiscard]] std::optional<MeshTable> mesh() const;

 private:
  /// The words of one buffer or texture, with the layout of its elements.
  struct Source {
    const gl::Buffer* words;
    int start, stride, count;
    std::vector<KernelSlot> slots;
    bool encoded = false;  ///< true if the first three numbers are sRGB
  };
  [[nodiscard]] Source source(const KernelStore& store, const std::string& of) const;
  void gather(const Source& from, const std::string& member, const std::string& fourth,
              const std::string& alive, const glm::vec4& fill, gl::Vec4Array& to) const;
  void makeSurface(const KernelStore& store);
  void makeFaces(const std::vector<unsigned>& indices, std::size_t vertices);
  void updateField(const KernelStore& store);

  std::string name_;
  const KernelPlan& plan_;
  scene::Material material_;
  gl::Kernel<GatherKernel> gather_;
  gl::Kernel<NormalKernel> normal_;
  bool made_ = false;
  gl::Vec4Array vertices_, normals_, places_, speeds_, cells_;
  gl::Buffer indices_, uvs_, ranges_, faces_;
  gl::Texture uvView_, words_;
  int indexCount_ = 0;
  std::vector<unsigned> triangles_;
  std::vector<glm::vec2> textureCoordinates_;
  std::vector<glm::vec3> pointColors_, fieldColors_;
  Field field_;
};

}  // namespace simreel::sim
