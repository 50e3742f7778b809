#include "sim/cave/growth.hpp"

#include "base/error.hpp"
#include "gl/limits.hpp"
#include "sim/cave/rooms.hpp"
#include "sim/cave/route.hpp"

#include <utility>

namespace simreel::sim {

struct CaveSmooth {
  static constexpr auto file = "cave/smooth.comp";
  CavePart cave;
  gl::Out<"NextBlock"> next;
};

struct CaveBlend {
  static constexpr auto file = "cave/blend.comp";
  CavePart cave;
  gl::Uniform<"fraction", float> fraction;
  gl::Uniform<"seed", unsigned> seed;
  gl::In<"BeforeBlock"> before;
  gl::Out<"BlendedBlock"> blended;
};

namespace {

struct CaveFill {
  static constexpr auto file = "cave/fill.comp";
  CavePart cave;
  gl::Uniform<"seed", unsigned> seed;
  gl::Uniform<"threshold", unsigned> threshold;
};

constexpr int walkRounds = 200;

CaveGrid checked(const std::string& name, glm::ivec2 size) {
  const CaveGrid grid{size};
  const std::int64_t bytes = grid.numbers() * 4;
  const gl::Limits& limits = gl::limits();
  if (bytes > limits.storageBlockBytes)
    fail(ExitCode::device,
         "cave \"{}\" of {}x{} cells needs {} bytes, this device allows {} in one buffer "
         "(GL_MAX_SHADER_STORAGE_BLOCK_SIZE); make \"size\" smaller",
         name, size.x, size.y, bytes, limits.storageBlockBytes);
  return grid;
}

void copyCells(const gl::Buffer& from, const gl::Buffer& to) {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(from.name(), to.name(), 0, 0, static_cast<GLsizeiptr>(from.bytes()));
}

}  // namespace

CaveGrowth::CaveGrowth(const std::string& name, const CaveParameters& parameters, int seed)
    : name_(name),
      parameters_(parameters),
      grid_(checked(name, parameters.size)),
      seed_(static_cast<unsigned>(seed)),
      distances_(name + " distances", static_cast<int>(grid_.numbers() / 4)),
      smooth_(gl::Defines()),
      regions_(name, grid_),
      waves_(name, grid_) {
  cells_[0] = gl::WordsArray(name + " cells", grid_.words() / 4);
  cells_[1] = gl::WordsArray(name + " next cells", grid_.words() / 4);
  roomCells_ = gl::WordsArray(name + " cells of rooms", grid_.words() / 4);
  if (parameters_.moves()) {
    blended_ = gl::WordsArray(name + " blended cells", static_cast<int>(grid_.numbers() / 4));
    blend_ = gl::Kernel<CaveBlend>(gl::Defines());
  }
  fill();
}

void CaveGrowth::fill() {
  gl::Kernel<CaveFill>(gl::Defines())
      .dispatch(
          grid_.words(),
          {.cave = partOf(grid_, cells_[0].buffer()), .seed = seed_, .threshold = parameters_.threshold()});
  gl::barrier();
}

void CaveGrowth::smooth() {
  smooth_.dispatch(grid_.words(), {partOf(grid_, cells_[0].buffer()), cells_[1].buffer()});
  gl::barrier();
  std::swap(cells_[0], cells_[1]);
}

void CaveGrowth::clean() {
  const gl::Buffer& cells = cells_[0].buffer();
  regions_.label(cells, CaveKind::open);
  const CaveRegions::Largest room = regions_.largest(cells);
  regions_.remove(cells, static_cast<unsigned>(parameters_.smallestRoom), room.first);
  regions_.label(cells, CaveKind::rock);
  regions_.remove(cells, static_cast<unsigned>(parameters_.smallestRock),
                  0);  // The rock region at the border contains cell 0 and is not removed.
}

void CaveGrowth::connect() {
  copyCells(cells_[0].buffer(), roomCells_.buffer());
  if (!parameters_.connect) return;
  regions_.label(cells_[0].buffer(), CaveKind::open);
  if (regions_.largest(cells_[0].buffer()).cells == 0) return;
  if (!corridors_) corridors_.emplace(name_, grid_);
  corridors_->dig(cells_[0].buffer(), regions_, parameters_.corridor);
}

/// Finds the two ends of the longest path by two sweeps: first the cell farthest from an arbitrary cell,
/// then the cell farthest from that first cell.
void CaveGrowth::findWay() {
  way_ = {};
  if (!done()) return;
  const gl::Buffer& cells = cells_[0].buffer();
  regions_.label(cells, CaveKind::open);
  const CaveRegions::Largest room = regions_.largest(cells);
  if (room.cells == 0) return;
  way_.entrance = waves_.run(cells, room.first).cell;
  way_.exit = waves_.run(cells, way_.entrance).cell;
  waves_.writeDistances(cells, distances_.buffer());
  const std::vector<unsigned> distances = waves_.distances();
  way_.path = cavePath(grid_, distances, way_.exit);
  way_.walk = smoothPath(grid_, distances, way_.path, walkRounds);
}

std::vector<Room> CaveGrowth::rooms() const {
  const gl::WordsArray& map = done() ? roomCells_ : cells_[0];
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  return caveRooms(grid_, map.buffer().readAll<unsigned>(), parameters_.cell);
}

void CaveGrowth::advance(int stage) {
  SIMREEL_CHECK(stage >= stage_ && stage <= parameters_.lastStage());
  while (stage_ < stage) {
    ++stage_;
    // A smoothing step swaps the two arrays. The other steps change the cells in place.
    if (parameters_.moves() && stage_ > parameters_.smoothing)
      copyCells(cells_[0].buffer(), cells_[1].buffer());
    if (stage_ <= parameters_.smoothing)
      smooth();
    else if (stage_ == parameters_.smoothing + 1)
      clean();
    else
      connect();
    if (done()) findWay();
  }
}

void CaveGrowth::blend(float fraction) {
  SIMREEL_CHECK(parameters_.moves());
  blend_.dispatch({32 * grid_.rowWords(), grid_.size.y}, {.cave = partOf(grid_, cells_[0].buffer()),
                                                          .fraction = fraction,
                                                          .seed = seed_,
                                                          .before = cells_[1].buffer(),
                                                          .blended = blended_.buffer()});
  gl::barrier();
}

void CaveGrowth::visitCheckpointData(CarryOver& carry) {
  carry.number("stage", stage_);
  carry.array("cells", cells_[0].buffer());
  if (parameters_.moves()) carry.array("before", cells_[1].buffer());
  carry.array("rooms", roomCells_.buffer());
}

}  // namespace simreel::sim
