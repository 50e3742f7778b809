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
#include "draw/exact/scene/glass.hpp"
#include "draw/exact/scene/lamp_maps.hpp"
#include "draw/exact/surface/surface_shading.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/lens.hpp"
#include "draw/surface/shadow_pass.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace simreel::draw {

/// Arguments of ExactScene::draw(), valid during the call.
struct PictureRequest {
  const ExactScene::Exposure* exposure = nullptr;
  ExactScene::Moment frame;
  const ExactScene::Overlays* overlays = nullptr;
  const gl::Texture* picture = nullptr;
};

/// Resources that the passes of an exact picture share. A resource that only one pass uses is a member of
/// that pass.
struct ExactFrame {
  ExactFrame(const scene::Scene& shown, const Environment* around, glm::ivec2 pixels, int count, int rows);

  /// Returns the defines with which kernels shade.
  [[nodiscard]] ThingVariant lit() const;
  /// Returns the defines that describe lights and shadows.
  [[nodiscard]] gl::Defines lights() const;
  [[nodiscard]] gl::Defines aroundDefines() const;
  [[nodiscard]] bool traces() const { return scene.render.quality == scene::Quality::high; }
  [[nodiscard]] bool occludes() const { return scene.render.quality == scene::Quality::standard; }
  /// Returns the object that receives the pass outputs, or null if this view is not the first one. The pass
  /// outputs and most layers show only the first view of a picture. Light and object coverage are means
  /// over all views.
  [[nodiscard]] PassPicture* kept() const { return number == 0 ? passes : nullptr; }
  /// True if the picture or a requested layer shows texture coordinates.
  [[nodiscard]] bool showsUv() const {
    return scene.render.overlay == scene::Overlay::uv ||
           (wanted &&
            std::find(wanted->layers.begin(), wanted->layers.end(), Layer::uv) != wanted->layers.end());
  }
  /// True if the samples of a pixel are averaged linearly, as requested light is.
  [[nodiscard]] bool linear() const { return wanted && !wanted->filmed; }
  /// True if the picture shows fields behind the scene.
  [[nodiscard]] bool behindFields() const;
  /// True if the film and the bloom expand compressed light, because no pass before them reads or changes
  /// the light of opaque surfaces.
  [[nodiscard]] bool evensLast() const;
  [[nodiscard]] bool keepsLayers() const { return wanted && number == 0; }
  /// True if each pixel looks through lens points of its own beside the point of the view
  /// (glsl/draw/exact/screen/lens_shift.glsl).
  [[nodiscard]] bool shiftsLens() const { return scene.camera.lens && !visibility.layout().parallel; }
  /// Returns lensShift() of the current view. Only if shiftsLens().
  [[nodiscard]] glm::vec3 lensShiftNow() const {
    return lensShift(scene.camera, seen, size, point.focus, moment.seconds);
  }
  /// Returns the distance (m) from the camera to its target.
  [[nodiscard]] float away() const;
  [[nodiscard]] GroundPlace groundPlace() const;
  /// Returns the objects with primitive ids in the band.
  [[nodiscard]] std::vector<DrawnThing> thingsDrawn() const;
  /// Returns the shader inputs of kernels that add light to `into`.
  [[nodiscard]] SceneLight sceneLight(const gl::Texture& into) const;
  void tellView() { view.write(0, std::as_bytes(std::span(&values, 1))); }
  /// Adds the light of all opaque objects except the ground to `into`.
  void shadeThings(const gl::Texture& into);
  /// Adds the light of the ground to `into`. `which`: 0 for the tiles without shadow, 1 for the other
  /// tiles.
  void shadeGround(int which, const ShadeGround::Variant& variant, const gl::Texture& into);
  /// Selects a layer that is shaded instead of light (SurfaceShading::selectLayer).
  void selectLayer(int layer) {
    surfaces.selectLayer(layer);
    instances.selectLayer(layer);
  }
  /// Adds the path-traced light at the visible surface points (spots) of a band or of one of its blended
  /// layers.
  void addRays(const Visibility& visible) {
    rays->add(visible, light, linear(), values.rows.y - values.rows.x, white);
  }

  const scene::Scene& scene;
  const Environment* environment;  ///< sky image; null if the sky is a gradient
  glm::ivec2 size;
  int samples;
  int bandRows;  ///< max rows of a band, limited by the memory of the visibility buffer
  bool ground;

  // The following members are the state of one picture.
  PictureRequest asked;
  PassPicture* passes = nullptr;           ///< receives the pass outputs (bisect, test); null if they
                                           ///< are not needed
  std::optional<LightRequest> wanted;      ///< light and layers that the caller has requested
  PictureLayers layers;                    ///< receives the requested light and layers
  bool layered = false;                    ///< true if the scene has had blended surfaces at any time
  bool shines = false;                     ///< true if any view of the picture drawn so far had glows
  const gl::Texture* scattered = nullptr;  ///< light of the bloom; null if none exists

  // The following members are the state of one moment. A shutter has several moments.
  ExactScene::Moment moment;
  sim::Drawables drawables;  ///< the moment's objects, plus the glows of lamps, without cut-out, blended
                             ///< and clear surfaces
  View seen;
  bool joins = false;     ///< true if the surfaces are joined into one mesh
  bool mirrors = false;   ///< true if any object reflects the scene
  bool refining = false;  ///< true while reflections of single pixels are traced
  float white = 1;        ///< light that the picture shows as white

  // The following members are the state of one view. A lens has one view per lens point.
  int views = 1;   ///< number of views of the picture
  int number = 0;  ///< zero-based index of this view
  LensPoint point;

  // The following members are the state of one band of the view.
  shader::ExactView values;
  std::vector<std::span<const TriangleRaster::Drawn>> gathered;  ///< groups of surfaces that one dispatch
                                                                 ///< shades together
  std::vector<unsigned> firstIds;                                ///< first primitive id of each shaded
                                                                 ///< object

  // The following members are GPU resources.
  SkinTextures skins;
  Lamps lamps;
  ShadowPass shadow;  ///< the sun's shadow map transform
  gl::Buffer view;
  Visibility visibility;
  JoinedSurfaces joined;
  TriangleRaster triangles;
  std::optional<Visibility> sunMap;
  std::optional<LampMaps> lampMaps;
  const ShadedTiles* tiles = nullptr;  ///< for each object, the list of the band's tiles that show it
  Occlusion occlusion;                 ///< ambient occlusion and nearness at half resolution
  std::optional<Reflections> reflections;
  std::optional<ReflectedChanges> reflected;
  SurfaceShading surfaces;
  TransparentSurfaces transparent;
  GlassSurfaces glass;
  ExactInstances instances;
  gl::Kernels<ShadeGround> groundShading;
  std::optional<RayLight> rays;
  gl::Texture lensNearness;  ///< nearness of each pixel of the view, if the camera has a lens
  gl::Texture light;  ///< RGB light of each pixel; alpha: coverage, negative where the light is compressed
                      ///< (glsl/draw/exact/screen/edge_light.glsl)
};

/// Base class of all passes.
class FramePass : public Pass {
 public:
  explicit FramePass(ExactFrame& frame) : f(frame) {}

 protected:
  ExactFrame& f;
};

}  // namespace simreel::draw
