#include "sim/automata/cell_engine.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace simreel::shader::automata {
#include "glsl/automata/bindings.glsl"
}

namespace simreel::sim {

namespace {

namespace bind = shader::automata;

constexpr int columnRows = 64;

/// What a kernel may read beyond a row's last cell, elements.
constexpr int spareItems = 64;

/// Up to it 2 range + 1 cells fit a byte.
constexpr int maxByteRange = 127;

void define(gl::Defines& defines, const char* name, int value) {
  defines.emplace_back(name, std::to_string(value));
}

}  // namespace

CellEngine::CellEngine(const CellRule& rule, const GridShape& shape, glm::ivec2 size, bool bits,
                       const std::string& object)
    : size_(size),
      bits_(bits),
      range_(rule.range()),
      marginX_((rule.range() + 1 + 15) / 16 * 16),
      rowItems_(bits ? (size.x + 127) / 128 : (size.x + 15) / 16),
      paddedItems_((size.x + 15) / 16 + 2 * marginX_ / 16),
      states_(rule.states) {
  const long items = long{paddedItems_} * (size.y + 2L * range_) + spareItems;
  // Single bytes are texels, too.
  const long max = std::min<long>(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels / 16);
  if (items > max)
    fail(ExitCode::device,
         "{} of {} x {} cells needs {} bytes in one buffer for this rule, this device allows {} "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, GL_MAX_TEXTURE_BUFFER_SIZE); make \"size\" smaller",
         object, size.x, size.y, items * 16, max * 16);
  padded_ = gl::WordsArray("padded cells", static_cast<int>(items));
  paddedWords_ = gl::Texture::view("padded words", GL_R32UI, padded_.buffer(), 4);
  paddedBytes_ = gl::Texture::view("padded bytes", GL_R8UI, padded_.buffer(), 1);
  gl::Defines pad = gl::kernelDefines(false);
  if (bits_) define(pad, "BITS", 1);
  pad_ = gl::Program::compute("automata/pad.comp", pad);
  const shader::GridJoin join = shape.join(size);
  pad_.set("grid.width", join.width);
  pad_.set("grid.height", join.height);
  pad_.set("grid.across", join.across);
  pad_.set("grid.down", join.down);
  pad_.set("grid.shiftX", join.shiftX);
  pad_.set("grid.shiftY", join.shiftY);
  pad_.set("rowItems", rowItems_);
  pad_.set("paddedItems", paddedItems_);
  pad_.set("marginX", marginX_);
  pad_.set("range", range_);
  switch (rule.family) {
    case CellRule::Family::wide:
      makeWide(rule);
      break;
    case CellRule::Family::cyclic:
      makeCyclic(rule);
      break;
    default:
      makeNine(rule);
  }
}

gl::Defines CellEngine::defines() const {
  gl::Defines all = gl::kernelDefines(false);
  define(all, "STATES", states_);
  if (bits_) define(all, "BITS", 1);
  return all;
}

void CellEngine::setCommon(const gl::Program& program) const {
  program.set("size", size_);
  program.set("rowItems", rowItems_);
  program.set("rowWords", paddedItems_ * 4);
  program.set("marginX", marginX_);
}

void CellEngine::makeNine(const CellRule& rule) {
  gl::Defines all = defines();
  if (rule.family == CellRule::Family::tree) {
    SIMREEL_CHECK(rule.tree);
    define(all, "NEIGHBOURS", rule.tree->neighbours);
    rule_ = gl::Program::compute("automata/step.comp", all);
    rule_.set("root", static_cast<int>(rule.tree->root));
    tree_ = gl::Buffer::of<std::uint32_t>("rule tree", rule.tree->items);
    treeItems_ = gl::Texture::view("rule tree", GL_R32UI, tree_, 4);
  } else {
    define(all, "MAP", 1);
    rule_ = gl::Program::compute("automata/step.comp", all);
    std::uint32_t words[16] = {};
    for (unsigned i = 0; i < 512; ++i)
      if (rule.outcome(i)) words[i / 32] |= 1U << (i % 32);
    static constexpr const char* names[] = {"map[0]", "map[1]", "map[2]", "map[3]"};
    for (int i = 0; i < 4; ++i) {
      glm::ivec4 four;
      std::memcpy(&four, words + 4 * i, sizeof four);
      rule_.set(names[i], four);
    }
  }
  setCommon(rule_);
}

void CellEngine::makeCyclic(const CellRule& rule) {
  gl::Defines all = defines();
  define(all, "RANGE", rule.cyclic.range);
  define(all, "THRESHOLD", rule.cyclic.threshold);
  if (rule.cyclic.shape == NeighbourShape::vonNeumann) define(all, "DIAMOND", 1);
  rule_ = gl::Program::compute("automata/cyclic.comp", all);
  setCommon(rule_);
}

void CellEngine::makeWide(const CellRule& rule) {
  const WideRule& wide = rule.wide;
  // A column's sum is a byte there.
  const bool square = wide.shape == NeighbourShape::moore && range_ <= maxByteRange;
  // Long enough that the first sum of a segment costs little beside those that run.
  items_ = bits_ ? std::max(1, range_ / 128) : std::max(4, range_ / 16);
  gl::Defines all = defines();
  define(all, "RANGE", range_);
  define(all, "MIDDLE", wide.middle ? 1 : 0);
  define(all, "SURVIVE_MIN", wide.surviveMin);
  define(all, "SURVIVE_MAX", wide.surviveMax);
  define(all, "BORN_MIN", wide.bornMin);
  define(all, "BORN_MAX", wide.bornMax);
  define(all, "ITEMS", items_);
  if (!square) {
    std::string reaches;
    for (int dy = -range_; dy <= range_; ++dy)
      reaches += (dy == -range_ ? "" : ",") + std::to_string(wide.reach(dy));
    all.emplace_back("REACHES", reaches);
    rule_ = gl::Program::compute("automata/spans.comp", all);
    setCommon(rule_);
    return;
  }
  rule_ = gl::Program::compute("automata/rows.comp", all);
  setCommon(rule_);
  gl::Defines down = defines();
  define(down, "RANGE", range_);
  define(down, "ROWS", columnRows);
  columns_ = gl::Program::compute("automata/columns.comp", down);
  columns_.set("height", size_.y);
  columns_.set("paddedItems", paddedItems_);
  sums_ = gl::WordsArray("sums of columns", paddedItems_ * size_.y + spareItems);
  sumWords_ = gl::Texture::view("sums of columns", GL_R32UI, sums_.buffer(), 4);
}

void CellEngine::run(const gl::WordsArray& from, const gl::WordsArray& to) {
  from.bindInput(bind::cellsBinding);
  padded_.bindState(bind::paddedBinding);
  pad_.dispatch(paddedItems_, size_.y + 2 * range_);
  gl::barrier();
  if (sumWords_) {
    padded_.bindInput(bind::paddedBinding);
    sums_.bindState(bind::sumsBinding);
    columns_.dispatch(paddedItems_, (size_.y + columnRows - 1) / columnRows);
    gl::barrier();
    sumWords_.bind(bind::sumsBinding);
  }
  paddedWords_.bind(bind::wordsBinding);
  paddedBytes_.bind(bind::bytesBinding);
  if (treeItems_) treeItems_.bind(bind::treeBinding);
  to.bindState(bind::nextCellsBinding);
  rule_.dispatch((rowItems_ + items_ - 1) / items_, size_.y);
}

}  // namespace simreel::sim
