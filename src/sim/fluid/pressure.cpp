#include "sim/fluid/pressure.hpp"

#include "base/error.hpp"
#include "gl/errors.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::shader::fluid {
#include "glsl/fluid/bindings.glsl"
}

namespace simreel::sim {

namespace {

namespace at = shader::fluid;

constexpr std::size_t lastSpeedWord = 7,
                      controlWords = 9;  // before the groups: glsl/fluid/solver/solve_control.glsl

/// Between the solver's kernels, which hand each other storage blocks only where there are no texels:
/// waiting for more takes a card longer than a kernel that is empty.
void barrier() {
  if (gl::memoryPath() == gl::MemoryPath::storage)
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  else
    gl::barrier();
}

/// Cycles that most projections want; those beyond them, if any, are left out together.
constexpr int usualCycles = 4;

GLintptr groupsAt(std::size_t dispatch) {
  return static_cast<GLintptr>((controlWords + 3 * dispatch) * 4);
}

/// For tiles in the open (1), the others (0) or both (2).
gl::Program onTiles(const char* path, const gl::Defines& defines, int tiles) {
  gl::Defines with = defines;
  with.emplace_back("IN_THE_OPEN", std::to_string(tiles));
  return gl::Program::compute(path, with);
}

/// Whether on a torus all levels but the coarsest are an even number of cells around.
bool isEven(const FluidPlan& plan) {
  const std::vector<FluidLevel>& levels = plan.levels().levels();
  return std::all_of(levels.begin(), levels.end() - 1, [&](const FluidLevel& level) {
    return (!plan.parameters().wrapsX() || level.cells.x % 2 == 0) &&
           (!plan.parameters().wrapsY() || level.cells.y % 2 == 0);
  });
}

}  // namespace

// Dispatches for each level's tiles, those in the open and the others, for a single group, and for down_
// and up_.
FluidPressure::FluidPressure(const std::string& name, const FluidPlan& plan, const gl::Defines& defines)
    : levels_(plan.levels()),
      cycles_(plan.parameters().cycles),
      tileAGroup_(gl::memoryPath() == gl::MemoryPath::storage && isEven(plan)),
      weights_(name + " openings", std::span<const glm::uvec4>(plan.solidsAt(0, 0)->words())),
      solids_(name + " obstacles", sizeof(shader::FluidSolidSet)),
      descend_(pairOf("fluid/solver/descend.comp", defines)),
      ascend_(pairOf("fluid/solver/ascend.comp", defines)),
      residual_(pairOf("fluid/solver/residual.comp", defines)),
      divergence_(gl::Program::compute("fluid/solver/divergence.comp", defines)),
      bottom_(onTiles("fluid/solver/bottom.comp", defines, 0)),
      decide_(gl::Program::compute("fluid/solver/decide.comp", defines)),
      firstCoarse_(plan.levels().levels().size() - 1),
      firstDown_(firstCoarse_),
      firstUp_(firstCoarse_),
      tilesStart_(plan.solidsAt(0, 0)->tilesStart()) {
  gl::Defines judging = defines;
  judging.emplace_back("JUDGE", "1");
  judge_ = gl::Program::compute("fluid/solver/decide.comp", judging);
  if (gl::memoryPath() == gl::MemoryPath::storage) makeCoarse(plan, defines);
  if (tileAGroup_ && coarse_) makeMiddle(defines);
  if (gl::memoryPath() == gl::MemoryPath::storage) condition_.emplace();
  groups_ = groupsOf(*plan.solidsAt(0, 0));
  std::vector<std::uint32_t> words(controlWords + groups_.size());
  words.insert(words.end(), groups_.begin(), groups_.end());
  words.resize((words.size() + 3) / 4 * 4);
  control_ = gl::Buffer::of<std::uint32_t>(name + " solver", words);
  places_ =
      StepBlocks<shader::FluidLevelPlace>(name + " levels", static_cast<int>(levels_.levels().size()));
  places_.upload(places(*plan.solidsAt(0, 0)));
  bottom_.checkUniformBlock("LevelBlock", sizeof(shader::FluidLevelPlace));
  const auto& finest = levels_.levels().front();
  divergence_.set("size", finest.cells);
  divergence_.set("rhsStart", 2 * finest.elements());
  divergence_.set("solidsStart", levels_.elements());
  decide_.set("dispatches", static_cast<int>(groups_.size()) / 3);
  decide_.set("tolerance", aimedFluidDivergence);
  judge_.set("tolerance", maxFluidDivergence);
  judge_.set("mostSpeed", plan.parameters().speed);
}

void FluidPressure::makeCoarse(const FluidPlan& plan, const gl::Defines& defines) {
  constexpr int most = 64;  // cells of a side
  const std::vector<FluidLevel>& levels = levels_.levels();
  const FluidParameters& p = plan.parameters();
  const auto fits = [&](const FluidLevel& level) {
    const bool odd = (p.wrapsX() && level.cells.x % 2 == 1) || (p.wrapsY() && level.cells.y % 2 == 1);
    return level.cells.x <= most && level.cells.y <= most && !odd;
  };
  std::size_t first = levels.size();
  while (first > 0 && fits(levels[first - 1])) --first;
  if (first == levels.size()) return;
  firstCoarse_ = firstDown_ = firstUp_ = first;
  gl::Defines with = defines;
  if (gl::limits().shuffle32) with.emplace_back("SUBGROUPS", "1");
  coarse_ = gl::Program::compute("fluid/solver/coarse.comp", with);
  int cells = 0;
  for (std::size_t i = first; i < levels.size(); ++i) {
    const std::string name = "levels[" + std::to_string(i - first) + "]";
    coarse_.set(name.c_str(), glm::ivec4(levels[i].cells, levels[i].start, cells));
    cells += levels[i].cells.x * levels[i].cells.y;
  }
  coarse_.set("levelCount", static_cast<int>(levels.size() - first));
  coarse_.set("rhsStart", 2 * levels.front().elements() + levels[first].start);
  coarse_.set("upStart", levels[first].start);
}

// On the way down windows grow by each level, so fewer share a dispatch.
void FluidPressure::makeMiddle(const gl::Defines& defines) {
  const std::vector<FluidLevel>& levels = levels_.levels();
  const auto make = [&](const char* path, std::size_t most, std::size_t& from) {
    const std::size_t count = std::min(firstCoarse_, most);
    if (count == 0) return gl::Program();
    from = firstCoarse_ - count;
    gl::Defines with = defines;
    with.emplace_back("LEVELS", std::to_string(count));
    gl::Program program = gl::Program::compute(path, with);
    for (std::size_t i = 0; i <= count; ++i) {
      const FluidLevel& level = levels[from + i];
      program.set(("levels[" + std::to_string(i) + "]").c_str(), glm::ivec4(level.cells, level.start, 0));
    }
    program.set("rhsStart", 2 * levels.front().elements());
    program.set("wayStart", levels_.elements());
    return program;
  };
  down_ = make("fluid/solver/down.comp", 3, firstDown_);
  up_ = make("fluid/solver/up.comp", 4, firstUp_);
}

bool FluidPressure::joins(std::size_t level) const {
  return gl::memoryPath() == gl::MemoryPath::storage && levels_.levels()[level].hasOpenTiles();
}

// The program for both is made only where a level joins its tiles: drivers take seconds for each.
FluidPressure::Pair FluidPressure::pairOf(const char* path, const gl::Defines& defines) const {
  gl::Defines others = defines;
  if (tileAGroup_) others.emplace_back("TILE_A_GROUP", "1");
  bool any = false;
  for (std::size_t i = 0; i < levels_.levels().size(); ++i) any = any || joins(i);
  // Without any all tiles are others there.
  const bool storage = gl::memoryPath() == gl::MemoryPath::storage;
  return {storage ? gl::Program() : onTiles(path, defines, 1), onTiles(path, others, 0),
          any ? onTiles(path, others, 2) : gl::Program()};
}

std::vector<std::uint32_t> FluidPressure::groupsOf(const FluidSolids& solids) const {
  constexpr auto row = static_cast<std::uint32_t>(FluidLevel::groupRow);
  std::vector<std::uint32_t> groups;
  for (std::size_t level = 0; level < solids.tileGroups().size(); ++level) {
    std::uint32_t rows = 0;
    for (int i = 0; i < 2; ++i) {
      const auto count =
          static_cast<std::uint32_t>(i == 0 ? solids.tileGroups()[level].x : otherGroups(solids, level));
      rows += (count + row - 1) / row;
      groups.insert(groups.end(), {std::min(count, row), (count + row - 1) / row, 1U});
    }
    // Whole rows of groups: what is left over finds no tile.
    if (joins(level)) {
      groups[groups.size() - 6] = row;
      groups[groups.size() - 5] = rows;
    }
  }
  groups.insert(groups.end(), {1U, 1U, 1U});
  for (const std::size_t first : {firstDown_, firstUp_}) {
    constexpr int tile = 32;  // down.comp, up.comp
    const glm::uvec2 tiles((levels_.levels()[first].cells - 1) / tile + 1);
    groups.insert(groups.end(), {tiles.x, tiles.y, 1U});
  }
  return groups;
}

int FluidPressure::otherGroups(const FluidSolids& solids, std::size_t level) const {
  return solids.tileGroups()[level].y * (tileAGroup_ ? FluidLevel::groupTiles : 1);
}

void FluidPressure::setSolids(const FluidSolids& solids) {
  weights_.write(solids.words());
  const std::vector<std::uint32_t> groups = groupsOf(solids);
  if (groups != groups_) {
    gl::beforeWrites();
    places_.upload(places(solids));
    control_.write(4 * (controlWords + groups.size()), std::as_bytes(std::span(groups)));
    groups_ = groups;
  }
  solids_.write(0, std::as_bytes(std::span(&solids.set(), 1)));
}

void FluidPressure::bindSolids() const {
  weights_.bindInput(at::weightsBinding);
  solids_.bindUniform(at::solidsBinding, 0, solids_.bytes());
}

std::vector<shader::FluidLevelPlace> FluidPressure::places(const FluidSolids& solids) const {
  const std::vector<FluidLevel>& levels = levels_.levels();
  const int finest = levels.front().elements();
  std::vector<shader::FluidLevelPlace> places;
  int tiles = tilesStart_;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const int coarser = i + 1 < levels.size() ? levels[i + 1].start : 0;
    shader::FluidLevelPlace place{};
    place.cells = levels[i].cells;
    place.weights = place.up = levels[i].start;
    place.rhs = 2 * finest + levels[i].start;
    place.way = levels_.elements() + levels[i].start;
    place.coarseRhs = 2 * finest + coarser;
    place.coarseUp = coarser;
    place.openTiles = tiles;
    place.otherTiles = tiles + levels[i].listElements();
    place.otherRows = (otherGroups(solids, i) + FluidLevel::groupRow - 1) / FluidLevel::groupRow;
    tiles += 2 * levels[i].listElements();
    places.push_back(place);
  }
  return places;
}

