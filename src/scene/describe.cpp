// Parameters of every section of a scene, declared once.
#include "scene/describe.hpp"

namespace simreel::scene {

namespace {

constexpr Range unit{0, 1};
constexpr Range colorRange{0, 1000};

}  // namespace

void Material::describe(Fields& f) {
  f.vector("color", color, colorRange, "linear RGB", "Multiplied with the texture.");
  f.asset("texture", texture, "Picture of the surface colour (sRGB), in the scene's folder or the asset folder.");
  f.vector("textureScale", textureScale, {-1e4, 1e4}, "", "Repeats of the texture along u and v; the third is unused.");
  f.number("roughness", roughness, {0.04, 1}, "", "0.04 polished, 1 chalk.");
  f.number("metallic", metallic, unit, "", "0 for cloth, wood, stone; 1 for bare metal.");
  f.number("translucency", translucency, unit, "", "Share of the light from behind that shines through.");
}

void Render::describe(Fields& f) {
  f.pair("size", size, {1, 16384}, "pixels", "Width and height of the picture.");
  f.integer("samples", samples, {1, 16}, "per pixel", "Anti-aliasing; 1 is none.");
  f.number("exposure", exposure, {-20, 20}, "EV", "Brightness; each step doubles it.");
  f.number("vignette", vignette, unit, "", "Darkening towards the corners.");
}

void Time::describe(Fields& f) {
  f.number("fps", fps, {1e-3, 1e5}, "1/s", "Frames per second of scene time.");
  f.number("start", start, {0, 1e6}, "s", "Simulated before frame 0, which is at time 0.");
  f.number("duration", duration, {0, 1e6}, "s", "Length of the sequence.");
  if ((start + duration) * fps > 1e7) f.error("duration", "more than 10 million frames; shorten it or lower fps");
}

void Camera::describe(Fields& f) {
  f.vector("position", position, anyNumber, "m", "Where the camera is.");
  f.vector("target", target, anyNumber, "m", "What it looks at.");
  f.number("fieldOfView", fieldOfView, {1, 170}, "degrees", "Vertical angle of view.");
  f.number("roll", roll, anyNumber, "degrees", "Turn about the line of sight.");
  f.number("near", near, {1e-5, 1e5}, "m", "Nothing nearer is drawn.");
  f.number("far", far, {1e-4, 1e6}, "m", "Nothing farther is drawn.");
  if (near >= far) f.error("near", "near must be less than far");
  if (!position.moves() && !target.moves() && position.at(0) == target.at(0))
    f.error("target", "the camera's position and target are the same point");
}

void Sun::describe(Fields& f) {
  f.vector("direction", direction, anyNumber, "", "Towards the light; any length.");
  f.vector("color", color, colorRange, "linear RGB", "Of the light.");
  f.number("intensity", intensity, {0, 1e4}, "", "Factor on the colour.");
  f.boolean("shadow", shadow, "Whether it casts shadows.");
  f.integer("shadowSize", shadowSize, {64, 8192}, "texels", "Side of the shadow map.");
  f.number("shadowSoftness", shadowSoftness, {0, 16}, "texels", "Radius of the shadow's soft edge.");
  if (!direction.moves() && direction.at(0) == glm::vec3(0)) f.error("direction", "the direction has no length");
}

void Sky::describe(Fields& f) {
  f.vector("zenith", zenith, colorRange, "linear RGB", "Colour overhead.");
  f.vector("horizon", horizon, colorRange, "linear RGB", "Colour at the horizon.");
  f.vector("ground", ground, colorRange, "linear RGB", "Light from below, and the background there.");
  f.number("ambient", ambient, {0, 100}, "", "Factor on the light the sky gives.");
}

void Ground::describe(Fields& f) {
  f.number("height", height, anyNumber, "m", "Of the plane; everything collides with it.");
  f.boolean("visible", visible, "Whether it is drawn.");
  f.vector("color", color, colorRange, "linear RGB", "Of the plane.");
  f.number("roughness", roughness, {0.04, 1}, "", "0.04 polished, 1 chalk.");
  f.number("fadeStart", fadeStart, {0, 1e6}, "m", "Distance from the camera's target where it begins to fade into the sky.");
  f.number("fadeEnd", fadeEnd, {0, 1e6}, "m", "Distance where it has faded.");
  if (fadeEnd <= fadeStart) f.error("fadeEnd", "fadeEnd must be more than fadeStart");
}

void describeScene(Fields& f, Scene& scene) {
  f.text("title", scene.title, "Name of the picture, for people.");
  f.integer("seed", scene.seed, {0, 2147483647}, "", "Of all random numbers.");
  f.choice("numerics", scene.numerics, {"exact", "fast"},
           "exact: the state has the same bits on every device; fast: built-in functions.");
  f.group("render", "The picture.", [&](Fields& g) { scene.render.describe(g); });
  f.group("time", "Frame rate and length.", [&](Fields& g) { scene.time.describe(g); });
  f.group("camera", "Where the picture is taken from.", [&](Fields& g) { scene.camera.describe(g); });
  f.group("sun", "The directional light.", [&](Fields& g) { scene.sun.describe(g); });
  f.group("sky", "Ambient light and background.", [&](Fields& g) { scene.sky.describe(g); });
  f.optionalGroup("ground", scene.hasGround, "A ground plane, drawn and collided with.",
                  [&](Fields& g) { scene.ground.describe(g); });
}

}  // namespace simreel::scene
