// Tests material maps, holes and blending in whole pictures.
#include "draw/exact/scene/apart.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr glm::ivec2 size{160, 160};
constexpr draw::RendererOptions exactly{.rasterizer = scene::Rasterizer::exact};

scene::Map picture(glm::ivec2 size, const std::vector<std::uint8_t>& rgba) {
  return {{},
          std::make_shared<const scene::Image>(scene::Image{"test", size, rgba}),
          scene::Wrap::clamp,
          scene::Wrap::clamp};
}

/// A square at height z that faces +z. Its sides have the length 2 * `half`. Its uv origin is at the upper
/// left.
struct Square : GridStage {
  Square(float z, float half) : GridStage({2, 2}, {-half, half, z}, {2 * half, 0, 0}, {0, -2 * half, 0}) {
    material.color = glm::vec3(0);
    material.roughness = 1;
  }
  /// A square that emits light and is blended if `opacity` is below 1.
  Square(float z, float half, glm::vec3 light, float opacity) : Square(z, half) {
    material.finish.emission = light;
    material.finish.alpha = opacity < 1 ? scene::Alpha::blend : scene::Alpha::opaque;
    material.finish.opacity = opacity;
  }
};

scene::Scene plainlyShown() {
  scene::Scene scene = darkScene();
  scene.render.tone = scene::Tone::plain;
  scene.sun.shadow = false;
  return scene;
}

scene::Scene unlit() {
  scene::Scene scene = plainlyShown();
  scene.sun.intensity = 0.0F;
  return scene;
}

double linear(int byte) {
  const double v = byte / 255.0;
  return v < 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

void checkLight(const Picture& picture, int x, int y, glm::dvec3 wanted) {
  const glm::ivec3 found = picture.at(x, y);
  for (int i = 0; i < 3; ++i) CHECK(std::abs(linear(found[i]) - wanted[i]) < 0.009);
}

/// Returns the pixel column of the position x (m) at z = 0.
int columnOf(double x) {
  return static_cast<int>(std::lround(80 + x / (5 * std::tan(20 * 3.14159265 / 180)) * 80));
}

}  // namespace

TEST_CASE("blended surfaces: from the nearest to what is opaque, in whatever order they come") {
  testContext();
  const glm::dvec3 back(0.2, 0.4, 0.1), middle(0.8, 0.1, 0.3), front(0.05, 0.2, 0.9);
  const Square behind(0, 1.5F, back, 1), between(1, 0.8F, middle, 0.25F), before(1.5F, 0.4F, front, 0.6F);
  const glm::dvec3 twice = 0.25 * middle + 0.75 * back;
  const auto shown =
      drawn(unlit(), {.surfaces = {behind.surface, between.surface, before.surface}}, size, 4, exactly);
  checkLight(shown, 80, 80, 0.6 * front + 0.4 * twice);
  checkLight(shown, 80 + 30, 80, twice);
  checkLight(shown, 80 + 55, 80, back);
  const std::vector<std::vector<sim::Surface>> orders = {{before.surface, between.surface, behind.surface},
                                                         {between.surface, behind.surface, before.surface}};
  for (const auto& order : orders)
    CHECK(drawn(unlit(), {.surfaces = order}, size, 4, exactly).bytes == shown.bytes);
  for (const char* layout : {"apart", "pairs"}) {
    const LayoutForced asked(layout);
    CHECK(drawn(unlit(), {.surfaces = orders[0]}, size, 4, exactly).bytes == shown.bytes);
  }
}

TEST_CASE("blended surfaces: equally near ones come by their numbers, the first one before the others") {
  testContext();
  const glm::dvec3 back(0.2, 0.4, 0.1), first(0.8, 0.1, 0.3), second(0.05, 0.2, 0.9);
  const Square behind(0, 1.5F, back, 1), one(1, 0.8F, first, 0.5F), other(1, 0.8F, second, 0.25F);
  const auto shown =
      drawn(unlit(), {.surfaces = {one.surface, other.surface, behind.surface}}, size, 4, exactly);
  checkLight(shown, 80, 80, 0.5 * first + 0.5 * (0.25 * second + 0.75 * back));
}

