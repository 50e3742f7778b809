#include "draw/screen/renderer.hpp"

#include "draw/frame_values.hpp"
#include "draw/instances/instances_pass.hpp"
#include "draw/lights/lamp_shadows.hpp"
#include "draw/lights/lamps.hpp"
#include "draw/overlay/axes_pass.hpp"
#include "draw/overlay/chart_pass.hpp"
#include "draw/overlay/field_pass.hpp"
#include "draw/overlay/field_textures.hpp"
#include "draw/screen/bloom_pass.hpp"
#include "draw/screen/resolve_pass.hpp"
#include "draw/screen/targets.hpp"
#include "draw/screen/tone_map_pass.hpp"
#include "draw/surface/ground_pass.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "draw/surface/skin_textures.hpp"
#include "draw/surface/surface_pass.hpp"

#include <span>

namespace simreel::draw {

struct Renderer::State {
  State(const scene::Scene& shown, glm::ivec2 pixels, int samples)
      : scene(shown),
        size(pixels),
        targets(pixels, samples),
        fieldTextures(shown),
        skins(shown),
        fields(pixels),
        axes(pixels),
        charts(pixels),
        lamps(shown),
        shadow(shown.sun),
        lampShadows(lamps),
        surfaces(shown, shadow, lamps),
        instances(shadow, lamps, targets.scene, pixels, samples),
        ground(shown, shadow, lamps),
        resolve(pixels, samples),
        bloom(shown.render.bloom, pixels, resolve.samples()),
        toneMap(resolve.samples(), bloom.on()),
        frame("frame values", sizeof(shader::Frame)) {}

  const scene::Scene& scene;
  glm::ivec2 size;
  Targets targets;
  FieldTextures fieldTextures;
  SkinTextures skins;
  FieldPass fields;
  AxesPass axes;
  ChartPass charts;
  Lamps lamps;
  ShadowPass shadow;
  LampShadows lampShadows;
  SurfacePass surfaces;
  InstancesPass instances;
  GroundPass ground;
  ResolvePass resolve;
  BloomPass bloom;
  ToneMapPass toneMap;
  gl::Buffer frame;

  /// All but what lies over the finished picture.
  void drawScene(double seconds, const sim::Drawables& drawables, const StageWatch& watch);
};

Renderer::Renderer(const scene::Scene& scene, glm::ivec2 size, int samples)
    : state_(std::make_unique<State>(scene, size, samples)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::draw(double seconds, const sim::Drawables& drawables, const StageWatch& watch) {
  State& s = *state_;
  const shader::Frame values = frameValues(s.scene, s.size, seconds, drawables);
  s.frame.write(0, std::as_bytes(std::span(&values, 1)));
  s.frame.bindUniform(frameBinding, 0, sizeof values);
  // Whatever the simulations wrote, vertex pulling and index fetch see it.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
  s.fieldTextures.update(drawables);
  s.fields.prepare(drawables, seconds);
  if (watch && !drawables.fields.empty()) watch("fields");
  if (!s.fields.hidesAll(drawables, seconds)) {
    if (s.lamps.on()) s.lamps.update(seconds, drawables);
    s.drawScene(seconds, s.lamps.on() ? s.lamps.withGlows(drawables) : drawables, watch);
  }
  s.targets.picture.bind();
  s.fields.draw(drawables, sim::FieldDisplay::Layer::over, seconds);
  s.axes.draw(drawables, seconds);
  s.charts.draw(drawables);
  if (watch && !(drawables.fields.empty() && drawables.charts.empty())) watch("fields");
}

void Renderer::State::drawScene(double seconds, const sim::Drawables& drawables, const StageWatch& watch) {
  State& s = *this;
  const auto issued = [&](const char* stage, bool any = true) {
    if (watch && any) watch(stage);
  };
  const bool instances = !drawables.instances.empty();
  s.skins.update(s.fieldTextures);
  if (s.shadow.on()) {
    s.shadow.fit(drawables, [&] { s.instances.growBounds(drawables); });
    s.instances.cullForLight(drawables);
    s.shadow.draw(drawables, [&] { s.instances.castShadows(drawables); });
    issued("shadow");
  }
  if (s.lampShadows.on()) {
    s.instances.cullForLamps(drawables);
    s.lampShadows.draw(drawables, [&](int cells) { s.instances.castLampShadows(drawables, cells); });
    issued("shadow");
  }
  s.instances.cull(drawables);
  issued("instances", instances);
  const bool cleared = s.resolve.needsClearedLight(drawables);
  s.targets.clear(cleared);
  s.targets.scene.bind();
  s.fields.draw(drawables, sim::FieldDisplay::Layer::behind, seconds);
  s.shadow.bind();
  s.lampShadows.bind();
  s.surfaces.draw(drawables, s.skins);
  issued("surfaces");
  s.instances.drawOpaque(drawables);
  issued("instances", instances);
  s.ground.draw();
  issued("ground", s.ground.on());
  s.instances.drawAdditive(drawables);
  if (s.resolve.on()) s.targets.finish();
  const GlowSums* glows = s.resolve.glows(drawables);
  if (glows != nullptr) s.instances.sumUp(drawables, s.targets.depth, *glows);
  issued("instances", instances);
  const gl::Texture& light = s.resolve.draw(s.targets, glows, cleared);
  const gl::Texture* scattered = s.bloom.on() ? &s.bloom.draw(light) : nullptr;
  issued("bloom", s.bloom.on());
  s.toneMap.draw(light, s.targets, scattered, s.scene.render.bloom.strength.at(seconds));
  issued("tone map");
}

const gl::Framebuffer& Renderer::target() const {
  return state_->targets.picture;
}

}  // namespace simreel::draw
