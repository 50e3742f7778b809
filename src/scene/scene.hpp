#pragma once
#include "scene/finish.hpp"
#include "scene/haze.hpp"
#include "scene/light.hpp"
#include "scene/test.hpp"
#include "scene/value/animated.hpp"
#include "scene/value/fields.hpp"
#include "scene/value/path_place.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::scene {

enum class Numerics { exact, fast };

/// Material that is generated from a simulated field and drawn on an object's surface.
struct Skin {
  enum class Look {
    leather,
    spots,
    cracks,
    map
  };  ///< Style of the skin. `map` shows the field in the
      ///< field's colours.
  enum class Projection { uv, triplanar };
  std::string field;  ///< name of the object whose field is used
  Look look = Look::leather;
  Projection projection = Projection::uv;
  float repeats = 1.0F;  ///< number of repeats of the field along u and v; on a surface without uv
                         ///< (triplanar mapping), number of repeats per metre
  /// Field value at the boundary between low and high colour. nullopt: default of `look`.
  std::optional<double> threshold;
  glm::vec3 low{-1};                ///< linear RGB for low field values; a negative value means the default
                                    ///< of `look`
  glm::vec3 high{-1};               ///< linear RGB for high field values; a negative value means the
                                    ///< default of `look`
  float bump = 1.0F;                ///< factor on the height of the relief
  std::optional<double> roughness;  ///< surface roughness; nullopt: default of `look`
  void describe(Fields& fields);
};

/// Surface with metallic/roughness shading. Colours are linear RGB.
struct Material {
  glm::vec3 color{0.8F, 0.7F, 0.6F};
  std::filesystem::path texture;  ///< file of an sRGB image that is multiplied by the colour; empty if
                                  ///< there is none
  /// Number of repeats along u and v, or per metre on surfaces without uv. z is unused.
  glm::vec3 textureScale{1, 1, 1};
  float roughness = 0.8F;
  float metallic = 0.0F;
  float translucency = 0.0F;  ///< fraction of light from behind that shines through
  float bump = 0.0F;          ///< height in metres of white texels above black texels
  bool castsShadow = true;    ///< true if the surface casts shadows in the light of the sun and the lights
  std::optional<Skin> skin;   ///< generated material that replaces colour and roughness
  Finish finish;
  void describe(Fields& fields);
};

/// Light that scatters around bright areas of the picture.
struct Bloom {
  Animated<float> strength = 0.0F;  ///< fraction of the light above the threshold that is scattered; 0
                                    ///< turns bloom off
  float threshold = 1.0F;           ///< threshold in linear light, above which light is scattered
  float radius = 0.1F;              ///< radius of the scattering as a fraction of the picture's height
  void describe(Fields& fields);
};

/// Method of drawing. exact: compute kernels, whose pictures have the same bytes on every machine. driver:
/// OpenGL's rasterizer.
enum class Rasterizer { exact, driver };

/// Quality of lighting. draft: direct light, and ambient light without occlusion. standard: adds ambient
/// occlusion and screen-space reflections. high: ray tracing.
enum class Quality { draft, standard, high };

/// Tone curve from linear light to pixel values (glsl/draw/screen/film.glsl).
enum class Tone { aces, agx, filmic, plain };

/// Property that pictures show instead of light.
enum class Overlay : std::uint8_t { none, wireframe, normals, uv, objects };

struct Render {
  Rasterizer rasterizer = Rasterizer::exact;
  Quality quality = Quality::draft;
  bool hasQuality = false;  ///< true if the scene gives "quality"
  Overlay overlay = Overlay::none;
  /// Radius of ambient occlusion in metres. nullopt: a sixth of the distance from the camera to the target.
  std::optional<double> occlusionRadius;
  int raySamples = 64;         ///< number of light samples per pixel with Quality::high
  glm::ivec2 size{1280, 720};  ///< width and height in pixels
  /// Number of samples per pixel: 1, 2, 4, 8 or 16. The driver's rasterizer may support only 1 and 4.
  int samples = 4;
  Animated<float> exposure = 0.0F;  ///< exposure value (EV); +1 doubles the brightness
  Tone tone = Tone::aces;
  /// White balance in kelvin: light of this black-body colour is shown as white.
  std::optional<Animated<float>> whiteBalance;
  bool transparent = false;  ///< true if pictures have an alpha channel instead of a background
  float vignette = 0.0F;
  Bloom bloom;
  void describe(Fields& fields);
};

