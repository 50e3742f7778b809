#include "sim/life/active.hpp"

#include "glsl/common/cpp.hpp"
#include "sim/life/stepper.hpp"

#include <algorithm>

namespace simreel::sim {

struct LifeActiveKernel {
  static constexpr auto file = "life/active.comp";
  struct Variant {
    LifeRuleVariant rule;
    gl::Range<"STEPS", 1, 16> steps;
    gl::Range<"TILE_WORDS", 1, 4> tileWords;
    gl::Range<"TILE_ROWS", 8, 64> tileRows;
    gl::Range<"TILES", 1, 8192> tiles;
    gl::Flag<"OVERLAP"> overlap;
    gl::Flag<"TORUS"> torus;
  };
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"rowWords", int> rowWords;
  gl::Uniform<"firstPass", unsigned> firstPass;
  gl::Uniform<"passes", int> passes;
  gl::Uniform<"all", bool> all;
  gl::In<"cellTexels"> texels;
  gl::InOut<"CellBlock"> cells;
  gl::InOut<"MarkBlock"> marks;
  gl::InOut<"StatusBlock"> status;
};

namespace {

constexpr int tileWords = 1, tileRows = 32;
// Maximum number of loop iterations that an invocation may execute in one dispatch, counted as below. Mesa
// 22.3 silently ends loops after 65,535 iterations. The margin is for compilers that keep additional loops
// in the kernel. If it is not enough, the kernel's last statement reports that.
constexpr int maxLoops = 20000;

int tilesOf(glm::ivec2 size) {
  return size.x / (32 * tileWords) * ((size.y + tileRows - 1) / tileRows);
}

}  // namespace

bool LifeActive::suits(glm::ivec2 size) {
  constexpr int maxCells = 1 << 18;
  return gl::memoryPath() == gl::MemoryPath::texel && size.x % (32 * tileWords) == 0 &&
         size.y >= tileRows && size.x <= maxCells / size.y;
}

LifeActive::LifeActive(const CellRule& rule, bool torus, glm::ivec2 size)
    : size_(size), words_((size.x + 127) / 128 * 4 * size.y) {
  const int tiles = tilesOf(size);
  // A pass counts as one iteration, plus the iterations that list the tiles and process them in groups of
  // eight, plus the iterations over the rows of each group. Each loop counts as one iteration more, because
  // its condition is tested once more at the end.
  const int eights = (tiles + 7) / 8;
  const int loops = 1 + 2 * (eights + 1) + eights * ((tileRows + 2 * steps) / 2 + 1);
  passesPerDispatch_ = std::max(1, (maxLoops - 1) / loops);
  const auto bytes = static_cast<std::size_t>(words_) * 4;
  cells_ = gl::Buffer("cells in tiles", 2 * bytes);
  texels_ = gl::Texture::view("cells in tiles", GL_R32UI, cells_, 4);
  marks_ = gl::Buffer("tiles that move", static_cast<std::size_t>(tiles) * 4);
  kernel_ = gl::Kernel<LifeActiveKernel>(gl::kernelDefines(false), {.rule = variantOf(rule),
                                                                    .steps = steps,
                                                                    .tileWords = tileWords,
                                                                    .tileRows = tileRows,
                                                                    .tiles = tiles,
                                                                    .overlap = size.y % tileRows != 0,
                                                                    .torus = torus});
}

void LifeActive::run(gl::WordsArray& cells, int passes, const gl::Buffer& status) {
  const auto bytes = static_cast<GLsizeiptr>(words_) * 4;
  const auto half = [&] { return (pass_ & 1U) == 0 ? GLintptr{0} : GLintptr{bytes}; };
  ++pass_;  // The marks of this run must differ from the marks of the previous run.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(cells.buffer().name(), cells_.name(), 0, half(), bytes);
  for (int done = 0; done < passes;) {
    const int some = std::min(passes - done, passesPerDispatch_);
    kernel_.dispatch(1, {.size = size_,
                         .rowWords = (size_.x + 127) / 128 * 4,
                         .firstPass = pass_,
                         .passes = some,
                         .all = done == 0,
                         .texels = texels_,
                         .cells = cells_,
                         .marks = marks_,
                         .status = status});
    done += some;
    pass_ += static_cast<unsigned>(some);
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(cells_.name(), cells.buffer().name(), half(), 0, bytes);
  gl::barrier();
}

}  // namespace simreel::sim
