#include "draw/exact/motion/velocities.hpp"
#include "draw/exact/scene/exact_frame.hpp"
#include "draw/exact/scene/share_keeper.hpp"
#include "draw/exact/shown.hpp"
#include "draw/frame_values.hpp"

#include <algorithm>
#include <array>

namespace simreel::draw {

struct LensSources {
  static constexpr auto file = "draw/exact/screen/lens_sources.comp";
  gl::Ambient<"ViewBlock"> view = {};
  gl::Uniform<"number", int> number;
  gl::Uniform<"lens", glm::vec3> lens;
  gl::In<"nearness"> nearness;
  gl::Out<"sources"> sources;
};

namespace {

/// Creates the requested layers. Normals and albedo are shaded like light; the other layers are computed
/// from visibility. All layers show the first view, except that object coverage is a mean over all views.
class LayersPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.wanted && (f.number == 0 || shares_); }
  void asked() override;
  void run() override;

 private:
  [[nodiscard]] bool wants(Layer layer) const {
    return std::find(f.wanted->layers.begin(), f.wanted->layers.end(), layer) != f.wanted->layers.end();
  }
  [[nodiscard]] bool shifts() const { return f.views > 1 && f.shiftsLens(); }
  void begin();
  void keepVisible(const std::vector<DrawnThing>& things);
  void countShifted();
  void shade();
  void keepShown();
  [[nodiscard]] std::optional<Velocities> velocitiesNow() const;
  [[nodiscard]] std::optional<CameraWay> cameraWayNow() const;

  std::optional<LayerKeeper> visible_;
  std::optional<CoverageCounter> shares_;
  gl::Kernel<LensSources> shift_;
  gl::Texture sources_;  ///< four pixels of the view for each pixel
  std::array<gl::Texture, shownLayers.size()> shown_;
};

void LayersPass::asked() {
  if (f.shiftsLens() && wants(Layer::object)) {
    shift_ = gl::Kernel<LensSources>(gl::Defines());
    sources_ = gl::Texture::image("pixels seen through the lens", GL_RGBA32UI, f.size.x, f.size.y);
  }
  for (std::size_t i = 0; i < shownLayers.size(); ++i)
    if (wants(shownLayers[i]))
      shown_[i] = gl::Texture::image("a layer of the picture", GL_RGBA32F, f.size.x, f.size.y);
}

void LayersPass::run() {
  const bool firstBand = f.values.rows.x == 0, lastBand = f.values.rows.y == f.size.y;
  const bool first = f.number == 0;
  if (first && firstBand) begin();
  const std::vector<DrawnThing> things = f.thingsDrawn();
  if (first) keepVisible(things);
  if (shares_) shares_->add(f.visibility.readNumbers(), f.values, things);
  if (first) shade();
  if (first && lastBand) keepShown();
  if (shares_ && lastBand && shifts()) countShifted();
  if (!lastBand || f.number + 1 < f.views) return;
  if (shares_) shares_->finish(f.layers, f.views);
  shares_.reset();
}

void LayersPass::begin() {
  constexpr std::array<GLfloat, 4> none = {0, 0, 0, 0};
  visible_.emplace(f.layers, f.wanted->layers, f.size, f.samples);
  shares_.reset();
  if (wants(Layer::object)) shares_.emplace(f.size, f.samples, shifts());
  for (const gl::Texture& layer : shown_)
    if (layer) glClearTexImage(layer.name(), 0, GL_RGBA, GL_FLOAT, none.data());
}

void LayersPass::keepVisible(const std::vector<DrawnThing>& things) {
  const std::optional<Velocities> velocities = velocitiesNow();
  const std::optional<CameraWay> way = cameraWayNow();
  visible_->add(f.visibility, f.values, things, velocities ? &*velocities : nullptr, way ? &*way : nullptr,
                f.seen.farther);
}

