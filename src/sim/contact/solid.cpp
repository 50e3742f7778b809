#include "sim/contact/solid.hpp"

#include <array>
#include <utility>

#include <glm/matrix.hpp>

namespace simreel::sim {

struct MoveKernel {
  static constexpr auto file = "contact/move.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"now", float> now;
  gl::Uniform<"begin.row0", glm::vec4> begin0;
  gl::Uniform<"begin.row1", glm::vec4> begin1;
  gl::Uniform<"begin.row2", glm::vec4> begin2;
  gl::Uniform<"end.row0", glm::vec4> end0;
  gl::Uniform<"end.row1", glm::vec4> end1;
  gl::Uniform<"end.row2", glm::vec4> end2;
  gl::In<"begins"> begins;
  gl::In<"ends"> ends;
  gl::Out<"places"> places;
};

constinit const PortInfo ContactSolid::port = {
    .name = "faces",
    .lacks = ", which has no faces to touch",
    .none = "the scene has no faces to touch",
    .unused = "nothing touches these faces; give a \"cloth\" of this scene \"contact\": {}",
};

namespace {

/// Returns four times the squared area of a face, in m^4.
double areaSquared(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a, v = c - a;
  const glm::dvec3 n(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
  return n.x * n.x + n.y * n.y + n.z * n.z;
}

}  // namespace

ContactPart solidPart(std::span<const glm::vec3> positions, std::span<const unsigned> indices,
                      const std::optional<double>& friction) {
  ContactPart part;
  part.solid = true;
  part.thickness = 0;
  part.friction = friction ? static_cast<float>(*friction) : -1.0F;
  part.positions.reserve(positions.size());
  for (const glm::vec3& p : positions) part.positions.emplace_back(p, 0.0F);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::uvec3 face(indices[i], indices[i + 1], indices[i + 2]);
    constexpr double none = 1e-24;
    if (areaSquared(positions[face.x], positions[face.y], positions[face.z]) > none)
      part.faces.push_back(face);
  }
  return part;
}

MovedVertices::MovedVertices(const std::string& name, std::span<const glm::vec4> positions, bool fast)
    : count_(static_cast<int>(positions.size())),
      begins_(name + " at a frame's beginning", positions),
      ends_(name + " at a frame's end", positions),
      places_{gl::Vec4Array(name + " touched", positions), gl::Vec4Array(name + " touched", positions)},
      move_(gl::kernelDefines(fast)) {}

void MovedVertices::copyPositions(const gl::Vec4Array& from, const gl::Vec4Array& to) {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(from.buffer().name(), to.buffer().name(), 0, 0,
                           static_cast<GLsizeiptr>(to.buffer().bytes()));
}

void MovedVertices::place(const glm::mat4& begin, const glm::mat4& end) {
  begin_ = glm::transpose(begin);
  end_ = glm::transpose(end);
  substep_ = -1;
}

void MovedVertices::moveTo(int substep, int substeps) {
  if (substep == substep_ && substeps == substeps_) return;
  gl::barrier();
  if (substep == substep_ + 1 && substeps == substeps_ && substep_ >= 0)
    std::swap(places_[0], places_[1]);
  else
    makeAt(static_cast<double>(substep) / substeps, places_[0]);
  makeAt(static_cast<double>(substep + 1) / substeps, places_[1]);
  gl::barrier();
  substep_ = substep;
  substeps_ = substeps;
}

void MovedVertices::makeAt(double share, const gl::Vec4Array& places) const {
  move_.dispatch(count_, {.count = count_,
                          .now = static_cast<float>(share),
                          .begin0 = begin_[0],
                          .begin1 = begin_[1],
                          .begin2 = begin_[2],
                          .end0 = end_[0],
                          .end1 = end_[1],
                          .end2 = end_[2],
                          .begins = begins_,
                          .ends = ends_,
                          .places = places});
}

}  // namespace simreel::sim