struct Time {
  double fps = 60.0;
  double start = 0.0;     ///< simulated time before frame 0 in seconds
  double duration = 2.0;  ///< length in seconds; frames = round(duration * fps), at least 1
  void describe(Fields& fields);
};

/// Camera that moves along a path found by an object.
struct Follow : PathPlace {
  float ahead = 4.0F;  ///< length in metres of the part of the path ahead of the camera; the camera looks
                       ///< at the mean of the points of this part
  double damping = 0;  ///< time in seconds that the camera lags behind steady motion; 0 means no lag
  void describe(Fields& fields);
};

/// Camera that keeps looking at a moving object.
struct Track {
  std::string object;
  glm::vec3 offset{0};  ///< offset in metres from the object's centre to the point that the camera looks at
  double damping = 0;   ///< time in seconds that the camera lags behind a steadily moving object; 0 means
                        ///< no lag
  void describe(Fields& fields);
};

/// Position and orientation of a camera at one moment.
struct CameraPose {
  glm::dvec3 eye{0};
  /// Axes of the camera: unit vectors, orthogonal to each other.
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
};

/// Motion of a camera that comes from a file. Several threads may use one object at once.
class CameraShot {
 public:
  virtual ~CameraShot() = default;
  /// Returns the pose at the scene's time `seconds`.
  [[nodiscard]] virtual CameraPose at(double seconds) const = 0;
  /// Returns the vertical angle of view in degrees. Only for perspective cameras.
  [[nodiscard]] virtual double fieldOfView() const = 0;
  /// Returns the height of the view in metres, or nullopt for a perspective camera.
  [[nodiscard]] virtual std::optional<double> height() const = 0;
  [[nodiscard]] virtual double near() const = 0;  ///< Returns the distance of the near plane in metres.
  /// Returns the distance of the far plane in metres, or nullopt if it is unlimited.
  [[nodiscard]] virtual std::optional<double> far() const = 0;
};

/// Camera whose pose and motion come from a glTF file.
struct CameraFile {
  std::filesystem::path file;
  std::string name;       ///< name of the camera or of the camera's node; if empty, the file must contain
                          ///< exactly one camera
  std::string animation;  ///< name of the animation; if empty, the first animation that moves the camera is
                          ///< used
  double speed = 1, start = 0;
  bool loop = false;
  float distance = 6;                    ///< distance from the camera to its target along the line of
                                         ///< sight, in metres
  bool hasNear = false, hasFar = false;  ///< true if the scene itself gives near or far
  std::shared_ptr<const CameraShot> shot = {};  ///< the file's camera; null until the file has been read
  void describe(Fields& fields);
};

/// Depth of field of a camera.
struct Lens {
  Animated<float> fNumber = 2.8F;  ///< f-number (focal length divided by aperture diameter) for a sensor 24
                                   ///< mm high
  /// Focus distance in metres along the line of sight; nullopt means the distance of the target.
  std::optional<Animated<float>> focus;
  int blades = 0;    ///< number of sides of the aperture polygon; 0 means a round aperture
  int samples = 32;  ///< number of points of the aperture from which each picture is drawn
  void describe(Fields& fields);
};

/// Exposure time of a picture. Objects that move during the exposure are blurred.
struct Shutter {
  float angle = 180.0F;  ///< exposure time in degrees; 360 is the interval between two frames
  int samples = 16;      ///< number of moments within the exposure at which each picture is drawn
  void describe(Fields& fields);
};

/// Orbit of a camera around its target.
struct Orbit {
  Animated<float> turn = 0.0F;        ///< angle about the vertical in degrees, from +z towards +x
  Animated<float> elevation = 20.0F;  ///< elevation of the camera above the horizon in degrees, seen from
                                      ///< the target
  Animated<float> distance = 6.0F;    ///< distance from the target in metres
  bool distanced = false;             ///< true if the scene gives the distance of the orbit
  void describe(Fields& fields);
};

/// Type of a camera's rays. perspective: all rays start at one point. orthographic: all rays are parallel
/// and perpendicular to the picture.
enum class Projection { perspective, orthographic };

