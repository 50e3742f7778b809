#include "serve/stage/stage.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "frame/draw_world.hpp"
#include "gl/context.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace simreel::serve {

namespace {

constexpr double perSecond = 1000.0;

glm::ivec2 scaledSize(glm::ivec2 size, float scale) {
  return glm::max(glm::ivec2(glm::round(glm::vec2(size) * scale)), glm::ivec2(1));
}

}  // namespace

Stage::Stage(std::shared_ptr<Script> script, std::size_t memory, Origin origin)
    : script_(std::move(script)),
      worldScript_(script_),
      origin_(std::move(origin)),
      memory_(memory),
      kept_(memory),
      storedSimulation_(simulatedOf(*script_)) {
  makeWorld();
}

Stage::~Stage() {
  if (world_) world_->onFrameBefore({});
}

/// Builds a new world, which has not computed a frame beyond the run's beginning.
void Stage::makeWorld() {
  summaries_ = nullptr;
  world_ = std::make_unique<sim::World>(script_->scene);
  begin();
  startAtOrigin();
}

void Stage::beginAt(Origin origin) {
  if (started_) summaries_->takeAll();
  origin_ = std::move(origin);
  kept_.clear();
  past_.reset();
  for (Series& series : series_) series.values.clear();
  makeWorld();
}

/// Puts the state of origin_ into a world that has not stepped yet. If it does not fit the scene, the run
/// begins at the scene's start.
void Stage::startAtOrigin() {
  if (!origin_) return;
  try {
    frame::putBack(*world_, origin_->frame, origin_->parts, origin_->bytes, "the checkpoint");
  } catch (const UserError&) {
    origin_.reset();
    summaries_ = nullptr;
    world_ = std::make_unique<sim::World>(script_->scene);
    return begin();
  }
  started_ = ready_ = true;
  summaries_->start();
}

/// Prepares the stage for a world that has not stepped yet.
void Stage::begin() {
  worldScript_ = script_;
  started_ = ready_ = carried_ = false;
  forgetBefore();
  summaries_ =
      std::make_unique<frame::Summaries>(*world_, [this](const auto& summary) { keepSummary(summary); });
  if (series_.empty()) {
    for (const sim::World::CountNames& counted : world_->countNames())
      for (const std::string& column : counted.columns) series_.push_back({counted.object, column, "", {}});
    measured_ = series_.size();
    for (const scene::Object& object : script_->scene.objects)
      if (object.parameters->measures())
        for (const scene::Quantity& quantity : object.parameters->quantities())
          series_.push_back({object.name, quantity.name, quantity.unit, {}});
  }
  follow();
}

/// With motion blur, passes the frame before each frame to the renderers of full pictures.
void Stage::follow() {
  if (!script_->scene.camera.shutter) return world_->onFrameBefore({});
  world_->onFrameBefore([this](const sim::Drawables& before) {
    for (Drawer* drawer : {&drawers_[0], &tester_}) {
      if (drawer->renderer == nullptr) continue;
      drawer->renderer->setPreviousFrame(before);
      drawer->previousFrameOf = world_->frame() + 1;
    }
  });
}

void Stage::forgetBefore() {
  drawers_[0].previousFrameOf.reset();
  tester_.previousFrameOf.reset();
}

void Stage::keepSummary(const sim::World::Summary& summary) {
  stateHash_ = summary.stateHash;
  arrayHashes_ = summary.arrays;
  if (summary.frame < 0) return;
  const auto names = world_->countNames();
  std::size_t at = 0;
  for (std::size_t i = 0; i < names.size() && i < summary.counts.size(); ++i) {
    const auto& rows = summary.counts[i];
    const auto elements = static_cast<std::size_t>(names[i].elements);
    for (std::size_t c = 0; c < names[i].columns.size(); ++c, ++at) {
      if (rows.size() < elements || at >= series_.size()) continue;
      const unsigned word = rows[rows.size() - elements + c / 4][static_cast<int>(c % 4)];
      series_[at].values[summary.frame] =
          names[i].measured ? static_cast<double>(std::bit_cast<float>(word)) : static_cast<double>(word);
    }
  }
}

void Stage::step(bool seen) {
  const int next = started_ ? world_->frame() + 1 : world_->firstFrame();
  if (seen)
    world_->advanceTo(next);
  else
    world_->advanceUndrawn(next);
  ++stepped_;
  started_ = true;
  ready_ = seen;
  if (seen) summaries_->start();
}

/// Prepares the current frame for drawing and computes its hash.
void Stage::lookAt() {
  if (!ready_) {
    world_->complete();
    ready_ = true;
    summaries_->start();
  }
  summaries_->takeAll();
}

bool Stage::approach(int frame) {
  if (started_ && world_->frame() == frame) return true;
  if (carried_ && world_->frame() > frame) simulateAs(script_);
  const bool back = started_ && world_->frame() > frame;
  const frame::WorldState* nearest = keptBefore(frame);
  if (back || (nearest != nullptr && (!started_ || world_->frame() < nearest->frame))) {
    summaries_->takeAll();
    if (nearest == nullptr) {
      makeWorld();
      return false;
    }
    return putBack(*nearest) && world_->frame() == frame;
  }
  const auto begun = Clock::now();
  const bool counts = measured_ > 0;
  step(counts || !started_ || world_->frame() + 1 == frame || kept_.wants(world_->frame() + 1));
  if (world_->frame() == frame) {
    lookAt();
    glFinish();
    took_.simulate = perSecond * secondsSince(begun) + std::exchange(making_, 0);
  }
  if (!carried_ && kept_.wants(world_->frame())) {
    lookAt();  // lookAt() throws if a simulation has lost its state, so that such a state is not stored.
    kept_.keep(frame::stateOf(*world_));
    if (past_ && kept_.bytes() + past_->kept.bytes() > memory_) past_.reset();
  }
  return world_->frame() == frame;
}

