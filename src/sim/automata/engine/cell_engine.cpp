#include "sim/automata/engine/cell_engine.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include <fmt/format.h>

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

/// Beyond it an invocation of spans.comp may take more than 65,535 turns of its loops: a software driver
/// ends them there, and says nothing.
constexpr int maxSpansRange = 90;

/// What wide.glsl asks of `count`.
std::string anyOf(const std::vector<CountRange>& counts) {
  std::string text;
  for (const CountRange& range : counts)
    text += fmt::format("{}(count>={}&&count<={})", text.empty() ? "" : "||", range.low, range.high);
  return text.empty() ? "false" : "(" + text + ")";
}

/// How spans.comp and far.comp take the rows around a cell, of which these are the first and the last.
void defineSpans(gl::Defines& defines, const WideRule& rule, int top, int bottom) {
  std::string lefts, rights;
  for (int dy = top; dy <= bottom; ++dy) {
    const WideRule::Span span = rule.span(dy);
    lefts += (lefts.empty() ? "" : ",") + std::to_string(span.first);
    rights += (rights.empty() ? "" : ",") + std::to_string(span.last);
  }
  defines.emplace_back("LEFTS", lefts);
  defines.emplace_back("RIGHTS", rights);
}

void define(gl::Defines& defines, const char* name, int value) {
  defines.emplace_back(name, std::to_string(value));
}

/// Whether sums of rows are whole words, from their beginnings on.
bool isFar(const CellRule& rule) {
  if (rule.family != CellRule::Family::wide || rule.wide.shape == NeighbourShape::places) return false;
  return rule.range() > (rule.wide.shape == NeighbourShape::moore ? maxByteRange : maxSpansRange);
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
  // Four times as much where sums are whole words (makeFar).
  const long items = long{paddedItems_} * (isFar(rule) ? 4 : 1) * (size.y + 2L * range_) + spareItems;
  // Single bytes are texels, too.
  const long max = std::min<long>(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels / 16);
  if (items > max)
    fail(ExitCode::device,
         "{} of {} x {} cells needs {} bytes in one buffer for this rule, this device allows {} "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, GL_MAX_TEXTURE_BUFFER_SIZE); make \"size\" smaller",
         object, size.x, size.y, items * 16, max * 16);
  padded_ = gl::WordsArray("padded cells", paddedItems_ * (size.y + 2 * range_) + spareItems);
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

void CellEngine::makeRule(const char* kernel, const gl::Defines& defines) {
  rule_ = gl::Program::compute(kernel, defines);
  rule_.set("size", size_);
  rule_.set("rowItems", rowItems_);
  rule_.set("rowWords", paddedItems_ * 4);
  rule_.set("marginX", marginX_);
}

void CellEngine::makeColumns(const char* kernel) {
  gl::Defines all = defines();
  define(all, "RANGE", range_);
  define(all, "ROWS", columnRows);
  columns_ = gl::Program::compute(kernel, all);
  columns_.set("height", size_.y);
  columns_.set("paddedItems", paddedItems_);
}

void CellEngine::makeList(const char* name, const std::vector<std::uint32_t>& list) {
  tree_ = gl::Buffer::of<std::uint32_t>(name, list);
  treeItems_ = gl::Texture::view(name, GL_R32UI, tree_, 4);
}

