#include "draw/exact/tiles/shaded_tiles.hpp"

#include "base/error.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/rows_at_once.hpp"
#include "gl/context.hpp"
#include "gl/rehearsal.hpp"

#include <algorithm>
#include <span>

#include <glm/common.hpp>

namespace simreel::draw {

struct TileKernel {
  static constexpr auto file = "draw/exact/tiles/tiles.comp";
  struct Variant {
    SampleVariant samples;
    gl::Flag<"PARALLEL"> parallel;
    gl::Range<"ROWS", 1, 8> rows;
    gl::Flag<"EMPTIES"> empties;
    gl::Flag<"SHADOW"> shadow;
    gl::Flag<"GROUND"> ground;
    gl::Flag<"GROUND_KEYS"> groundKeys;
    gl::Flag<"FEW"> few;
    gl::Range<"FOURS", 1, 2> fours;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::Ambient<"light"> sunPlace = {};
  SamplesRead samples;
  gl::Shared<"NearBlock"> nearest;
  gl::Shared<"IdBlock"> ids;
  gl::In<"firstIds"> firstIds;
  gl::Shared<"sums"> sums;
  gl::Shared<"CounterBlock"> counters;
  gl::Shared<"ListBlock"> lists;
  gl::Uniform<"draws", int> draws;
  gl::Uniform<"tileCount", int> tileCount;
  gl::Uniform<"firstTileRow", int> firstTileRow;
  gl::Uniform<"firstFour", glm::ivec4> firstFour;
  gl::Uniform<"nextFour", glm::ivec4> nextFour;
  gl::Uniform<"groundNear", glm::vec4> groundNear;
  gl::Uniform<"groundRays", glm::vec3> groundRays;
};

namespace {

// Max number of objects per tile list kernel: the 2,048 bits of tiles.comp, minus two for the ground.
constexpr int maxThings = 2046;
// Max number of objects for the FEW variant of tiles.comp: 32 bits, minus two for the ground.
constexpr int fewThings = 30;

/// Returns the FOURS variant of tiles.comp for at most 4 or 8 objects, or none for more.
gl::Range<"FOURS", 1, 2> foursFor(int things) {
  if (things <= 4) return 1;
  if (things <= 8) return 2;
  return {};
}

/// Returns four of the ids, starting at index `first`. Missing ids are -1, which is larger than any id when
/// it is read as an unsigned number.
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
      ground_(ground),
      shadow_(shadow),
      empties_(empties && emptiesLight()) {}

bool ShadedTiles::any() const {
  if (gl::Rehearsal::now()) return true;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<GLuint> counts(static_cast<std::size_t>(things_));
  counters_.read(0, std::as_writable_bytes(std::span(counts)));
  return std::any_of(counts.begin(), counts.end(), [](GLuint count) { return count > 0; });
}

bool ShadedTiles::emptiesLight() {
  return !gl::softwareDriver();
}

void ShadedTiles::list(const std::vector<unsigned>& firstIds, const Visibility& visibility,
                       const gl::Texture& sums, const GroundPlace& place, bool groundKeys) {
  constexpr GLuint zero = 0;
  things_ = static_cast<int>(firstIds.size());
  if (things_ > maxThings)
    fail(ExitCode::device,
         "the picture has {} surfaces and groups of copies, but the exact rasterizer supports at most {}; "
         "set "
         "\"rasterizer\" to \"driver\"",
         things_, maxThings);
  const std::size_t lists = firstIds.size() + 2;
  const std::size_t tiles = static_cast<std::size_t>(tiles_.x) * static_cast<std::size_t>(tiles_.y);
  reserve(firstIds_, firstIdView_, "first numbers", lists * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  reserve(lists_, listView_, "lists of tiles", lists * tiles * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  reserve(counters_, counterView_, "counts of tiles", lists * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  reserve(dispatches_, "groups for tiles", lists * GroupCounts::bytes);
  if (!firstIds.empty()) firstIds_.write(0, std::as_bytes(std::span(firstIds)));
  glClearNamedBufferData(counters_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  visibility_ = &visibility;
  // On GPUs one dispatch handles all rows and the ground. On software drivers, rows with and without ground
  // have separate dispatches, because these drivers execute both sides of a branch.
  const glm::ivec2 groundRows = place.rows;
  const glm::ivec2 ground = !ground_               ? glm::ivec2(0)
                            : gl::softwareDriver() ? glm::min(groundRows / side, tiles_.y)
                                                   : glm::ivec2(0, tiles_.y);
  const auto rows = [&](int from, int to, bool onGround) {
    if (from >= to) return;
    kernels_
        .of({.samples = visibility.variant(),
             .parallel = visibility.layout().parallel,
             .rows = rowsAtOnce(),
             .empties = empties_,
             .shadow = shadow_,
             .ground = onGround,
             .groundKeys = onGround && groundKeys,
             .few = things_ <= fewThings,
             .fours = foursFor(things_)})
        .dispatch({tiles_.x * side, (to - from) * side / rowsAtOnce()},
                  {.samples = visibility.read(),
                   .nearest = visibility.nearestBuffer(),
                   .ids = visibility.idBuffer(),
                   .firstIds = firstIdView_,
                   .sums = sums,
                   .counters = counters_,
                   .lists = lists_,
                   .draws = things_,
                   .tileCount = tiles_.x * tiles_.y,
                   .firstTileRow = from,
                   .firstFour = fourOf(firstIds, 0),
                   .nextFour = fourOf(firstIds, 4),
                   .groundNear = place.near,
                   .groundRays = place.rays});
  };
  rows(0, ground.x, false);
  rows(ground.x, ground.y, true);
  rows(ground.y, tiles_.y, false);
  groups_.fill(counters_, {.counts = things_ + 2}, dispatches_);
}

TileFields ShadedTiles::tile(int thing) const {
  return {.frame = {},
          .view = {},
          .samples = visibility_->read(),
          .lists = listView_,
          .counts = counterView_,
          .thing = thing,
          .tileCount = tiles_.x * tiles_.y};
}

}  // namespace simreel::draw
