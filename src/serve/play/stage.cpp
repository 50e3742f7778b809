#include "serve/play/stage.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "frame/draw_world.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

namespace simreel::serve {

namespace {

constexpr double perSecond = 1000.0;

glm::ivec2 scaledSize(glm::ivec2 size, float scale) {
  return glm::max(glm::ivec2(glm::round(glm::vec2(size) * scale)), glm::ivec2(1));
}

}  // namespace

Stage::Stage(std::shared_ptr<Script> script, std::size_t memory)
    : script_(std::move(script)), made_(script_), kept_(memory) {
  makeWorld();
}

Stage::~Stage() {
  if (world_) world_->onFrameBefore({});
}

void Stage::makeWorld() {
  summaries_ = nullptr;
  world_ = std::make_unique<sim::World>(script_->scene);
  made_ = script_;
  started_ = false;
  seen_ = false;
  forgetBefore();
  summaries_ = std::make_unique<frame::Summaries>(*world_, [this](const auto& summary) { hear(summary); });
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

/// Who draws whole pictures hears of the frame before each, where they have motion blur.
void Stage::follow() {
  if (!script_->scene.camera.hasShutter) return world_->onFrameBefore({});
  world_->onFrameBefore([this](const sim::Drawables& before) {
    for (Drawer* drawer : {&drawers_[0], &tester_}) {
      if (drawer->renderer == nullptr) continue;
      drawer->renderer->keepBefore(before);
      drawer->toldBefore = world_->frame() + 1;
    }
  });
}

void Stage::forgetBefore() {
  drawers_[0].toldBefore.reset();
  tester_.toldBefore.reset();
}

void Stage::hear(const sim::World::Summary& summary) {
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
    world_->passTo(next);
  started_ = true;
  seen_ = seen;
  if (seen) summaries_->start();
}

/// The present frame becomes one that may be drawn, and its hash is known.
void Stage::lookAt() {
  if (!seen_) {
    world_->show();
    seen_ = true;
    summaries_->start();
  }
  summaries_->takeAll();
}

bool Stage::approach(int frame) {
  if (started_ && world_->frame() == frame) return true;
  const frame::WorldState* nearest = kept_.before(frame);
  const bool back = started_ && world_->frame() > frame;
  if (back || (nearest != nullptr && (!started_ || world_->frame() < nearest->frame))) {
    summaries_->takeAll();
    if (nearest == nullptr) {
      makeWorld();
      return false;
    }
    frame::putBack(*world_, nearest->frame, nearest->parts, nearest->bytes, "a state that was kept");
    started_ = true;
    seen_ = true;
    forgetBefore();
    summaries_->start();
    return world_->frame() == frame;
  }
  const auto begun = Clock::now();
  const bool counts = measured_ > 0;
  step(counts || !started_ || world_->frame() + 1 == frame || kept_.wants(world_->frame() + 1));
  if (world_->frame() == frame) {
    lookAt();
    glFinish();
    took_.simulate = perSecond * secondsSince(begun);
  }
  if (!carried_ && kept_.wants(world_->frame())) {
    lookAt();  // no state that is lost is kept
    kept_.keep(frame::stateOf(*world_));
  }
  return world_->frame() == frame;
}

Stage::Drawer& Stage::drawerOf(std::size_t level) {
  Drawer& drawer = drawers_[level];
  if (drawer.renderer != nullptr) return drawer;
  const scene::Scene& shown = level == 0 ? script_->scene : script_->draft;
  const DetailLevel& detail = detailLevels[level];
  drawer.size = scaledSize(shown.render.size, detail.scale);
  drawer.script = script_;
  drawer.renderer = std::make_unique<draw::Renderer>(
      shown, drawer.size, detail.samples > 0 ? detail.samples : shown.render.samples);
  drawer.readback = std::make_unique<draw::Readback>(drawer.size);
  return drawer;
}

/// Where pictures have motion blur, the frame before the present one is made once more for who draws it.
void Stage::prepareMotion(Drawer& drawer) {
  const int frame = world_->frame();
  if (!script_->scene.camera.hasShutter || drawer.toldBefore == frame) return;
  if (frame <= world_->firstFrame()) {
    lookAt();
    drawer.renderer->keepBefore(world_->drawables());  // things stand still, whatever came before elsewhere
    drawer.toldBefore = frame;
    return;
  }
  summaries_->takeAll();
  const frame::WorldState* nearest = kept_.before(frame - 1);
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
  image.bytes = drawer.readback->take(true)->second;
  took_.readBack = perSecond * secondsSince(drawn);
  return image;
}

void Stage::setTestScene(std::unique_ptr<scene::Scene> scene) {
  tester_ = {};  // its renderer reads the scene of before
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
  made.image.bytes = tester_.readback->take(true)->second;
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
  for (std::size_t i = 0; i < world_->objectCount() && i < made_->scene.objects.size(); ++i) {
    const scene::Object& object = made_->scene.objects[i];
    if (!object.parameters->measures()) continue;
    const std::vector<double> values = world_->object(i).measure();
    const std::size_t count = object.parameters->quantities().size();
    for (std::size_t k = 0; k < count && at + k < series_.size(); ++k)
      if (k < values.size()) series_[at + k].values[world_->frame()] = values[k];
    at += count;
  }
}

PixelAnswer Stage::ask(glm::dvec2 place) {
  lookAt();
  return askPixel(script_->draft, *world_, place);
}

void Stage::takeLookOf(Script& from) {
  // Renderers and world may have been made of another one each.
  std::set<Script*> all = {script_.get(), made_.get()};
  for (const Drawer& drawer : drawers_)
    if (drawer.script) all.insert(drawer.script.get());
  for (Script* one : all) takeLook(*one, from);
  setTestScene(nullptr);
}

void Stage::drawAs(std::shared_ptr<Script> script) {
  drawers_ = {};
  setTestScene(nullptr);
  script_ = std::move(script);
  forgetBefore();
  follow();
}

void Stage::dressAs(std::shared_ptr<Script> script) {
  SIMREEL_CHECK(carryOverTo(std::move(script)));
  drawers_ = {};
}

/// Who draws stays: what of a scene it knows has not changed.
void Stage::take(std::unique_ptr<sim::World> world, std::shared_ptr<Script> script) {
  script_ = std::move(script);
  made_ = script_;
  summaries_ = nullptr;
  world_ = std::move(world);
  summaries_ = std::make_unique<frame::Summaries>(*world_, [this](const auto& summary) { hear(summary); });
  setTestScene(nullptr);
  forgetBefore();
  started_ = true;
  seen_ = true;
  follow();
  summaries_->start();
}

bool Stage::carryOverTo(std::shared_ptr<Script> script) {
  summaries_->takeAll();
  if (!started_) {
    drawAs(std::move(script));
    makeWorld();
    return true;
  }
  const frame::WorldState state = frame::stateOf(*world_);
  auto world = std::make_unique<sim::World>(script->scene);
  try {
    frame::putBack(*world, state.frame, state.parts, state.bytes, "the present state");
  } catch (const UserError&) {
    return false;
  }
  if (script->simulation != script_->simulation) {
    carried_ = true;
    kept_.clear();
  }
  take(std::move(world), std::move(script));
  return true;
}

bool Stage::goOnAs(std::shared_ptr<Script> script, int frame) {
  const frame::WorldState* nearest = kept_.before(frame - 1);
  if (carried_ || !started_ || nearest == nullptr) return false;
  summaries_->takeAll();
  auto world = std::make_unique<sim::World>(script->scene);
  try {
    frame::putBack(*world, nearest->frame, nearest->parts, nearest->bytes, "a state that was kept");
  } catch (const UserError&) {
    return false;
  }
  kept_.forgetFrom(frame);
  for (Series& series : series_) series.values.erase(series.values.lower_bound(frame), series.values.end());
  take(std::move(world), std::move(script));
  return true;
}

}  // namespace simreel::serve
