#include "draw/exact/scene/exact_scene.hpp"

#include "base/error.hpp"
#include "draw/exact/scene/exact_frame.hpp"
#include "draw/exact/scene/pass_run.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <utility>

namespace simreel::draw {

namespace {

void checkSamples(int samples) {
  if (samples != 1 && samples != 2 && samples != 4 && samples != 8 && samples != 16)
    fail(ExitCode::usage, "{} samples per pixel: the exact rasterizer has 1, 2, 4, 8 and 16", samples);
}

/// Returns the max size in bytes of the visibility buffer of a band. This is `bytes`, or less for path
/// tracing, because path tracing processes at most RayLight::sampleLimit samples per band.
std::size_t bytesOfBands(const scene::Scene& scene, std::size_t bytes) {
  if (scene.render.quality != scene::Quality::high) return bytes;
  return std::min(bytes, RayLight::sampleLimit * Visibility::sampleBytes);
}

}  // namespace

int rowsOfBands(glm::ivec2 size, int samples, const BandLimits& room) {
  const std::size_t pixels = std::min(room.samples / static_cast<std::size_t>(samples),
                                      static_cast<std::size_t>(room.glowBytes / GlowRaster::sumBytes));
  const std::size_t rows = pixels / static_cast<std::size_t>(size.x);
  if (rows >= static_cast<std::size_t>(size.y)) return size.y;
  constexpr int side = ShadedTiles::side;
  return std::min(size.y, std::max(static_cast<int>(rows) / side * side, side));
}

struct ExactScene::State {
  State(const scene::Scene& scene, const Environment* environment, glm::ivec2 size, int samples, int rows)
      : frame(scene, environment, size, samples, rows), passes(frame) {}

  ExactFrame frame;
  PassRun passes;
};

ExactScene::ExactScene(const scene::Scene& scene, const Environment* environment, glm::ivec2 size,
                       int samples, std::size_t visibilityBytes) {
  checkSamples(samples);
  const BandLimits room{
      std::min(bytesOfBands(scene, visibilityBytes) / Visibility::sampleBytes, Visibility::maxSamples()),
      gl::limits().storageBlockBytes};
  state_ = std::make_unique<State>(scene, environment, size, samples, rowsOfBands(size, samples, room));
}
ExactScene::~ExactScene() = default;

void ExactScene::keepPasses(PassPicture* passes) {
  state_->frame.passes = passes;
}

void ExactScene::keepLayers(const LightRequest& wanted) {
  state_->frame.wanted = wanted;
  state_->passes.asked();
}

PictureLayers ExactScene::takeLayers() {
  return std::move(state_->frame.layers);
}

void ExactScene::draw(const Exposure& exposure, const Moment& frame, const Overlays& overlays,
                      const gl::Texture& picture, const StageCallback& watch) {
  ExactFrame& f = state_->frame;
  f.asked = {&exposure, frame, &overlays, &picture};
  if (f.environment != nullptr) f.environment->bind();
  state_->passes.draw(watch);
}

}  // namespace simreel::draw
