#include "sim/cloth/thin.hpp"

namespace simreel::shader::cloth {
#include "glsl/cloth/thin_rounds.glsl"
}  // namespace simreel::shader::cloth

namespace simreel::sim {

struct ThinShift {
  static constexpr auto file = "cloth/shift.comp";
  gl::Uniform<"vertices", int> vertices;
  gl::InOut<"nextPositions"> next;
  gl::InOut<"velocities"> velocities;
  gl::In<"shifts"> shifts;
};

const int ThinColliders::rounds = shader::cloth::thinRounds;

ThinColliders::ThinColliders(const std::string& name, int count, int vertices, bool fast)
    : any_(count > 0), vertices_(vertices) {
  if (!any_) return;
  move_ = gl::Kernel<ThinShift>(gl::kernelDefines(fast));
  shifts_ = gl::Vec4Array(name + " shifts", 2 * vertices);
}

void ThinColliders::move(const gl::Vec4Array& next, const gl::Vec4Array& velocities) const {
  move_.dispatch(vertices_,
                 {.vertices = vertices_, .next = next, .velocities = velocities, .shifts = shifts_});
}

}  // namespace simreel::sim