void CellEngine::makeNine(const CellRule& rule) {
  gl::Defines all = defines();
  if (rule.family == CellRule::Family::tree) {
    SIMREEL_CHECK(rule.tree);
    define(all, "NEIGHBOURS", rule.tree->neighbours);
    makeRule("automata/step.comp", all);
    rule_.set("root", static_cast<int>(rule.tree->root));
    makeList("rule tree", rule.tree->items);
    return;
  }
  define(all, "MAP", 1);
  makeRule("automata/step.comp", all);
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

void CellEngine::makeCyclic(const CellRule& rule) {
  gl::Defines all = defines();
  define(all, "RANGE", rule.cyclic.range);
  define(all, "THRESHOLD", rule.cyclic.threshold);
  if (rule.cyclic.shape == NeighbourShape::vonNeumann) define(all, "DIAMOND", 1);
  makeRule("automata/cyclic.comp", all);
}

void CellEngine::makeWide(const CellRule& rule) {
  const WideRule& wide = rule.wide;
  gl::Defines all = defines();
  define(all, "MIDDLE", wide.middle ? 1 : 0);
  all.emplace_back("SURVIVES", anyOf(wide.survive));
  all.emplace_back("BORN", anyOf(wide.born));
  if (wide.shape == NeighbourShape::places)
    makePlaces(wide, std::move(all));
  else if (isFar(rule))
    makeFar(wide, std::move(all));
  else
    makeRunning(wide, std::move(all));
}

void CellEngine::makeRunning(const WideRule& rule, gl::Defines all) {
  // Long enough that the first sum of a segment costs little beside those that run.
  items_ = bits_ ? std::max(1, range_ / 128) : std::max(4, range_ / 16);
  define(all, "RANGE", range_);
  define(all, "ITEMS", items_);
  if (rule.shape == NeighbourShape::moore) {
    makeRule("automata/rows.comp", all);
    makeColumns("automata/columns.comp");
    sums_ = gl::WordsArray("sums of columns", paddedItems_ * size_.y + spareItems);
    sumWords_ = gl::Texture::view("sums of columns", GL_R32UI, sums_.buffer(), 4);
    return;
  }
  defineSpans(all, rule, -range_, range_);
  makeRule("automata/spans.comp", all);
  turned_ = true;
}

void CellEngine::makeFar(const WideRule& rule, gl::Defines all) {
  lanes_ = bits_ ? 8 : 1;
  const bool square = rule.shape == NeighbourShape::moore;
  const int rows = square ? 0 : range_;  // above and below; a square's are in its sums
  defineSpans(all, rule, -rows, rows);
  define(all, "ROWS", 2 * rows + 1);
  makeRule("automata/far.comp", all);
  rule_.set("range", range_);
  rowSum_ = gl::Program::compute("automata/row_sums.comp", defines());
  rowSum_.set("rows", size_.y + 2 * range_);
  rowSum_.set("paddedItems", paddedItems_);
  const auto array = [&](const char* name, int height) {
    return gl::WordsArray(name, paddedItems_ * 4 * height + spareItems);
  };
  rowSums_ = array("sums of rows", size_.y + 2 * range_);
  if (square) {
    makeColumns("automata/window_sums.comp");
    sums_ = array("sums of squares", size_.y);
  }
  sumWords_ = gl::Texture::view("sums", GL_R32UI, (square ? sums_ : rowSums_).buffer(), 4);
}

void CellEngine::makePlaces(const WideRule& rule, gl::Defines all) {
  lanes_ = bits_ ? 8 : 1;
  if (rule.flips) define(all, "FLIPPED", 1);
  if (!rule.stateWeights.empty()) define(all, "STATE_WEIGHTS", 1);
  makeRule("automata/places.comp", all);
  rule_.set("range", range_);
  rule_.set("places", static_cast<int>(rule.places.size()));
  std::vector<std::uint32_t> list;
  for (const NeighbourPlace& place : rule.places) {
    list.push_back(static_cast<std::uint32_t>(place.dx + 512 + (place.dy + 512) * 1024));
    list.push_back(static_cast<std::uint32_t>(place.weight));
  }
  for (const int weight : rule.stateWeights) list.push_back(static_cast<std::uint32_t>(weight));
  if (list.empty()) list.push_back(0);
  makeList("places", list);
}

void CellEngine::run(const gl::WordsArray& from, const gl::WordsArray& to) {
  from.bindInput(bind::cellsBinding);
  padded_.bindState(bind::paddedBinding);
  pad_.dispatch(paddedItems_, size_.y + 2 * range_);
  gl::barrier();
  const bool sumsRows = static_cast<bool>(rowSum_);
  if (sumsRows) {
    padded_.bindInput(bind::paddedBinding);
    rowSums_.bindState(bind::sumsBinding);
    rowSum_.dispatch(size_.y + 2 * range_);
    gl::barrier();
    rowSums_.bindInput(bind::rowSumsBinding);
  }
  if (columns_) {
    padded_.bindInput(bind::paddedBinding);
    sums_.bindState(bind::sumsBinding);
    columns_.dispatch(paddedItems_ * (sumsRows ? 4 : 1), (size_.y + columnRows - 1) / columnRows);
    gl::barrier();
  }
  if (sumWords_) sumWords_.bind(bind::sumsBinding);
  paddedWords_.bind(bind::wordsBinding);
  paddedBytes_.bind(bind::bytesBinding);
  if (treeItems_) treeItems_.bind(bind::treeBinding);
  to.bindState(bind::nextCellsBinding);
  const int across = (rowItems_ + items_ - 1) / items_ * lanes_;
  if (turned_)
    rule_.dispatch(size_.y, across);
  else
    rule_.dispatch(across, size_.y);
}

}  // namespace simreel::sim
