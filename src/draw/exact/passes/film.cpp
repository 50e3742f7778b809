#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_frame.hpp"
#include "draw/exact/screen/bloom.hpp"
#include "draw/exact/screen/light_pictures.hpp"
#include "draw/frame_values.hpp"
#include "draw/rows_at_once.hpp"
#include "sim/grid/field_display.hpp"

#include <algorithm>
#include <string>

namespace simreel::draw {

namespace {

class FieldsBehindPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override {
    const std::vector<sim::Field>& fields = f.asked.frame.drawables->fields;
    return std::any_of(fields.begin(), fields.end(), [](const sim::Field& field) {
      return field.display != nullptr && field.display->layer == sim::FieldDisplay::Layer::behind;
    });
  }
  void run() override {
    f.asked.overlays->fields.drawBehind(*f.asked.frame.drawables, f.asked.frame.seconds, f.light, true);
    if (f.passes != nullptr) f.passes->keepLight("glow", "fields", f.light, {0, f.size.y});
  }
};

class ScatterPass final : public FramePass {
 public:
  explicit ScatterPass(ExactFrame& frame)
      : FramePass(frame), bloom_(frame.scene.render.bloom, frame.size) {}
  [[nodiscard]] bool on() const override { return bloom_.on(); }
  void run() override {
    f.scattered = &bloom_.draw(f.light);
    if (f.passes != nullptr) f.passes->keepLight("bloom", "", *f.scattered, {0, f.scattered->height()});
  }

 private:
  Bloom bloom_;
};

/// Makes the picture; and, if somebody asked for it, the light before the film or as the film shows it.
class FilmPass final : public FramePass {
 public:
  explicit FilmPass(ExactFrame& frame)
      : FramePass(frame), picture_(gl::Program::compute("draw/exact/screen/picture.comp", defines())) {}
  void asked() override {
    gl::Defines more = defines();
    more.emplace_back(f.wanted->filmed ? "DEEP" : "LINEAR", "1");
    linear_ = gl::Program::compute("draw/exact/screen/picture.comp", more);
    light_ = gl::Texture::image("light before the film", GL_RGBA32F, f.size.x, f.size.y);
  }
  void run() override {
    if (f.scattered != nullptr) bindLight(*f.scattered, bloomUnit, scatteredImage);
    bindLight(f.light, sceneUnit, lightImage);
    expose(picture_, *f.asked.picture);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
    if (f.passes != nullptr) f.passes->keepBytes("picture", "film", *f.asked.picture);
    if (f.wanted) keepLight();
  }

 private:
  [[nodiscard]] gl::Defines defines() const;
  void expose(const gl::Program& program, const gl::Texture& into) const {
    if (f.scattered != nullptr)
      program.set("bloomStrength", f.scene.render.bloom.strength.at(f.asked.frame.seconds));
    into.bindImage(pictureImage, GL_WRITE_ONLY);
    program.set("perSize", 2.0F / glm::vec2(f.size));
    program.dispatch(f.size.x, (f.size.y + rowsAtOnce() - 1) / rowsAtOnce());
  }
  void keepLight() {
    expose(linear_, light_);
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    PictureLayers& layers = f.layers;
    layers.alpha = f.scene.render.transparent;
    layers.filmed = f.wanted->filmed;
    layers.bits = f.wanted->bits;
    layers.light.resize(4 * static_cast<std::size_t>(f.size.x) * static_cast<std::size_t>(f.size.y));
    glGetTextureImage(light_.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(layers.light.size() * sizeof(float)), layers.light.data());
    // Which of two zeros a minimum is, devices may choose.
    for (float& value : layers.light) value += 0.0F;
  }

  gl::Program picture_, linear_;
  gl::Texture light_;
};

gl::Defines FilmPass::defines() const {
  gl::Defines defines = lightDefines();
  if (isParallel(f.scene.camera)) defines.emplace_back("PARALLEL", "1");
  for (auto& define : f.aroundDefines()) defines.push_back(std::move(define));
  for (auto& define : filmDefines(f.scene.render)) defines.push_back(std::move(define));
  if (f.scene.render.transparent) defines.emplace_back("TRANSPARENT", "1");
  defines.emplace_back("ROWS", std::to_string(rowsAtOnce()));
  if (Bloom::on(f.scene.render.bloom)) defines.emplace_back("BLOOM", "1");
  if (f.scene.numerics == scene::Numerics::fast) defines.emplace_back("FAST_NUMERICS", "1");
  return defines;
}

}  // namespace

std::unique_ptr<Pass> makeFieldsBehind(ExactFrame& frame) {
  return std::make_unique<FieldsBehindPass>(frame);
}
std::unique_ptr<Pass> makeScatter(ExactFrame& frame) {
  return std::make_unique<ScatterPass>(frame);
}
std::unique_ptr<Pass> makeFilm(ExactFrame& frame) {
  return std::make_unique<FilmPass>(frame);
}

}  // namespace simreel::draw
