#include "sim/fluid/pressure.hpp"

#include "base/error.hpp"
#include "gl/access_together.hpp"
#include "gl/errors.hpp"
#include "gl/limits.hpp"
#include "sim/fluid/solver_interfaces.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

namespace {

constexpr std::size_t
    lastSpeedWord = 7,
    controlWords =
        9;  // Number of control words before the dispatch sizes (glsl/fluid/solver/solve_control.glsl).

/// Number of cycles that most projections need; the remaining cycles are skipped together by one condition.
constexpr int usualCycles = 4;

GLintptr groupsAt(std::size_t dispatch) {
  return static_cast<GLintptr>((controlWords + 3 * dispatch) * 4);
}

/// Returns true if all levels except the coarsest have an even number of cells on each periodic axis.
bool isEven(const FluidPlan& plan) {
  const std::vector<FluidLevel>& levels = plan.levels().levels();
  return std::all_of(levels.begin(), levels.end() - 1, [&](const FluidLevel& level) {
    return (!plan.parameters().wrapsX() || level.cells.x % 2 == 0) &&
           (!plan.parameters().wrapsY() || level.cells.y % 2 == 0);
  });
}

}  // namespace

// There are two indirect dispatch sizes per level (for open tiles and for other tiles), one for a single
// workgroup, and one each for down_ and up_.
FluidPressure::FluidPressure(const std::string& name, const FluidPlan& plan, const gl::Defines& defines)
    : levels_(plan.levels()),
      cycles_(plan.parameters().cycles),
      tileAGroup_(gl::memoryPath() == gl::MemoryPath::storage && isEven(plan)),
      weights_(name + " openings", std::span<const glm::uvec4>(plan.solidsAt(0, 0)->words())),
      solids_(name + " obstacles", sizeof(shader::FluidSolidSet)),
      divergence_(defines),
      bottom_(defines, {.open = 0}),
      decide_(defines),
      judge_(defines, {.judge = true}),
      firstCoarse_(levels_.levels().size() - 1),
      maxSpeed_(plan.fastest()),
      firstDown_(firstCoarse_),
      firstUp_(firstCoarse_),
      tilesStart_(plan.solidsAt(0, 0)->tilesStart()) {
  makePair(descend_, defines);
  makePair(ascend_, defines);
  makePair(residual_, defines);
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
}

void FluidPressure::makeCoarse(const FluidPlan& plan, const gl::Defines& defines) {
  constexpr int maximum = 64;  // Maximum number of cells along each side of a level that coarse_ processes.
  const std::vector<FluidLevel>& levels = levels_.levels();
  const FluidParameters& p = plan.parameters();
  const auto fits = [&](const FluidLevel& level) {
    const bool odd = (p.wrapsX() && level.cells.x % 2 == 1) || (p.wrapsY() && level.cells.y % 2 == 1);
    return level.cells.x <= maximum && level.cells.y <= maximum && !odd;
  };
  std::size_t first = levels.size();
  while (first > 0 && fits(levels[first - 1])) --first;
  if (first == levels.size()) return;
  firstCoarse_ = firstDown_ = firstUp_ = first;
  coarse_ = gl::Kernel<FluidCoarse>(defines, {.subgroups = gl::limits().shuffle32});
  coarseLevels_ = placesFrom(first, levels.size() - first, FluidCoarse::maximum);
  int cells = 0;
  for (std::size_t i = first; i < levels.size(); ++i) {
    coarseLevels_[i - first].w = cells;
    cells += levels[i].cells.x * levels[i].cells.y;
  }
}

std::vector<glm::ivec4> FluidPressure::placesFrom(std::size_t first, std::size_t count,
                                                  std::size_t elements) const {
  std::vector<glm::ivec4> places(elements, glm::ivec4(0));
  for (std::size_t i = 0; i < count; ++i) {
    const FluidLevel& level = levels_.levels()[first + i];
    places.at(i) = glm::ivec4(level.cells, level.start, 0);
  }
  return places;
}

// On the way to coarser levels, the windows grow with each level, so down_ can merge fewer levels than up_.
void FluidPressure::makeMiddle(const gl::Defines& defines) {
  const auto make = [&](auto& kernel, std::size_t maximum, std::size_t& from,
                        std::vector<glm::ivec4>& places) {
    const std::size_t count = std::min(firstCoarse_, maximum);
    if (count == 0) return;
    from = firstCoarse_ - count;
    kernel = std::remove_cvref_t<decltype(kernel)>(defines, {.levels = static_cast<int>(count)});
    places = placesFrom(from, count + 1, maximum + 1);
  };
  make(down_, FluidDown::maximum, firstDown_, downLevels_);
  make(up_, FluidUp::maximum, firstUp_, upLevels_);
}

bool FluidPressure::joins(std::size_t level) const {
  return gl::memoryPath() == gl::MemoryPath::storage && levels_.levels()[level].hasOpenTiles();
}