/// Restores a state. Returns false if the state does not fit the world, for example if a fluid had no dye
/// before. In that case no stored state fits, so all are removed and the world starts again.
bool Stage::putBack(const frame::WorldState& state) {
  try {
    frame::putBack(*world_, state.frame, state.parts, state.bytes, "a state that was kept");
  } catch (const UserError&) {
    kept_.clear();
    makeWorld();
    return false;
  }
  started_ = true;
  ready_ = true;
  forgetBefore();
  summaries_->start();
  return true;
}

/// Returns the latest stored state at or before a frame, or null while the current state is carried over
/// from other values.
const frame::WorldState* Stage::keptBefore(int frame) const {
  return carried_ ? nullptr : kept_.before(frame);
}

Stage::Drawer& Stage::drawerOf(std::size_t level) {
  Drawer& drawer = drawers_[level];
  if (drawer.renderer != nullptr) return drawer;
  const scene::Scene& shown = level == 0 ? script_->scene : script_->draft;
  const DetailLevel& detail = detailLevels[level];
  drawer.size = scaledSize(shown.render.size, detail.scale);
  drawer.script = script_;
  // In scenes with only fields, the rasterizer of a software driver takes a third of the exact rasterizer's
  // time.
  draw::RendererOptions how;
  if (level > 0 && script_->fieldsAlone && gl::memoryPath() == gl::MemoryPath::texel)
    how.rasterizer = scene::Rasterizer::driver;
  drawer.renderer = std::make_unique<draw::Renderer>(
      shown, drawer.size, detail.samples > 0 ? detail.samples : shown.render.samples, how);
  drawer.readback = std::make_unique<draw::Readback>(drawer.size);
  return drawer;
}

/// With motion blur, computes the frame before the current one again if the renderer does not have it.
void Stage::prepareMotion(Drawer& drawer) {
  const int frame = world_->frame();
  if (!script_->scene.camera.shutter || drawer.previousFrameOf == frame) return;
  if (frame <= (origin_ ? origin_->frame : world_->firstFrame())) {
    lookAt();
    drawer.renderer->setPreviousFrame(world_->drawables());  // At the first frame, nothing moves.
    drawer.previousFrameOf = frame;
    return;
  }
  summaries_->takeAll();
  const frame::WorldState* nearest = keptBefore(frame - 1);
  if (nearest != nullptr) {
    frame::putBack(*world_, nearest->frame, nearest->parts, nearest->bytes, "a state that was kept");
    started_ = true;
  } else {
    makeWorld();
  }
  while (!started_ || world_->frame() < frame) {
    step(world_->frame() + 1 == frame);
    summaries_->takeAll();
  }
}

frame::Image Stage::draw(std::size_t level) {
  Drawer& drawer = drawerOf(level);
  if (level == 0) prepareMotion(drawer);
  lookAt();
  const auto begun = Clock::now();
  frame::drawWorld(*drawer.renderer, *world_);
  drawer.readback->start(drawer.renderer->target(), world_->frame());
  drawer.readback->waitForOldest();
  took_.draw = perSecond * secondsSince(begun);
  const auto drawn = Clock::now();
  frame::Image image{drawer.size.x, drawer.size.y, {}, script_->scene.render.transparent};
  image.bytes = drawer.readback->nextPicture(true)->second;
  took_.readBack = perSecond * secondsSince(drawn);
  return image;
}

void Stage::setTestScene(std::unique_ptr<scene::Scene> scene) {
  tester_ = {};  // The assignment destroys the renderer, because it reads the old scene.
  testScene_ = std::move(scene);
}

golden::RunFrame Stage::drawTested() {
  SIMREEL_CHECK(testScene_ != nullptr);
  if (tester_.renderer == nullptr) {
    tester_.size = testScene_->render.size;
    tester_.renderer =
        std::make_unique<draw::Renderer>(*testScene_, tester_.size, testScene_->render.samples);
    tester_.readback = std::make_unique<draw::Readback>(tester_.size);
  }
  prepareMotion(tester_);
  lookAt();
  frame::drawWorld(*tester_.renderer, *world_);
  tester_.readback->start(tester_.renderer->target(), world_->frame());
  golden::RunFrame made{world_->frame(),
                        world_->time(),
                        {tester_.size.x, tester_.size.y, {}, testScene_->render.transparent},
                        {},
                        {}};
  made.image.bytes = tester_.readback->nextPicture(true)->second;
  made.pixels = frame::pixelHash(made.image);
  const auto arrays = world_->arrays();
  SIMREEL_CHECK_EQ(arrays.size(), arrayHashes_.size());
  for (std::size_t i = 0; i < arrays.size(); ++i)
    made.state[arrays[i].object + "." + arrays[i].array] = arrayHashes_[i];
  return made;
}

void Stage::measure() {
  lookAt();
  std::size_t at = measured_;
  for (std::size_t i = 0; i < world_->objectCount() && i < worldScript_->scene.objects.size(); ++i) {
    const scene::Object& object = worldScript_->scene.objects[i];
    if (!object.parameters->measures()) continue;
    const std::vector<double> values = world_->object(i).measure();
    const std::size_t count = object.parameters->quantities().size();
    for (std::size_t k = 0; k < count && at + k < series_.size(); ++k)
      if (k < values.size()) series_[at + k].values[world_->frame()] = values[k];
    at += count;
  }
}

PixelInfo Stage::ask(glm::dvec2 place) {
  lookAt();
  return pixelInfo(script_->draft, *world_, place);
}

}  // namespace simreel::serve
