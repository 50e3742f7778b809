#include "sim/life/plan.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/automata/file/rule_file.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/common.hpp>

#define FUNCTION inline
namespace simreel::shader {
namespace {
#include "glsl/life/fill.glsl"
}
}  // namespace simreel::shader
#undef FUNCTION

namespace simreel::sim {

namespace {

/// Maps cells of a pattern to the grid: flips the pattern within its size, then rotates it clockwise.
class Placement {
 public:
  Placement(const LifePattern& pattern, const CellPattern& cells)
      : pattern_(pattern), cells_(cells), size_(cells.size) {}

  [[nodiscard]] glm::ivec2 turnedSize() const {
    return pattern_.rotate % 180 == 0 ? size_ : glm::ivec2(size_.y, size_.x);
  }
  /// Returns true if the pattern is neither flipped nor rotated, so that horizontal runs stay horizontal.
  [[nodiscard]] bool upright() const {
    return pattern_.rotate == 0 && pattern_.flip == LifePattern::Flip::none;
  }
  /// Returns the grid cell of the pattern's top left corner. It is the scene's value; otherwise the file's
  /// value, if the file was made for a grid of this size; otherwise the pattern is centred.
  [[nodiscard]] glm::ivec2 corner(glm::ivec2 grid) const {
    if (pattern_.at) return *pattern_.at;
    const bool turns = pattern_.rotate % 180 != 0;
    if (!cells_.corner || cells_.grid != grid || (turns && grid.x != grid.y))
      return grid / 2 - turnedSize() / 2;
    // Flips and rotates the whole grid for which the file was made.
    glm::ivec2 minimum = *cells_.corner, maximum = minimum + size_;
    if (pattern_.flip == LifePattern::Flip::horizontal)
      std::tie(minimum.x, maximum.x) = std::pair(grid.x - maximum.x, grid.x - minimum.x);
    if (pattern_.flip == LifePattern::Flip::vertical)
      std::tie(minimum.y, maximum.y) = std::pair(grid.y - maximum.y, grid.y - minimum.y);
    switch (pattern_.rotate) {
      case 90:
        return {grid.x - maximum.y, minimum.x};
      case 180:
        return grid - maximum;
      case 270:
        return {minimum.y, grid.y - maximum.x};
      default:
        return minimum;
    }
  }
  /// Returns the transformed cell relative to the corner.
  [[nodiscard]] glm::ivec2 operator()(glm::ivec2 cell) const {
    if (pattern_.flip == LifePattern::Flip::horizontal) cell.x = size_.x - 1 - cell.x;
    if (pattern_.flip == LifePattern::Flip::vertical) cell.y = size_.y - 1 - cell.y;
    switch (pattern_.rotate) {
      case 90:
        return {size_.y - 1 - cell.y, cell.x};
      case 180:
        return {size_.x - 1 - cell.x, size_.y - 1 - cell.y};
      case 270:
        return {cell.y, size_.x - 1 - cell.x};
      default:
        return cell;
    }
  }

