#include "draw/renderer.hpp"

#include "draw/bloom_pass.hpp"
#include "draw/field_pass.hpp"
#include "draw/field_textures.hpp"
#include "draw/frame_values.hpp"
#include "draw/ground_pass.hpp"
#include "draw/instances_pass.hpp"
#include "draw/shadow_pass.hpp"
#include "draw/skin_textures.hpp"
#include "draw/surface_pass.hpp"
#include "draw/targets.hpp"
#include "draw/tone_map_pass.hpp"

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
        shadow(shown.sun),
        surfaces(shown, shadow),
        instances(shadow, targets.scene, samples),
        ground(shown, shadow),
        bloom(shown.render.bloom, pixels, samples),
        toneMap(samples, bloom.on()),
        frame("frame values", sizeof(shader::Frame)) {}

  const scene::Scene& scene;
  glm::ivec2 size;
  Targets targets;
  FieldTextures fieldTextures;
  SkinTextures skins;
  FieldPass fields;
  ShadowPass shadow;
  SurfacePass surfaces;
  InstancesPass instances;
  GroundPass ground;
  BloomPass bloom;
  ToneMapPass toneMap;
  gl::Buffer frame;

  /// All but what lies over the finished picture.
  void drawScene(double seconds, const sim::Drawables& drawables);
};

Renderer::Renderer(const scene::Scene& scene, glm::ivec2 size, int samples)
    : state_(std::make_unique<State>(scene, size, samples)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::draw(double seconds, const sim::Drawables& drawables) {
  State& s = *state_;
  const shader::Frame values = frameValues(s.scene, s.size, seconds);
  s.frame.write(0, std::as_bytes(std::span(&values, 1)));
  s.frame.bindUniform(0, 0, sizeof values);
  // Whatever the simulations wrote, vertex pulling and index fetch see it.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
  s.fieldTextures.update(drawables);
  s.fields.prepare(drawables, seconds);
  if (!s.fields.hidesAll(drawables, seconds)) s.drawScene(seconds, drawables);
  s.targets.picture.bind();
  s.fields.draw(drawables, sim::FieldDisplay::Layer::over, seconds);
}

void Renderer::State::drawScene(double seconds, const sim::Drawables& drawables) {
  State& s = *this;
  s.skins.update(s.fieldTextures);
  if (s.shadow.on()) {
    s.shadow.fit(drawables, [&] { s.instances.growBounds(drawables); });
    s.instances.cullForLight(drawables);
    s.shadow.draw(drawables, [&] { s.instances.castShadows(drawables); });
  }
  s.instances.cull(drawables);
  s.targets.clear();
  s.targets.scene.bind();
  s.fields.draw(drawables, sim::FieldDisplay::Layer::behind, seconds);
  s.shadow.bind();
  s.surfaces.draw(drawables, s.skins);
  s.instances.drawOpaque(drawables);
  s.ground.draw();
  s.instances.drawAdditive(drawables);
  const gl::Texture* glow = s.bloom.on() ? &s.bloom.draw(s.targets) : nullptr;
  s.toneMap.draw(s.targets, glow, s.scene.render.bloom.strength.at(seconds));
}

const gl::Framebuffer& Renderer::target() const {
  return state_->targets.picture;
}

}  // namespace simreel::draw
