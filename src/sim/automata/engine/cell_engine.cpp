#include "sim/automata/engine/cell_engine.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

struct PadKernel {
  static constexpr auto file = "automata/pad.comp";
  struct Variant {
    gl::Flag<"BITS"> bits;
  };
  gl::Uniform<"grid.width", int> width;
  gl::Uniform<"grid.height", int> height;
  gl::Uniform<"grid.across", int> across;
  gl::Uniform<"grid.down", int> down;
  gl::Uniform<"grid.shiftX", int> shiftX;
  gl::Uniform<"grid.shiftY", int> shiftY;
  gl::Uniform<"rowItems", int> rowItems;
  gl::Uniform<"paddedItems", int> paddedItems;
  gl::Uniform<"marginX", int> marginX;
  gl::Uniform<"range", int> range;
  gl::In<"cells"> cells;
  gl::Out<"padded"> padded;
};

struct RowSumsKernel {
  static constexpr auto file = "automata/row_sums.comp";
  gl::Uniform<"rows", int> rows;
  gl::Uniform<"paddedItems", int> paddedItems;
  gl::In<"padded"> padded;
  gl::Out<"sums"> sums;
};

struct ColumnsKernel {
  static constexpr auto file = "automata/columns.comp";
  struct Variant {
    gl::Range<"STATES", 2, 256> states;
    gl::Range<"RANGE", 1, 500> range;
    gl::Range<"ROWS", 64, 64> rows;
  };
  gl::Uniform<"height", int> height;
  gl::Uniform<"paddedItems", int> paddedItems;
  gl::In<"padded"> padded;
  gl::Out<"sums"> sums;
};

struct WindowSumsKernel {
  static constexpr auto file = "automata/window_sums.comp";
  struct Variant {
    gl::Range<"RANGE", 1, 500> range;
    gl::Range<"ROWS", 64, 64> rows;
  };
  gl::Uniform<"height", int> height;
  gl::Uniform<"paddedItems", int> paddedItems;
  gl::In<"rowSums"> rowSums;
  gl::Out<"sums"> sums;
};

/// Part of a kernel interface: members common to all rule kernels.
struct CellRulePart {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"rowItems", int> rowItems;
  gl::Uniform<"rowWords", int> rowWords;
  gl::Uniform<"marginX", int> marginX;
  gl::Out<"newCells"> next;
};
struct CellDefines {
  gl::Range<"STATES", 2, 256> states;
  gl::Flag<"BITS"> bits;
};
/// Preprocessor definitions for glsl/automata/wide.glsl.
struct WideDefines {
  CellDefines cells;
  gl::Switch<"MIDDLE"> middle;
  gl::Code<"SURVIVES", "(count>=2&&count<=3)"> survives;
  gl::Code<"BORN", "(count>=3&&count<=3)"> born;
};
/// Column offsets of the first and the last cell of each row in the neighbourhood.
struct SpanDefines {
  gl::Code<"LEFTS", "-1,-1,-1"> lefts;
  gl::Code<"RIGHTS", "1,1,1"> rights;
};