struct Camera {
  Animated<glm::vec3> position = glm::vec3(0, 1.5F, 6);
  Animated<glm::vec3> target = glm::vec3(0, 0, 0);
  Animated<float> fieldOfView = 40.0F;  ///< vertical angle of view in degrees
  Projection projection = Projection::perspective;
  Animated<float> height = 4.0F;  ///< height of an orthographic view in metres
  bool hasHeight = false;         ///< true if the scene gives the height
  Animated<float> roll = 0.0F;    ///< rotation about the line of sight in degrees
  double damping = 0;  ///< time in seconds that the line of sight lags behind a steadily moving `target`; 0
                       ///< means no lag
  std::optional<Follow> follow;    ///< camera on a path; replaces position and target
  std::optional<Track> track;      ///< tracked object; replaces target
  std::optional<Orbit> orbit;      ///< orbit around the target; replaces position
  std::optional<CameraFile> gltf;  ///< camera of a glTF file; replaces position and target
  bool placed = false;             ///< true if the scene determines the camera's position or target
  /// True if the scene gives the target but not the position. The position is then computed from the
  /// extents of the objects. Only scenes since version 2 can do so.
  bool aimed = false;
  bool hasAngle = false;           ///< true if the scene gives the field of view
  std::optional<Lens> lens;        ///< depth of field; if nullopt, everything is sharp
  std::optional<Shutter> shutter;  ///< motion blur; if nullopt, each picture shows one moment
  float near = 0.05F;
  float far = 200.0F;
  void describe(Fields& fields);
};

/// One of several views of the scene that share the picture.
struct Panel {
  /// `camera`: the scene's camera. The others look along an axis at the same target.
  enum class View { camera, front, back, left, right, top };
  std::string name;
  std::string caption;  ///< text in the panel's corner; empty: none
  View view = View::camera;
  std::optional<Camera> camera;    ///< camera of the panel; nullopt: the one that `view` names
  std::optional<Overlay> overlay;  ///< nullopt: the overlay of Render
  struct Shown {
    std::string name;
  };
  std::vector<Shown> objects;  ///< objects that the panel shows; empty: all
  void describe(Fields& fields);
};

struct Sun {
  Animated<glm::vec3> direction = glm::vec3(0.4F, 0.8F, 0.45F);  ///< vector towards the sun
  Animated<glm::vec3> color = glm::vec3(1, 0.92F, 0.80F);
  /// Black-body temperature in kelvin, which sets the colour in place of `color`.
  std::optional<double> temperature;
  Animated<float> intensity = 4.0F;
  float diameter = 0.0F;  ///< angular diameter in degrees, which widens penumbras with distance; if 0,
                          ///< penumbras have constant width
  bool shadow = true;
  int shadowSize = 1024;        ///< side of the shadow map in texels
  float shadowSoftness = 1.5F;  ///< radius of the shadow filter in texels
  void describe(Fields& fields);
};

/// Ambient light and background, which are a gradient or a panorama image.
struct Sky {
  std::filesystem::path picture;  ///< equirectangular HDR image whose centre lies in direction -z; empty
                                  ///< for a gradient
  float strength = 1.0F;          ///< factor on the image's light
  float turn = 0.0F;              ///< rotation of the image about the vertical in degrees
  Animated<glm::vec3> zenith = glm::vec3(0.08F, 0.22F, 0.52F);
  Animated<glm::vec3> horizon = glm::vec3(0.68F, 0.80F, 0.93F);
  Animated<glm::vec3> ground = glm::vec3(0.26F, 0.23F, 0.20F);
  Animated<float> ambient = 1.0F;  ///< factor on the sky's light
  void describe(Fields& fields);
};

/// true if objects collide with the plane; false for the floor of a stage
struct Ground {
  bool solid = false;    ///< true if objects collide with the plane; false for the floor of a stage
  float height = -5.0F;  ///< height of the plane in metres
  /// Coulomb's friction coefficient. If nullopt, the speed of sliding objects decays at a rate of 25.3 1/s.
  std::optional<double> friction;
  bool visible = true;
  glm::vec3 color{0.32F, 0.29F, 0.25F};
  float roughness = 0.9F;
  /// Distance in metres from the camera's target at which the ground starts to fade into the sky.
  float fadeStart = 15.0F;
  float fadeEnd = 40.0F;
  void describe(Fields& fields);
};

