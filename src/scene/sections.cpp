#include "scene/sections.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

constexpr const char* renderDoc = "Size and look of the pictures.";
constexpr const char* timeDoc = "Frame rate, start and length.";
constexpr const char* cameraDoc = "Camera that takes the pictures.";
constexpr const char* stageDoc =
    "Floor, background, light and colours of a scene of solids. The stage supplies every value of sun, "
    "sky, "
    "ground, lights and materials that the scene leaves out; false: the plain defaults.";
constexpr const char* sunDoc =
    "The one directional light and its shadow. The stage supplies the values that a scene leaves out.";
constexpr const char* skyDoc =
    "Ambient light and background gradient. The stage supplies the values that a scene leaves out.";
constexpr const char* hazeDoc =
    "Air that dims distant things and adds its own light, so that ground and hills melt into the sky. It "
    "extends the ground and the camera's \"far\" to where it hides everything.";
constexpr const char* groundDoc =
    "Ground plane, which is drawn and collided with. Without it, the stage draws a floor below everything, "
    "and nothing collides with that floor.";
constexpr const char* lightsDoc =
    "Lights at places of the scene, each {position, intensity, ...} by name. The stage adds one named "
    "\"rim\", which shines from behind.";
constexpr const char* materialDoc =
    "Surface of an object. On a stage, an object without a \"color\" gets one of the stage's palette.";

constexpr const char* panelsDoc =
    "Views that share the picture side by side, each {view, camera, overlay, objects, caption} by name.";
constexpr std::size_t maxPanels = 16;
/// Names of the values of Overlay.
const std::vector<const char*> overlayWords = {"none", "wireframe", "normals", "uv", "objects"};

template <class T>
Section section(const char* name, const char* doc) {
  return {name, doc, [](Fields& fields) { T().describe(fields); }};
}

void describeLights(Fields& fields, Scene& scene) {
  fields.named(
      "lights", scene.lights, lightsDoc, "light",
      [](Fields& inner, Light& light) { light.describe(inner); }, maxLights);
  const auto shadowed = static_cast<std::size_t>(
      std::count_if(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.shadow; }));
  if (shadowed > maxShadowedLights)
    fields.error("lights", fmt::format("{} lights cast shadows, and at most {} may; give the others "
                                       "\"shadow\": false",
                                       shadowed, maxShadowedLights));
}

/// Warns about shadow-map settings with ray tracing, which does not use shadow maps. Warns about a sun
/// diameter if the sun casts no shadows, because without ray tracing the diameter affects only shadows.
void remarkRays(Fields& fields, const Scene& scene) {
  const bool traces = scene.render.quality == Quality::high && scene.render.rasterizer == Rasterizer::exact;
  fields.idleUnless(traces || scene.sun.shadow, "sun.shadow", {"sun.diameter"}, "a sun with \"shadow\"");
  const char* const maps = "shadow maps, and \"quality\": \"high\" computes shadows by ray tracing";
  if (scene.sun.shadow)
    fields.idleUnless(!traces, "render.quality", {"sun.shadowSize", "sun.shadowSoftness"}, maps);
  for (const Light& light : scene.lights) {
    if (!light.shadow) continue;
    for (const char* name : {"shadowSize", "shadowSoftness"}) {
      const std::string path = "lights." + light.name + "." + name;
      fields.idleUnless(!traces, "render.quality", {path.c_str()}, maps);
    }
  }
}

/// Warns about a sun that is always below a visible ground, probably because its direction has the wrong
/// sign.
void remarkSun(Fields& fields, const Scene& scene) {
  const auto& keys = scene.sun.direction.keys();
  const bool below = std::all_of(keys.begin(), keys.end(), [](const auto& key) { return key.value.y < 0; });
  if (below && scene.ground && scene.ground->visible && !isNothing(scene.sun.intensity))
    fields.idle("sun.direction", "",
                "\"direction\" points to the sun, which is then below the ground and lights nothing on it");
}

}  // namespace

