#include "sim/life_plan.hpp"

#include "base/error.hpp"
#include "sim/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#define FUNCTION inline
namespace simreel::shader {
namespace {
#include "glsl/life/fill.glsl"
}
}  // namespace simreel::shader
#undef FUNCTION

namespace simreel::sim {

namespace {

/// Where a cell of a pattern goes: flipped within its size, then turned clockwise.
struct Placement {
  const LifePattern& pattern;
  glm::ivec2 size;

  [[nodiscard]] glm::ivec2 turnedSize() const {
    return pattern.rotate % 180 == 0 ? size : glm::ivec2(size.y, size.x);
  }
  [[nodiscard]] glm::ivec2 operator()(glm::ivec2 cell) const {
    if (pattern.flip == LifePattern::Flip::horizontal) cell.x = size.x - 1 - cell.x;
    if (pattern.flip == LifePattern::Flip::vertical) cell.y = size.y - 1 - cell.y;
    switch (pattern.rotate) {
      case 90:
        return pattern.at + glm::ivec2(size.y - 1 - cell.y, cell.x);
      case 180:
        return pattern.at + glm::ivec2(size.x - 1 - cell.x, size.y - 1 - cell.y);
      case 270:
        return pattern.at + glm::ivec2(cell.y, size.x - 1 - cell.x);
      default:
        return pattern.at + cell;
    }
  }
};

int wrapped(int x, int size) {
  return (x % size + size) % size;
}

}  // namespace

LifePlan::LifePlan(LifeParameters parameters, const std::string& object, int seed, double frameSeconds)
    : parameters_(std::move(parameters)),
      seed_(seed),
      frameSeconds_(frameSeconds),
      strokes_(parameters_.strokes, seed) {
  std::vector<RlePattern> files;
  for (const LifePattern& pattern : parameters_.patterns) {
    // The same gun many times is read once.
    const auto same = std::find_if(parameters_.patterns.begin(), parameters_.patterns.end(),
                                   [&](const LifePattern& p) { return p.file == pattern.file; });
    const auto index = static_cast<std::size_t>(same - parameters_.patterns.begin());
    files.push_back(index < files.size() ? files[index] : readRle(pattern.file));
  }
  takeRule(files, object);
  for (std::size_t i = 0; i < files.size(); ++i) place(parameters_.patterns[i], files[i], object);
}

void LifePlan::takeRule(const std::vector<RlePattern>& files, const std::string& object) {
  if (!parameters_.rule.empty()) {
    const LifeRuleProblem problem = parseLifeRule(parameters_.rule, rule_);
    SIMREEL_CHECK(problem.message.empty());  // the scene was checked
    return;
  }
  const glm::ivec2 size = parameters_.size;
  const LifePattern* named = nullptr;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const RlePattern& file = files[i];
    const LifePattern& pattern = parameters_.patterns[i];
    if (!file.rule) continue;
    if (named != nullptr && *file.rule != rule_)
      fail(ExitCode::usage,
           "life \"{}\": {} is for the rule {}, but {} for {}; say in the scene which \"rule\" is meant",
           object, named->file.string(), rule_.text(), pattern.file.string(), file.rule->text());
    rule_ = *file.rule;
    named = &pattern;
    if (file.border != 0 && (file.border != (torus() ? 'T' : 'P') || file.grid != size))
      fail(ExitCode::usage,
           "life \"{}\": {} is for a grid of {} x {} with border \"{}\", but the scene's is {} x {} with "
           "\"{}\"; "
           "change \"size\" and \"border\", or give a \"rule\" in the scene",
           object, pattern.file.string(), file.grid.x, file.grid.y, file.border == 'T' ? "torus" : "dead",
           size.x, size.y, torus() ? "torus" : "dead");
  }
}

void LifePlan::place(const LifePattern& pattern, const RlePattern& cells, const std::string& object) {
  const glm::ivec2 size = parameters_.size;
  const Placement placement{pattern, cells.size};
  const glm::ivec2 turned = placement.turnedSize();
  if (turned.x > size.x || turned.y > size.y)
    fail(ExitCode::usage,
         "life \"{}\": {} has {} x {} cells, more than the grid's {} x {}; make \"size\" larger", object,
         pattern.file.string(), turned.x, turned.y, size.x, size.y);
  const glm::ivec2 end = pattern.at + turned;
  if (!torus() && (pattern.at.x < 0 || pattern.at.y < 0 || end.x > size.x || end.y > size.y))
    fail(ExitCode::usage,
         "life \"{}\": {} at [{}, {}] reaches to [{}, {}], outside the grid of {} x {}; move it (\"at\") "
         "or use "
         "\"border\": \"torus\"",
         object, pattern.file.string(), pattern.at.x, pattern.at.y, end.x - 1, end.y - 1, size.x, size.y);
  for (const RlePattern::Run& run : cells.runs)
    for (int i = 0; i < run.length; ++i) {
      const glm::ivec2 cell = placement({run.x + i, run.y});
      runs_.push_back({wrapped(cell.x, size.x), wrapped(cell.y, size.y), 1});
    }
}

int LifePlan::fillShare() const {
  return static_cast<int>(std::lround(static_cast<double>(parameters_.fill) * 16777216.0));
}

void LifePlan::addPatterns(std::vector<std::uint32_t>& words) const {
  const auto rowWords = static_cast<std::size_t>(rowBlocks()) * 4;
  for (const RlePattern::Run& cell : runs_)
    words[static_cast<std::size_t>(cell.y) * rowWords + static_cast<std::size_t>(cell.x) / 32] |=
        1U << (cell.x % 32);
}

std::vector<std::uint32_t> LifePlan::firstCells() const {
  std::vector<std::uint32_t> words(static_cast<std::size_t>(blocks()) * 4);
  const int share = fillShare();
  if (share > 0) {
    const auto rowWords = static_cast<std::size_t>(rowBlocks()) * 4;
    for (int y = 0; y < parameters_.size.y; ++y)
      for (int x = 0; x < parameters_.size.x; ++x)
        if (shader::startsAlive(x, y, seed_, share))
          words[static_cast<std::size_t>(y) * rowWords + static_cast<std::size_t>(x) / 32] |= 1U
                                                                                              << (x % 32);
  }
  addPatterns(words);
  return words;
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

std::vector<shader::Stroke> LifePlan::strokesIn(long generation) const {
  if (strokes_.empty()) return {};
  const double seconds = 1 / parameters_.stepsPerSecond;
  return strokes_.during(static_cast<double>(generation) * seconds, seconds, generation);
}

}  // namespace simreel::sim
