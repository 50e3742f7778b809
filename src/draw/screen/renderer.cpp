#include "draw/screen/renderer.hpp"

#include "base/error.hpp"
#include "draw/environment.hpp"
#include "draw/exact/scene/exact_scene.hpp"
#include "draw/frame_values.hpp"
#include "draw/overlay/axes_pass.hpp"
#include "draw/overlay/chart_pass.hpp"
#include "draw/overlay/field_pass.hpp"
#include "draw/overlay/field_textures.hpp"
#include "draw/screen/driver_scene.hpp"
#include "draw/screen/targets.hpp"

#include <optional>
#include <span>

namespace simreel::draw {

struct Renderer::State {
  State(const scene::Scene& shown, glm::ivec2 pixels, int samples, const RendererOptions& options,
        Rasterizer rasterizer)
      : scene(shown),
        size(pixels),
        picture(pixels),
        fieldTextures(shown, rasterizer),
        fields(pixels, rasterizer),
        axes(pixels, rasterizer),
        charts(pixels, rasterizer),
        frame("frame values", sizeof(shader::Frame)) {
    if (!shown.sky.picture.empty()) environment.emplace(shown.sky);
    if (rasterizer == Rasterizer::exact)
      exact.emplace(shown, environment ? &*environment : nullptr, pixels, samples, options.visibilityBytes);
    else
      driver.emplace(DriverScene::Shared{shown, fieldTextures, fields, picture}, samples);
  }

  const scene::Scene& scene;
  glm::ivec2 size;
  Picture picture;
  FieldTextures fieldTextures;
  FieldPass fields;
  AxesPass axes;
  ChartPass charts;
  gl::Buffer frame;
  std::optional<Environment> environment;
  std::optional<DriverScene> driver;
  std::optional<ExactScene> exact;
  PassPicture* passes = nullptr;
};

Renderer::Renderer(const scene::Scene& scene, glm::ivec2 size, int samples, const RendererOptions& options)
    : state_(std::make_unique<State>(scene, size, samples, options,
                                     options.rasterizer.value_or(scene.render.rasterizer))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch) {
  State& s = *state_;
  if (s.passes != nullptr) *s.passes = {};
  shader::Frame values = frameValues(s.scene, s.size, seconds, drawables);
  if (s.environment) s.environment->setGradient(values, values.ambient);
  s.frame.write(0, std::as_bytes(std::span(&values, 1)));
  s.frame.bindUniform(frameBinding, 0, sizeof values);
  // Whatever the simulations wrote, vertex pulling and index fetch see it.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
  s.fieldTextures.update(drawables);
  s.fields.prepare(drawables, seconds);
  if (watch && !drawables.fields.empty()) watch("fields");
  if (!s.fields.hidesAll(drawables, seconds)) {
    if (s.exact)
      s.exact->draw(seconds, drawables, {s.fieldTextures, s.fields}, s.picture.color, watch);
    else
      s.driver->draw(seconds, drawables, watch);
  }
  if (s.exact) {
    s.fields.drawOver(drawables, seconds, s.picture.color);
    s.axes.draw(drawables, seconds, s.picture.color);
    s.charts.draw(drawables, s.picture.color);
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT);
    if (s.passes != nullptr) s.passes->keepBytes("picture", "finished", s.picture.color);
  } else {
    s.picture.framebuffer.bind();
    s.fields.draw(drawables, sim::FieldDisplay::Layer::over, seconds);
    s.axes.draw(drawables, seconds);
    s.charts.draw(drawables);
  }
  if (watch && !(drawables.fields.empty() && drawables.charts.empty())) watch("fields");
}

void Renderer::keepPasses(PassPicture* passes) {
  SIMREEL_CHECK(state_->exact.has_value());
  state_->passes = passes;
  state_->exact->keepPasses(passes);
}

void Renderer::keepLayers(std::span<const Layer> wanted) {
  SIMREEL_CHECK(state_->exact.has_value());
  state_->exact->keepLayers(wanted);
}

PictureLayers Renderer::takeLayers() {
  return state_->exact->takeLayers();
}

const gl::Framebuffer& Renderer::target() const {
  return state_->picture.framebuffer;
}

}  // namespace simreel::draw