TEST_CASE("blended surfaces: at each sample by itself, and hidden by what is opaque before them") {
  testContext();
  const glm::dvec3 back(0.5, 0.5, 0.5), pane(0.0, 0.9, 0.0), front(0.9, 0.0, 0.0);
  const Square behind(0, 1.5F, back, 1), glass(1, 1.5F, pane, 0.5F), before(2, 0.31F, front, 1);
  const auto shown =
      drawn(unlit(), {.surfaces = {behind.surface, glass.surface, before.surface}}, size, 4, exactly);
  checkLight(shown, 80, 80, front);
  // A pixel on the edge of the front square shows only a mix of two colours. One is the colour of the front
  // square, and the other is the colour of the pane over the back square.
  const glm::dvec3 beside = 0.5 * pane + 0.5 * back;
  checkLight(shown, 80 + 45, 80, beside);
  int edges = 0;
  for (int x = 80; x < 125; ++x) {
    const double part = linear(shown.at(x, 80).b) / beside.b;
    if (part < 0.1 || part > 0.9) continue;
    ++edges;
    checkLight(shown, x, 80, (1 - part) * front + part * beside);
  }
  CHECK(edges > 0);
}

TEST_CASE("blended surfaces: sixteen layers, and what is opaque behind them") {
  testContext();
  std::vector<std::unique_ptr<Square>> panes;
  std::vector<sim::Surface> surfaces;
  double left = 1;
  for (int i = 0; i < draw::TransparentSurfaces::maximum + 3; ++i) {
    panes.push_back(std::make_unique<Square>(0.1F * static_cast<float>(i), 0.5F, glm::vec3(0), 0.1F));
    surfaces.push_back(panes.back()->surface);
    if (i < draw::TransparentSurfaces::maximum) left *= 0.9;
  }
  const Square behind(-0.1F, 1.5F, glm::vec3(0.9F), 1);
  surfaces.push_back(behind.surface);
  checkLight(drawn(unlit(), {.surfaces = surfaces}, size, 1, exactly), 80, 80, glm::dvec3(0.9 * left));
}

TEST_CASE("cut surfaces: holes where the map's opacity is low, in what they hide and in their shadows") {
  testContext();
  Square leaf(1, 0.5F), wall(0, 2);
  leaf.material.finish.color = picture({2, 1}, {255, 255, 255, 255, 255, 255, 255, 0});
  leaf.material.finish.alpha = scene::Alpha::cut;
  wall.material.color = glm::vec3(0.7F);
  scene::Scene scene = plainlyShown();
  scene.sun.shadow = true;
  scene.sun.shadowSoftness = 0.0F;
  scene.sun.direction = glm::vec3(1, 0, 1);
  const auto shown = drawn(scene, {.surfaces = {leaf.surface, wall.surface}}, size, 4, exactly);
  CHECK(shown.brightness(80 - 20, 80) < 90);   // the leaf, which is black except for its specular
                                               // reflection
  CHECK(shown.brightness(80 + 20, 80) > 300);  // the wall behind the leaf's hole
  // The leaf is 1 m in front of the wall, so its shadow is shifted 1 m to the left.
  CHECK(shown.brightness(columnOf(-1.25), 80) < 30);
  CHECK(shown.brightness(columnOf(-0.75), 80) > 300);
  CHECK(shown.brightness(columnOf(-1.7), 80) > 300);
  for (const char* layout : {"apart", "pairs"}) {
    const LayoutForced asked(layout);
    CHECK(drawn(scene, {.surfaces = {wall.surface, leaf.surface}}, size, 4, exactly).bytes == shown.bytes);
  }
  // With cutoff 0 the leaf has no holes. If its opacity is below the cutoff, it is not drawn.
  leaf.material.finish.cutoff = 0.0F;
  CHECK(drawn(scene, {.surfaces = {leaf.surface, wall.surface}}, size, 4, exactly).brightness(80 + 20, 80) <
        90);
  leaf.material.finish.color = {};
  leaf.material.finish.opacity = 0.4F;
  leaf.material.finish.cutoff = 0.5F;
  CHECK(drawn(scene, {.surfaces = {leaf.surface, wall.surface}}, size, 4, exactly).brightness(80 - 20, 80) >
        300);
}

