#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/exact/instances/exact_instances.hpp"
#include "draw/exact/motion/velocities.hpp"
#include "draw/exact/occlusion/occlusion.hpp"
#include "draw/exact/rays/ray_light.hpp"
#include "draw/exact/reflections/reflections.hpp"
#include "draw/exact/scene/apart.hpp"
#include "draw/exact/scene/exact_scene.hpp"
#include "draw/exact/scene/lamp_maps.hpp"
#include "draw/exact/scene/share_keeper.hpp"
#include "draw/exact/screen/bloom.hpp"
#include "draw/exact/screen/light_pictures.hpp"
#include "draw/exact/surface/surface_shading.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/frame_values.hpp"
#include "draw/rows_at_once.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "draw/surface/surface_pass.hpp"

#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::draw {

/// What exact_scene.cpp makes and finishes pictures with, exposure.cpp exposes them by, bands.cpp lights
/// bands of them with, and kept.cpp keeps of them.
struct ExactScene::State {
  State(const scene::Scene& shown, const Environment* around, glm::ivec2 pixels, int count, int rows);

  /// Defines of what shades.
  [[nodiscard]] gl::Defines lighting(int count) const {
    gl::Defines defines = definesOf(visibility.layout());
    if (scene.numerics == scene::Numerics::fast) defines.emplace_back("FAST_NUMERICS", "1");
    defines.emplace_back("SAMPLES", std::to_string(count));
    defines.emplace_back("ROWS", std::to_string(rowsAtOnce()));
    if (occludes()) defines.emplace_back("OCCLUSION", "1");
    if (occludes() && ground) {
      defines.emplace_back("GROUND_BELOW", "1");
      if (isReflective(scene.ground)) defines.emplace_back("GROUND_REFLECTIVE", "1");
    }
    if (layered) defines.emplace_back("BEHIND", "1");
    if (traces()) {
      defines.emplace_back("RAYS", "1");
      return defines;
    }
    for (const gl::Defines& more : {shadow.defines(), lamps.defines(), aroundDefines()})
      defines.insert(defines.end(), more.begin(), more.end());
    return defines;
  }
  /// Of what lights by rays.
  [[nodiscard]] gl::Defines rayLighting(int count) const {
    gl::Defines defines = lighting(count);
    for (const gl::Defines& more : {lamps.defines(), aroundDefines()})
      defines.insert(defines.end(), more.begin(), more.end());
    return defines;
  }
  [[nodiscard]] bool traces() const { return scene.render.quality == scene::Quality::high; }
  [[nodiscard]] bool occludes() const { return scene.render.quality == scene::Quality::standard; }
  [[nodiscard]] gl::Defines aroundDefines() const {
    return environment == nullptr ? gl::Defines() : environment->defines();
  }
  [[nodiscard]] gl::Defines pictureDefines() const {
    gl::Defines defines = lightDefines();
    if (isParallel(scene.camera)) defines.emplace_back("PARALLEL", "1");
    for (auto& define : aroundDefines()) defines.push_back(std::move(define));
    for (auto& define : filmDefines(scene.render)) defines.push_back(std::move(define));
    if (scene.render.transparent) defines.emplace_back("TRANSPARENT", "1");
    defines.emplace_back("ROWS", std::to_string(rowsAtOnce()));
    if (bloom.on()) defines.emplace_back("BLOOM", "1");
    if (scene.numerics == scene::Numerics::fast) defines.emplace_back("FAST_NUMERICS", "1");
    return defines;
  }
  void sayFinishes(const sim::Drawables& drawables);
  void makeGround();
  void beginLayers();
  void drawShadows(const sim::Drawables& drawables);
  std::vector<unsigned> findVisible(const sim::Drawables& drawables);
  [[nodiscard]] GroundPlace groundPlace(const shader::ExactView& values) const;
  void findOpenness(const shader::ExactView& values, const Watch& watch);
  void drawBand(const sim::Drawables& drawables, const shader::ExactView& values, const Watch& watch);
  void drawThrough(const sim::Drawables& drawables, shader::ExactView values, const Watch& watch);
  void addThrough(int number, int pictures);
  View prepare(const Moment& moment, sim::Drawables& drawables, const Watch& watch);
  void buildRays(const sim::Drawables& drawables);
  bool expose(const Exposure& exposure, const Watch& watch);
  void gather();
  void bindShadows() const;
  void shadeAll();
  void keepVisibility(glm::ivec2 rows) const;
  [[nodiscard]] std::vector<DrawnThing> thingsDrawn() const;
  void keepLayers(const shader::ExactView& values);
  [[nodiscard]] std::optional<Velocities> velocitiesNow() const;
  [[nodiscard]] std::optional<CameraWay> cameraWayNow() const;
  void keepLight();
  void shadeThings(const ShadedTiles& on);
  [[nodiscard]] bool anyMirrors(const sim::Drawables& drawables) const;
  void shadeReflections(const ShadedTiles& on);
  void addReflections(const sim::Drawables& drawables, const shader::ExactView& values);
  void finishBand(const sim::Drawables& drawables, glm::ivec2 rows, const Watch& watch);
  void shadeShown();
  void clearShown() const;
  void keepShown();