void Material::describe(Fields& fields) {
  fields.color("color", color, notNegative, "Base colour, linear RGB.");
  fields.leftOut("color", "the stage's, else [0.8, 0.7, 0.6]");
  fields.asset("texture", texture, "sRGB image multiplied with the colour.");
  fields.flatVector("textureScale", textureScale, anyNumber, "",
                    "Repeats of the texture along u and v, [u, v], or in a metre of surfaces without uv, "
                    "which are textured from three sides; a third number is unused.",
                    {2, 1});
  fields.number("bump", bump, {-100, 100}, "m",
                "Height of the texture's white over its black, as the light shows it.");
  fields.number("roughness", roughness, fraction, "", "0 mirrors, 1 is matt.");
  fields.leftOut("roughness", "the stage's, else 0.8");
  fields.number("metallic", metallic, fraction, "", "0 for plastic, cloth and wood; 1 for metal.");
  fields.number("translucency", translucency, fraction, "",
                "Fraction of the light from behind that shines through.");
  fields.leftOut("translucency", "the stage's, else 0");
  fields.boolean("castsShadow", castsShadow, "Casts shadows in the light of sun and lamps.");
  fields.optionalGroup("skin", skin, "A live material grown from a field of the scene.");
  finish.describe(fields);
  if (finish.used() && bump != 0)
    fields.error("bump", "\"bump\" is for a material without maps beside its texture; use a \"normalMap\"");
  if (finish.used() && skin)
    fields.error("skin", "a skin cannot be combined with maps, coats or opacity; leave out one of the two");
  if (std::max({color.x, color.y, color.z}) > 1)
    fields.idle(
        "color", "",
        fmt::format(
            "a \"color\" above 1 sends back more light than comes in, found {:g}; give colours of 0 to 255 "
            "as text, for example \"#ff8800\"",
            std::max({color.x, color.y, color.z})));
  fields.idleUnless(finish.alpha == Alpha::opaque || finish.opacity < 1 || !texture.empty(), "opacity",
                    {"alpha"}, "a material with an \"opacity\" or a \"texture\" that has one");
  const bool mapped = !texture.empty() || finish.hasMaps();
  fields.idleUnless(mapped, "texture", {"textureScale"}, "a material with a \"texture\" or maps");
  fields.idleUnless(!texture.empty(), "texture", {"bump"},
                    "a material with a \"texture\", whose heights these are");
  fields.idleUnless(!skin, "skin", {"color", "texture", "textureScale", "bump", "roughness"},
                    "a material without a \"skin\", which has its own");
}

void Skin::describe(Fields& fields) {
  fields.text("field", field, "Name of the object that supplies the field.");
  fields.choice("look", look, {"leather", "spots", "cracks", "map"},
                "Look of the field's values; map: the field's own colours.");
  fields.choice("projection", projection, {"uv", "triplanar"},
                "uv: by the surface's texture coordinates; triplanar: from three sides in its own space, "
                "for meshes without uv.");
  fields.number("repeats", repeats, positive, "", "Copies of the field along u and v, or in a metre.");
  fields.optionalNumber("threshold", threshold, anyNumber, "", "Value where low and high meet.");
  fields.color("low", low, {-1, 1e9}, "Colour where the field is low, linear RGB.");
  fields.color("high", high, {-1, 1e9}, "Colour where the field is high, linear RGB.");
  fields.number("bump", bump, {-100, 100}, "", "Factor on the height of the relief.");
  fields.optionalNumber("roughness", roughness, fraction, "", "0 mirrors, 1 is matt.");
  fields.idleUnless(look != Look::map, "look", {"threshold", "low", "high"},
                    "a look of two colours; a \"map\" has the field's");
}

