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

/// A material grown from a field while it runs, laid over the object's surface.
struct Skin {
  enum class Look { leather, spots, cracks, map };  ///< map: the field's own colours
  enum class Projection { uv, triplanar };
  std::string field;  ///< name of the object whose field it is
  Look look = Look::leather;
  Projection projection = Projection::uv;
  float repeats = 1.0F;             ///< of the field along u and v, or in a metre (triplanar)
  std::optional<double> threshold;  ///< value of the field where the colours meet; else the look's own
  glm::vec3 low{-1};                ///< linear RGB where the field is low; negative: the look's own
  glm::vec3 high{-1};               ///< and where it is high
  float bump = 1.0F;                ///< factor on the relief's height
  std::optional<double> roughness;  ///< else the look's own
  void describe(Fields& fields);
};

/// Metal/rough surface. Colours are linear RGB.
struct Material {
  glm::vec3 color{0.8F, 0.7F, 0.6F};
  std::filesystem::path texture;    ///< sRGB image multiplied with the colour; empty: none
  glm::vec3 textureScale{1, 1, 1};  ///< repeats along u and v, or in a metre (z unused)
  float roughness = 0.8F;
  float metallic = 0.0F;
  float translucency = 0.0F;  ///< fraction of light from behind that shines through
  float bump = 0.0F;          ///< m: height of the texture's white over its black
  bool castsShadow = true;    ///< in the light of sun and lamps
  std::optional<Skin> skin;   ///< replaces colour and roughness
  Finish finish;
  void describe(Fields& fields);
};

/// Light scattered around what is bright.
struct Bloom {
  Animated<float> strength = 0.0F;  ///< fraction of the light above the threshold; 0: off
  float threshold = 1.0F;           ///< linear light
  float radius = 0.1F;              ///< fraction of the picture's height
  void describe(Fields& fields);
};

/// Who finds out what is visible, and shades it.
enum class Rasterizer { exact, driver };

/// How much is spent on the light of a picture. standard: draft, and creases and gaps get less of the
/// surroundings' light. high: light is found by rays through the scene.
enum class Quality { draft, standard, high };

/// The curve from light to the numbers of a picture (glsl/draw/screen/film.glsl).
enum class Tone { aces, agx, filmic, plain };

struct Render {
  Rasterizer rasterizer = Rasterizer::exact;
  Quality quality = Quality::draft;
  bool hasQuality = false;                ///< whether the scene gives it
  std::optional<double> occlusionRadius;  ///< m; none: a share of the distance to the target
  int raySamples = 64;                    ///< of a pixel's light, with quality high
  glm::ivec2 size{1280, 720};             ///< pixels
  int samples = 4;  ///< per pixel: 1, 2, 4, 8 or 16 (of the driver: those it has, 1 and 4 always)
  Animated<float> exposure = 0.0F;  ///< EV
  Tone tone = Tone::aces;
  std::optional<Animated<float>> whiteBalance;  ///< K: light of this colour is shown as white
  bool transparent = false;                     ///< whether the background is left out
  float vignette = 0.0F;
  Bloom bloom;
  void describe(Fields& fields);
};

struct Time {
  double fps = 60.0;
  double start = 0.0;     ///< s simulated before frame 0
  double duration = 2.0;  ///< s; frames = round(duration * fps), at least 1
  void describe(Fields& fields);
};

/// A camera that goes along the path that an object has found.
struct Follow : PathPlace {
  float ahead = 4.0F;  ///< m along the path to what it looks at
  double damping = 0;  ///< s: what moves steadily it follows so long behind; 0: at once
  void describe(Fields& fields);
};

/// A camera that looks at an object wherever that is.
struct Track {
  std::string object;
  glm::vec3 offset{0};  ///< m, from its middle to what is looked at
  double damping = 0;   ///< s: what moves steadily is looked at where it was so long ago; 0: where it is
  void describe(Fields& fields);
};

/// Where a camera stands at a moment, and how it is turned.
struct CameraPose {
  glm::dvec3 eye{0};
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};  ///< unit, square to each other
};

