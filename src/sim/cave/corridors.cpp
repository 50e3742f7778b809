#include "sim/cave/corridors.hpp"

#include "gl/element_array.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace simreel::sim {

/// Part of a kernel interface: members of glsl/cave/ways.glsl.
struct CaveTreesPart {
  CavePart cave;
  gl::In<"LabelBlock"> labels;
  gl::InOut<"TreeBlock"> trees;
  gl::InOut<"FlagBlock"> flags;
  gl::In<"SourceBlock"> sources;
  gl::InOut<"WeightBlock"> weights;
  gl::InOut<"EdgeBlock"> edges;
  gl::InOut<"LinkBlock"> links;
};

struct CaveRooms {
  static constexpr auto file = "cave/rooms.comp";
  CaveRunsPart part;
  gl::Out<"SourceBlock"> sources;
  gl::Out<"WeightBlock"> weights;
  gl::Out<"EdgeBlock"> edges;
};

struct CaveNearest {
  static constexpr auto file = "cave/nearest.comp";
  CavePart cave;
  gl::Uniform<"reach", glm::ivec2> reach;
  gl::In<"SourceBlock"> sources;
  gl::Out<"NextBlock"> next;
};

struct CaveWeigh {
  static constexpr auto file = "cave/weigh.comp";
  CaveTreesPart part;
  gl::Uniform<"pass", int> pass;
};

struct CaveDig {
  static constexpr auto file = "cave/dig.comp";
  CaveTreesPart part;
  gl::Uniform<"width", int> width;
  gl::Uniform<"firstStep", int> firstStep;
  gl::Uniform<"steps", int> steps;
  gl::InOut<"DugBlock"> dug;
};

struct CaveLink {
  static constexpr auto file = "cave/link.comp";
  CaveTreesPart part;
};

struct CaveFollow {
  static constexpr auto file = "cave/follow.comp";
  CaveTreesPart part;
};

struct CaveMerge {
  static constexpr auto file = "cave/merge.comp";
  CaveTreesPart part;
};

namespace {

// Maximum number of cells that one dispatch digs. It is limited because a software driver ends a shader's
// loops after 65,535 iterations.
constexpr int cellsDug = 32768;

gl::Buffer words(const std::string& label, std::int64_t count) {
  return {label, static_cast<std::size_t>(count) * 4};
}

}  // namespace

CaveCorridors::CaveCorridors(const std::string& name, const CaveGrid& grid)
    : name_(name),
      grid_(grid),
      rooms_(gl::Defines()),
      nearest_(gl::Defines()),
      weigh_(gl::Defines()),
      dig_(gl::Defines()),
      link_(gl::Defines()),
      follow_(gl::Defines()),
      merge_(gl::Defines()),
      sources_(words(name + " nearest cells", grid.numbers())),
      nextSources_(words(name + " next nearest cells", grid.numbers())),
      weights_(words(name + " ways", grid.numbers())),
      edges_(words(name + " edges", grid.numbers())),
      links_(words(name + " links", grid.numbers())),
      dug_(words(name + " corridors", grid.words())),
      flags_(name + " corridor flags", 16) {}

void CaveCorridors::findNearest(const gl::Buffer& cells) {
  const glm::ivec2 items(32 * grid_.rowWords(), grid_.size.y);
  const auto reachOut = [&](glm::ivec2 reach) {
    nearest_.dispatch(items, {partOf(grid_, cells), reach, sources_, nextSources_});
    std::swap(sources_, nextSources_);
  };
  for (int reach = 1; reach < grid_.size.x; reach *= 2) reachOut({reach, 0});
  for (int reach = 1; reach < grid_.size.y; reach *= 2) reachOut({0, reach});
}

void CaveCorridors::digChosen(const CaveTreesPart& part, int width) const {
  const int longest = std::max(grid_.size.x, grid_.size.y);
  const int steps = std::max(1, cellsDug / (2 * width + 2));
  for (int first = 0; first < longest; first += steps)
    dig_.dispatch(grid_.words(),
                  {.part = part, .width = width, .firstStep = first, .steps = steps, .dug = dug_});
}

bool CaveCorridors::joinTrees(const CaveTreesPart& part) {
  const std::array<unsigned, 4> none{};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  flags_.write(0, std::as_bytes(std::span(none)));
  link_.dispatch(grid_.words(), {part});
  // Each iteration halves the chains of merged trees (pointer jumping).
  for (std::int64_t longest = 1; longest < grid_.numbers(); longest *= 2)
    follow_.dispatch(grid_.words(), {part});
  merge_.dispatch(grid_.words(), {part});
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
  gl::barrier();
  rooms_.dispatch(grid_.words(), {.part = {partOf(grid_, cells), regions.labels(), regions.tally(), flags_},
                                  .sources = sources_,
                                  .weights = weights_,
                                  .edges = edges_});
  findNearest(cells);
  const CaveTreesPart part = {.cave = partOf(grid_, cells),
                              .labels = regions.labels(),
                              .trees = regions.tally(),
                              .flags = flags_,
                              .sources = sources_,
                              .weights = weights_,
                              .edges = edges_,
                              .links = links_};
  bool more = true;
  while (more) {
    for (int pass = 0; pass < 2; ++pass)
      weigh_.dispatch({32 * grid_.rowWords(), grid_.size.y}, {part, pass});
    digChosen(part, width);
    more = joinTrees(part);
  }
  copy(dug_, cells);
}

}  // namespace simreel::sim
