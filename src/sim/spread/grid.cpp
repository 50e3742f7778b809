#include "sim/spread/grid.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace simreel::sim {

namespace {

constexpr int firstCapacity = 1024;

glm::uvec4 countClasses(const std::vector<std::uint8_t>& cells) {
  glm::uvec4 counts(0);
  for (const std::uint8_t cell : cells)
    ++counts[(cell / 64 + 3) % 4];  // The counter of uninhabited cells is the last of the four counters.
  return counts;
}

std::vector<glm::uvec4> paddedWords(const std::vector<std::uint32_t>& words) {
  std::vector<glm::uvec4> elements((words.size() + 3) / 4, glm::uvec4(0));
  for (std::size_t i = 0; i < words.size(); ++i) elements[i / 4][static_cast<int>(i % 4)] = words[i];
  return elements;
}

template <class Cell>
std::vector<glm::uvec4> inRows(const std::vector<Cell>& cells, glm::ivec2 size) {
  const auto width = static_cast<std::size_t>(size.x);
  const std::size_t rowBytes = (width + 15) / 16 * 16 * sizeof(Cell);
  std::vector<glm::uvec4> elements(rowBytes / 16 * static_cast<std::size_t>(size.y), glm::uvec4(0));
  static_assert(std::endian::native == std::endian::little);
  auto* bytes = reinterpret_cast<std::uint8_t*>(elements.data());
  for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y)
    std::memcpy(bytes + y * rowBytes, &cells[y * width], width * sizeof(Cell));
  return elements;
}

}  // namespace

std::vector<glm::uvec4> packedCells(const std::vector<std::uint8_t>& cells, glm::ivec2 size) {
  return inRows(cells, size);
}

std::vector<glm::uvec4> packedCells(const std::vector<std::uint16_t>& cells, glm::ivec2 size) {
  return inRows(cells, size);
}

void SpreadGrid::checkLimits(const std::string& name, glm::ivec2 size, int bytesPerCell) {
  const auto bytes = std::int64_t{(size.x + 15) / 16} * 16 * size.y * bytesPerCell;
  const auto& limits = gl::limits();
  if (bytes > limits.storageBlockBytes)
    fail(ExitCode::device,
         "\"{}\" of {}x{} cells needs {} bytes, this device allows {} in one buffer "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); make \"size\" smaller",
         name, size.x, size.y, bytes, limits.storageBlockBytes);
  if (bytes / 16 > limits.texelBufferTexels)
    fail(ExitCode::device,
         "\"{}\" of {}x{} cells needs {} texels, this device allows {} in one buffer "
         "(GL_MAX_TEXTURE_BUFFER_SIZE); make \"size\" smaller",
         name, size.x, size.y, bytes / 16, limits.texelBufferTexels);
}

SpreadGrid::SpreadGrid(const std::string& name, const SpreadParameters& parameters,
                       const std::vector<std::uint8_t>& cells, int stepsPerFrame, const Strokes& strokes)
    : name_(name), size_(parameters.size), torus_(parameters.border == SpreadParameters::Border::torus) {
  const auto elements = packedCells(cells, size_);
  cells_[0] = gl::WordsArray(name + " cells", elements);
  cells_[1] = gl::WordsArray(name + " next cells", elements);
  const glm::uvec4 start = countClasses(cells);
  max_ = std::max(1U, start.x + start.y + start.z);
  std::vector<glm::uvec4> rows(firstCapacity, glm::uvec4(0));
  rows[0] = start;
  capacity_ = firstCapacity;
  history_ = gl::WordsArray(name + " counts", rows);
  std::vector<glm::uvec4> frame(static_cast<std::size_t>(stepsPerFrame), glm::uvec4(0));
  frame[0] = start;
  frameCounts_ = gl::Buffer::of<glm::uvec4>(name + " counts of a frame", frame);
  stamps_ = gl::WordsArray(name + " stroke images", paddedWords(strokes.imageBits()));
  if (gl::memoryPath() == gl::MemoryPath::texel)
    for (gl::WordsArray& tiles : tiles_)
      tiles = gl::WordsArray(name + " tiles", rowElements() * groupRows());
}