 private:
  const LifePattern& pattern_;
  const CellPattern& cells_;
  glm::ivec2 size_;
};

const char* borderName(GridBorder border) {
  static constexpr const char* names[] = {"torus",         "dead",         "cylinder", "klein",
                                          "kleinSideways", "crossSurface", "sphere"};
  return names[static_cast<std::size_t>(border)];
}

int wrapped(int x, int size) {
  return (x % size + size) % size;
}

/// Sets `length` cells from column x on to alive, a word at a time; `row` is the index of the row's first
/// word.
void setRun(std::vector<std::uint32_t>& words, std::size_t row, int x, int length) {
  while (length > 0) {
    const int bit = x % 32;
    const int count = std::min(32 - bit, length);
    words[row + static_cast<std::size_t>(x) / 32] |= ~0U >> (32 - count) << bit;
    x += count;
    length -= count;
  }
}

}  // namespace

LifePlan::LifePlan(LifeParameters parameters, const std::string& object, int seed, double frameSeconds)
    : parameters_(std::move(parameters)), seed_(seed), frameSeconds_(frameSeconds) {
  for (const LifePattern& pattern : parameters_.patterns) {
    if (files_.contains(pattern.file)) continue;
    const CellPattern& read = files_.emplace(pattern.file, readPattern(pattern.file)).first->second;
    if (!read.remark.empty()) warn("{}", read.remark);
  }
  resolveNames();
  if (parameters_.fitted) fitGrid();
  takeRule(object);
  checkStates(object);
  checkPlaces(object);
  strokes_ = Strokes(parameters_.strokes, seed, {parameters_.size, torus(), "life \"" + object + "\""});
  checkLiving(object);
}

const CellPattern& LifePlan::cellsOf(const LifePattern& pattern) const {
  return files_.at(pattern.file);
}

// Chooses the size of the grid. A pattern made for a bounded grid determines it. Otherwise, gliders get
// some space and the aspect ratio is 16:9.
void LifePlan::fitGrid() {
  constexpr int minMargin = 12, maxMargin = 256;
  constexpr glm::ivec2 shape(16, 9);
  glm::ivec2 reach(0), min(0);
  int longest = 0;
  for (const LifePattern& pattern : parameters_.patterns) {
    const CellPattern& cells = cellsOf(pattern);
    if (cells.shape) {
      parameters_.size = cells.grid;
      if (!parameters_.borderGiven) {
        parameters_.border = cells.shape->border;
        parameters_.shift = cells.shape->shift;
      }
      return;
    }
    const glm::ivec2 turned = Placement(pattern, cells).turnedSize();
    longest = std::max({longest, turned.x, turned.y});
    if (pattern.at)
      reach = glm::max(reach, *pattern.at + turned);
    else
      min = glm::max(min, turned);
  }
  const int margin = std::clamp(longest / 2, minMargin, maxMargin);
  const glm::ivec2 needed = glm::max(reach + margin, min + 2 * margin);
  const int unit = std::max((needed.x - 1) / shape.x, (needed.y - 1) / shape.y) + 1;
  parameters_.size = glm::min(unit * shape, glm::ivec2(maxLifeSide));
}

// Loads the rule files that patterns name, from the patterns' folders.
void LifePlan::resolveNames() {
  for (auto& [file, cells] : files_) {
    if (cells.ruleName.empty() || !parameters_.rule.empty() || !parameters_.ruleFile.empty()) continue;
    const std::filesystem::path rule = file.parent_path() / (cells.ruleName + ".rule");
    if (std::error_code error; !std::filesystem::is_regular_file(rule, error))
      fail(ExitCode::usage,
           "{}: the rule {} is no notation and there is no file {} beside the pattern; give \"rule\" or "
           "\"ruleFile\"",
           cells.rulePlace, cells.ruleName, rule.filename().string());
    cells.rule = readRuleFile(rule);
  }
}

// Checks the scene against the rule; called when the rule is known.
void LifePlan::checkStates(const std::string& object) const {
  if (const std::string problem = shape().problem(parameters_.size); !problem.empty())
    fail(ExitCode::usage, "life \"{}\": {}", object, problem);
  const int range = rule_.range();
  if (!plain() && std::min(parameters_.size.x, parameters_.size.y) < range)
    fail(ExitCode::usage, "life \"{}\": a grid of {} x {} cells is smaller than the rule's range of {}",
         object, parameters_.size.x, parameters_.size.y, range);
  if (range > 1 && parameters_.border == GridBorder::sphere)
    fail(ExitCode::usage, "life \"{}\": only rules of range 1 run on a sphere, this one's is {}", object,
         range);
  if (rule_.states > 2 && parameters_.trail > 0 && parameters_.trailGiven)
    fail(ExitCode::usage, "life \"{}\": \"trail\" needs a rule of two states, but {} has {}", object,
         rule_.text(), rule_.states);
  for (const LifePattern& pattern : parameters_.patterns)
    if (const CellPattern& cells = cellsOf(pattern); cells.highest >= rule_.states)
      fail(ExitCode::usage, "{}: a cell of state {}, but the rule {} has the states 0 to {}",
           cells.highestPlace, cells.highest, rule_.text(), rule_.states - 1);
  for (const StrokeParameters& stroke : parameters_.strokes)
    if (stroke.value > rule_.states - 1)
      fail(ExitCode::usage, "life \"{}\": a stroke paints state {}, but the rule {} has the states 0 to {}",
           object, stroke.value, rule_.text(), rule_.states - 1);
}

void LifePlan::takeRule(const std::string& object) {
  if (!parameters_.ruleFile.empty()) {
    rule_ = readRuleFile(parameters_.ruleFile);
    return;
  }
  if (!parameters_.rule.empty()) {
    const RuleProblem problem = parseCellRule(parameters_.rule, rule_);
    SIMREEL_CHECK(problem.message.empty());  // The scene parser has validated the rule.
    return;
  }
  const glm::ivec2 size = parameters_.size;
  const LifePattern* named = nullptr;
  for (const LifePattern& pattern : parameters_.patterns) {
    const CellPattern& file = cellsOf(pattern);
    if (!file.rule) continue;
    if (named != nullptr && *file.rule != rule_)
      fail(ExitCode::usage,
           "life \"{}\": {} is for the rule {}, but {} for {}; say in the scene which \"rule\" is meant",
           object, named->file.string(), rule_.text(), pattern.file.string(), file.rule->text());
    rule_ = *file.rule;
    named = &pattern;
    if (file.shape && (*file.shape != shape() || file.grid != size))
      fail(ExitCode::usage,
           "life \"{}\": {} is for a grid of {} x {} with border \"{}\"{}, but the scene's is {} x {} with "
           "\"{}\"; "
           "change \"size\" and \"border\", or give a \"rule\" in the scene",
           object, pattern.file.string(), file.grid.x, file.grid.y, borderName(file.shape->border),
           file.shape->shift == glm::ivec2(0) ? "" : " shifted", size.x, size.y,
           borderName(parameters_.border));
  }
}

void LifePlan::checkPlaces(const std::string& object) const {
  const glm::ivec2 size = parameters_.size;
  for (const LifePattern& pattern : parameters_.patterns) {
    const Placement placement(pattern, cellsOf(pattern));
    const glm::ivec2 turned = placement.turnedSize();
    if (turned.x > size.x || turned.y > size.y)
      fail(ExitCode::usage,
           "life \"{}\": {} has {} x {} cells, more than the grid's {} x {}; make \"size\" larger", object,
           pattern.file.string(), turned.x, turned.y, size.x, size.y);
    const glm::ivec2 at = placement.corner(size);
    const glm::ivec2 end = at + turned;
    if (!torus() && (at.x < 0 || at.y < 0 || end.x > size.x || end.y > size.y))
      fail(ExitCode::usage,
           "life \"{}\": {} at [{}, {}] reaches to [{}, {}], outside the grid of {} x {}; move it (\"at\") "
           "or use \"border\": \"torus\"",
           object, pattern.file.string(), at.x, at.y, end.x - 1, end.y - 1, size.x, size.y);
  }
}

// Limits the total number of live cells. A file that is listed several times is read only once, but its
// cells are set each time.
void LifePlan::checkLiving(const std::string& object) const {
  constexpr std::uint64_t alwaysAllowed = 1 << 24;
  std::map<std::filesystem::path, std::uint64_t> living;
  for (const auto& [file, cells] : files_) {
    std::uint64_t& count = living[file];
    for (const CellPattern::Run& run : cells.runs) count += static_cast<std::uint64_t>(run.length);
  }
  std::uint64_t all = 0;
  for (const LifePattern& pattern : parameters_.patterns) all += living[pattern.file];
  const auto grid =
      static_cast<std::uint64_t>(parameters_.size.x) * static_cast<std::uint64_t>(parameters_.size.y);
  if (all > std::max(grid, alwaysAllowed))
    fail(ExitCode::usage,
         "life \"{}\": its {} patterns have {} living cells together, more than the grid has cells ({}); "
         "list fewer",
         object, parameters_.patterns.size(), all, grid);
}

int LifePlan::fillFraction() const {
  return static_cast<int>(std::lround(static_cast<double>(parameters_.fill) * 16777216.0));
}

void LifePlan::addPatterns(std::vector<std::uint32_t>& words) const {
  const auto rowWords = static_cast<std::size_t>(rowBlocks()) * 4;
  const glm::ivec2 size = parameters_.size;
  for (const LifePattern& pattern : parameters_.patterns) {
    const CellPattern& cells = cellsOf(pattern);
    const Placement placement(pattern, cells);
    const glm::ivec2 corner = placement.corner(size);
    const glm::ivec2 end = corner + cells.size;
    if (placement.upright() && corner.x >= 0 && corner.y >= 0 && end.x <= size.x && end.y <= size.y) {
      for (const CellPattern::Run& run : cells.runs)
        setRun(words, static_cast<std::size_t>(corner.y + run.y) * rowWords, corner.x + run.x, run.length);
      continue;
    }
    for (const CellPattern::Run& run : cells.runs)
      for (int i = 0; i < run.length; ++i) {
        const glm::ivec2 cell = corner + placement({run.x + i, run.y});
        const auto x = static_cast<std::size_t>(wrapped(cell.x, size.x));
        const auto y = static_cast<std::size_t>(wrapped(cell.y, size.y));
        words[y * rowWords + x / 32] |= 1U << (x % 32);
      }
  }
}

std::vector<std::uint32_t> LifePlan::firstCells() const {
  std::vector<std::uint32_t> words(static_cast<std::size_t>(blocks()) * 4);
  const int fraction = fillFraction();
  if (fraction > 0) {
    const auto rowWords = static_cast<std::size_t>(rowBlocks()) * 4;
    for (int y = 0; y < parameters_.size.y; ++y)
      for (int x = 0; x < parameters_.size.x; ++x)
        if (shader::startsAlive(x, y, seed_, fraction))
          words[static_cast<std::size_t>(y) * rowWords + static_cast<std::size_t>(x) / 32] |= 1U
                                                                                              << (x % 32);
  }
  addPatterns(words);
  return words;
}

std::vector<std::uint8_t> LifePlan::firstStates() const {
  const glm::ivec2 size = parameters_.size;
  const int items = (size.x + 15) / 16;
  const std::size_t rowBytes = static_cast<std::size_t>(items) * 16;
  std::vector<std::uint8_t> bytes(rowBytes * static_cast<std::size_t>(size.y));
  const int fraction = fillFraction();
  const bool any = rule_.family == CellRule::Family::cyclic || rule_.family == CellRule::Family::tree;
  // All states of a cyclic rule are equivalent, so by default every cell gets a random one.
  const bool all = rule_.family == CellRule::Family::cyclic && !parameters_.fillGiven && !hasPatterns();
  if (fraction > 0)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (!all && !shader::startsAlive(x, y, seed_, fraction)) continue;
        const auto states = static_cast<unsigned>(rule_.states);
        const unsigned hash = shader::hash3(glm::uvec3(x, y, seed_)).y >> 8U;
        bytes[static_cast<std::size_t>(y) * rowBytes + static_cast<std::size_t>(x)] =
            static_cast<std::uint8_t>(!any  ? 1
                                      : all ? hash % states
                                            : 1 + hash % (states - 1));
      }
  for (const LifePattern& pattern : parameters_.patterns) {
    const CellPattern& cells = cellsOf(pattern);
    const Placement placement(pattern, cells);
    const glm::ivec2 corner = placement.corner(size);
    for (const CellPattern::Run& run : cells.runs)
      for (int i = 0; i < run.length; ++i) {
        const glm::ivec2 cell = corner + placement({run.x + i, run.y});
        bytes[static_cast<std::size_t>(wrapped(cell.y, size.y)) * rowBytes +
              static_cast<std::size_t>(wrapped(cell.x, size.x))] = static_cast<std::uint8_t>(run.state);
      }
  }
  return bytes;
}

