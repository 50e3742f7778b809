#include "sim/gray_scott/kernels.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace simreel::sim {

struct GrayScottGrid {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"columns", int> columns;
  gl::Uniform<"rowRange", glm::ivec2> rowRange;
  gl::Block<"RatesBlock", shader::GrayScottRates> rates;
  gl::In<"cells"> cells;
  gl::In<"weights"> weights;
};

struct GrayScottStep {
  static constexpr auto file = "gray_scott/step.comp";
  struct Variant {
    gl::Flag<"MAPPED"> mapped;
    gl::Flag<"ODD_WIDTH"> oddWidth;
    gl::Range<"ACROSS", 1, 4> across;
    gl::Range<"ROWS", 1, 64> rows;
    gl::Range<"GROUP_X", 1, 64> groupX;
    gl::Range<"GROUP_Y", 1, 8> groupY;
  };
  GrayScottGrid grid;
  gl::Out<"nextCells"> next;
};

struct GrayScottStrips {
  static constexpr auto file = "gray_scott/strips.comp";
  struct Variant {
    gl::Flag<"ODD_WIDTH"> oddWidth;
    gl::Flag<"SUBGROUPS"> subgroups;
    gl::Choice<"STEPS", 2, 3, 4, 6, 8> steps;
    gl::Range<"ELEMENTS", 1, 12> elements;
    gl::Range<"STRIP_ROWS", 1, 512> rows;
  };
  GrayScottGrid grid;
  gl::Out<"nextCells"> next;
};

struct GrayScottLook {
  static constexpr auto file = "gray_scott/look.comp";
  struct Variant {
    gl::Flag<"MAPPED"> mapped;
    gl::Flag<"ODD_WIDTH"> oddWidth;
  };
  GrayScottGrid grid;
  gl::InOut<"StatusBlock"> status;
};

struct GrayScottPaint {
  static constexpr auto file = "gray_scott/paint.comp";
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"columns", int> columns;
  StrokeUniforms stroke;
  gl::InOut<"cells"> cells;
  gl::In<"stamps"> stamps;
};

namespace {

/// Returns the number of adjacent invocations across a strip (strips.comp).
int stripGroup() {
  return gl::memoryPath() == gl::MemoryPath::texel ? 1 : 32;
}

/// Returns the number of strips in a pass of several steps. Each strip also recomputes `steps` cells on
/// each side of its cells.
int stripCount(glm::ivec2 size, int steps, int elements, int rows) {
  const int width = stripGroup() * elements - (steps + 1) / 2 * 2;
  return (((size.x + 1) / 2 - 1) / width + 1) * ((size.y - 1) / rows + 1);
}

/// Checks the device limits before the arrays are filled, because an oversized grid would take gigabytes.
void checkLimits(const std::string& name, glm::ivec2 size, int columns) {
  const std::int64_t elements = std::int64_t{columns} * size.y;
  const auto refuse = [&](std::int64_t need, const char* what, std::int64_t max, const char* limit) {
    if (need > max)
      fail(ExitCode::device,
           "grayScott \"{}\" of {}x{} cells needs {} {} in one buffer, this device allows {} ({}); make it "
           "smaller",
           name, size.x, size.y, need, what, max, limit);
  };
  refuse(elements * 16, "bytes", gl::limits().storageBlockBytes, "GL_MAX_SHADER_STORAGE_BLOCK_SIZE");
  refuse(elements, "texels", gl::limits().texelBufferTexels, "GL_MAX_TEXTURE_BUFFER_SIZE");
}

/// Returns the number of rows per band, or 0 to use no bands. An H200 transfers 3.6e12 bytes/s if both
/// arrays together fit into 256 MiB, but only 2.1e12 bytes/s at 1 GiB, probably because of TLB misses.
/// Therefore, the rows of a band take 256 MiB in both arrays together. Software drivers and grids of up to
/// 512 MiB use no bands.
int bandRowsFor(int columns, int rows) {
  constexpr std::int64_t reach = 512LL << 20;
  const std::int64_t rowBytes = std::int64_t{columns} * 32;
  if (gl::memoryPath() == gl::MemoryPath::texel || rowBytes * rows <= reach) return 0;
  return static_cast<int>(std::max<std::int64_t>(reach / 2 / rowBytes, 1));
}

}  // namespace

// With longer and wider strips, fewer cells are recomputed, but an H200 needs about 4,000 strips, because
// each of its 132 multiprocessors runs 9 of the widest strips at a time. The values were measured from
// 512x512 to 8192x8192 (tools/bench/README.md).
GrayScottKernels::Cut GrayScottKernels::bestCut(glm::ivec2 size) {
  constexpr int steps = 4;
  if (gl::memoryPath() == gl::MemoryPath::texel) {
    constexpr int elements = 12, lanes = 64;  // There must be enough strips for four threads with eight
                                              // lanes each.
    int rows = 64;
    while (rows > 8 && stripCount(size, steps, elements, rows) < lanes) rows /= 2;
    return {1, 4, 32, 4, -1, steps, elements, rows};
  }
  constexpr int wanted = 4000;
  if (stripCount(size, steps, 2, 128) >= wanted) return {1, 1, 32, 4, -1, steps, 2, 128};
  int rows = 128;
  while (rows > 16 && stripCount(size, steps, 1, rows) < wanted) rows /= 2;
  return {1, 1, 32, 4, -1, steps, 1, rows};
}

