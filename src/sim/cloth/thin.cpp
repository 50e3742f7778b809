#include "sim/cloth/thin.hpp"

namespace simreel::shader::cloth {
#include "glsl/cloth/bindings.glsl"
#include "glsl/cloth/thin_rounds.glsl"
}  // namespace simreel::shader::cloth

namespace simreel::sim {

ThinColliders::ThinColliders(const std::string& name, const char* path, int count, int vertices, bool fast)
    : there_(count > 0), vertices_(vertices) {
  if (!there_) return;
  gl::Defines defines = gl::kernelDefines(fast);
  for (const char* other : {"HEIGHTS", "WALLS", "MESHES"}) defines.emplace_back(other, "0");
  find_ = gl::Program::compute(path, defines);
  move_ = gl::Program::compute("cloth/shift.comp", defines);
  move_.set("vertices", vertices);
  shifts_ = gl::Vec4Array(name + " shifts", 2 * vertices);
}

void ThinColliders::fend(const gl::Vec4Array& before, const gl::Vec4Array& next,
                         const gl::Vec4Array& velocities, int x, int y) const {
  if (!there_) return;
  for (int round = 0; round < shader::cloth::thinRounds; ++round) {
    gl::barrier();
    before.bindInput(shader::cloth::positionsBinding);
    next.bindInput(shader::cloth::nextPositionsBinding);
    velocities.bindInput(shader::cloth::velocitiesBinding);
    shifts_.bindState(shader::cloth::shiftsBinding);
    find_.dispatch(x, y);
    gl::barrier();
    next.bindState(shader::cloth::nextPositionsBinding);
    velocities.bindState(shader::cloth::velocitiesBinding);
    shifts_.bindInput(shader::cloth::shiftsBinding);
    move_.dispatch(vertices_);
  }
}

}  // namespace simreel::sim
