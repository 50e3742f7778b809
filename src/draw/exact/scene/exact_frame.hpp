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

/// What a picture was asked for with; holds while it is drawn.
struct AskedPicture {
  const ExactScene::Exposure* exposure = nullptr;
  ExactScene::Moment frame;
  const ExactScene::Overlays* overlays = nullptr;
  const gl::Texture* picture = nullptr;
};

/// The resources that passes of an exact picture share. What one pass alone needs is in that pass.
struct ExactFrame {
  ExactFrame(const scene::Scene& shown, const Environment* around, glm::ivec2 pixels, int count, int rows);

  /// Defines of what shades.
  [[nodiscard]] gl::Defines lighting() const;
  [[nodiscard]] gl::Defines aroundDefines() const;
  [[nodiscard]] bool traces() const { return scene.render.quality == scene::Quality::high; }
  [[nodiscard]] bool occludes() const { return scene.render.quality == scene::Quality::standard; }
  /// Passes and layers are kept of the first view of a picture, light and objects' shares of the mean.
  [[nodiscard]] PassPicture* kept() const { return number == 0 ? passes : nullptr; }
  [[nodiscard]] bool keepsLayers() const { return wanted && number == 0; }
  /// m to what the camera looks at.
  [[nodiscard]] float away() const;
  [[nodiscard]] GroundPlace groundPlace() const;
  /// What has numbers in the band.
  [[nodiscard]] std::vector<DrawnThing> thingsDrawn() const;
  /// For kernels that add light.
  void bindLight() const { light.bindImage(sumImage, GL_READ_WRITE); }
  void bindShadows() const;
  void tellView() { view.write(0, std::as_bytes(std::span(&values, 1))); }
  /// Adds the light of all that is opaque but for the ground.
  void shadeThings();
  /// Shades a layer of the picture instead (SurfaceShading::show).
  void show(int layer) {
    surfaces.show(layer);
    instances.show(layer);
  }
  /// Adds the light of rays that begin where a band or a layer of it is visible.
  void addRays(const Visibility& visible) { rays->add(visible, light, values.rows.y - values.rows.x, white); }

  const scene::Scene& scene;
  const Environment* environment;  ///< null: the sky is a gradient
  glm::ivec2 size;
  int samples;
  int bandRows;  ///< of the picture at most, whose visibility there is at once
  bool ground;

  // The picture.
  AskedPicture asked;
  PassPicture* passes = nullptr;       ///< where they are kept
  std::optional<LightRequest> wanted;  ///< besides pictures,
  PictureLayers layers;                ///< and what came of it
  bool layered = false;                ///< whether what shades may be behind layers
  bool shines = false;                 ///< some of it adds light
  const gl::Texture* scattered = nullptr;

  // The moment: of a picture there may be several.
  ExactScene::Moment moment;
  sim::Drawables drawables;  ///< what is there, with the lamps' own light, without what is apart
  View seen;
  bool joins = false;    ///< its surfaces
  bool mirrors = false;  ///< some of it show the scene
  float white = 1;       ///< light that it shows as white

  // The view: of a moment there may be several, one for each point of the lens.
  int views = 1;   ///< of the picture
  int number = 0;  ///< of this one among them
  LensPoint point;
  shader::ExactView values;                                      ///< of its band,
  std::vector<std::span<const TriangleRaster::Drawn>> gathered;  ///< whose surfaces are shaded together,
  std::vector<unsigned> firstIds;                                ///< and first numbers of what is shaded

  // What is on the GPU.
  SkinTextures skins;
  Lamps lamps;
  ShadowPass shadow;  ///< the sun's place
  gl::Buffer view;
  Visibility visibility;
  JoinedSurfaces joined;
  TriangleRaster triangles;
  std::optional<Visibility> sunMap;
  std::optional<LampMaps> lampMaps;
  const ShadedTiles* tiles = nullptr;  ///< of the band
  Occlusion occlusion;                 ///< nearness and openness
  std::optional<Reflections> reflections;
  SurfaceShading surfaces;
  ApartSurfaces apart;
  ExactInstances instances;
  std::optional<RayLight> rays;
  gl::Texture light;  ///< of each pixel, and in alpha how much of it is covered
};

/// What all passes begin with.
class FramePass : public Pass {
 public:
  explicit FramePass(ExactFrame& frame) : f(frame) {}

 protected:
  ExactFrame& f;
};

}  // namespace simreel::draw
