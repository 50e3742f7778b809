#pragma once
#include "draw/exact/bindings.hpp"
#include "draw/exact/exact_view.hpp"
#include "draw/exact/instances/exact_instances.hpp"
#include "draw/exact/occlusion/occlusion.hpp"
#include "draw/exact/pass_list.hpp"
#include "draw/exact/rays/ray_light.hpp"
#include "draw/exact/reflections/reflections.hpp"
#include "draw/exact/scene/apart.hpp"
#include "draw/exact/scene/exact_scene.hpp"
#include "draw/exact/scene/lamp_maps.hpp"
#include "draw/exact/surface/surface_shading.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/lens.hpp"
#include "draw/surface/shadow_pass.hpp"

#include <optional>
#include <span>
#include <vector>

namespace simreel::draw {

/// The arguments of ExactScene::draw, while it runs.
struct AskedPicture {
  const ExactScene::Exposure* exposure = nullptr;
  ExactScene::Moment frame;
  const ExactScene::Overlays* overlays = nullptr;
  const gl::Texture* picture = nullptr;
};

/// The resources that passes of an exact picture share. A resource that one pass alone uses is a member of
/// that pass.
struct ExactFrame {
  ExactFrame(const scene::Scene& shown, const Environment* around, glm::ivec2 pixels, int count, int rows);

  /// How kernels shade.
  [[nodiscard]] ThingVariant lit() const;
  /// Defines of the lights and the shadows.
  [[nodiscard]] gl::Defines lights() const;
  [[nodiscard]] gl::Defines aroundDefines() const;
  [[nodiscard]] bool traces() const { return scene.render.quality == scene::Quality::high; }
  [[nodiscard]] bool occludes() const { return scene.render.quality == scene::Quality::standard; }
  /// Passes and layers show the first view of a picture; light and objects' shares are a mean over all.
  [[nodiscard]] PassPicture* kept() const { return number == 0 ? passes : nullptr; }
  [[nodiscard]] bool keepsLayers() const { return wanted && number == 0; }
  /// Distance (m) to the place that the camera looks at.
  [[nodiscard]] float away() const;
  [[nodiscard]] GroundPlace groundPlace() const;
  /// The things that have numbers in the band.
  [[nodiscard]] std::vector<DrawnThing> thingsDrawn() const;
  /// For kernels that add light to `into`.
  [[nodiscard]] SceneLight sceneLight(const gl::Texture& into) const;
  void tellView() { view.write(0, std::as_bytes(std::span(&values, 1))); }
  /// Adds the light of all opaque things, without the ground.
  void shadeThings(const gl::Texture& into);
  /// Adds the light of the ground where no shadow reaches it (0), or elsewhere (1).
  void shadeGround(int which, const ShadeGround::Variant& variant, const gl::Texture& into);
  /// Shades a layer of the picture instead (SurfaceShading::show).
  void show(int layer) {
    surfaces.show(layer);
    instances.show(layer);
  }
  /// Adds the light of rays that begin at the visible places of a band, or of a layer of it.
  void addRays(const Visibility& visible) {
    rays->add(visible, light, values.rows.y - values.rows.x, white);
  }

  const scene::Scene& scene;
  const Environment* environment;  ///< null: the sky is a gradient
  glm::ivec2 size;
  int samples;
  int bandRows;  ///< rows of a band at most: there is room for so many rows of visibility
  bool ground;

  // One picture.
  AskedPicture asked;
  PassPicture* passes = nullptr;           ///< takes copies for bisect; null: nobody wants them
  std::optional<LightRequest> wanted;      ///< light and layers besides the picture,
  PictureLayers layers;                    ///< and where they go
  bool layered = false;                    ///< some scene so far had blended surfaces
  bool shines = false;                     ///< some view so far had glows
  const gl::Texture* scattered = nullptr;  ///< light around bright places; null: no bloom

  // One moment: a shutter has several.
  ExactScene::Moment moment;
  sim::Drawables drawables;  ///< the moment's, with the glows of lamps, without cut and blended surfaces
  View seen;
  bool joins = false;    ///< the surfaces are joined
  bool mirrors = false;  ///< something mirrors the scene
  float white = 1;       ///< light that the picture shows as white

  // One view: a lens has several, one for each of its points.
  int views = 1;   ///< their number in the picture
  int number = 0;  ///< this one's, from 0
  LensPoint point;

  // One band of the view.
  shader::ExactView values;
  std::vector<std::span<const TriangleRaster::Drawn>> gathered;  ///< groups of surfaces, shaded together
  std::vector<unsigned> firstIds;                                ///< first numbers of all that is shaded

  // On the GPU.
  SkinTextures skins;
  Lamps lamps;
  ShadowPass shadow;  ///< the sun's place
  gl::Buffer view;
  Visibility visibility;
  JoinedSurfaces joined;
  TriangleRaster triangles;
  std::optional<Visibility> sunMap;
  std::optional<LampMaps> lampMaps;
  const ShadedTiles* tiles = nullptr;  ///< the band's lists
  Occlusion occlusion;                 ///< nearness and openness
  std::optional<Reflections> reflections;
  SurfaceShading surfaces;
  ApartSurfaces apart;
  ExactInstances instances;
  gl::Kernels<ShadeGround> groundShading;
  std::optional<RayLight> rays;
  gl::Texture light;  ///< RGB of each pixel; alpha: how much of the pixel is covered
};

/// Base of all passes.
class FramePass : public Pass {
 public:
  explicit FramePass(ExactFrame& frame) : f(frame) {}

 protected:
  ExactFrame& f;
};

}  // namespace simreel::draw