/// A camera of a file, by the time alone. May be asked by several threads at once.
class CameraShot {
 public:
  virtual ~CameraShot() = default;
  /// At a time of the scene (s).
  [[nodiscard]] virtual CameraPose at(double seconds) const = 0;
  [[nodiscard]] virtual double fieldOfView() const = 0;  ///< degrees, vertical; of perspective ones
  [[nodiscard]] virtual std::optional<double> height() const = 0;  ///< m: its picture's, if orthographic
  [[nodiscard]] virtual double near() const = 0;                   ///< m
  [[nodiscard]] virtual std::optional<double> far() const = 0;     ///< m; none: it has no end
};

/// A camera that stands and turns as that of a glTF file does.
struct CameraFile {
  std::filesystem::path file;
  std::string name;       ///< of the camera's node; empty: the only one
  std::string animation;  ///< empty: the first that moves it
  double speed = 1, start = 0;
  bool loop = false;
  float distance = 6;                           ///< m along its line of sight to its target
  bool hasNear = false, hasFar = false;         ///< whether the scene gives these itself
  std::shared_ptr<const CameraShot> shot = {};  ///< the file's, where it has been read
  void describe(Fields& fields);
};

/// A camera's lens: what does not lie at the distance that it is focused on is blurred.
struct Lens {
  Animated<float> fNumber = 2.8F;  ///< focal length / diameter of the opening, for a picture 24 mm high
  std::optional<Animated<float>> focus;  ///< m along the line of sight; none: what the camera looks at
  int blades = 0;                        ///< sides of the opening; 0: it is round
  int samples = 32;                      ///< points of the opening through which each picture is drawn
  void describe(Fields& fields);
};

/// How long each picture is exposed: what moves meanwhile is blurred.
struct Shutter {
  float angle = 180.0F;  ///< degrees: 360 is from one frame to the next
  int samples = 16;      ///< moments that each picture is drawn at
  void describe(Fields& fields);
};

/// A camera that goes round its target.
struct Orbit {
  Animated<float> turn = 0.0F;        ///< degrees about the vertical, from +z towards +x
  Animated<float> elevation = 20.0F;  ///< degrees above the horizon
  Animated<float> distance = 6.0F;    ///< m
  bool distanced = false;             ///< whether the scene gives the distance
  void describe(Fields& fields);
};

/// Where a camera's rays come from: one point, or all of its picture, square to it.
enum class Projection { perspective, orthographic };

struct Camera {
  Animated<glm::vec3> position = glm::vec3(0, 1.5F, 6);
  Animated<glm::vec3> target = glm::vec3(0, 0, 0);
  Animated<float> fieldOfView = 40.0F;  ///< degrees, vertical
  Projection projection = Projection::perspective;
  Animated<float> height = 4.0F;   ///< m that the picture is high, of an orthographic one
  bool hasHeight = false;          ///< whether the scene gives it
  Animated<float> roll = 0.0F;     ///< degrees
  double damping = 0;              ///< s: what `target` does steadily it looks at so long after; 0: at once
  std::optional<Follow> follow;    ///< instead of position and target
  std::optional<Track> track;      ///< instead of target
  std::optional<Orbit> orbit;      ///< instead of position
  std::optional<CameraFile> gltf;  ///< instead of position and target
  bool placed = false;             ///< whether the scene says where it stands or what it looks at
  bool hasAngle = false;           ///< whether the scene gives its field of view
  std::optional<Lens> lens;        ///< none: the whole picture is sharp
  std::optional<Shutter> shutter;  ///< none: each picture shows one moment
  float near = 0.05F;
  float far = 200.0F;
  void describe(Fields& fields);
};

struct Sun {
  Animated<glm::vec3> direction = glm::vec3(0.4F, 0.8F, 0.45F);  ///< towards the light
  Animated<glm::vec3> color = glm::vec3(1, 0.92F, 0.80F);
  std::optional<double> temperature;  ///< K: its colour is that of a black body, instead of `color`
  Animated<float> intensity = 4.0F;
  float diameter = 0.0F;  ///< degrees, as seen from here: what penumbras grow by; 0: they do not grow
  bool shadow = true;
  int shadowSize = 1024;        ///< texels on a side
  float shadowSoftness = 1.5F;  ///< radius of the filter, texels
  void describe(Fields& fields);
};

/// Ambient light and the background: a gradient, or a picture all around.
struct Sky {
  std::filesystem::path picture;  ///< of light, equirectangular: its middle lies towards -z; empty: none
  float strength = 1.0F;          ///< factor on the picture's light
  float turn = 0.0F;              ///< degrees that the picture is turned about the vertical
  Animated<glm::vec3> zenith = glm::vec3(0.08F, 0.22F, 0.52F);
  Animated<glm::vec3> horizon = glm::vec3(0.68F, 0.80F, 0.93F);
  Animated<glm::vec3> ground = glm::vec3(0.26F, 0.23F, 0.20F);
  Animated<float> ambient = 1.0F;  ///< factor on the light the sky gives
  void describe(Fields& fields);
};

