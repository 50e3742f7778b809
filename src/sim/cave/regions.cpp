#include "sim/cave/regions.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"

#include <array>

namespace simreel::shader::cave {
#include "glsl/cave/bindings.glsl"
}

namespace simreel::sim {

namespace {

// Each round at least halves the ways to the lowest cell that are left, and lowers every region that is not
// done.
constexpr int roundsTogether = 4;
constexpr int maxRounds = 100'000;

using Flags = std::array<unsigned, 4>;

Flags readFlags(const gl::Buffer& buffer) {
  Flags flags{};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  buffer.read(0, std::as_writable_bytes(std::span(flags)));
  return flags;
}

void writeFlags(gl::Buffer& buffer, const Flags& flags) {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  buffer.write(0, std::as_bytes(std::span(flags)));
}

}  // namespace

void CaveGrid::set(const gl::Program& program) const {
  program.set("size", size);
  program.set("rowWords", rowWords());
}

CaveRegions::CaveRegions(const std::string& name, const CaveGrid& grid)
    : name_(name),
      grid_(grid),
      labels_(name + " labels", static_cast<std::size_t>(grid.numbers()) * 4),
      tally_(name + " region sizes", static_cast<std::size_t>(grid.numbers()) * 4),
      flags_(name + " region flags", sizeof(Flags)) {
  for (const CaveKind kind : {CaveKind::open, CaveKind::rock}) {
    gl::Defines defines;
    if (kind == CaveKind::rock) defines.emplace_back("ROCK", "1");
    Kernels& made = kernels_[static_cast<std::size_t>(kind)];
    made = {gl::Program::compute("cave/label_start.comp", defines),
            gl::Program::compute("cave/label_join.comp", defines),
            gl::Program::compute("cave/label_end.comp", defines),
            gl::Program::compute("cave/largest.comp", defines),
            gl::Program::compute("cave/remove.comp", defines)};
    for (const gl::Program* program : {&made.start, &made.join, &made.end, &made.largest, &made.remove})
      grid.set(*program);
  }
}

void CaveRegions::bind(const gl::Buffer& cells) const {
  cells.bindStorage(shader::cave::cellsBinding);
  labels_.bindStorage(shader::cave::labelsBinding);
  tally_.bindStorage(shader::cave::tallyBinding);
  flags_.bindStorage(shader::cave::flagsBinding);
  gl::barrier();
}

void CaveRegions::label(const gl::Buffer& cells, CaveKind kind) {
  kind_ = kind;
  bind(cells);
  kernels().start.dispatch(grid_.words());
  gl::barrier();
  bool changed = true;
  for (int round = 0; changed; round += roundsTogether) {
    SIMREEL_CHECK(round < maxRounds);
    for (int i = 0; i < roundsTogether; ++i) {
      if (i == roundsTogether - 1) writeFlags(flags_, {});
      kernels().join.dispatch(grid_.words());
      gl::barrier();
    }
    changed = readFlags(flags_)[0] != 0;
  }
  kernels().end.dispatch(grid_.words());
  gl::barrier();
}

CaveRegions::Largest CaveRegions::largest(const gl::Buffer& cells) {
  bind(cells);
  writeFlags(flags_, {0, 0, noCell, 0});
  for (int pass = 0; pass < 2; ++pass) {
    kernels().largest.set("pass", pass);
    kernels().largest.dispatch(grid_.words());
    gl::barrier();
  }
  const Flags flags = readFlags(flags_);
  return {flags[1], flags[2]};
}

void CaveRegions::remove(const gl::Buffer& cells, unsigned fewest, unsigned kept) {
  bind(cells);
  kernels().remove.set("fewest", fewest);
  kernels().remove.set("kept", kept);
  kernels().remove.dispatch(grid_.words());
  gl::barrier();
}

}  // namespace simreel::sim
