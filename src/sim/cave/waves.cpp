#include "sim/cave/waves.hpp"

#include "gl/element_array.hpp"

#include <array>

namespace simreel::shader::cave {
#include "glsl/cave/bindings.glsl"
}

namespace simreel::sim {

namespace {

constexpr int wavesTogether = 128;
/// WaveBlock of wave.glsl.
struct WaveState {
  unsigned begin, end, steps, farthest, tail, over;
};

}  // namespace

CaveWaves::CaveWaves(const std::string& name, const CaveGrid& grid)
    : grid_(grid),
      start_(gl::Program::compute("cave/wave_start.comp")),
      waves_(gl::Program::compute("cave/waves.comp")),
      show_(gl::Program::compute("cave/show_distances.comp")),
      distances_(name + " steps", static_cast<std::size_t>(grid.numbers()) * 4),
      queue_(name + " wave cells", static_cast<std::size_t>(grid.numbers()) * 4),
      wave_(name + " wave", 32) {
  for (const gl::Program* program : {&start_, &waves_, &show_}) grid.set(*program);
}

CaveWaves::Farthest CaveWaves::run(const gl::Buffer& cells, unsigned start) {
  cells.bindStorage(shader::cave::cellsBinding);
  distances_.bindStorage(shader::cave::distancesBinding);
  queue_.bindStorage(shader::cave::queueBinding);
  wave_.bindStorage(shader::cave::flagsBinding);
  gl::barrier();
  start_.dispatch(32 * grid_.rowWords(), grid_.size.y);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  const unsigned zero = 0;
  distances_.write(std::size_t{4} * start, std::as_bytes(std::span(&zero, 1)));
  queue_.write(0, std::as_bytes(std::span(&start, 1)));
  WaveState wave{0, 1, 0, noCell, 1, 0};
  wave_.write(0, std::as_bytes(std::span(&wave, 1)));
  waves_.set("waves", wavesTogether);
  while (wave.over == 0) {
    gl::barrier();
    waves_.dispatch(1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    wave_.read(0, std::as_writable_bytes(std::span(&wave, 1)));
  }
  gl::barrier();
  return {wave.farthest, wave.steps};
}

void CaveWaves::show(const gl::Buffer& cells, const gl::Buffer& field) const {
  cells.bindStorage(shader::cave::cellsBinding);
  distances_.bindStorage(shader::cave::distancesBinding);
  queue_.bindStorage(shader::cave::queueBinding);
  field.bindStorage(shader::cave::labelsBinding);
  gl::barrier();
  show_.dispatch(32 * grid_.rowWords(), grid_.size.y);
  gl::barrier();
}

}  // namespace simreel::sim
