#include "sim/body/skinned_surface.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <cstdint>
#include <utility>

namespace simreel::sim {

struct SkinKernel {
  static constexpr auto file = "body/skin.comp";
  struct Variant {
    gl::Flag<"NORMALS"> normals;
  };
  gl::Uniform<"count", int> count;
  gl::Uniform<"joints", int> joints;
  gl::Uniform<"before", float> before;
  gl::Uniform<"now", float> now;
  gl::In<"restPositions"> restPositions;
  gl::In<"restNormals"> restNormals;
  gl::In<"follow"> follow;
  gl::In<"weights"> weights;
  gl::In<"poses"> poses;
  gl::Out<"positions"> positions;
  gl::Out<"normals"> normals;
};

namespace {

std::vector<glm::vec4> asVec4(const std::vector<glm::vec3>& items) {
  std::vector<glm::vec4> wide;
  wide.reserve(items.size());
  for (const glm::vec3& item : items) wide.emplace_back(item, 0.0F);
  return wide;
}

std::vector<glm::uvec4> facesOf(const Mesh& mesh) {
  std::vector<glm::uvec4> faces;
  faces.reserve(mesh.indices.size() / 3);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    faces.emplace_back(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2], 0);
  return faces;
}

/// Returns the vertex count. Throws UserError(device) if the buffers would exceed the limit; called before
/// any buffer is filled.
int checkedCount(const std::string& name, const Mesh& mesh) {
  const auto bytes =
      static_cast<std::int64_t>(std::max(mesh.positions.size(), mesh.indices.size() / 3)) * 16;
  const std::int64_t max = gl::limits().storageBlockBytes;
  if (bytes > max)
    fail(ExitCode::device,
         "body \"{}\" of {} vertices and {} faces needs {} bytes, this device allows {} in one buffer "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); simplify it",
         name, mesh.positions.size(), mesh.indices.size() / 3, bytes, max);
  return static_cast<int>(mesh.positions.size());
}

}  // namespace

constinit const PortInfo SkinnedSurface::port = {
    .name = "skin",
    .lacks = ", which has no bones",
    .none = "the scene has no body",
};

SkinnedSurface::SkinnedSurface(const std::string& name, const Figure& figure, bool fast)
    : name_(name),
      vertexCount_(checkedCount(name, figure.mesh)),
      joints_(static_cast<int>(figure.joints.size())),
      restPositions_(name + " positions at bind", asVec4(figure.mesh.positions)),
      restNormals_(name + " normals at bind", asVec4(figure.mesh.normals)),
      weights_(name + " weights", figure.weights),
      poses_(name + " poses", static_cast<int>(6 * figure.joints.size())),
      follow_(name + " joints", figure.follow),
      faces_(name + " faces", facesOf(figure.mesh)),
      positions_(name + " positions", vertexCount_),
      normals_(name + " normals", vertexCount_),
      draw_(gl::kernelDefines(fast), {.normals = true}),
      move_(gl::kernelDefines(fast), {.normals = false}) {}

void SkinnedSurface::begin(std::vector<glm::vec4> atBegin, const std::vector<glm::vec4>& atEnd) {
  atBegin.insert(atBegin.end(), atEnd.begin(), atEnd.end());
  poses_.write(atBegin);
  substep_ = -1;
  skin(draw_, 1.0, positions_);
}

void SkinnedSurface::moveTo(int substep, int substeps) {
  if (substep == substep_ && substeps == substeps_) return;
  if (touched_[0].buffer().bytes() == 0)
    for (gl::Vec4Array& array : touched_) array = gl::Vec4Array(name_ + " touched", vertexCount_);
  if (substep == substep_ + 1 && substeps == substeps_ && substep_ >= 0)
    std::swap(touched_[0], touched_[1]);
  else
    skin(move_, static_cast<double>(substep) / substeps, touched_[0]);
  skin(move_, static_cast<double>(substep + 1) / substeps, touched_[1]);
  substep_ = substep;
  substeps_ = substeps;
}

void SkinnedSurface::skin(const gl::Kernel<SkinKernel>& kernel, double now,
                          const gl::Vec4Array& positions) const {
  gl::barrier();
  kernel.dispatch(vertexCount_, {.count = vertexCount_,
                                 .joints = joints_,
                                 .before = static_cast<float>(1.0 - now),
                                 .now = static_cast<float>(now),
                                 .restPositions = restPositions_,
                                 .restNormals = restNormals_,
                                 .follow = follow_,
                                 .weights = weights_,
                                 .poses = poses_,
                                 .positions = positions,
                                 .normals = normals_});
  gl::barrier();
}

}  // namespace simreel::sim
