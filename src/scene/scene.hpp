#pragma once
#include "scene/finish.hpp"
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

/// Material that is generated from a simulated field and applied to the object's surface.
struct Skin {
  enum class Look { leather, spots, cracks, map };  ///< `map` shows the field in its own colours
  enum class Projection { uv, triplanar };
  std::string field;  ///< name of the object whose field is used
  Look look = Look::leather;
  Projection projection = Projection::uv;
  float repeats = 1.0F;  ///< repeats of the field along u and v, or per metre (triplanar)
  /// Field value between low and high colour; nullopt: default of the look.
  std::optional<double> threshold;
  glm::vec3 low{-1};                ///< linear RGB for low field values; negative: default of the look
  glm::vec3 high{-1};               ///< linear RGB for high field values; negative: default of the look
  float bump = 1.0F;                ///< factor on the height of the relief
  std::optional<double> roughness;  ///< surface roughness; nullopt: default of the look
  void describe(Fields& fields);
};

/// Surface with metallic/roughness shading. Colours are linear RGB.
struct Material {
  glm::vec3 color{0.8F, 0.7F, 0.6F};
  std::filesystem::path texture;  ///< sRGB image multiplied by the colour; empty: none
  /// Repeats along u and v, or per metre on surfaces without uv; z is unused.
  glm::vec3 textureScale{1, 1, 1};
  float roughness = 0.8F;
  float metallic = 0.0F;
  float translucency = 0.0F;  ///< fraction of light from behind that shines through
  float bump = 0.0F;          ///< height in metres of the texture's white above its black
  bool castsShadow = true;    ///< true: casts shadows in the light of the sun and the lights
  std::optional<Skin> skin;   ///< live material that replaces colour and roughness
  Finish finish;
  void describe(Fields& fields);
};

/// Light that scatters around bright areas of the picture.
struct Bloom {
  Animated<float> strength = 0.0F;  ///< fraction of the light above the threshold that scatters; 0: off
  float threshold = 1.0F;           ///< threshold of linear light; only light above it scatters
  float radius = 0.1F;              ///< radius of the scattering as a fraction of the picture's height
  void describe(Fields& fields);
};

/// Method of drawing. exact: compute kernels with the same bytes on every machine; driver: OpenGL's
/// rasterizer.
enum class Rasterizer { exact, driver };

/// Effort for lighting. draft: direct light and ambient light without occlusion. standard: adds ambient
/// occlusion and screen-space reflections. high: ray tracing.
enum class Quality { draft, standard, high };

/// Tone curve from linear light to pixel values (glsl/draw/screen/film.glsl).
enum class Tone { aces, agx, filmic, plain };

struct Render {
  Rasterizer rasterizer = Rasterizer::exact;
  Quality quality = Quality::draft;
  bool hasQuality = false;  ///< true if the scene gives "quality"
  /// Radius of ambient occlusion in metres; nullopt: a sixth of the distance to the target.
  std::optional<double> occlusionRadius;
  int raySamples = 64;         ///< light samples per pixel with quality high
  glm::ivec2 size{1280, 720};  ///< width and height in pixels
  /// Samples per pixel: 1, 2, 4, 8 or 16; the driver's rasterizer may support only 1 and 4.
  int samples = 4;
  Animated<float> exposure = 0.0F;  ///< exposure value (EV); +1 doubles the brightness
  Tone tone = Tone::aces;
  /// White balance in kelvin: light of this black-body colour is shown as white.
  std::optional<Animated<float>> whiteBalance;
  bool transparent = false;  ///< true: pictures have no background but an alpha channel
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
  float ahead = 4.0F;  ///< metres of path ahead; the camera looks at the mean of its points
  double damping = 0;  ///< lag of the camera in seconds behind steady motion; 0: none
  void describe(Fields& fields);
};

/// Camera that keeps looking at a moving object.
struct Track {
  std::string object;
  glm::vec3 offset{0};  ///< offset in metres from the object's middle to the point that the camera looks at
  double damping = 0;   ///< lag of the camera in seconds behind a steadily moving object; 0: none
  void describe(Fields& fields);
};

/// Position and orientation of a camera at one time.
struct CameraPose {
  glm::dvec3 eye{0};
  /// Axes of the camera: unit vectors, orthogonal to each other.
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
};

/// Camera of a file as a function of time. Several threads may use it at once.
class CameraShot {
 public:
  virtual ~CameraShot() = default;
  /// Returns the pose at `seconds` of the scene's time.
  [[nodiscard]] virtual CameraPose at(double seconds) const = 0;
  /// Vertical angle of view in degrees; only for perspective cameras.
  [[nodiscard]] virtual double fieldOfView() const = 0;
  /// Height of the view in metres; nullopt: perspective.
  [[nodiscard]] virtual std::optional<double> height() const = 0;
  [[nodiscard]] virtual double near() const = 0;  ///< nearest drawn distance in metres
  /// Farthest drawn distance in metres; nullopt: unlimited.
  [[nodiscard]] virtual std::optional<double> far() const = 0;
};