TEST_CASE("cut surfaces: without holes, surfaces of every size look like opaque ones") {  // 2 s
  testContext();
  // Each surface takes more loop iterations than software drivers allow an invocation: a triangle of at
  // most 64 pixels, a long strip, and a plane that fills a large picture.
  Square small(0, 0.68F), large(0, 8);
  GridStage strip({2, 2}, {-6, 0.2F, 0}, {13, 0, 0}, {0, -0.42F, 0});
  const auto check = [](GridStage& shown, glm::ivec2 pixels, int samples) {
    CAPTURE(pixels.x);
    shown.material.finish.emission = glm::vec3(0.5F);
    shown.material.finish.color = picture({1, 1}, {255, 255, 255, 255});
    const auto opaque = drawn(unlit(), {.surfaces = {shown.surface}}, pixels, samples, exactly);
    shown.material.finish.alpha = scene::Alpha::cut;
    CHECK(drawn(unlit(), {.surfaces = {shown.surface}}, pixels, samples, exactly).bytes == opaque.bytes);
  };
  check(small, size, 16);
  check(strip, {320, 180}, 8);
  check(large, {1920, 1080}, 8);
}

TEST_CASE("cut surfaces: holes in the shadows of lamps") {
  testContext();
  Square leaf(1, 0.5F), wall(0, 2);
  leaf.material.finish.color = picture({2, 1}, {255, 255, 255, 255, 255, 255, 255, 0});
  leaf.material.finish.alpha = scene::Alpha::cut;
  wall.material.color = glm::vec3(0.7F);
  scene::Scene scene = unlit();
  scene::Light lamp;
  lamp.position = glm::vec3(2, 0, 2);  // a point x at z = 1 casts its shadow at 2 x - 2
  lamp.intensity = 60.0F;
  lamp.shadowSoftness = 0;
  lamp.glow = 0;
  scene.lights = {lamp};
  const auto shown = drawn(scene, {.surfaces = {leaf.surface, wall.surface}}, size, 4, exactly);
  CHECK(shown.brightness(columnOf(-1.5), 80) > 60);  // light through the hole, which extends from x = 0 to
                                                     // 0.5
  leaf.material.finish.color = picture({2, 1}, {255, 255, 255, 0, 255, 255, 255, 255});
  CHECK(drawn(scene, {.surfaces = {leaf.surface, wall.surface}}, size, 4, exactly)
            .brightness(columnOf(-1.5), 80) == 0);
}