void FluidPressure::indirect(const gl::Program& program, std::size_t number) const {
  program.dispatchIndirect(control_, static_cast<std::size_t>(groupsAt(number)));
}

void FluidPressure::onLevel(const Pair& pair, std::size_t number) const {
  places_.bind(number, at::levelBinding);
  barrier();
  if (joins(number)) return indirect(pair.both, 2 * number);
  indirect(pair.others, 2 * number + 1);
  if (levels_.levels()[number].hasOpenTiles()) indirect(pair.open, 2 * number);
}

void FluidPressure::cycle() const {
  const std::size_t single = 2 * levels_.levels().size();
  const auto alone = [&](const gl::Program& program, std::size_t number) {
    barrier();
    indirect(program, number);
  };
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);  // how much there is to do
  for (std::size_t i = 0; i < firstDown_; ++i) onLevel(descend_, i);
  if (firstDown_ < firstCoarse_) alone(down_, single + 1);
  places_.bind(firstCoarse_, at::levelBinding);
  alone(coarse_ ? coarse_ : bottom_, single);
  if (firstUp_ < firstCoarse_) alone(up_, single + 2);
  for (std::size_t i = firstUp_; i-- > 0;) onLevel(ascend_, i);
  onLevel(residual_, 0);
  alone(decide_, single);
}

