#include "sim/life/active.hpp"

#include "glsl/common/cpp.hpp"
#include "sim/life/stepper.hpp"

#include <algorithm>
#include <string>

namespace simreel::sim {

namespace {

constexpr int tileWords = 1, tileRows = 32;
// Loops of an invocation in one dispatch, as counted below. Mesa 22.3 ends them silently after 65,535;
// compilers that leave further loops in the kernel need room. Where it is not enough, the kernel's end
// notes it.
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
  // A pass is an iteration of its own, some that list tiles and take eight at a time, and those over the
  // rows of each eight; every loop ends in one more that finds it done.
  const int eights = (tiles + 7) / 8;
  const int loops = 1 + 2 * (eights + 1) + eights * ((tileRows + 2 * steps) / 2 + 1);
  passesPerDispatch_ = std::max(1, (maxLoops - 1) / loops);
  const auto bytes = static_cast<std::size_t>(words_) * 4;
  cells_ = gl::Buffer("cells in tiles", 2 * bytes);
  texels_ = gl::Texture::view("cells in tiles", GL_R32UI, cells_, 4);
  marks_ = gl::Buffer("tiles that move", static_cast<std::size_t>(tiles) * 4);
  gl::Defines defines = gl::kernelDefines(false);
  const auto define = [&](const char* name, int value) {
    defines.emplace_back(name, std::to_string(value));
  };
  defineRule(defines, rule);
  define("STEPS", steps);
  define("TILE_WORDS", tileWords);
  define("TILE_ROWS", tileRows);
  define("TILES", tiles);
  if (size.y % tileRows != 0) define("OVERLAP", 1);
  if (torus) define("TORUS", 1);
  program_ = gl::Program::compute("life/active.comp", defines);
  program_.set("size", size);
  program_.set("rowWords", (size.x + 127) / 128 * 4);
}

void LifeActive::run(gl::WordsArray& cells, int passes, const gl::Buffer& status) {
  const auto bytes = static_cast<GLsizeiptr>(words_) * 4;
  const auto half = [&] { return (pass_ & 1U) == 0 ? GLintptr{0} : GLintptr{bytes}; };
  ++pass_;  // a mark of the last run is no mark of this one
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(cells.buffer().name(), cells_.name(), 0, half(), bytes);
  texels_.bindImage(shader::life::cellsBinding, GL_READ_ONLY);
  cells_.bindStorage(shader::life::cellsBinding);
  marks_.bindStorage(shader::life::marksBinding);
  status.bindStorage(shader::statusBinding);
  for (int done = 0; done < passes;) {
    const int some = std::min(passes - done, passesPerDispatch_);
    program_.set("firstPass", pass_);
    program_.set("passes", some);
    program_.set("all", done == 0 ? 1 : 0);
    program_.dispatch(1);
    gl::barrier();
    done += some;
    pass_ += static_cast<unsigned>(some);
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(cells_.name(), cells.buffer().name(), half(), 0, bytes);
  gl::barrier();
}

}  // namespace simreel::sim