TEST_CASE("maps: normals lean as their colours say, and other maps are factors") {
  testContext();
  const auto lightFrom = [](const scene::Material& material, glm::vec3 direction) {
    Square square(0, 1);
    square.material = material;
    scene::Scene scene = plainlyShown();
    scene.sun.direction = direction;
    return linear(drawn(scene, {.surfaces = {square.surface}}, size, 1, exactly).at(80, 80).g);
  };
  scene::Material material;
  material.color = glm::vec3(0.8F);
  material.roughness = 1;
  const std::uint8_t up = 204, half = 128, down = 51, out = 230;  // texel values that encode the normal
                                                                  // components 0.6, 0, -0.6, 0.8
  material.finish.normals = picture({1, 1}, {up, half, out, 255});
  CHECK(lightFrom(material, {1, 0, 0}) == doctest::Approx(0.6 * 0.8).epsilon(0.08));
  CHECK(lightFrom(material, {-1, 0, 0}) < 0.01);
  material.finish.normals = picture({1, 1}, {half, up, out, 255});
  CHECK(lightFrom(material, {0, 1, 0}) == doctest::Approx(0.6 * 0.8).epsilon(0.08));
  CHECK(lightFrom(material, {0, -1, 0}) < 0.01);
  material.finish.normals = picture({1, 1}, {half, down, out, 255});
  CHECK(lightFrom(material, {0, -1, 0}) == doctest::Approx(0.6 * 0.8).epsilon(0.08));
  material.finish.normalStrength = -1;
  CHECK(lightFrom(material, {0, 1, 0}) == doctest::Approx(0.6 * 0.8).epsilon(0.08));
  material.finish.normals = {};
  // Colour is sRGB. Metal has no diffuse reflection. Roughness and metallic are the green and blue
  // channels.
  material.finish.color = picture({1, 1}, {188, 188, 188, 255});
  CHECK(lightFrom(material, {0.8F, 0, 0.6F}) == doctest::Approx(0.6 * 0.8 * linear(188)).epsilon(0.08));
  material.metallic = 1;
  CHECK(lightFrom(material, {0.8F, 0, 0.6F}) < 0.15);
  material.finish.metalRough = picture({1, 1}, {255, 255, 0, 255});
  CHECK(lightFrom(material, {0.8F, 0, 0.6F}) == doctest::Approx(0.6 * 0.8 * linear(188)).epsilon(0.08));
}

TEST_CASE("maps: beyond their border they repeat, extend their last texels, or are mirrored") {
  testContext();
  Square square(0, 1, glm::vec3(1), 1);
  square.material.textureScale = glm::vec3(2, 1, 1);
  square.material.finish.emissionMap = picture({2, 1}, {255, 0, 0, 255, 0, 255, 0, 255});
  // The four quarters of the square along u show the map's left texel, its right texel, and the texels at u
  // = 1.25 and 1.75.
  const auto quarters = [&](scene::Wrap wrap) {
    square.material.finish.emissionMap.wrapU = wrap;
    const auto shown = drawn(unlit(), {.surfaces = {square.surface}}, size, 1, exactly);
    std::string colors;
    for (const double x : {-0.75, -0.25, 0.25, 0.75}) {
      const glm::ivec3 found = shown.at(columnOf(x), 80);
      colors += found.r > 200 ? 'r' : found.g > 200 ? 'g' : '-';
    }
    return colors;
  };
  CHECK(quarters(scene::Wrap::repeat) == "rgrg");
  CHECK(quarters(scene::Wrap::clamp) == "rggg");
  CHECK(quarters(scene::Wrap::mirror) == "rggr");
}

TEST_CASE("maps: light of their own and of the surroundings") {
  testContext();
  Square square(0, 1, {0.5F, 0.25F, 1}, 1);
  square.material.finish.emissionStrength = 0.5F;
  square.material.finish.emissionMap = picture({2, 1}, {255, 255, 255, 255, 0, 188, 0, 255});
  const auto shown = drawn(unlit(), {.surfaces = {square.surface}}, size, 1, exactly);
  checkLight(shown, 80 - 30, 80, {0.25, 0.125, 0.5});
  checkLight(shown, 80 + 30, 80, {0, 0.125 * linear(188), 0});
  square.material.finish = {};
  square.material.color = glm::vec3(0.8F);
  square.material.finish.occlusion = picture({2, 1}, {255, 0, 0, 255, 51, 0, 0, 255});
  square.material.finish.occlusionStrength = 0.5F;
  scene::Scene scene = unlit();
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0.5F);
  const auto open = drawn(scene, {.surfaces = {square.surface}}, size, 1, exactly);
  const double light = linear(open.at(80 - 30, 80).g);
  CHECK(light > 0.2);
  CHECK(linear(open.at(80 + 30, 80).g) == doctest::Approx(0.6 * light).epsilon(0.03));
}
