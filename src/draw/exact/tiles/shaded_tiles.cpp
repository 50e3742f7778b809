#include "draw/exact/tiles/shaded_tiles.hpp"

#include "base/error.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/rows_at_once.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "gl/rehearsal.hpp"

#include <algorithm>
#include <span>
#include <string>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

constexpr int maxThings = 2046;  // the bits that tiles.comp has, 32 times 64, less the ground's two,
constexpr int fewThings = 30;    // and with FEW
constexpr unsigned onGround = 1;
constexpr unsigned groundsKeys = 2;
constexpr unsigned few = 4;
constexpr unsigned fours = 8;  // and twice that: lists for four things, or for eight

/// Four of the numbers, from `first` on; beyond them, more than any.
glm::ivec4 fourOf(const std::vector<unsigned>& numbers, std::size_t first) {
  glm::ivec4 four(-1);
  for (int i = 0; i < 4; ++i)
    if (const auto at = first + static_cast<std::size_t>(i); at < numbers.size())
      four[i] = static_cast<int>(numbers[at]);
  return four;
}

}  // namespace

ShadedTiles::ShadedTiles(const Visibility& visibility, bool ground, bool shadow, bool empties)
    : size_(visibility.size()),
      tiles_((size_ + side - 1) / side),
      defines_(definesOf(visibility.layout())),
      ground_(ground) {
  defines_.emplace_back("SAMPLES", std::to_string(visibility.samples()));
  defines_.emplace_back("ROWS", std::to_string(rowsAtOnce()));
  if (empties && emptiesLight()) defines_.emplace_back("EMPTIES", "1");
  if (shadow) defines_.emplace_back("SHADOW", "1");
  program((ground ? onGround : 0U) | few | fours);
}

bool ShadedTiles::any() const {
  if (gl::Rehearsal::now()) return true;
  std::vector<GLuint> counts(static_cast<std::size_t>(things_));
  counters_.read(0, std::as_writable_bytes(std::span(counts)));
  return std::any_of(counts.begin(), counts.end(), [](GLuint count) { return count > 0; });
}

bool ShadedTiles::emptiesLight() {
  return !gl::softwareDriver();
}

const gl::Program& ShadedTiles::program(unsigned features) {
  const auto found = programs_.find(features);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = defines_;
  if ((features & onGround) != 0) defines.emplace_back("GROUND", "1");
  if ((features & groundsKeys) != 0) defines.emplace_back("GROUND_KEYS", "1");
  if ((features & few) != 0) defines.emplace_back("FEW", "1");
  if (features >= fours) defines.emplace_back("FOURS", std::to_string(features / fours));
  return programs_.emplace(features, gl::Program::compute("draw/exact/tiles/tiles.comp", defines))
      .first->second;
}

void ShadedTiles::list(const std::vector<unsigned>& firstIds, const Visibility& visibility,
                       const GroundPlace& place, bool groundKeys) {
  constexpr GLuint zero = 0;
  things_ = static_cast<int>(firstIds.size());
  if (things_ > maxThings)
    fail(ExitCode::device,
         "the exact rasterizer draws {} things at once, not {}; set \"rasterizer\" to \"driver\"",
         maxThings, things_);
  const std::size_t lists = firstIds.size() + 2;
  const std::size_t tiles = static_cast<std::size_t>(tiles_.x) * static_cast<std::size_t>(tiles_.y);
  reserve(firstIds_, firstIdView_, "first numbers", lists * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  reserve(lists_, listView_, "lists of tiles", lists * tiles * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  reserve(counters_, counterView_, "counts of tiles", lists * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  reserve(dispatches_, "groups for tiles", lists * GroupCounts::bytes);
  if (!firstIds.empty()) firstIds_.write(0, std::as_bytes(std::span(firstIds)));
  glClearNamedBufferData(counters_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  visibility.bind();
  firstIdView_.bind(firstIdUnit);
  lists_.bindStorage(tileListBinding);
  counters_.bindStorage(counterBinding);
  // Cards do all rows at once; software drivers run both sides of a branch.
  const glm::ivec2 groundRows = place.rows;
  const glm::ivec2 ground = !ground_               ? glm::ivec2(0)
                            : gl::softwareDriver() ? glm::min(groundRows / side, tiles_.y)
                                                   : glm::ivec2(0, tiles_.y);
  const unsigned size = (things_ <= fewThings ? few : 0U) | (things_ <= 4   ? fours
                                                             : things_ <= 8 ? 2 * fours
                                                                            : 0U);
  const auto rows = [&](int from, int to, unsigned features) {
    if (from >= to) return;
    const gl::Program& kernel = program(features | size);
    kernel.set("draws", things_);
    kernel.set("tileCount", tiles_.x * tiles_.y);
    kernel.set("firstTileRow", from);
    kernel.set("firstFour", fourOf(firstIds, 0));
    kernel.set("nextFour", fourOf(firstIds, 4));
    kernel.set("groundNear", place.near);
    kernel.set("groundRays", place.rays);
    kernel.dispatch(tiles_.x * side, (to - from) * side / rowsAtOnce());
  };
  rows(0, ground.x, 0);
  rows(ground.x, ground.y, onGround | (groundKeys ? groundsKeys : 0U));
  rows(ground.y, tiles_.y, 0);
  gl::barrier();
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  groups_.fill(counters_, {.counts = things_ + 2}, dispatches_);
  gl::barrier();
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
}

void ShadedTiles::shade(int thing, const gl::Program& program) const {
  listView_.bind(tileListUnit);
  counterView_.bind(counterUnit);
  program.set("draw_", thing);
  program.set("tileCount", tiles_.x * tiles_.y);
  GroupCounts::dispatch(program, dispatches_, static_cast<std::size_t>(thing));
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace simreel::draw
