#include "base/ieee.hpp"
#include "draw/exact/scene/exact_frame.hpp"
#include "draw/exact/screen/bloom.hpp"
#include "draw/exact/screen/light_pictures.hpp"
#include "draw/frame_values.hpp"
#include "draw/rows_at_once.hpp"
#include "gl/kernel/kernel.hpp"

#include <string>

namespace simreel::draw {

struct FilmKernel {
  static constexpr auto file = "draw/exact/screen/picture.comp";
  struct Variant {
    gl::Flag<"PARALLEL"> parallel;
    gl::Flag<"TRANSPARENT"> transparent;
    gl::Flag<"BLOOM"> bloom;
    gl::Flag<"FAST_NUMERICS"> fast;
    gl::Range<"ROWS", 1, 8> rows;
    gl::Flag<"LINEAR"> linear = {};  ///< LINEAR: outputs light before the film; DEEP: outputs light as the
                                     ///< film shows it
    gl::Flag<"DEEP"> deep = {};
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::Ambient<"environment"> environment = {};
  gl::Uniform<"perSize", glm::vec2> perSize;
  gl::Uniform<"bloomStrength", float> bloomStrength;
  gl::Uniform<"white", float> white;
  gl::In<"sums"> light;
  gl::In<"scattered"> scattered;
  gl::Out<"picture"> picture;
};

namespace {

class FieldsBehindPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.behindFields(); }
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

/// Writes the picture. On request, also writes light, either before the film or as the film shows it.
class FilmPass final : public FramePass {
 public:
  explicit FilmPass(ExactFrame& frame) : FramePass(frame), picture_(defines(), variant()) {}
  void asked() override {
    FilmKernel::Variant deeper = variant();
    deeper.linear = !f.wanted->filmed;
    deeper.deep = f.wanted->filmed;
    linear_ = gl::Kernel<FilmKernel>(defines(), deeper);
    light_ = gl::Texture::image("light before the film", GL_RGBA32F, f.size.x, f.size.y);
  }
  void run() override {
    expose(picture_, *f.asked.picture);
    gl::barrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
    if (f.passes != nullptr) f.passes->keepBytes("picture", "film", *f.asked.picture);
    if (f.wanted) keepLight();
  }

 private:
  [[nodiscard]] gl::Defines defines() const;
  [[nodiscard]] FilmKernel::Variant variant() const {
    return {.parallel = isParallel(f.scene.camera),
            .transparent = f.scene.render.transparent,
            .bloom = Bloom::on(f.scene.render.bloom),
            .fast = f.scene.numerics == scene::Numerics::fast,
            .rows = rowsAtOnce()};
  }
  void expose(const gl::Kernel<FilmKernel>& kernel, const gl::Texture& into) const {
    kernel.dispatch({f.size.x, (f.size.y + rowsAtOnce() - 1) / rowsAtOnce()},
                    {.perSize = 2.0F / glm::vec2(f.size),
                     .bloomStrength = f.scene.render.bloom.strength.at(f.asked.frame.seconds),
                     .white = whiteLight(),
                     .light = f.light,
                     .scattered = f.scattered != nullptr ? *f.scattered : f.light,
                     .picture = into});
  }
  /// Returns the light of a white surface. Without blended surfaces, all light at the edges of objects
  /// belongs to the objects.
  [[nodiscard]] float whiteLight() const {
    if (!f.transparent.anyBlended()) return 6e4F;
    return static_cast<float>(
        ieee::exp2(-static_cast<double>(f.scene.render.exposure.at(f.asked.frame.seconds))));
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
    // Replaces -0 by 0, because min returns zeros of different sign on different devices.
    for (float& value : layers.light) value += 0.0F;
  }

  gl::Kernel<FilmKernel> picture_, linear_;
  gl::Texture light_;
};

gl::Defines FilmPass::defines() const {
  gl::Defines defines = lightDefines();
  for (auto& define : f.aroundDefines()) defines.push_back(std::move(define));
  for (auto& define : filmDefines(f.scene.render)) defines.push_back(std::move(define));
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
