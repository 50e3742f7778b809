#include "sim/gray_scott_kernels.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace simreel::sim {

namespace {

/// Of a pass of several steps: elements and rows of its tile (32 KiB, which every driver has), and rows
/// that an invocation keeps in registers (fused.comp unrolls them).
constexpr int stripGroup = 32;
constexpr int tileX = 32, tileY = 64, tileRows = 8;

/// Before anything is filled: a grid far beyond the limit would first take gigabytes.
void checkLimits(const std::string& name, glm::ivec2 size, int columns) {
  const std::int64_t elements = std::int64_t{columns} * size.y;
  const auto refuse = [&](std::int64_t need, const char* what, std::int64_t most, const char* limit) {
    if (need > most)
      fail(ExitCode::device,
           "grayScott \"{}\" of {}x{} cells needs {} {} in one buffer, this device allows {} ({}); make it "
           "smaller",
           name, size.x, size.y, need, what, most, limit);
  };
  refuse(elements * 16, "bytes", gl::limits().storageBlockBytes, "GL_MAX_SHADER_STORAGE_BLOCK_SIZE");
  refuse(elements, "texels", gl::limits().texelBufferTexels, "GL_MAX_TEXTURE_BUFFER_SIZE");
}

/// An H200 reads and writes 3.35e12 bytes/s while both arrays are within 512 MiB, 2.1e12 when they are
/// twice that (its cache of addresses, it seems): bands have half of it. None for software drivers and
/// smaller grids.
int bandRowsFor(int columns, int rows) {
  constexpr std::int64_t reach = 512LL << 20;
  const std::int64_t rowBytes = std::int64_t{columns} * 32;
  if (gl::memoryPath() == gl::MemoryPath::texel || rowBytes * rows <= reach) return 0;
  return static_cast<int>(std::max<std::int64_t>(reach / 2 / rowBytes, 1));
}

std::vector<glm::uvec4> elementsOf(const std::vector<std::uint32_t>& words) {
  std::vector<glm::uvec4> elements;
  for (std::size_t i = 0; i + 3 < words.size(); i += 4)
    elements.emplace_back(words[i], words[i + 1], words[i + 2], words[i + 3]);
  return elements;
}

}  // namespace

GrayScottKernels::Cut GrayScottKernels::bestCut() {
  return gl::memoryPath() == gl::MemoryPath::texel ? Cut{1, 4, 32, 4, 1} : Cut{1, 8, 32, 4, 8};
}

GrayScottKernels::GrayScottKernels(const std::string& name, const GrayScottPlan& plan, bool fast,
                                   const Cut& cut)
    : size_(plan.parameters().size), columns_(plan.columns()), cut_(cut), mapped_(plan.mapped()) {
  if (mapped_) cut_.stepsPerPass = 1;  // its kernel knows no map of rates
  if (cut_.bandRows < 0) cut_.bandRows = bandRowsFor(columns_, size_.y);
  cut_.bandRows = std::min(cut_.bandRows, size_.y / 2);
  checkLimits(name, size_, columns_);
  const std::vector<glm::vec4> first = plan.firstCells();
  cells_[0] = gl::Vec4Array(name + " cells", first);
  cells_[1] = gl::Vec4Array(name + " next cells", first);
  for (int i = 0; i < 2; ++i)
    words_[i] = gl::Texture::view(name + " words", GL_RGBA32UI, cells_[i].buffer());
  if (mapped_) weights_ = gl::Vec4Array(name + " rate map", plan.weights());

  gl::Defines defines = gl::kernelDefines(fast);
  if (!plan.strokes().empty()) {
    strokeBits_ = gl::WordsArray(name + " brush images", elementsOf(plan.strokes().imageBits()));
    paint_ = gl::Program::compute("gray_scott/paint.comp", defines);
    paint_.set("size", size_);
    paint_.set("columns", columns_);
  }
  if (mapped_) defines.emplace_back("MAPPED", "1");
  if (size_.x % 2 == 1) defines.emplace_back("ODD_WIDTH", "1");
  const auto define = [&](const char* key, int value) { defines.emplace_back(key, std::to_string(value)); };
  define("ACROSS", cut_.across);
  define("ROWS", cut_.rows);
  define("GROUP_X", cut_.groupX);
  define("GROUP_Y", cut_.groupY);
  makeProgram(step_, "gray_scott/step.comp", defines);
  if (cut_.stepsPerPass == 1) return;
  gl::Defines several = gl::kernelDefines(fast);
  if (size_.x % 2 == 1) several.emplace_back("ODD_WIDTH", "1");
  if (cut_.stripPairs > 0 && gl::limits().shuffle32) several.emplace_back("SUBGROUPS", "1");
  for (const auto& [key, value] :
       {std::pair{"TILE_X", tileX}, std::pair{"TILE_Y", tileY}, std::pair{"STEPS", cut_.stepsPerPass},
        std::pair{"PAIRS", cut_.stripPairs}, std::pair{"ROWS", cut_.stripRows}})
    several.emplace_back(key, std::to_string(value));
  makeProgram(fused_, cut_.stripPairs > 0 ? "gray_scott/strips.comp" : "gray_scott/fused.comp", several);
}