/// Camera whose pose and motion come from a glTF file.
struct CameraFile {
  std::filesystem::path file;
  std::string name;       ///< name of the camera or its node; empty: the file's only camera
  std::string animation;  ///< name of the animation; empty: the first that moves the camera
  double speed = 1, start = 0;
  bool loop = false;
  float distance = 6;                    ///< distance of the target along the line of sight, in metres
  bool hasNear = false, hasFar = false;  ///< true if the scene itself gives near or far
  std::shared_ptr<const CameraShot> shot = {};  ///< the file's camera; null until the file has been read
  void describe(Fields& fields);
};

/// Lens of a camera: objects outside the focus distance are blurred.
struct Lens {
  Animated<float> fNumber = 2.8F;  ///< focal length / aperture diameter, for a picture 24 mm high
  /// Focus distance in metres along the line of sight; nullopt: distance of the target.
  std::optional<Animated<float>> focus;
  int blades = 0;    ///< number of sides of the aperture; 0: round
  int samples = 32;  ///< number of aperture points; each picture is drawn once for each
  void describe(Fields& fields);
};

/// Exposure time of a picture: objects that move during it are blurred.
struct Shutter {
  float angle = 180.0F;  ///< exposure time in degrees; 360 is the whole time between two frames
  int samples = 16;      ///< number of times within the exposure at which each picture is drawn
  void describe(Fields& fields);
};

/// Camera that orbits its target.
struct Orbit {
  Animated<float> turn = 0.0F;        ///< angle about the vertical in degrees, from +z towards +x
  Animated<float> elevation = 20.0F;  ///< camera angle above the horizon in degrees
  Animated<float> distance = 6.0F;    ///< distance from the target in metres
  bool distanced = false;             ///< true if the scene gives the distance
  void describe(Fields& fields);
};

/// Camera rays. perspective: all from one point; orthographic: parallel, perpendicular to the picture.
enum class Projection { perspective, orthographic };

struct Camera {
  Animated<glm::vec3> position = glm::vec3(0, 1.5F, 6);
  Animated<glm::vec3> target = glm::vec3(0, 0, 0);
  Animated<float> fieldOfView = 40.0F;  ///< vertical angle of view in degrees
  Projection projection = Projection::perspective;
  Animated<float> height = 4.0F;  ///< height of an orthographic view in metres
  bool hasHeight = false;         ///< true if the scene gives the height
  Animated<float> roll = 0.0F;    ///< rotation about the line of sight in degrees
  double damping = 0;  ///< lag of the line of sight in seconds behind a steadily moving `target`; 0: none
  std::optional<Follow> follow;    ///< camera on a path; replaces position and target
  std::optional<Track> track;      ///< tracked object; replaces target
  std::optional<Orbit> orbit;      ///< orbit around the target; replaces position
  std::optional<CameraFile> gltf;  ///< camera of a glTF file; replaces position and target
  bool placed = false;             ///< true if the scene determines the camera's position or target
  /// True if the scene gives the target alone; the position follows from the extents of the objects. Since
  /// version 2 of scenes.
  bool aimed = false;
  bool hasAngle = false;           ///< true if the scene gives the field of view
  std::optional<Lens> lens;        ///< depth of field; nullopt: everything is sharp
  std::optional<Shutter> shutter;  ///< motion blur; nullopt: each picture shows one moment
  float near = 0.05F;
  float far = 200.0F;
  void describe(Fields& fields);
};

struct Sun {
  Animated<glm::vec3> direction = glm::vec3(0.4F, 0.8F, 0.45F);  ///< vector towards the sun
  Animated<glm::vec3> color = glm::vec3(1, 0.92F, 0.80F);
  /// Black-body temperature in kelvin, which sets the colour in place of `color`.
  std::optional<double> temperature;
  Animated<float> intensity = 4.0F;
  float diameter = 0.0F;  ///< angular diameter in degrees; penumbras grow with it; 0: they do not grow
  bool shadow = true;
  int shadowSize = 1024;        ///< side of the shadow map in texels
  float shadowSoftness = 1.5F;  ///< radius of the shadow filter in texels
  void describe(Fields& fields);
};