void FluidPressure::solve(const FluidArray& flow, const FluidArray& pool, const FluidArray& raised) {
  const glm::ivec2 blocks = levels_.levels().front().blocks();
  flow.bindInput(at::flowBinding);
  bindSolids();
  pool.bindStorage(at::poolOutBinding);
  control_.bindStorage(at::controlBinding);
  gl::barrier();
  divergence_.dispatch(blocks.x, blocks.y);
  gl::barrier();
  decide_.set("first", 1);
  decide_.dispatch(1);
  decide_.set("first", 0);
  pool.bindInput(at::poolBinding);
  raised.bindInput(at::raisedBinding);
  raised.bindStorage(at::raisedOutBinding);
  const bool leaves = condition_ && cycles_ > usualCycles;
  for (int i = 0; i < cycles_; ++i) {
    if (leaves && i == usualCycles) {
      glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
      condition_->begin(control_.name(), groupsAt(2 * levels_.levels().size()));
    }
    cycle();
  }
  if (leaves) condition_->end();
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
  gl::barrier();
}

void FluidPressure::judge(const gl::Buffer& status) const {
  control_.bindStorage(at::controlBinding);
  status.bindStorage(shader::statusBinding);
  gl::barrier();
  judge_.dispatch(1);
}

void FluidPressure::resume() {
  constexpr std::uint32_t none = 0;
  gl::beforeWrites();
  control_.write(4 * lastSpeedWord, std::as_bytes(std::span(&none, 1)));
  control_.write(4 * (controlWords + groups_.size()), std::as_bytes(std::span(groups_)));
}

FluidPressure::Report FluidPressure::report() const {
  std::uint32_t words[controlWords];
  control_.read(0, std::as_writable_bytes(std::span(words)));
  const auto number = [&](int i) { return std::bit_cast<float>(words[i]); };
  Report r;
  r.worstShare = number(4);
  r.worstSpeed = number(5);
  r.lastShare = number(6);
  r.lastSpeed = number(7);
  r.cycles = words[3] > 0 ? static_cast<double>(words[2]) / words[3] : 0;
  return r;
}

}  // namespace simreel::sim