GrayScottKernels::GrayScottKernels(const std::string& name, const GrayScottPlan& plan, bool fast,
                                   const Cut& cut)
    : size_(plan.parameters().size), columns_(plan.columns()), cut_(cut), mapped_(plan.mapped()) {
  if (mapped_) cut_.stepsPerPass = 1;  // The strip kernel does not support mapped rates.
  if (cut_.bandRows < 0) cut_.bandRows = bandRowsFor(columns_, size_.y);
  cut_.bandRows = std::min(cut_.bandRows, size_.y / 2);
  checkLimits(name, size_, columns_);
  const std::vector<glm::vec4> first = plan.firstCells();
  cells_[0] = gl::Vec4Array(name + " cells", first);
  cells_[1] = gl::Vec4Array(name + " next cells", first);
  for (int i = 0; i < 2; ++i)
    words_[i] = gl::Texture::view(name + " words", GL_RGBA32UI, cells_[i].buffer());
  if (mapped_) weights_ = gl::Vec4Array(name + " rate map", plan.weights());
  constexpr unsigned fine[] = {0xffffffffU, 0, 0, 0};
  status_ = gl::Buffer::of<unsigned>(name + " status", fine);
  rates_ = gl::Buffer(name + " rates", sizeof(shader::GrayScottRates));

  const gl::Defines defines = gl::kernelDefines(fast);
  const bool odd = size_.x % 2 == 1;
  if (!plan.strokes().empty()) {
    stamps_ = gl::WordsArray(name + " brush images", plan.strokes().imageElements());
    paint_ = gl::Kernel<GrayScottPaint>(defines);
  }
  step_ = gl::Kernel<GrayScottStep>(defines, {.mapped = mapped_,
                                              .oddWidth = odd,
                                              .across = cut_.across,
                                              .rows = cut_.rows,
                                              .groupX = cut_.groupX,
                                              .groupY = cut_.groupY});
  look_ = gl::Kernel<GrayScottLook>(defines, {.mapped = mapped_, .oddWidth = odd});
  if (cut_.stepsPerPass > 1)
    strips_ = gl::Kernel<GrayScottStrips>(defines, {.oddWidth = odd,
                                                    .subgroups = gl::limits().shuffle32,
                                                    .steps = cut_.stepsPerPass,
                                                    .elements = cut_.stripElements,
                                                    .rows = cut_.stripRows});
}

GrayScottGrid GrayScottKernels::grid(int from, int first, int rows) const {
  return {.size = size_,
          .columns = columns_,
          .rowRange = glm::ivec2(first, rows),
          .rates = rates_,
          .cells = cells_[from],
          .weights = weights_};
}

void GrayScottKernels::setRates(const shader::GrayScottRates& rates) {
  rates_.write(0, std::as_bytes(std::span(&rates, 1)));
}

void GrayScottKernels::advance(int steps) {
  if (cut_.stepsPerPass > 1)
    for (; steps >= cut_.stepsPerPass; steps -= cut_.stepsPerPass) {
      stripPass();
      swapCells();
      look(cut_.stepsPerPass);
    }
  while (steps > 0) {
    const int passes = std::clamp(steps, 1, std::max(cut_.bandRows / 4, 1));
    if (passes > 1)
      bands(passes);
    else
      pass(0, 0, size_.y);
    if (passes % 2 == 1) swapCells();
    steps -= passes;
    look(passes);
  }
}

void GrayScottKernels::look(int steps) {
  constexpr long rarest = 128;
  taken_ += steps;
  if (taken_ < nextLook_) return;
  nextLook_ = taken_ + std::min(taken_, rarest);
  look_.dispatch({columns_, size_.y}, {.grid = grid(0, 0, 0), .status = status_});
}

void GrayScottKernels::swapCells() {
  std::swap(cells_[0], cells_[1]);
  std::swap(words_[0], words_[1]);
}

// Runs several steps band by band. On a grid larger than the GPU's caches and TLB, each pass over the whole
// grid would cause cache misses. Therefore, all steps are first computed for one band of rows that fits:
// step s computes the rows of the band whose distance from the band's edges is at least s, which need only
// existing values. Afterwards, the missing rows around each edge are computed, s rows on both sides. Each
// row keeps the values of its last two steps, which are exactly those that its neighbours still need, so
// two arrays are enough.
void GrayScottKernels::bands(int steps) {
  const int number = (size_.y - 1) / cut_.bandRows + 1;
  const auto edge = [&](int band) { return static_cast<int>(std::int64_t{size_.y} * band / number); };
  for (int band = 0; band < number; ++band)
    for (int s = 1; s <= steps; ++s) pass((s - 1) % 2, edge(band) + s, edge(band + 1) - edge(band) - 2 * s);
  for (int band = 0; band < number; ++band)
    for (int s = 1; s <= steps; ++s) pass((s - 1) % 2, (edge(band) - s + size_.y) % size_.y, 2 * s);
}

void GrayScottKernels::pass(int from, int first, int rows) {
  step_.dispatch({(columns_ - 1) / cut_.across + 1, (rows - 1) / cut_.rows + 1},
                 {.grid = grid(from, first, rows), .next = cells_[1 - from]});
}

void GrayScottKernels::stripPass() {
  const int down = (size_.y - 1) / cut_.stripRows + 1;
  const int across = stripCount({size_.x, 1}, cut_.stepsPerPass, cut_.stripElements, 1);
  strips_.dispatch({across * stripGroup(), down}, {.grid = grid(0, 0, size_.y), .next = cells_[1]});
}

void GrayScottKernels::paint(const shader::Stroke& stroke) {
  const glm::ivec4 box = Strokes::box(stroke, size_);
  if (box.z == 0) return;
  paint_.dispatch({columns_, box.w}, {.size = size_,
                                      .columns = columns_,
                                      .stroke = uniformsOf(stroke, box),
                                      .cells = cells_[0],
                                      .stamps = stamps_});
  taken_ = 0;
  nextLook_ = 1;
}

}  // namespace simreel::sim