void GrayScottKernels::makeProgram(gl::Program& program, const char* path,
                                   const gl::Defines& defines) const {
  program = gl::Program::compute(path, defines);
  program.set("size", size_);
  program.set("columns", columns_);
}

void GrayScottKernels::setRates(const GrayScottPlan::Rates& rates) {
  const shader::GrayScottRates& r = rates.base;
  for (const gl::Program* program : {&step_, &fused_}) {
    if (program->name() == 0) continue;
    program->set("rates", glm::vec4(r.diffuseU, r.diffuseV, r.dt, 0));
    program->set("feedKill", glm::vec4(r.feed, r.kill, rates.feedSpan, rates.killSpan));
  }
}

void GrayScottKernels::advance(int steps) {
  const int fused = cut_.stepsPerPass > 1 ? steps / cut_.stepsPerPass : 0;
  run(fused_, fused, cut_.stepsPerPass);
  run(step_, steps - fused * cut_.stepsPerPass, 1);
}

void GrayScottKernels::run(const gl::Program& program, int count, int reach) {
  const int depth = cut_.bandRows / (4 * reach);
  while (count > 0) {
    const int passes = depth > 1 ? std::min(count, depth) : 1;
    if (passes > 1)
      bands(program, passes, reach);
    else
      pass(program, 0, 0, size_.y);
    if (passes % 2 == 1) {
      std::swap(cells_[0], cells_[1]);
      std::swap(words_[0], words_[1]);
    }
    count -= passes;
  }
}

// Sweeping a grid larger than the device's caches of memory and addresses misses them in every pass. Bands
// of rows that fit take several passes in turn: pass s computes the rows of a band that are s * reach or
// more from its edges, from values that are there; then what is missing around each edge, s * reach to both
// sides. A row keeps the values of its last two passes, and those are what its neighbours still ask for:
// two arrays are enough.
void GrayScottKernels::bands(const gl::Program& program, int count, int reach) {
  const int number = (size_.y - 1) / cut_.bandRows + 1;
  const auto edge = [&](int band) { return static_cast<int>(std::int64_t{size_.y} * band / number); };
  for (int band = 0; band < number; ++band)
    for (int s = 1; s <= count; ++s) {
      const int first = edge(band) + s * reach;
      pass(program, (s - 1) % 2, first, edge(band + 1) - s * reach - first);
    }
  for (int band = 0; band < number; ++band)
    for (int s = 1; s <= count; ++s)
      pass(program, (s - 1) % 2, (edge(band) - s * reach + size_.y) % size_.y, 2 * s * reach);
}

void GrayScottKernels::pass(const gl::Program& program, int from, int first, int rows) {
  cells_[from].bindInput(0);
  cells_[1 - from].bindState(1);
  if (mapped_) weights_.bindInput(2);
  program.set("rowRange", glm::ivec2(first, rows));
  gl::barrier();
  const int borders = (cut_.stepsPerPass + 1) / 2 * 2;
  if (&program == &fused_ && cut_.stripPairs > 0) {
    const int width = stripGroup * cut_.stripPairs - borders;
    program.dispatch(((columns_ - 1) / width + 1) * stripGroup, (rows - 1) / cut_.stripRows + 1);
  } else if (&program == &fused_) {
    const int width = tileX - borders;
    const int height = tileY - 2 * cut_.stepsPerPass;
    program.dispatch(((columns_ - 1) / width + 1) * tileX, ((rows - 1) / height + 1) * (tileY / tileRows));
  } else {
    program.dispatch((columns_ - 1) / cut_.across + 1, (rows - 1) / cut_.rows + 1);
  }
}

void GrayScottKernels::paint(const shader::Stroke& stroke) {
  const glm::ivec4 box = Strokes::box(stroke, size_);
  if (box.z == 0) return;
  setStroke(paint_, stroke, box);
  cells_[0].bindState(1);
  strokeBits_.bindInput(2);
  gl::barrier();
  paint_.dispatch(columns_, box.w);
}

}  // namespace simreel::sim