void Render::describe(Fields& fields) {
  fields.pair("size", size, {1, 16384}, "pixels", "Width and height of the images.");
  fields.integer(
      "samples", samples, {1, 16}, "",
      "Samples per pixel: 1, 2, 4, 8 or 16; a driver's own rasterizer may support only 1 and 4.");
  if (samples >= 1 && samples <= 16 && (samples & (samples - 1)) != 0)
    fields.error("samples",
                 fmt::format("{} samples per pixel are not supported; use 1, 2, 4, 8 or 16", samples));
  fields.choice(
      "rasterizer", rasterizer, {"exact", "driver"},
      "exact: kernels in exact arithmetic draw, with the same bytes on every machine; driver: vertex and "
      "fragment shaders, with the edges and filters of that driver.");
  fields.choice(
      "quality", quality, {"draft", "standard", "high"},
      "draft: direct light with shadows, and ambient light without occlusion. standard: creases, folds "
      "and narrow gaps get less ambient light (ambient occlusion); smooth metal, gloss and clear coats "
      "(roughness below 0.3) reflect the ground and what is visible in the picture. high: ray tracing with "
      "soft shadows, one bounce of light, and mirrors "
      "that show the scene. The driver's rasterizer has only draft.");
  fields.leftOut("quality", "draft, or standard on a stage");
  hasQuality = fields.given("quality");
  fields.optionalNumber("occlusionRadius", occlusionRadius, positive, "m",
                        "Greatest distance of things that cause ambient occlusion.");
  fields.leftOut("occlusionRadius", "a sixth of the distance to the target");
  fields.integer("raySamples", raySamples, {1, 1024}, "",
                 "Light samples of a pixel with quality high. Four times as many halve the noise.");
  fields.number("exposure", exposure, {-20, 20}, "EV", "Brightness; one more doubles it.");
  fields.choice(
      "tone", tone, {"aces", "agx", "filmic", "plain"},
      "Tone curve from light to the picture. aces: high contrast; agx: bright colours fade softly to "
      "white; filmic: a gentle shoulder; plain: no curve, light above white is cut off.");
  fields.leftOut("tone", "aces; in version 2 plain if a colorBar explains a field behind all objects");
  fields.optionalValue("whiteBalance", whiteBalance, Animated<float>(6504.0F),
                       [&](Animated<float>& kelvin) {
                         fields.number("whiteBalance", kelvin, blackBodyRange, "K",
                                       "Light of a black body of this temperature is shown as white.");
                       });
  fields.leftOut("whiteBalance", "none: light is shown as it is");
  fields.boolean("transparent", transparent,
                 "Leaves out the background: pictures get an alpha channel (straight, not premultiplied) "
                 "and no sky; on a stage no ground, either.");
  if (transparent && rasterizer == Rasterizer::driver)
    fields.error("transparent", "a transparent background needs \"rasterizer\": \"exact\"");
  fields.number("vignette", vignette, fraction, "", "Darkening towards the corners.");
  fields.choice(
      "overlay", overlay, overlayWords,
      "Shows a property of surfaces instead of light, without ground and sky. wireframe: the edges of all "
      "triangles; normals: red, green and blue are 0.5 + 0.5 times the normal's x, y and z; uv: a checker "
      "of "
      "8 by 8 squares over the texture coordinates, red along u and green along v; objects: another colour "
      "for each object.");
  if (overlay != Overlay::none && rasterizer == Rasterizer::driver)
    fields.error("overlay", "an overlay needs \"rasterizer\": \"exact\"");
  fields.group("bloom", "Light that scatters around bright places.",
               [&](Fields& inner) { bloom.describe(inner); });
  fields.idleUnless(quality == Quality::high, "quality", {"raySamples"}, "\"quality\": \"high\"");
}

void Panel::describe(Fields& fields) {
  fields.choice("view", view, {"camera", "front", "back", "left", "right", "top"},
                "camera: the scene's camera; front, back, left, right, top: from that side of its target, "
                "from 1.35 times the distance.");
  fields.optionalGroup("camera", camera, "A camera of this panel's own.");
  if (camera && fields.given("view"))
    fields.error("view", "\"camera\" says where the panel looks from; leave out \"view\"");
  if (camera && (!camera->placed || camera->follow || camera->track || camera->gltf || camera->damping > 0))
    fields.error(
        "camera",
        "a panel's camera stands at a \"position\" or goes round in an \"orbit\" with a "
        "\"distance\"; \"follow\", \"track\", \"gltf\" and \"damping\" are for the scene's camera");
  fields.optionalValue("overlay", overlay, Overlay::none, [&](Overlay& shown) {
    fields.choice("overlay", shown, overlayWords, "Property that the panel shows instead of light.");
  });
  fields.leftOut("overlay", "that of \"render\"");
  fields.shorthand("objects", "name");
  fields.list("objects", objects, "Names of the objects that the panel shows; left out, all.",
              [](Fields& inner, Shown& shown) { inner.text("name", shown.name, "Name of an object."); });
  if (caption.empty() && !fields.given("caption")) caption = name;
  fields.text("caption", caption, "Text in the panel's corner; \"\" for none.");
  fields.leftOut("caption", "the panel's name");
}