namespace {

struct NineKernel {
  static constexpr auto file = "automata/step.comp";
  struct Variant {
    CellDefines cells;
    gl::Flag<"MAP"> map;
    gl::Range<"NEIGHBOURS", 4, 8>
        neighbours;  // Number of neighbours of a rule given as a decision diagram.
  };
  CellRulePart rule;
  gl::Uniforms<"map", glm::ivec4, 4> map;
  gl::Uniform<"root", int> root;
  gl::In<"paddedWords"> paddedWords;
  gl::In<"tree"> tree;
};

struct CyclicKernel {
  static constexpr auto file = "automata/cyclic.comp";
  struct Variant {
    CellDefines cells;
    gl::Range<"RANGE", 1, 500> range;
    gl::Range<"THRESHOLD", 1, 1000000> threshold;
    gl::Flag<"DIAMOND"> diamond;
  };
  CellRulePart rule;
  gl::In<"paddedBytes"> paddedBytes;
};

struct RowsKernel {
  static constexpr auto file = "automata/rows.comp";
  struct Variant {
    WideDefines wide;
    gl::Range<"RANGE", 1, 500> range;
    gl::Range<"ITEMS", 1, 64> items;
  };
  CellRulePart rule;
  gl::In<"paddedWords"> paddedWords;
  gl::In<"columnWords"> columnWords;
};

struct SpansKernel {
  static constexpr auto file = "automata/spans.comp";
  struct Variant {
    WideDefines wide;
    SpanDefines spans;
    gl::Range<"RANGE", 1, 500> range;
    gl::Range<"ITEMS", 1, 64> items;
  };
  CellRulePart rule;
  gl::In<"paddedBytes"> paddedBytes;
};

struct FarKernel {
  static constexpr auto file = "automata/far.comp";
  struct Variant {
    WideDefines wide;
    SpanDefines spans;
    gl::Range<"ROWS", 1, 1001> rows;
  };
  CellRulePart rule;
  gl::Uniform<"range", int> range;
  gl::In<"paddedWords"> paddedWords;
  gl::In<"sums"> sums;
};

struct PlacesKernel {
  static constexpr auto file = "automata/places.comp";
  struct Variant {
    WideDefines wide;
    gl::Flag<"FLIPPED"> flipped;
    gl::Flag<"STATE_WEIGHTS"> stateWeights;
  };
  CellRulePart rule;
  gl::Uniform<"range", int> range;
  gl::Uniform<"places", int> places;
  gl::In<"paddedWords"> paddedWords;
  gl::In<"list"> list;
};

constexpr int columnRows = 64;

/// Number of elements after the last cell of a row that a kernel may read.
constexpr int spareItems = 64;

/// Maximum range for which the sum of 2 range + 1 cells fits in a byte.
constexpr int maxByteRange = 127;

/// Maximum range of spans.comp. For larger ranges, an invocation may exceed 65,535 loop iterations, after
/// which a software driver silently ends the loop.
constexpr int maxSpansRange = 90;

/// Returns the GLSL condition of wide.glsl which is true if `count` is in one of the ranges.
std::string anyOf(const std::vector<CountRange>& counts) {
  std::string text;
  for (const CountRange& range : counts)
    text += fmt::format("{}(count>={}&&count<={})", text.empty() ? "" : "||", range.low, range.high);
  return text.empty() ? "false" : "(" + text + ")";
}

/// Returns the first and last columns of the neighbourhood in the rows `top` to `bottom`, relative to the
/// cell, as the definitions LEFTS and RIGHTS of spans.comp and far.comp.
SpanDefines spansOf(const WideRule& rule, int top, int bottom) {
  std::string lefts, rights;
  for (int dy = top; dy <= bottom; ++dy) {
    const WideRule::Span span = rule.span(dy);
    lefts += (lefts.empty() ? "" : ",") + std::to_string(span.first);
    rights += (rights.empty() ? "" : ",") + std::to_string(span.last);
  }
  return {lefts, rights};
}

/// Returns true if the rule uses prefix sums of rows, stored as whole words.
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
      states_(rule.states),
      join_(shape.join(size)) {
  // Prefix sums stored as words (makeFar) take four times the memory of bytes.
  const long items = long{paddedItems_} * (isFar(rule) ? 4 : 1) * (size.y + 2L * range_) + spareItems;
  // A texel of the byte view is a single byte.
  const long max = std::min<long>(gl::limits().storageBlockBytes / 16, gl::limits().texelBufferTexels / 16);
  if (items > max)
    fail(ExitCode::device,
         "{} of {} x {} cells needs {} bytes in one buffer for this rule, this device allows {} "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, GL_MAX_TEXTURE_BUFFER_SIZE); make \"size\" smaller",
         object, size.x, size.y, items * 16, max * 16);
  padded_ = gl::WordsArray("padded cells", paddedItems_ * (size.y + 2 * range_) + spareItems);
  paddedWords_ = gl::Texture::view("padded words", GL_R32UI, padded_.buffer(), 4);
  paddedBytes_ = gl::Texture::view("padded bytes", GL_R8UI, padded_.buffer(), 1);
  pad_ = gl::Kernel<PadKernel>(gl::kernelDefines(false), {bits_});
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

template <class Kernel, class Given>
void CellEngine::makeRule(const typename Kernel::Variant& variant, const Given& given) {
  auto kernel = std::make_shared<gl::Kernel<Kernel>>(gl::kernelDefines(false), variant);
  rule_ = [kernel, given](const CellRulePart& rule, glm::ivec2 items) {
    kernel->dispatch(items, given(rule));
  };
}

void CellEngine::makeList(const char* name, const std::vector<std::uint32_t>& list) {
  tree_ = gl::Buffer::of<std::uint32_t>(name, list);
  treeItems_ = gl::Texture::view(name, GL_R32UI, tree_, 4);
}

void CellEngine::makeNine(const CellRule& rule) {
  const CellDefines cells = {states_, bits_};
  if (rule.family == CellRule::Family::tree) {
    SIMREEL_CHECK(rule.tree);
    makeList("rule tree", rule.tree->items);
    makeRule<NineKernel>(
        {.cells = cells, .map = false, .neighbours = rule.tree->neighbours},
        [this, root = static_cast<int>(rule.tree->root)](const CellRulePart& part) {
          return NineKernel{
              .rule = part, .map = {}, .root = root, .paddedWords = paddedWords_, .tree = treeItems_};
        });
    return;
  }
  std::vector<glm::ivec4> map(4, glm::ivec4(0));
  std::uint32_t words[16] = {};
  for (unsigned i = 0; i < 512; ++i)
    if (rule.outcome(i)) words[i / 32] |= 1U << (i % 32);
  std::memcpy(map.data(), words, sizeof words);
  makeRule<NineKernel>(
      {.cells = cells, .map = true, .neighbours = {}}, [this, map](const CellRulePart& part) {
        return NineKernel{.rule = part, .map = map, .root = {}, .paddedWords = paddedWords_, .tree = {}};
      });
}

void CellEngine::makeCyclic(const CellRule& rule) {
  makeRule<CyclicKernel>({.cells = {states_, bits_},
                          .range = rule.cyclic.range,
                          .threshold = rule.cyclic.threshold,
                          .diamond = rule.cyclic.shape == NeighbourShape::vonNeumann},
                         [this](const CellRulePart& part) {
                           return CyclicKernel{part, paddedBytes_};
                         });
}

void CellEngine::makeWide(const CellRule& rule) {
  const WideRule& wide = rule.wide;
  const WideDefines all = {.cells = {states_, bits_},
                           .middle = wide.middle,
                           .survives = anyOf(wide.survive),
                           .born = anyOf(wide.born)};
  if (wide.shape == NeighbourShape::places)
    makePlaces(wide, all);
  else if (isFar(rule))
    makeFar(wide, all);
  else
    makeRunning(wide, all);
}

void CellEngine::makeRunning(const WideRule& rule, const WideDefines& wide) {
  // Number of elements per invocation. It is large enough that the initial sum of a segment costs little
  // compared to the running sums.
  items_ = bits_ ? std::max(1, range_ / 128) : std::max(4, range_ / 16);
  if (rule.shape == NeighbourShape::moore) {
    makeRule<RowsKernel>({.wide = wide, .range = range_, .items = items_},
                         [this](const CellRulePart& part) {
                           return RowsKernel{part, paddedWords_, sumWords_};
                         });
    columns_ = gl::Kernel<ColumnsKernel>(gl::kernelDefines(false),
                                         {.states = states_, .range = range_, .rows = columnRows});
    sums_ = gl::WordsArray("sums of columns", paddedItems_ * size_.y + spareItems);
    sumWords_ = gl::Texture::view("sums of columns", GL_R32UI, sums_.buffer(), 4);
    return;
  }
  makeRule<SpansKernel>(
      {.wide = wide, .spans = spansOf(rule, -range_, range_), .range = range_, .items = items_},
      [this](const CellRulePart& part) {
        return SpansKernel{part, paddedBytes_};
      });
  turned_ = true;
}

void CellEngine::makeFar(const WideRule& rule, const WideDefines& wide) {
  lanes_ = bits_ ? 8 : 1;
  const bool square = rule.shape == NeighbourShape::moore;
  const int rows = square ? 0 : range_;  // Number of rows above and below the cell. For a square, sums_
                                         // already includes all rows.
  makeRule<FarKernel>({.wide = wide, .spans = spansOf(rule, -rows, rows), .rows = 2 * rows + 1},
                      [this](const CellRulePart& part) {
                        return FarKernel{part, range_, paddedWords_, sumWords_};
                      });
  rowSum_ = gl::Kernel<RowSumsKernel>(gl::kernelDefines(false));
  const auto array = [&](const char* name, int height) {
    return gl::WordsArray(name, paddedItems_ * 4 * height + spareItems);
  };
  rowSums_ = array("sums of rows", size_.y + 2 * range_);
  if (square) {
    windowSum_ =
        gl::Kernel<WindowSumsKernel>(gl::kernelDefines(false), {.range = range_, .rows = columnRows});
    sums_ = array("sums of squares", size_.y);
  }
  sumWords_ = gl::Texture::view("sums", GL_R32UI, (square ? sums_ : rowSums_).buffer(), 4);
}

void CellEngine::makePlaces(const WideRule& rule, const WideDefines& wide) {
  lanes_ = bits_ ? 8 : 1;
  std::vector<std::uint32_t> list;
  for (const NeighbourPlace& place : rule.places) {
    list.push_back(static_cast<std::uint32_t>(place.dx + 512 + (place.dy + 512) * 1024));
    list.push_back(static_cast<std::uint32_t>(place.weight));
  }
  for (const int weight : rule.stateWeights) list.push_back(static_cast<std::uint32_t>(weight));
  if (list.empty()) list.push_back(0);
  makeList("places", list);
  makeRule<PlacesKernel>({.wide = wide, .flipped = rule.flips, .stateWeights = !rule.stateWeights.empty()},
                         [this, places = static_cast<int>(rule.places.size())](const CellRulePart& part) {
                           return PlacesKernel{part, range_, places, paddedWords_, treeItems_};
                         });
}

void CellEngine::run(const gl::WordsArray& from, const gl::WordsArray& to) {
  pad_.dispatch({paddedItems_, size_.y + 2 * range_}, {.width = join_.width,
                                                       .height = join_.height,
                                                       .across = join_.across,
                                                       .down = join_.down,
                                                       .shiftX = join_.shiftX,
                                                       .shiftY = join_.shiftY,
                                                       .rowItems = rowItems_,
                                                       .paddedItems = paddedItems_,
                                                       .marginX = marginX_,
                                                       .range = range_,
                                                       .cells = from,
                                                       .padded = padded_});
  const int segments = (size_.y + columnRows - 1) / columnRows, rows = size_.y + 2 * range_;
  if (rowSum_) rowSum_.dispatch(rows, {rows, paddedItems_, padded_, rowSums_});
  if (columns_) columns_.dispatch({paddedItems_, segments}, {size_.y, paddedItems_, padded_, sums_});
  if (windowSum_)
    windowSum_.dispatch({paddedItems_ * 4, segments}, {size_.y, paddedItems_, rowSums_, sums_});
  const int across = (rowItems_ + items_ - 1) / items_ * lanes_;
  rule_(
      {.size = size_, .rowItems = rowItems_, .rowWords = paddedItems_ * 4, .marginX = marginX_, .next = to},
      turned_ ? glm::ivec2(size_.y, across) : glm::ivec2(across, size_.y));
}

}  // namespace simreel::sim
