#include "api/scene_state.hpp"

#include "api/failure.hpp"
#include "base/error.hpp"
#include "frame/draw_world.hpp"
#include "frame/interrupt.hpp"
#include "scene/as_run.hpp"
#include "scene/shipped_scene.hpp"
#include "sim/core/numerics.hpp"
#include "sim/world/list.hpp"
#include "sim/world/survey.hpp"

#include <exception>
#include <utility>

#include <fmt/format.h>

namespace simreel {

namespace {

/// Returns the error that calls throw after an error has ended a frame midway.
std::exception_ptr endedMidway() {
  return std::make_exception_ptr(
      Error(ErrorKind::usage,
            "an earlier error ended a frame of this scene midway; restart() it, or load it again"));
}

}  // namespace

Scene::State::State(std::shared_ptr<Device::State> on, scene::SceneInput source, bool keepsMotion)
    : device(std::move(on)), input(std::move(source)), motion(keepsMotion) {}

void Scene::State::begin() {
  device->run([this] {
    if (!input.text) input.file = scene::sceneFile(input.file.string());
    scene = std::make_unique<scene::Scene>(input.load(sim::kinds()));
    sim::requireExact(*scene, device->numerics);
    if (motion && scene->render.rasterizer != scene::Rasterizer::exact)
      api::fail(ErrorKind::usage,
                "motion: only the exact rasterizer has layers; leave render.rasterizer out");
    makeWorld();
  });
}

Scene::State::~State() {
  if (device->isForked()) {
    static_cast<void>(layerRenderer_.release());
    static_cast<void>(renderer_.release());
    static_cast<void>(readback_.release());
    static_cast<void>(summaries.release());
    static_cast<void>(world.release());
    return;
  }
  // Moves the members into a shared object, because the device may release them after this destructor.
  struct Remains {
    std::unique_ptr<scene::Scene> scene;
    std::unique_ptr<sim::World> world;
    std::unique_ptr<frame::Summaries> summaries;
    std::unique_ptr<draw::Readback> readback;
    std::unique_ptr<draw::Renderer> renderer, layerRenderer;
  };
  auto remains = std::make_shared<Remains>();
  *remains = {std::move(scene),     std::move(world),     std::move(summaries),
              std::move(readback_), std::move(renderer_), std::move(layerRenderer_)};
  device->release([held = std::move(remains)] { *held = {}; });
}

std::string Scene::State::simulationHash() const {
  return scene::simulationHash(input.asRun(sim::kinds())) + scene->filesHash;
}

template <class Work>
void Scene::State::keepLoss(const Work& work) {
  try {
    work();
  } catch (const UserError& error) {
    if (error.code() == ExitCode::device)
      loss_ = std::current_exception();
    else if (!world || !world->isWhole())
      loss_ = endedMidway();
    throw;
  } catch (...) {
    if (!world || !world->isWhole()) loss_ = endedMidway();
    throw;
  }
}

void Scene::State::requireState() const {
  if (loss_) std::rethrow_exception(loss_);
}

void Scene::State::makeWorld() {
  loss_ = endedMidway();  // This error also applies if an error ends the pre-roll between two frames.
  keepLoss([this] { buildWorld(); });
  loss_ = nullptr;
}

/// Builds the world and simulates the pre-roll.
void Scene::State::buildWorld() {
  const bool moves = scene->camera.shutter || motion;
  if (moves && !placed_) static_cast<void>(sim::frameMotion(*scene, frame::throwIfInterrupted));
  placed_ = placed_ || moves;
  summaries.reset();
  world.reset();
  sim::compileWorldAhead(*scene);
  world = std::make_unique<sim::World>(*scene);
  summaries = std::make_unique<frame::Summaries>(
      *world, [this](const sim::World::Summary& summary) { stateHash = summary.stateHash; });
  seen = true;
  changed = false;
  movedTo_.reset();
  if (moves) {  // Creates new renderers, because the existing ones store earlier motion.
    renderer_.reset();
    layerRenderer_.reset();
    if (scene->camera.shutter) makeRenderer();
    if (motion) makeLayerRenderer();
    follow();
  }
  if (world->firstFrame() < 0)
    stepTo(0);
  else
    summaries->start();
}

/// Passes the frame before each frame to the renderers that need it for motion.
void Scene::State::follow() {
  world->onFrameBefore([this](const sim::Drawables& before) {
    for (draw::Renderer* renderer : {renderer_.get(), layerRenderer_.get()})
      if (renderer != nullptr && renderer->needsPreviousFrame()) renderer->setPreviousFrame(before);
    movedTo_ = world->frame() + 1;
  });
}

void Scene::State::restart() {
  makeWorld();
}

void Scene::State::advanceTo(int frame) {
  requireState();
  if (frame < 0)
    api::fail(ErrorKind::usage, fmt::format("frames count from 0; there is no frame {}", frame));
  if (frame < world->frame())
    api::fail(ErrorKind::usage,
              fmt::format("frame {} is before the current frame, {}; restart() the scene first", frame,
                          world->frame()));
  keepLoss([&] { stepTo(frame); });
}

void Scene::State::stepTo(int frame) {
  while (world->frame() < frame) {
    frame::throwIfInterrupted();
    const int next = world->frame() + 1;
    seen = next == frame;
    if (seen)
      world->advanceTo(next);
    else
      world->advanceUndrawn(next);
    if (seen) summaries->start();
  }
}

void Scene::State::complete() {
  requireState();
  keepLoss([this] {
    if (!seen) {
      world->complete();
      seen = true;
      summaries->start();
    }
    summaries->takeAll();
  });
}

std::size_t Scene::State::indexOf(std::string_view object) const {
  std::string known;
  for (std::size_t i = 0; i < world->objectCount(); ++i) {
    if (world->objectName(i) == object) return i;
    known += (known.empty() ? "" : ", ") + world->objectName(i);
  }
  api::fail(ErrorKind::usage, fmt::format("the scene has no object \"{}\"; it has {}", object,
                                          known.empty() ? "none" : known));
}

sim::StateArray Scene::State::arrayOf(std::string_view object, std::string_view array) const {
  std::string known;
  for (const sim::StateArray& one : world->object(indexOf(object)).state()) {
    if (one.name == array) return one;
    known += (known.empty() ? "" : ", ") + std::string(one.name);
  }
  api::fail(ErrorKind::usage, fmt::format("object \"{}\" has no array \"{}\"; it has {}", object, array,
                                          known.empty() ? "none" : known));
}

void Scene::State::restore(const Snapshot::State& from) {
  if (from.simulation != simulationHash())
    api::fail(ErrorKind::usage, "the snapshot belongs to a scene with other simulations");
  if (loss_) makeWorld();
  try {
    complete();
  } catch (const UserError&) {
    makeWorld();  // The current frame was lost, and no call had needed its state so far.
  }
  frame::putBack(*world, from.world.frame, from.world.parts, from.world.bytes, "the snapshot");
  seen = true;
  changed = from.changed;
  movedTo_.reset();
  summaries->start();
}

/// Places the camera and sets colour ranges as `simreel render` does. A simulation may store the ranges of
/// its colours, so it is created again with the current state.
void Scene::State::placeCamera() {
  if (placed_) return;
  if (!sim::needsSurvey(*scene) && !sim::needsRanges(*scene)) {
    placed_ = true;
    return;
  }
  complete();
  const bool begun = world->frame() > 0 || changed;
  std::optional<frame::WorldState> state;
  if (begun) state = frame::stateOf(*world);
  static_cast<void>(sim::frameMotion(*scene, frame::throwIfInterrupted));
  placed_ = true;
  const bool was = changed;
  makeWorld();
  changed = was;
  if (state) {
    complete();
    frame::putBack(*world, state->frame, state->parts, state->bytes, "the present state");
    summaries->start();
  }
}

void Scene::State::makeRenderer() {
  if (renderer_) return;
  const glm::ivec2 size = scene->render.size;
  renderer_ = std::make_unique<draw::Renderer>(*scene, size, scene->render.samples);
  readback_ = std::make_unique<draw::Readback>(size);
  draw::compileAhead(*scene, size, scene->render.samples, world->time(), world->drawables());
}

void Scene::State::makeLayerRenderer() {
  if (!layerRenderer_)
    layerRenderer_ = std::make_unique<draw::Renderer>(*scene, scene->render.size, scene->render.samples);
  if (motion) layerRenderer_->keepLayers({{draw::Layer::velocity, draw::Layer::vector}, false, 32, true});
}

/// Frame 0 has no preceding frame, and nothing moves in it.
void Scene::State::requireMotion(const draw::Renderer& renderer, const char* what) const {
  if (renderer.needsPreviousFrame() && world->frame() > world->firstFrame() && movedTo_ != world->frame())
    api::fail(ErrorKind::usage,
              fmt::format(
                  "{} needs the frame before frame {}, which this scene did not simulate; go one frame on",
                  what, world->frame()));
}

Picture Scene::State::picture() {
  placeCamera();
  complete();
  makeRenderer();
  requireMotion(*renderer_, "motion blur");
  frame::drawWorld(*renderer_, *world);
  readback_->start(renderer_->target(), world->frame());
  const std::vector<std::uint8_t> all = readback_->nextPicture(true)->second;
  Picture picture{scene->render.size.x, scene->render.size.y, scene->render.transparent ? 4 : 3, {}};
  if (picture.channels == 4) {
    picture.bytes = all;
    return picture;
  }
  const std::size_t pixels = all.size() / 4;
  picture.bytes.resize(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) picture.bytes[3 * i + c] = all[4 * i + c];
  return picture;
}

draw::PictureLayers Scene::State::layers(const std::vector<draw::Layer>& wanted) {
  if (scene->render.rasterizer != scene::Rasterizer::exact)
    api::fail(ErrorKind::usage, "only the exact rasterizer has layers; leave render.rasterizer out");
  placeCamera();
  complete();
  makeLayerRenderer();
  layerRenderer_->keepLayers({wanted, false, 32, true});
  requireMotion(*layerRenderer_, "the layer");
  frame::drawWorld(*layerRenderer_, *world);
  draw::PictureLayers layers = layerRenderer_->takeLayers();
  layerObjects = layers.objects;
  if (motion)  // so that the next step keeps the frame before
    layerRenderer_->keepLayers({{draw::Layer::velocity, draw::Layer::vector}, false, 32, true});
  return layers;
}

}  // namespace simreel