void Bloom::describe(Fields& fields) {
  fields.number("strength", strength, {0, 100}, "",
                "Factor on the scattered light; 0 switches it off and costs nothing.");
  fields.number("threshold", threshold, notNegative, "", "Only light above this is scattered.");
  fields.number("radius", radius, {0.001, 1}, "",
                "Distance over which light scatters, as a fraction of the picture's height.");
  fields.idleUnless(!isNothing(strength), "strength", {"threshold", "radius"}, "bloom with a \"strength\"");
}

void Time::describe(Fields& fields) {
  fields.number("fps", fps, {0.001, 1e5}, "frames/s", "Frames per second.");
  fields.number("start", start, notNegative, "s", "Simulated time before frame 0.");
  fields.leftOut(
      "start", "0; in version 2 the longest life of particles, at most 4, if only emitters move by rules");
  fields.number("duration", duration, notNegative, "s",
                "Length; there are round(duration * fps) frames, at least one.");
  constexpr double maxFrames = 1e7;
  if (!((start + duration) * fps < maxFrames))
    fields.error(fields.given("duration") ? "duration"
                 : fields.given("start")  ? "start"
                                          : "fps",
                 fmt::format("(start + duration) * fps is {:g} frames; the limit is 10 million",
                             (start + duration) * fps));
}

void Sun::describe(Fields& fields) {
  fields.vector("direction", direction, anyNumber, "", "Towards the sun; its length does not matter.");
  fields.color("color", color, notNegative, "Colour of its light, linear RGB.");
  describeTemperature(fields, temperature);
  fields.number("intensity", intensity, notNegative, "lx",
                "Illuminance of a surface that faces it, for the colour 1.");
  fields.leftOut("intensity", "4, or 0 without a \"sun\" where the sky is a picture");
  fields.number(
      "diameter", diameter, {0, 60}, "degrees",
      "Angular diameter of its disc; the real sun has 0.53. Penumbras grow with it and with the distance "
      "from the object that casts them; 0: they do not grow. The driver's rasterizer supports only 0.");
  fields.boolean("shadow", shadow, "Casts shadows.");
  fields.integer("shadowSize", shadowSize, {16, 8192}, "texels", "Side of the shadow map.");
  fields.number("shadowSoftness", shadowSoftness, {0, 16}, "texels", "Radius of the shadow's soft edge.");
  for (const auto& key : direction.keys()) {
    if (key.value != glm::vec3(0)) continue;
    fields.error("direction", "\"direction\" is [0, 0, 0], which points nowhere");
    break;
  }
  fields.idleUnless(shadow, "shadow", {"shadowSize", "shadowSoftness"}, "a sun with \"shadow\"");
}

void Sky::describe(Fields& fields) {
  fields.asset("picture", picture,
               "Light from all around instead of a gradient: an equirectangular Radiance (.hdr) or OpenEXR "
               "picture, whose middle lies towards -z. It is seen, mirrored, and lights the scene.");
  fields.number("strength", strength, {0, 1e4}, "", "Factor on the picture's light.");
  fields.number("turn", turn, {-1e6, 1e6}, "degrees",
                "Angle by which the picture is turned about the vertical; 90 moves its middle to +x.");
  for (const char* name : {"zenith", "horizon", "ground"})
    if (!picture.empty() && fields.given(name))
      fields.error(name, fmt::format("the sky is a \"picture\"; leave out \"{}\"", name));
  for (const char* name : {"strength", "turn"})
    if (picture.empty() && fields.given(name))
      fields.error(name, fmt::format("\"{}\" is for a sky with a \"picture\"", name));
  fields.color("zenith", zenith, notNegative, "Colour overhead, linear RGB.");
  fields.color("horizon", horizon, notNegative, "Colour at the horizon, linear RGB.");
  fields.color("ground", ground, notNegative, "Colour below the horizon, linear RGB.");
  fields.number("ambient", ambient, notNegative, "", "Factor on the light that the sky gives.");
}

