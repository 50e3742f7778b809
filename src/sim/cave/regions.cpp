#include "sim/cave/regions.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"

#include <array>

namespace simreel::sim {

struct CaveLargest {
  static constexpr auto file = "cave/largest.comp";
  using Variant = CaveRunsKernel<"cave/largest.comp">::Variant;
  CaveRunsPart part;
  gl::Uniform<"pass", int> pass;
};

struct CaveRemove {
  static constexpr auto file = "cave/remove.comp";
  using Variant = CaveLargest::Variant;
  CaveRunsPart part;
  gl::Uniform<"fewest", unsigned> fewest;
  gl::Uniform<"kept", unsigned> kept;
};

namespace {

// Number of rounds between two tests for completion. Each round at least halves the remaining paths to the
// lowest cell and lowers the label of every unfinished region.
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

CaveRegions::CaveRegions(const std::string& name, const CaveGrid& grid)
    : name_(name),
      grid_(grid),
      labels_(name + " labels", static_cast<std::size_t>(grid.numbers()) * 4),
      tally_(name + " region sizes", static_cast<std::size_t>(grid.numbers()) * 4),
      flags_(name + " region flags", sizeof(Flags)) {
  for (const CaveKind kind : {CaveKind::open, CaveKind::rock}) {
    const bool rock = kind == CaveKind::rock;
    Kernels& made = kernels_[static_cast<std::size_t>(kind)];
    made.start = decltype(made.start)({}, {rock});
    made.join = decltype(made.join)({}, {rock});
    made.end = decltype(made.end)({}, {rock});
    made.largest = gl::Kernel<CaveLargest>({}, {rock});
    made.remove = gl::Kernel<CaveRemove>({}, {rock});
  }
}

void CaveRegions::label(const gl::Buffer& cells, CaveKind kind) {
  kind_ = kind;
  const CaveRunsPart given = part(cells);
  kernels().start.dispatch(grid_.words(), {given});
  bool changed = true;
  for (int round = 0; changed; round += roundsTogether) {
    SIMREEL_CHECK(round < maxRounds);
    for (int i = 0; i < roundsTogether; ++i) {
      if (i == roundsTogether - 1) writeFlags(flags_, {});
      kernels().join.dispatch(grid_.words(), {given});
    }
    changed = readFlags(flags_)[0] != 0;
  }
  kernels().end.dispatch(grid_.words(), {given});
}

CaveRegions::Largest CaveRegions::largest(const gl::Buffer& cells) {
  writeFlags(flags_, {0, 0, noCell, 0});
  for (int pass = 0; pass < 2; ++pass) kernels().largest.dispatch(grid_.words(), {part(cells), pass});
  const Flags flags = readFlags(flags_);
  return {flags[1], flags[2]};
}

void CaveRegions::remove(const gl::Buffer& cells, unsigned fewest, unsigned kept) {
  kernels().remove.dispatch(grid_.words(), {part(cells), fewest, kept});
}

}  // namespace simreel::sim