void SpreadGrid::beginFrame(int steps) {
  frameStart_ = done_;
  frameSteps_ = steps;
  if (done_ + steps + 1 <= capacity_) return;
  while (done_ + steps + 1 > capacity_) capacity_ *= 2;
  gl::WordsArray longer(name_ + " counts", capacity_);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(history_.buffer().name(), longer.buffer().name(), 0, 0,
                           static_cast<GLsizeiptr>(done_ + 1) * 16);
  history_ = std::move(longer);
}

void SpreadGrid::startPainted() {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(history_.buffer().name(), frameCounts_.name(), 0, 0, 16);
  gl::barrier();
}

SpreadStepPart SpreadGrid::beginStep() {
  ++done_;
  if (gl::memoryPath() == gl::MemoryPath::texel && !fresh_) {
    // The kernel only adds changes, so the counts of the previous step are copied first.
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const GLuint history = history_.buffer().name();
    glCopyNamedBufferSubData(history, history, GLintptr{done_ - 1} * 16, GLintptr{done_} * 16, 16);
  }
  return {.size = size_,
          .torus = torus_,
          .countPlace = done_,
          .fresh = fresh_,
          .cells = cells_[0],
          .next = cells_[1],
          .counts = history_.buffer(),
          .tiles = tiles_[0],
          .nextTiles = tiles_[1].buffer()};
}

void SpreadGrid::endStep() {
  std::swap(cells_[0], cells_[1]);
  std::swap(tiles_[0], tiles_[1]);
  fresh_ = false;
}

int SpreadGrid::groupRows() const {
  const int rowsEach = gl::memoryPath() == gl::MemoryPath::texel ? 16 : 4;  // number of rows per
                                                                            // invocation, see
                                                                            // glsl/spread/step.glsl
  return (size_.y + rowsEach - 1) / rowsEach;
}

void SpreadGrid::endFrame() {
  gl::barrier();
  if (frameSteps_ == 0) return;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(history_.buffer().name(), frameCounts_.name(),
                           static_cast<GLintptr>(frameStart_ + 1) * 16, 0,
                           static_cast<GLsizeiptr>(frameSteps_) * 16);
}

void SpreadGrid::visitCheckpointData(CarryOver& carry) {
  const int room = capacity_;
  carry.number("steps", done_);
  carry.number("steps of the frame", frameSteps_);
  carry.number("room for counts", capacity_);
  if (capacity_ != room) history_ = gl::WordsArray(name_ + " counts", capacity_);
  carry.array("cells", cells_[0].buffer());
  carry.array("counts", history_.buffer());
  carry.array("counts of the frame", frameCounts_);
  fresh_ = true;
}

glm::uvec4 SpreadGrid::latestCounts() const {
  glm::uvec4 row(0);
  history_.buffer().read(static_cast<std::size_t>(done_) * 16, std::as_writable_bytes(std::span(&row, 1)));
  return row;
}

std::string SpreadGrid::elementName(long element) const {
  const long x = element % rowElements() * 16;
  const long y = element / rowElements();
  return fmt::format("cells ({}, {}) to ({}, {})", x, y, std::min<long>(x + 15, size_.x - 1), y);
}

void SpreadGrid::publishField(const std::string& name, const std::vector<glm::vec3>& colors,
                              const ClassNames& classes, const FieldDisplay& display,
                              Drawables& drawables) const {
  Field field;
  field.name = &name;
  field.words = &cells_[0].view();
  field.cells = Field::Cells::bytes;
  field.size = size_;
  field.rowWords = 4 * rowElements();
  field.categories = true;
  field.range = {0, 255};
  field.colors = &colors;
  field.classes = &classes;
  field.display = &display;
  drawables.fields.push_back(field);
}

void SpreadGrid::publishChart(const std::vector<std::string>& names, const std::vector<glm::vec3>& colors,
                              double steps, Drawables& drawables) const {
  Chart chart;
  chart.counts = &history_.view();
  chart.steps = done_ + 1;
  chart.width = std::max({chart.steps, static_cast<int>(steps), 2});
  chart.max = max_;
  chart.names = names;
  chart.colors = colors;
  drawables.charts.push_back(std::move(chart));
}

}  // namespace simreel::sim
