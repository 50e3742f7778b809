#include "draw/screen/single_view.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "draw/environment.hpp"
#include "draw/exact/motion/motion.hpp"
#include "draw/exact/scene/exact_scene.hpp"
#include "draw/frame_values.hpp"
#include "draw/overlay/axes_pass.hpp"
#include "draw/overlay/chart_labels.hpp"
#include "draw/overlay/chart_pass.hpp"
#include "draw/overlay/field_pass.hpp"
#include "draw/overlay/field_textures.hpp"
#include "draw/overlay/writing_pass.hpp"
#include "draw/screen/drawn_scene.hpp"
#include "draw/screen/driver_scene.hpp"
#include "draw/screen/targets.hpp"
#include "sim/grid/field_display.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace simreel::draw {

namespace {

/// Returns the name of an overlay in the picture, or null if none exists.
const char* overlayOf(const sim::Drawables& drawables) {
  if (!drawables.writings.empty()) return "text";
  if (!drawables.charts.empty()) return "a chart";
  for (const sim::Field& field : drawables.fields)
    if (field.display != nullptr && field.display->layer == sim::FieldDisplay::Layer::over)
      return "a field";
  return nullptr;
}

/// Throws UserError(usage) because 16-bit output does not support overlays, which have 8 bits and no light
/// values. `found`: name of the overlay.
void refuseOverlays(const char* found) {
  fail(ExitCode::usage,
       "--bits 16: {} is drawn over the picture with 8 bits; leave it out of the scene, or write OpenEXR, "
       "which contains only the light of the scene",
       found);
}

}  // namespace

struct SingleView::State {
  State(const scene::Scene& given, glm::ivec2 pixels, int samples, const RendererOptions& options,
        Rasterizer rasterizer)
      : own(overlaidScene(given)),
        scene(own ? *own : given),
        size(pixels),
        picture(pixels),
        fieldTextures(scene, rasterizer),
        fields(pixels, rasterizer),
        axes(pixels, rasterizer),
        charts(pixels, rasterizer),
        labels(pixels),
        writings(pixels),
        frame("frame values", sizeof(shader::Frame)) {
    if (!scene.sky.picture.empty()) environment.emplace(scene.sky);
    if (rasterizer == Rasterizer::exact && scene.camera.shutter)
      motion.emplace(scene.numerics == scene::Numerics::fast);
    if (rasterizer == Rasterizer::exact)
      exact.emplace(scene, environment ? &*environment : nullptr, pixels, samples, options.visibilityBytes);
    else
      driver.emplace(DriverScene::Shared{scene, fieldTextures, fields, picture}, samples);
  }

  std::unique_ptr<scene::Scene> own;  ///< the scene as an overlay shows it; null without one
  const scene::Scene& scene;
  glm::ivec2 size;
  Picture picture;
  FieldTextures fieldTextures;
  FieldPass fields;
  AxesPass axes;
  ChartPass charts;
  ChartLabels labels;
  TextPass writings;
  gl::Buffer frame;
  std::optional<Environment> environment;
  std::optional<DriverScene> driver;
  std::optional<ExactScene> exact;
  std::optional<Motion> motion;
  PassPicture* passes = nullptr;
  std::optional<bool> filmed;  ///< true if the requested light is as the film shows it; empty if no light
                               ///< is requested
  bool saidOverlay = false;    ///< true if the warning about missing overlays was given or is disabled

  /// Draws text over the finished picture: first of axes and charts, then of objects.
  void write(const sim::Drawables& drawables, double seconds) {
    sim::Drawables lettered;
    lettered.writings = axes.letters(drawables, seconds);
    const std::vector<sim::Writing> charted = labels.of(drawables);
    lettered.writings.insert(lettered.writings.end(), charted.begin(), charted.end());
    lettered.writings.insert(lettered.writings.end(), drawables.writings.begin(), drawables.writings.end());
    writings.draw(lettered, picture.color);
  }
  void tellFrame(double seconds, const sim::Drawables& drawables);
  void drawExactly(const ExactScene::Moment& shown, const StageWatch& watch);
};

void SingleView::State::tellFrame(double seconds, const sim::Drawables& drawables) {
  shader::Frame values = frameValues(scene, size, seconds, drawables);
  if (environment) environment->setGradient(values, values.ambient);
  frame.write(0, std::as_bytes(std::span(&values, 1)));
  frame.bindUniform(frameBinding, 0, sizeof values);
}