/// Counts the samples of the view that each pixel shows through lens points of its own.
void LayersPass::countShifted() {
  std::vector<glm::uvec4> from(static_cast<std::size_t>(f.size.x) * static_cast<std::size_t>(f.size.y));
  gl::barrier();
  shift_.dispatch(
      f.size,
      {.number = f.number, .lens = f.lensShiftNow(), .nearness = f.lensNearness, .sources = sources_});
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glGetTextureImage(sources_.name(), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                    static_cast<GLsizei>(from.size() * sizeof(glm::uvec4)), from.data());
  shares_->countView(from);
}

void LayersPass::shade() {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (!shown_[i]) continue;
    const int layer = static_cast<int>(i) + 1;
    f.selectLayer(layer);
    f.shadeThings(shown_[i]);
    if (!f.ground) continue;
    const ShadeGround::Variant ground{.shade = showing(f.lit(), layer, true).shade, .shadowed = false};
    f.shadeGround(0, ground, shown_[i]);
    if (f.shadow.on()) f.shadeGround(1, ground, shown_[i]);
  }
  f.selectLayer(0);
  gl::barrier();
}

void LayersPass::keepShown() {
  std::vector<float> sum(4 * static_cast<std::size_t>(f.size.x) * static_cast<std::size_t>(f.size.y));
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (!shown_[i]) continue;
    glGetTextureImage(shown_[i].name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(sum.size() * sizeof(float)), sum.data());
    f.layers.keepShown(shownLayers[i], sum);
  }
}

/// Collects the motion of all objects with primitive ids. The drawn surfaces are copies of the moment's
/// surfaces. A copy is matched with its original by their buffers.
std::optional<Velocities> LayersPass::velocitiesNow() const {
  const ExactScene::Exposure& exposure = *f.asked.exposure;
  if (exposure.motion == nullptr || (!wants(Layer::velocity) && !wants(Layer::vector))) return std::nullopt;
  const sim::Drawables& atMoment = *f.moment.drawables;
  Velocities velocities(*exposure.motion, exposure.frameSeconds, exposure.part);
  const auto add = [&](const TriangleRaster::Drawn& drawn) {
    const auto same = [&](const sim::Surface& surface) {
      return surface.positions == drawn.surface->positions && surface.indices == drawn.surface->indices &&
             surface.model == drawn.surface->model && surface.object == drawn.surface->object;
    };
    const auto found = std::find_if(atMoment.surfaces.begin(), atMoment.surfaces.end(), same);
    if (found != atMoment.surfaces.end())
      velocities.addSurface(*found, static_cast<std::size_t>(found - atMoment.surfaces.begin()),
                            drawn.firstId, drawn.maxTriangles);
  };
  for (const TriangleRaster::Drawn& drawn : f.triangles.drawn()) add(drawn);
  for (const TriangleRaster::Drawn& drawn : f.transparent.drawn()) add(drawn);
  for (const ExactInstances::Numbered& drawn : f.instances.numbered()) {
    const auto same = [&](const sim::Instances& one) {
      return one.positions == drawn.instances->positions && one.object == drawn.instances->object;
    };
    const auto found = std::find_if(atMoment.instances.begin(), atMoment.instances.end(), same);
    if (found != atMoment.instances.end())
      velocities.addInstances(static_cast<std::size_t>(found - atMoment.instances.begin()), drawn.firstId,
                              drawn.each);
  }
  return velocities;
}

/// Returns the camera's current view and the view one frame earlier, or nothing if the vector layer is not
/// requested.
std::optional<CameraWay> LayersPass::cameraWayNow() const {
  const ExactScene::Exposure& exposure = *f.asked.exposure;
  if (exposure.motion == nullptr || !wants(Layer::vector)) return std::nullopt;
  const scene::Camera& camera = f.scene.camera;
  const double seconds = exposure.frameSeconds;
  const View now = viewAt(camera, f.moment.seconds, f.size, *f.moment.drawables, visibleGround(f.scene));
  const View before = viewAt(camera, f.moment.seconds - seconds, f.size,
                             exposure.motion->cameraAt(exposure.part - 1), visibleGround(f.scene));
  return CameraWay{exactView(now, camera, f.size), exactView(before, camera, f.size), seconds};
}

}  // namespace

std::unique_ptr<Pass> makeLayers(ExactFrame& frame) {
  return std::make_unique<LayersPass>(frame);
}

}  // namespace simreel::draw
