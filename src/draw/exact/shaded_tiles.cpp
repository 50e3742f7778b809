#include "draw/exact/shaded_tiles.hpp"

#include "base/error.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <span>
#include <string>

namespace simreel::draw {

namespace {

constexpr int maxThings = 2046;  // 32 times maxWords of tiles.comp, less the ground's two

}  // namespace

ShadedTiles::ShadedTiles(const Visibility& visibility, bool ground, bool shadow)
    : size_(visibility.size()),
      tiles_((size_ + side - 1) / side),
      defines_(definesOf(visibility.layout())) {
  defines_.emplace_back("SAMPLES", std::to_string(visibility.samples()));
  if (emptiesLight()) defines_.emplace_back("EMPTIES", "1");
  if (ground) defines_.emplace_back("GROUND", "1");
  if (shadow) defines_.emplace_back("SHADOW", "1");
  program_ = gl::Program::compute("draw/exact/tiles.comp", defines_);
}

bool ShadedTiles::emptiesLight() {
  return !gl::softwareDriver();
}

void ShadedTiles::list(const std::vector<unsigned>& firstIds, const Visibility& visibility,
                       bool groundKeys) {
  constexpr GLuint zero = 0;
  if (groundKeys && keyProgram_.name() == 0) {
    gl::Defines defines = defines_;
    defines.emplace_back("GROUND_KEYS", "1");
    keyProgram_ = gl::Program::compute("draw/exact/tiles.comp", defines);
  }
  const gl::Program& program = groundKeys ? keyProgram_ : program_;
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
  program.set("draws", things_);
  program.set("tileCount", tiles_.x * tiles_.y);
  program.dispatch(size_.x, size_.y);
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
  program.use();
  GroupCounts::dispatch(dispatches_, static_cast<std::size_t>(thing));
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace simreel::draw
