#include "sim/cave/corridors.hpp"

#include "gl/element_array.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace simreel::shader::cave {
#include "glsl/cave/bindings.glsl"
}

namespace simreel::sim {

namespace {

// A software driver ends a shader's loops after 65,535 iterations: so many cells are dug by one dispatch.
constexpr int cellsDug = 32768;

gl::Buffer words(const std::string& label, std::int64_t count) {
  return {label, static_cast<std::size_t>(count) * 4};
}

}  // namespace

CaveCorridors::CaveCorridors(const std::string& name, const CaveGrid& grid)
    : name_(name),
      grid_(grid),
      rooms_(gl::Program::compute("cave/rooms.comp")),
      nearest_(gl::Program::compute("cave/nearest.comp")),
      weigh_(gl::Program::compute("cave/weigh.comp")),
      dig_(gl::Program::compute("cave/dig.comp")),
      link_(gl::Program::compute("cave/link.comp")),
      follow_(gl::Program::compute("cave/follow.comp")),
      merge_(gl::Program::compute("cave/merge.comp")),
      sources_(words(name + " nearest cells", grid.numbers())),
      nextSources_(words(name + " next nearest cells", grid.numbers())),
      weights_(words(name + " ways", grid.numbers())),
      edges_(words(name + " edges", grid.numbers())),
      links_(words(name + " links", grid.numbers())),
      dug_(words(name + " corridors", grid.words())),
      flags_(name + " corridor flags", 16) {
  for (const gl::Program* program : {&rooms_, &nearest_, &weigh_, &dig_, &link_, &follow_, &merge_})
    grid.set(*program);
}

void CaveCorridors::findNearest() {
  const int pitch = 32 * grid_.rowWords();
  const auto reachOut = [&](glm::ivec2 reach) {
    sources_.bindStorage(shader::cave::sourcesBinding);
    nextSources_.bindStorage(shader::cave::nextSourcesBinding);
    nearest_.set("reach", reach);
    nearest_.dispatch(pitch, grid_.size.y);
    gl::barrier();
    std::swap(sources_, nextSources_);
  };
  for (int reach = 1; reach < grid_.size.x; reach *= 2) reachOut({reach, 0});
  for (int reach = 1; reach < grid_.size.y; reach *= 2) reachOut({0, reach});
  sources_.bindStorage(shader::cave::sourcesBinding);
}

void CaveCorridors::digChosen(int width) {
  dug_.bindStorage(shader::cave::dugBinding);
  const int longest = std::max(grid_.size.x, grid_.size.y);
  const int steps = std::max(1, cellsDug / (2 * width + 2));
  dig_.set("width", width);
  dig_.set("steps", steps);
  for (int first = 0; first < longest; first += steps) {
    dig_.set("firstStep", first);
    dig_.dispatch(grid_.words());
  }
  gl::barrier();
}

bool CaveCorridors::joinTrees() {
  const std::array<unsigned, 4> none{};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  flags_.write(0, std::as_bytes(std::span(none)));
  links_.bindStorage(shader::cave::linksBinding);
  link_.dispatch(grid_.words());
  gl::barrier();
  // Chains of trees are halved each time.
  for (std::int64_t longest = 1; longest < grid_.numbers(); longest *= 2) {
    follow_.dispatch(grid_.words());
    gl::barrier();
  }
  merge_.dispatch(grid_.words());
  gl::barrier();
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::array<unsigned, 4> flags{};
  flags_.read(0, std::as_writable_bytes(std::span(flags)));
  return flags[0] != 0;
}

void CaveCorridors::dig(gl::Buffer& cells, const CaveRegions& regions, int width) {
  const auto copy = [&](const gl::Buffer& from, const gl::Buffer& to) {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(from.name(), to.name(), 0, 0, static_cast<GLsizeiptr>(dug_.bytes()));
  };
  copy(cells, dug_);
  cells.bindStorage(shader::cave::cellsBinding);
  regions.labels().bindStorage(shader::cave::labelsBinding);
  regions.tally().bindStorage(shader::cave::tallyBinding);
  flags_.bindStorage(shader::cave::flagsBinding);
  sources_.bindStorage(shader::cave::sourcesBinding);
  weights_.bindStorage(shader::cave::weightsBinding);
  edges_.bindStorage(shader::cave::edgesBinding);
  gl::barrier();
  rooms_.dispatch(grid_.words());
  gl::barrier();
  findNearest();
  weights_.bindStorage(shader::cave::weightsBinding);
  bool more = true;
  while (more) {
    for (int pass = 0; pass < 2; ++pass) {
      weigh_.set("pass", pass);
      weigh_.dispatch(32 * grid_.rowWords(), grid_.size.y);
      gl::barrier();
    }
    digChosen(width);
    more = joinTrees();
  }
  copy(dug_, cells);
}

}  // namespace simreel::sim