/// Ambient light and background: a gradient, or a panorama.
struct Sky {
  std::filesystem::path picture;  ///< equirectangular HDR image whose middle lies towards -z; empty: none
  float strength = 1.0F;          ///< factor on the image's light
  float turn = 0.0F;              ///< rotation of the image about the vertical in degrees
  Animated<glm::vec3> zenith = glm::vec3(0.08F, 0.22F, 0.52F);
  Animated<glm::vec3> horizon = glm::vec3(0.68F, 0.80F, 0.93F);
  Animated<glm::vec3> ground = glm::vec3(0.26F, 0.23F, 0.20F);
  Animated<float> ambient = 1.0F;  ///< factor on the sky's light
  void describe(Fields& fields);
};

/// Ground plane.
struct Ground {
  bool solid = false;    ///< true if objects collide with it; false for the floor of a stage
  float height = -5.0F;  ///< height of the plane in metres
  /// Coulomb's coefficient; nullopt: sliding objects lose speed at a rate of 25.3 1/s
  std::optional<double> friction;
  bool visible = true;
  glm::vec3 color{0.32F, 0.29F, 0.25F};
  float roughness = 0.9F;
  /// Metres from the camera's target at which the ground starts to fade into the sky.
  float fadeStart = 15.0F;
  float fadeEnd = 40.0F;
  void describe(Fields& fields);
};

/// Source of the values that a scene leaves out of sun, sky, ground, lights and materials (stage.hpp).
struct Stage {
  /// `none`: plain defaults. `automatic`: studio, or a dark stage for objects that glow. `hollow`: "void".
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
  Palette palette = Palette::preset;       ///< colours of objects that have none of their own
  std::optional<glm::vec3> backdrop = {};  ///< linear RGB of floor and background; nullopt: the preset's
  std::set<std::string, std::less<>> given = {};  ///< paths that the scene gives: "sun", "sun.color"
  [[nodiscard]] bool leaves(std::string_view path) const { return !given.contains(path); }
  void describe(Fields& fields);
};

struct Object {
  std::string name;
  std::string kind;  ///< name of one of the Kinds
  std::unique_ptr<Parameters> parameters;
  Material material;
  std::set<std::string, std::less<>> materialKeys;  ///< keys of the material that the scene gives
  [[nodiscard]] bool hasMaterial() const { return !materialKeys.empty(); }
};

/// Reports an error of an object at the value that `path` names below it. If the scene does not give that
/// value, the place is the last part of `path` that the scene gives.
using Report = std::function<void(const Object& object, const std::vector<std::string>& path,
                                  const std::string& message)>;

/// All kinds of objects, and checks that involve several objects. `check` receives all objects, also those
/// with errors (their parameters may be null). Errors that it reports about values with errors are dropped.
struct Kinds {
  std::span<const Kind> list;
  std::function<void(std::span<const Object>, const Report&)> check = {};
  /// Reads the file of a camera. Throws UserError; its code is `usage` if the scene's settings do not fit
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
  Stage stage;
  bool staged = false;    ///< true if the stage supplies the values that the scene leaves out
  bool surveyed = false;  ///< true if camera and stage were placed after a trial run (sim/world/survey.hpp)
  std::optional<Ground> ground;
  /// Local lights: at most maxLights, of which at most maxShadowedLights cast shadows.
  std::vector<Light> lights;
  std::vector<Object> objects;
  Test test;
  std::vector<Check> checks;
  std::vector<std::filesystem::path> files;  ///< resolved paths of the files that the scene names
  std::string filesHash;                     ///< hashes of the contents of `files`
  std::string hash;                          ///< hash of the text, overrides and named files; 32 digits
  std::vector<std::string> overrides;        ///< "path=value" of each override, in the order applied
  /// Warnings about values without effect. Each is "file:line:column: warning: ...", the source line and a
  /// caret.
  std::vector<std::string> remarks;

  [[nodiscard]] int frameCount() const;
  /// True if the pictures have the same bytes on every machine.
  [[nodiscard]] bool drawsExactly() const {
    return numerics == Numerics::exact && render.rasterizer == Rasterizer::exact;
  }
  /// Returns the indices of the objects that measure the quantity named by `check`; only `check.object`, if
  /// given. A valid check has exactly one.
  [[nodiscard]] std::vector<std::size_t> owners(const Check& check) const;
  /// Returns the frames that a test compares: the given frames, or the first, middle and last. Ascending,
  /// without repeats.
  [[nodiscard]] std::vector<int> testFrames() const;
};

/// Override `path=value` of option -D. The value is JSON or a bare string.
struct Override {
  std::string path;
  std::string value;
};

/// Splits "path=value". Throws UserError(usage) if there is no path or no '='.
[[nodiscard]] Override parseOverride(std::string_view argument);

/// Returns overrides as command-line arguments: -D seed=7 -D 'render.size=[320,180]'. Empty for an empty
/// list.
[[nodiscard]] std::string asArguments(std::span<const std::string> overrides);

}  // namespace simreel::scene