std::vector<glm::vec3> LifePlan::stateColors() const {
  if (!rule_.colors.empty() && !parameters_.colorsGiven) return rule_.colors;
  const std::vector<glm::vec3> stops = parameters_.display.colors();
  const bool ages = rule_.family == CellRule::Family::map || rule_.family == CellRule::Family::wide;
  const int states = rule_.states;
  std::vector<glm::vec3> colors;
  for (int s = 0; s < states; ++s) {
    const float place = static_cast<float>(s == 0 ? 0
                                           : ages ? states - s
                                                  : s) /
                        static_cast<float>(states - 1);
    const float at = place * static_cast<float>(stops.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 1);
    const std::size_t high = std::min(low + 1, stops.size() - 1);
    const float part = at - static_cast<float>(low);
    colors.push_back(stops[low] + (stops[high] - stops[low]) * part);
  }
  return colors;
}

long LifePlan::generationAt(long frame) const {
  const double steps = static_cast<double>(frame) * parameters_.stepsPerSecond * frameSeconds_;
  return static_cast<long>(std::floor(steps + 1e-9 * (1 + std::abs(steps))));
}

int LifePlan::stepsPerFrame() const {
  const double steps = parameters_.stepsPerSecond * frameSeconds_;
  return std::max(1, static_cast<int>(std::ceil(steps - 1e-9 * (1 + steps))));
}

long LifePlan::frameAt(double time) const {
  return std::lround(time / frameSeconds_);
}

std::vector<shader::Stroke> LifePlan::strokesInto(long generation) const {
  if (strokes_.empty()) return {};
  const double seconds = 1 / parameters_.stepsPerSecond;
  return strokes_.into(static_cast<double>(generation) * seconds, seconds, generation);
}

}  // namespace simreel::sim