  const scene::Scene& scene;
  const Environment* environment;  ///< null: the sky is a gradient
  glm::ivec2 size;
  int samples;
  int bandRows;  ///< of the picture at most, whose visibility there is at once
  bool ground;
  bool layered = false;  ///< whether what shades may be behind layers
  SkinTextures skins;
  Lamps lamps;
  ShadowPass shadow;
  gl::Buffer view;
  std::set<std::string> said;  ///< objects of whose materials something is not drawn
  Visibility visibility;
  JoinedSurfaces joined;
  bool joins = false;  ///< the surfaces of this picture
  TriangleRaster triangles;
  std::vector<std::span<const TriangleRaster::Drawn>> gathered;  ///< surfaces that are shaded together
  std::optional<Visibility> map;
  std::optional<TriangleRaster> casters;
  std::optional<LampMaps> lampMaps;
  ShadedTiles tiles;
  Occlusion occlusion;
  float farther = 0;                       ///< m that the moment's eye stands back (View::farther)
  float occlusionRadius = 0;               ///< of this picture (m)
  std::optional<Reflections> reflections;  ///< from the first picture on that has mirrors
  bool mirrors = false;                    ///< some of this picture show the scene
  std::optional<ShadedTiles> again;        ///< of bands that are found once more for them,
  gl::Texture unused;                      ///< where layers' light goes then
  float white = 1;                         ///< light that it shows as white
  SurfaceShading surfaces;
  ApartSurfaces apart;
  unsigned numbers = 0;  ///< that have been given in this band
  ExactInstances instances;
  std::optional<RayLight> rays;
  Bloom bloom;
  gl::Program litGround, shadedGround, mirrorGround, lensSum, picture;
  std::array<gl::Program, shownLayers.size()> shownGround;
  std::array<gl::Texture, shownLayers.size()> shown;  ///< those of its layers that are wanted
  PassPicture* passes = nullptr;                      ///< where they are kept
  std::optional<LightRequest> wanted;                 ///< besides pictures
  PictureLayers layers;
  std::optional<LayerKeeper> layerKeeper;  ///< while the layers' view is drawn,
  std::optional<ShareKeeper> shareKeeper;  ///< while views are drawn that objects' shares are of,
  const Exposure* exposed = nullptr;       ///< and of what the layers' is the first moment,
  const sim::Drawables* there = nullptr;   ///< of which these are,
  double exposedSeconds = 0;               ///< at that time
  gl::Program linear;                      ///< of those alone
  gl::Texture light;
  gl::Texture sums;          ///< light of each pixel, and in alpha how much of it is covered
  gl::Texture total;         ///< of moments and points of the lens so far, if there are several
  shader::ExactView middle;  ///< of the first moment, where there are several of them
};

}  // namespace simreel::draw