void Ground::describe(Fields& fields) {
  fields.number("height", height, anyNumber, "m", "Height of the plane.");
  fields.optionalNumber("friction", friction, {0, 100}, "",
                        "Coulomb's coefficient for sliding objects; left out, they lose speed at 25.3 1/s, "
                        "which keeps 0.9 of it in 1/240 s.");
  fields.boolean("visible", visible, "Draws it; objects collide with it in any case.");
  fields.color("color", color, notNegative, "Base colour, linear RGB.");
  fields.number("roughness", roughness, fraction, "", "0 mirrors, 1 is matt.");
  fields.number("fadeStart", fadeStart, notNegative, "m",
                "Distance from the camera's target where it begins to dissolve into the sky.");
  fields.leftOut("fadeStart", "15; with \"haze\" at least its \"start\" + 5 \"distance\"");
  fields.number("fadeEnd", fadeEnd, notNegative, "m", "Distance at which it has dissolved.");
  fields.leftOut("fadeEnd", "40; with \"haze\" at least its \"start\" + 8 \"distance\"");
  if (!(fadeStart < fadeEnd))
    fields.error(
        fields.given("fadeStart") ? "fadeStart" : "fadeEnd",
        fmt::format("\"fadeStart\" ({} m) must be less than \"fadeEnd\" ({} m)", fadeStart, fadeEnd));
  fields.idleUnless(visible, "visible", {"color", "roughness", "fadeStart", "fadeEnd"},
                    "ground that is \"visible\"");
}

void describeScene(Fields& fields, Scene& scene) {
  fields.text("title", scene.title, "Title of the scene.");
  fields.integer("seed", scene.seed, {0, 2147483647}, "",
                 "Seed of all random numbers; another seed gives another variation.");
  fields.choice("numerics", scene.numerics, {"exact", "fast"},
                "exact: the same bits on every device. fast: the device's own functions.");
  fields.group("render", renderDoc, [&](Fields& inner) { scene.render.describe(inner); });
  fields.group("time", timeDoc, [&](Fields& inner) { scene.time.describe(inner); });
  fields.group("camera", cameraDoc, [&](Fields& inner) { scene.camera.describe(inner); });
  fields.shorthand("panels", "view");
  fields.named(
      "panels", scene.panels, panelsDoc, "panel",
      [&](Fields& inner, Panel& panel) {
        panel.describe(inner);
        if (panel.overlay.value_or(Overlay::none) != Overlay::none &&
            scene.render.rasterizer == Rasterizer::driver)
          inner.error("overlay", "an overlay needs \"rasterizer\": \"exact\"");
      },
      maxPanels);
  fields.switchable("stage");
  fields.shorthand("stage", "preset");
  fields.group("stage", stageDoc, [&](Fields& inner) { scene.stage.describe(inner); });
  fields.group("sun", sunDoc, [&](Fields& inner) { scene.sun.describe(inner); });
  fields.group("sky", skyDoc, [&](Fields& inner) { scene.sky.describe(inner); });
  fields.shortNumber("haze", "distance");
  fields.optionalGroup("haze", scene.haze, hazeDoc);
  if (scene.haze && scene.render.rasterizer == Rasterizer::driver)
    fields.error("haze", "haze needs \"rasterizer\": \"exact\"");
  if (!scene.sky.picture.empty() && !fields.given("sun")) {
    scene.sun.intensity = 0.0F;
    scene.sun.shadow = false;
  }
  fields.switchable("ground");
  fields.optionalGroup("ground", scene.ground, groundDoc);
  if (scene.ground) scene.ground->solid = true;
  describeLights(fields, scene);
  remarkRays(fields, scene);
  remarkSun(fields, scene);
}

std::span<const Section> sections() {
  static const Section all[] = {section<Render>("render", renderDoc),
                                section<Time>("time", timeDoc),
                                section<Camera>("camera", cameraDoc),
                                section<Panel>("panels", panelsDoc),
                                section<Stage>("stage", stageDoc),
                                section<Sun>("sun", sunDoc),
                                section<Sky>("sky", skyDoc),
                                section<Haze>("haze", hazeDoc),
                                section<Ground>("ground", groundDoc),
                                section<Light>("lights", lightsDoc),
                                section<Material>("material", materialDoc),
                                section<Test>("test", testDoc),
                                section<Check>("checks", checksDoc)};
  return all;
}

int Scene::frameCount() const {
  return std::max(1, static_cast<int>(std::lround(time.duration * time.fps)));
}

}  // namespace simreel::scene
