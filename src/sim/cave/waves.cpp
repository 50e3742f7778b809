#include "sim/cave/waves.hpp"

#include "gl/element_array.hpp"

#include <array>

namespace simreel::sim {

/// Part of a kernel interface: members of glsl/cave/wave.glsl.
struct CaveWavePart {
  CavePart cave;
  gl::InOut<"DistanceBlock"> distances;
  gl::InOut<"QueueBlock"> queue;
  gl::InOut<"WaveBlock"> wave;
};

struct CaveWaveStart {
  static constexpr auto file = "cave/wave_start.comp";
  CaveWavePart part;
};

struct CaveWave {
  static constexpr auto file = "cave/waves.comp";
  CaveWavePart part;
  gl::Uniform<"waves", int> waves;
};

struct CaveDisplay {
  static constexpr auto file = "cave/show_distances.comp";
  CaveWavePart part;
  gl::Out<"ShownBlock"> shown;
};

namespace {

constexpr int wavesTogether = 128;
/// Contents of WaveBlock in glsl/cave/wave.glsl.
struct WaveState {
  unsigned begin, end, steps, farthest, tail, over;
};

}  // namespace

CaveWaves::CaveWaves(const std::string& name, const CaveGrid& grid)
    : grid_(grid),
      start_(gl::Defines()),
      waves_(gl::Defines()),
      display_(gl::Defines()),
      distances_(name + " steps", static_cast<std::size_t>(grid.numbers()) * 4),
      queue_(name + " wave cells", static_cast<std::size_t>(grid.numbers()) * 4),
      wave_(name + " wave", 32) {}

CaveWavePart CaveWaves::part(const gl::Buffer& cells) const {
  return {partOf(grid_, cells), distances_, queue_, wave_};
}

CaveWaves::Farthest CaveWaves::run(const gl::Buffer& cells, unsigned start) {
  start_.dispatch({32 * grid_.rowWords(), grid_.size.y}, {part(cells)});
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  const unsigned zero = 0;
  distances_.write(std::size_t{4} * start, std::as_bytes(std::span(&zero, 1)));
  queue_.write(0, std::as_bytes(std::span(&start, 1)));
  WaveState wave{0, 1, 0, noCell, 1, 0};
  wave_.write(0, std::as_bytes(std::span(&wave, 1)));
  while (wave.over == 0) {
    waves_.dispatch(1, {part(cells), wavesTogether});
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    wave_.read(0, std::as_writable_bytes(std::span(&wave, 1)));
  }
  return {wave.farthest, wave.steps};
}

void CaveWaves::writeDistances(const gl::Buffer& cells, const gl::Buffer& field) const {
  display_.dispatch({32 * grid_.rowWords(), grid_.size.y}, {part(cells), field});
  gl::barrier();
}

}  // namespace simreel::sim