// The variant `both` is created only if a level needs it, because drivers take seconds to compile each
// variant.
template <class Interface>
void FluidPressure::makePair(Pair<Interface>& pair, const gl::Defines& defines) const {
  bool any = false;
  for (std::size_t i = 0; i < levels_.levels().size(); ++i) any = any || joins(i);
  const auto of = [&](int open, bool tileAGroup) {
    return gl::Kernel<Interface>(defines, {.open = open, .tileAGroup = tileAGroup});
  };
  // On the storage path there is no such variant, and all tiles are in the list of other tiles.
  if (gl::memoryPath() != gl::MemoryPath::storage) pair.open = of(1, false);
  pair.others = of(0, tileAGroup_);
  if (any) pair.both = of(2, tileAGroup_);
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
    // Rounds up to whole rows of workgroups; surplus workgroups find no tile.
    if (joins(level)) {
      groups[groups.size() - 6] = row;
      groups[groups.size() - 5] = rows;
    }
  }
  groups.insert(groups.end(), {1U, 1U, 1U});
  for (const std::size_t first : {firstDown_, firstUp_}) {
    constexpr int tile = 32;  // Tile width in cells of down.comp and up.comp.
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

FluidPart FluidPressure::part(const gl::Resource& step) const {
  return {.step = step,
          .size = levels_.levels().front().cells,
          .solids = solids_,
          .solidsStart = levels_.elements(),
          .weights = weights_};
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

template <class Interface>
void FluidPressure::indirect(const gl::Kernel<Interface>& kernel, std::size_t number,
                             const Interface& given) const {
  kernel.dispatchIndirect(control_, static_cast<std::size_t>(groupsAt(number)), given);
}

template <class Interface>
void FluidPressure::onLevel(const Pair<Interface>& pair, std::size_t number, const Interface& given) const {
  if (joins(number)) return indirect(pair.both, 2 * number, given);
  const gl::AccessTogether together;
  indirect(pair.others, 2 * number + 1, given);
  if (levels_.levels()[number].hasOpenTiles()) indirect(pair.open, 2 * number, given);
}

FluidLevelPart FluidPressure::levelPart(std::size_t level, const Memory& memory) const {
  return {.level = places_.at(level), .pool = memory.pool, .raised = memory.raised, .weights = weights_};
}

FluidDecide FluidPressure::decision(const gl::Buffer& status, bool first, float tolerance) const {
  return {.dispatches = static_cast<int>(groups_.size()) / 3,
          .first = first ? 1 : 0,
          .tolerance = tolerance,
          .maxSpeed = maxSpeed_,
          .status = status,
          .control = control_};
}

void FluidPressure::bottom(const Memory& memory) const {
  const std::size_t single = 2 * levels_.levels().size();
  if (!coarse_) return indirect(bottom_, single, {levelPart(firstCoarse_, memory), memory.raised});
  const FluidLevel& level = levels_.levels()[firstCoarse_];
  indirect(coarse_, single,
           {.levels = coarseLevels_,
            .levelCount = static_cast<int>(levels_.levels().size() - firstCoarse_),
            .rhsStart = 2 * levels_.levels().front().elements() + level.start,
            .upStart = level.start,
            .pool = memory.pool,
            .weights = weights_,
            .raisedOut = memory.raised});
}

void FluidPressure::cycle(const Memory& memory) const {
  const std::size_t single = 2 * levels_.levels().size();
  const int rhsStart = 2 * levels_.levels().front().elements(), wayStart = levels_.elements();
  for (std::size_t i = 0; i < firstDown_; ++i)
    onLevel(descend_, i, {levelPart(i, memory), memory.pool, memory.raised});
  if (firstDown_ < firstCoarse_)
    indirect(down_, single + 1,
             {downLevels_, rhsStart, wayStart, memory.pool, weights_, memory.pool, memory.raised});
  bottom(memory);
  if (firstUp_ < firstCoarse_)
    indirect(up_, single + 2,
             {upLevels_, rhsStart, wayStart, memory.pool, memory.raised, weights_, memory.raised});
  for (std::size_t i = firstUp_; i-- > 0;) onLevel(ascend_, i, {levelPart(i, memory), memory.raised});
  onLevel(residual_, 0, {levelPart(0, memory), memory.pool, control_});
  indirect(decide_, single, decision(*memory.status, false, aimedFluidDivergence));
}

void FluidPressure::solve(const FluidPart& part, const FluidArray& flow, const FluidArray& pool,
                          const FluidArray& raised, const gl::Buffer& status) const {
  const Memory memory = {pool.resource(), raised.resource(), &status};
  divergence_.dispatch(levels_.levels().front().blocks(),
                       {.part = part,
                        .rhsStart = 2 * levels_.levels().front().elements(),
                        .flow = flow.resource(),
                        .poolOut = memory.pool,
                        .control = control_});
  decide_.dispatch(1, decision(status, true, aimedFluidDivergence));
  const bool leaves = condition_ && cycles_ > usualCycles;
  for (int i = 0; i < cycles_; ++i) {
    if (leaves && i == usualCycles) {
      glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
      condition_->begin(control_.name(), groupsAt(2 * levels_.levels().size()));
    }
    cycle(memory);
  }
  if (leaves) condition_->end();
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
}

void FluidPressure::judge(const gl::Buffer& status) const {
  judge_.dispatch(1, decision(status, false, maxFluidDivergence));
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