/// Ground plane.
struct Ground {
  bool solid = false;              ///< True if the scene gives it: objects collide with it.
  float height = -5.0F;            ///< m
  std::optional<double> friction;  ///< Coulomb's coefficient; none: what slides loses speed at 25.3 1/s
  bool visible = true;
  glm::vec3 color{0.32F, 0.29F, 0.25F};
  float roughness = 0.9F;
  float fadeStart = 15.0F;  ///< m from the camera's target where the ground begins to dissolve into the sky
  float fadeEnd = 40.0F;
  void describe(Fields& fields);
};

/// Surroundings of a scene of solids: whatever it leaves out of sun, sky, ground, lights and materials
/// (stage.hpp).
struct Stage {
  /// `none` leaves everything at the plain defaults; `automatic` is studio, or night for objects that glow.
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
  Palette palette = Palette::preset;       ///< colours of objects without a colour
  std::optional<glm::vec3> backdrop = {};  ///< linear RGB of floor and background; none: the preset's
  std::set<std::string, std::less<>> given = {};  ///< "sun", "sun.color": what the scene gives itself
  [[nodiscard]] bool leaves(std::string_view path) const { return !given.contains(path); }
  void describe(Fields& fields);
};

struct Object {
  std::string name;
  std::string kind;  ///< a name from the list of simulations
  std::unique_ptr<Parameters> parameters;
  Material material;
  std::set<std::string, std::less<>> materialKeys;  ///< keys of the material that the scene gives
  [[nodiscard]] bool hasMaterial() const { return !materialKeys.empty(); }
};

/// Reports a mistake of an object at the place of the value that `path` leads to from it, or of the last on
/// the way there that the scene gives.
using Report = std::function<void(const Object& object, const std::vector<std::string>& path,
                                  const std::string& message)>;

/// The kinds of object there are, and what no object knows by itself: whether the others are what it needs.
/// `check` hears of all objects, those with mistakes of their own too (parameters may be null); what it
/// reports of them is not said.
struct Kinds {
  std::span<const Kind> list;
  std::function<void(std::span<const Object>, const Report&)> check = {};
  /// Reads the file of a camera. Throws UserError, usage for what the scene says wrongly of it.
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
  bool staged = false;    ///< True if the stage supplies what the scene leaves out.
  bool surveyed = false;  ///< whether camera and stage stand where a run has shown (sim/world/survey.hpp)
  std::optional<Ground> ground;
  std::vector<Light> lights;  ///< at most maxLights, maxShadowedLights of them with shadows
  std::vector<Object> objects;
  Test test;
  std::vector<Check> checks;
  std::vector<std::filesystem::path> files;  ///< that it names, found
  std::string hash;                          ///< of the scene's text and overrides; 32 hexadecimal digits
  std::vector<std::string> overrides;        ///< "path=value" of each, as they were applied
  /// What it gives that does nothing: "file:line:column: warning: ...", the line and a caret, each.
  std::vector<std::string> remarks;

  [[nodiscard]] int frameCount() const;
  /// Whether its pictures have the same bytes on every machine.
  [[nodiscard]] bool drawsExactly() const {
    return numerics == Numerics::exact && render.rasterizer == Rasterizer::exact;
  }
  /// The objects that measure the quantity a check names, among those it may mean; it should be one.
  [[nodiscard]] std::vector<std::size_t> owners(const Check& check) const;
  /// The frames that a test compares: the given ones, or first, middle and last; ascending, no repeats.
  [[nodiscard]] std::vector<int> testFrames() const;
};

/// `path=value` of -D; value is JSON, or bare text taken as a string.
struct Override {
  std::string path;
  std::string value;
};

/// Splits "path=value". Throws UserError(usage) when there is no path or no '='.
[[nodiscard]] Override parseOverride(std::string_view argument);

/// Overrides as words of a command line: -D seed=7 -D 'render.size=[320,180]'. Empty for none.
[[nodiscard]] std::string asArguments(std::span<const std::string> overrides);

}  // namespace simreel::scene