/// Draws a frame with the exact rasterizer. The exposure time is divided into equal parts; the moments are
/// at their centres, the latest one first.
void SingleView::State::drawExactly(const ExactScene::Moment& shown, const StageWatch& watch) {
  ExactScene::Exposure exposure{1, [&](int) { return shown; }};
  const double frameSeconds = 1.0 / scene.time.fps;
  if (motion) {
    motion->begin(*shown.drawables, frameSeconds, shown.seconds);
    exposure.motion = &*motion;
    exposure.frameSeconds = frameSeconds;
  }
  if (scene.camera.shutter) {
    const scene::Shutter& shutter = *scene.camera.shutter;
    exposure.moments = shutter.samples;
    exposure.at = [=, this](int i) -> ExactScene::Moment {
      const double open = static_cast<double>(shutter.angle) / 360;
      const double ago = open * (i + 0.5) / shutter.samples;
      const ExactScene::Moment moment{shown.seconds - ago * frameSeconds,
                                      &motion->between(static_cast<float>(1 - ago))};
      tellFrame(moment.seconds, *moment.drawables);
      return moment;
    };
    exposure.part =
        static_cast<float>(1 - static_cast<double>(shutter.angle) / 360 * 0.5 / shutter.samples);
    exposure.close = [=, this] { tellFrame(shown.seconds, *shown.drawables); };
  }
  exact->draw(exposure, shown, {fieldTextures, fields}, picture.color, watch);
}

SingleView::SingleView(const scene::Scene& scene, glm::ivec2 size, int samples,
                       const RendererOptions& options)
    : state_(std::make_unique<State>(scene, size, samples, options,
                                     options.rasterizer.value_or(scene.render.rasterizer))) {}
SingleView::~SingleView() = default;
SingleView::SingleView(SingleView&&) noexcept = default;

void SingleView::draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch) {
  State& s = *state_;
  if (s.passes != nullptr) *s.passes = {};
  const char* const overlay = s.filmed ? overlayOf(drawables) : nullptr;
  if (overlay != nullptr && *s.filmed) refuseOverlays(overlay);
  if (overlay != nullptr && !std::exchange(s.saidOverlay, true))
    warn(
        "OpenEXR pictures contain only the light of the scene; missing there, because drawn over the "
        "picture: {}",
        overlay);
  s.tellFrame(seconds, drawables);
  // Makes all writes of simulation kernels visible to texture fetches and index reads.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
  s.fieldTextures.update(drawables);
  s.fields.prepare(drawables, seconds);
  if (watch && !drawables.fields.empty()) watch("fields");
  if (s.filmed || !s.fields.hidesAll(drawables, seconds)) {  // the requested light also shows objects that
                                                             // opaque fields hide
    if (s.exact)
      s.drawExactly({seconds, &drawables}, watch);
    else
      s.driver->draw(seconds, drawables, watch);
  }
  if (s.exact) {
    s.fields.drawOver(drawables, seconds, s.picture.color);
    s.axes.draw(drawables, seconds, s.picture.color);
    s.charts.draw(drawables, s.picture.color);
    s.write(drawables, seconds);
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT);
    if (s.passes != nullptr) s.passes->keepBytes("picture", "finished", s.picture.color);
  } else {
    s.picture.framebuffer.bind();
    s.fields.draw(drawables, sim::FieldDisplay::Layer::over, seconds);
    s.axes.draw(drawables, seconds);
    s.charts.draw(drawables);
    s.write(drawables, seconds);
  }
  if (watch && !(drawables.fields.empty() && drawables.charts.empty())) watch("fields");
}

void SingleView::setPreviousFrame(const sim::Drawables& before) {
  if (state_->motion) state_->motion->keep(before);
}

bool SingleView::needsPreviousFrame() const {
  return state_->motion.has_value();
}

void SingleView::keepPasses(PassPicture* passes) {
  SIMREEL_CHECK(state_->exact.has_value());
  state_->passes = passes;
  state_->exact->keepPasses(passes);
}

void SingleView::keepLayers(const LightRequest& wanted) {
  SIMREEL_CHECK(state_->exact.has_value());
  state_->filmed = wanted.filmed;
  state_->saidOverlay = wanted.quiet;
  if (!state_->motion && std::any_of(wanted.layers.begin(), wanted.layers.end(), [](Layer layer) {
        return layer == Layer::velocity || layer == Layer::vector;
      }))
    state_->motion.emplace(state_->scene.numerics == scene::Numerics::fast);
  state_->exact->keepLayers(wanted);
}

PictureLayers SingleView::takeLayers() {
  return state_->exact->takeLayers();
}

const Picture& SingleView::picture() const {
  return state_->picture;
}

}  // namespace simreel::draw