/// Preset that supplies the values that a scene leaves out of sun, sky, ground, lights and materials
/// (stage.hpp).
struct Stage {
  /// Preset values. `none`: plain defaults. `automatic`: studio, or a dark stage for objects that glow.
  /// `hollow`: the preset "void".
  enum class Preset {
    none,
    automatic,
    studio,
    daylight,
    overcast,
    sunset,
    night,
    hollow,
    paper,
    blueprint
  };
  enum class Palette { preset, vivid, earth, pastel, grey, ocean, neon };
  Preset preset = Preset::automatic;
  Palette palette = Palette::preset;       ///< colours for objects that have no colour in the scene
  std::optional<glm::vec3> backdrop = {};  ///< linear RGB of floor and background; nullopt means the colour
                                           ///< of the preset
  std::set<std::string, std::less<>> given = {};  ///< paths of the members that the scene gives, such as
                                                  ///< "sun" and "sun.color"
  [[nodiscard]] bool leaves(std::string_view path) const { return !given.contains(path); }
  void describe(Fields& fields);
};

struct Object {
  std::string name;
  std::string kind;  ///< name of the object's entry in Kinds::list
  std::unique_ptr<Parameters> parameters;
  Material material;
  std::set<std::string, std::less<>> materialKeys;  ///< keys of the material that the scene gives
  [[nodiscard]] bool hasMaterial() const { return !materialKeys.empty(); }
};

/// Callback that reports an error of an object. `path` names a value below the object, at which the error
/// is reported. If the scene does not give that value, the error is reported at the last part of `path`
/// that the scene gives.
using Report = std::function<void(const Object& object, const std::vector<std::string>& path,
                                  const std::string& message)>;

/// All kinds of objects, and checks that involve several objects. `check` receives all objects, including
/// those with errors, whose parameters may be null, and whether the scene has a ground that collides.
/// Errors that `check` reports about values that already have errors are dropped.
struct Kinds {
  std::span<const Kind> list;
  std::function<void(std::span<const Object>, bool hasGround, const Report&)> check = {};
  /// Reads the file of a camera. Throws UserError; its code is `usage` if the scene's settings do not suit
  /// the file.
  std::function<std::shared_ptr<const CameraShot>(const CameraFile&)> openCamera = {};
};

struct Scene {
  std::string title;
  int seed = 1;
  Numerics numerics = Numerics::exact;
  Render render;
  Time time;
  Camera camera;
  Sun sun;
  Sky sky;
  std::optional<Haze> haze;
  Stage stage;
  bool staged = false;    ///< true if the stage supplies the values that the scene leaves out
  bool surveyed = false;  ///< true if camera and stage were placed by a trial run (sim/world/survey.hpp)
  std::optional<Ground> ground;
  /// Lights at positions in the scene. There are at most maxLights, of which at most maxShadowedLights cast
  /// shadows.
  std::vector<Light> lights;
  std::vector<Object> objects;
  Test test;
  std::vector<Check> checks;
  std::vector<std::filesystem::path> files;  ///< resolved paths of the files that the scene names
  std::string filesHash;                     ///< hashes of the contents of `files`
  std::string hash;                          ///< hash of the text, the overrides and the named files as 32
                                             ///< hexadecimal digits
  std::vector<std::string> overrides;        ///< "path=value" of each override, in the order applied
  /// Warnings about values that have no effect. Each is "file:line:column: warning: ...", the source line
  /// and a caret.
  std::vector<std::string> remarks;
  std::vector<Panel> panels;  ///< views that share the picture; empty: the camera fills the picture

  [[nodiscard]] int frameCount() const;
  /// True if the pictures have the same bytes on every machine.
  [[nodiscard]] bool drawsExactly() const {
    return numerics == Numerics::exact && render.rasterizer == Rasterizer::exact;
  }
  /// Returns the indices of the objects that measure the quantity named by `check`. If `check.object` is
  /// given, only that object is considered. For a valid check, the result has exactly one index.
  [[nodiscard]] std::vector<std::size_t> owners(const Check& check) const;
  /// Returns the frames that a test compares, in ascending order without repeats. These are the frames that
  /// the scene gives, or the first, middle and last frame.
  [[nodiscard]] std::vector<int> testFrames() const;
};

/// Override `path=value` of option -D. The value is JSON or a bare string.
struct Override {
  std::string path;
  std::string value;
};

/// Splits "path=value". Throws UserError(usage) if there is no path or no '='.
[[nodiscard]] Override parseOverride(std::string_view argument);

/// Returns the overrides as command-line arguments: -D seed=7 -D 'render.size=[320,180]'. Returns an empty
/// string for an empty list.
[[nodiscard]] std::string asArguments(std::span<const std::string> overrides);

}  // namespace simreel::scene
