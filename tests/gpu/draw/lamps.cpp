// Tests the lights of a scene on all types of drawables by comparison with closed forms.
#include "base/error.hpp"
#include "base/file.hpp"
#include "draw/lights/lamp_shadows.hpp"
#include "gpu/draw/ball_stage.hpp"
#include "gpu/draw/lamp_stage.hpp"
#include "gpu/draw/skin_stage.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <doctest/doctest.h>

namespace simreel::test::lamps_draw {

using Shape = sim::Instances::Shape;

namespace {

constexpr double pi = std::numbers::pi;

/// Returns pi times the specular lobe of a spherical light for F0 = 0.04: GGX, Smith's shadowing and
/// Schlick's Fresnel term, implemented independently of the shaders. `spread`: the light's radius divided
/// by its distance.
double lobeOf(glm::dvec3 normal, glm::dvec3 view, glm::dvec3 light, double roughness, double spread) {
  const glm::dvec3 half = glm::normalize(view + light);
  const double nh = std::fmax(glm::dot(normal, half), 0);
  const double alpha2 = std::pow(std::fmax(roughness * roughness, 0.002), 2) + spread * spread / 4;
  const double d = 1 + nh * nh * (alpha2 - 1);
  const auto hidden = [&](double c) { return (std::sqrt(1 + alpha2 * (1 / (c * c) - 1)) - 1) / 2; };
  const double nl = glm::dot(normal, light), nv = glm::dot(normal, view);
  const double lobe = alpha2 / (d * d) / (1 + hidden(nl) + hidden(nv)) / (4 * nl * nv);
  return std::fmin(lobe, 60) * (0.04 + 0.96 * std::pow(1 - glm::dot(light, half), 5));
}

/// Returns the brightness of the brightest pixel.
int brightest(const Picture& picture) {
  int maximum = 0;
  for (int y = 0; y < picture.size.y; ++y)
    for (int x = 0; x < picture.size.x; ++x) maximum = std::max(maximum, picture.brightness(x, y));
  return maximum;
}

}  // namespace

TEST_CASE("lights: a plane below a point has the illuminance I cos^3(theta) / h^2") {
  testContext();
  for (const bool shadow : {false, true})
    for (const float radius : {0.01F, 0.8F}) {
      CAPTURE(shadow);
      CAPTURE(radius);
      scene::Scene scene = fromAbove();
      scene.ground->color = glm::vec3(0.5F, 0.4F, 0.3F);
      const glm::vec3 place(0.3F, 1.5F, -0.4F);
      scene.lights = {lampAt(place, 6, shadow)};
      scene.lights[0].radius = radius;
      scene.lights[0].color = glm::vec3(1, 0.7F, 0.4F);
      const Picture picture = drawn(scene, {}, {65, 65});
      for (const auto& [x, y] : {std::pair{32, 32}, {34, 29}, {20, 40}, {3, 5}, {60, 33}, {48, 62}}) {
        const glm::dvec3 p = placeOf(x, y, 65);
        const glm::dvec3 to = glm::dvec3(place) - p;
        const double d = glm::length(to);
        const double theta = std::acos(to.y / d);
        const double illuminance = 6 * std::pow(std::cos(theta), 3) / (place.y * place.y);
        const glm::dvec3 view = glm::normalize(glm::dvec3(0, 20, 0) - p);
        const double mirrored = lobeOf({0, 1, 0}, view, to / d, 0.9, radius / d);
        const auto wanted =
            filmByte({illuminance / pi * (0.5 + mirrored), illuminance / pi * 0.7 * (0.4 + mirrored),
                      illuminance / pi * 0.4 * (0.3 + mirrored)});
        CHECK_MESSAGE(near(picture.at(x, y), wanted, 2.5), x, " ", y);
      }
    }
}

TEST_CASE("lights: a spot lights its cone and fades towards the edge") {
  testContext();
  for (const bool shadow : {false, true})
    for (const float softness : {0.0F, 0.4F, 1.0F}) {
      CAPTURE(shadow);
      CAPTURE(softness);
      scene::Scene scene = fromAbove();
      scene.ground->color = glm::vec3(0.5F);
      const glm::vec3 place(0.9F, 1.5F, -0.7F), target(-0.4F, 0.2F, 0.5F);
      scene.lights = {lampAt(place, 6, shadow), lampAt({-3, 2, -3}, 1, !shadow)};
      scene.lights[0].type = scene::Light::Type::spot;
      scene.lights[0].spot.target = target;
      scene.lights[0].spot.angle = 70.0F;
      scene.lights[0].spot.softness = softness;
      const Picture picture = drawn(scene, {}, {65, 65});
      const double edge = std::cos(35 * pi / 180),
                   full = std::cos(35 * (1 - static_cast<double>(softness)) * pi / 180);
      int within = 0, between = 0, beyond = 0;
      for (int y = 1; y < 65; y += 4)
        for (int x = 2; x < 65; x += 4) {
          const glm::dvec3 p = placeOf(x, y, 65);
          const auto lit = [&](glm::dvec3 from, double candela) {
            const glm::dvec3 to = from - p;
            const double d = glm::length(to);
            const glm::dvec3 view = glm::normalize(glm::dvec3(0, 20, 0) - p);
            return candela * to.y / (d * d * d) / pi *
                   (0.5 + lobeOf({0, 1, 0}, view, to / d, 0.9, 0.01 / d));
          };
          const double cosine =
              glm::dot(glm::normalize(p - glm::dvec3(place)), glm::normalize(glm::dvec3(target - place)));
          // Skips points within half a pixel of the cone's edge.
          if (softness == 0 && std::abs(cosine - edge) < 0.03) continue;
          const double line = softness == 0 ? (cosine > edge ? 1 : 0)
                                            : std::clamp((cosine - edge) / (full - edge), 0.0, 1.0);
          (line == 0 ? beyond : line == 1 ? within : between) += 1;
          const double light = lit(place, 6 * line * line) + lit({-3, 2, -3}, 1);
          CHECK_MESSAGE(near(picture.at(x, y), filmByte({light, light, light}), 3), x, " ", y);
        }
      CHECK(beyond > 50);
      CHECK((softness == 1 ? between : within) > 10);
    }
}

TEST_CASE("lights: reflection grows at grazing angles, for ground and surfaces, sun and lamps") {
  testContext();
  for (const bool ground : {true, false})
    for (const bool lamp : {true, false}) {
      CAPTURE(ground);
      CAPTURE(lamp);
      scene::Scene scene = fromAbove();
      scene.camera.position = glm::vec3(0, 1, 6);
      scene.camera.target = glm::vec3(0, 1, 0);
      scene.camera.fieldOfView = 40;
      scene.ground->color = glm::vec3(0);
      scene.ground->roughness = 0.5F;
      if (!ground) scene.ground.reset();
      GridStage sheet({9, 7}, {-20, 0, 20}, {40, 0, 0}, {0, 0, -40});
      sheet.material.color = glm::vec3(0);
      sheet.material.roughness = 0.5F;
      const glm::dvec3 place(0.2, 0.8, -7);
      const glm::dvec3 sun = glm::normalize(glm::dvec3(-0.05, 0.16, -1));
      if (lamp) {
        scene.lights = {lampAt(glm::vec3(place), 30, false)};
      } else {
        scene.sun.direction = glm::vec3(sun);
        scene.sun.intensity = 0.7F;
      }
      const Picture picture =
          ground ? drawn(scene, {}, {65, 65}) : drawn(scene, {.surfaces = {sheet.surface}}, {65, 65});
      int seen = 0;
      for (const auto& [x, y] : {std::pair{32, 42}, {32, 45}, {31, 48}, {36, 44}, {27, 46}, {33, 55}}) {
        const double half = std::tan(20 * pi / 180);
        const glm::dvec3 along((2 * (x + 0.5) / 65 - 1) * half, (1 - 2 * (y + 0.5) / 65) * half, -1);
        const glm::dvec3 p = glm::dvec3(0, 1, 6) - along / along.y;
        const glm::dvec3 to = place - p;
        const double d = glm::length(to);
        const double arriving = lamp ? 30 * to.y / (d * d * d) / pi : 0.7 * sun.y / pi;
        const double mirrored =
            lobeOf({0, 1, 0}, -glm::normalize(along), lamp ? to / d : sun, 0.5, lamp ? 0.01 / d : 0) *
            arriving;
        CHECK_MESSAGE(near(picture.at(x, y), filmByte({mirrored, mirrored, mirrored}), 4), x, " ", y);
        seen += mirrored > 0.05 && mirrored < 2 ? 1 : 0;
      }
      CHECK(seen >= 3);
    }
}

TEST_CASE("lights: smooth surfaces show a highlight as wide as the light's sphere") {
  testContext();
  for (const float radius : {0.01F, 0.9F})
    for (const float roughness : {0.25F, 0.5F}) {
      CAPTURE(radius);
      CAPTURE(roughness);
      scene::Scene scene = fromAbove();
      scene.ground->color = glm::vec3(0);
      scene.ground->roughness = roughness;
      const glm::vec3 place(0.4F, 1.5F, 0.3F);
      scene.lights = {lampAt(place, 9, false)};
      scene.lights[0].radius = radius;
      const Picture picture = drawn(scene, {}, {65, 65});
      int seen = 0;
      for (const auto& [x, y] : {std::pair{35, 34}, {33, 32}, {38, 36}, {41, 34}, {30, 40}}) {
        const glm::dvec3 p = placeOf(x, y, 65);
        const glm::dvec3 to = glm::dvec3(place) - p;
        const double d = glm::length(to);
        const glm::dvec3 view = glm::normalize(glm::dvec3(0, 20, 0) - p);
        const double illuminance = 9 * to.y / (d * d * d);
        const double mirrored = lobeOf({0, 1, 0}, view, to / d, roughness, radius / d) * illuminance / pi;
        CHECK_MESSAGE(near(picture.at(x, y), filmByte({mirrored, mirrored, mirrored}), 3.5), x, " ", y);
        seen += mirrored > 0.02 ? 1 : 0;
      }
      CHECK(seen >= 2);
    }
}

TEST_CASE("lights: sixteen lights add up to their sum, at their animated intensity") {
  testContext();
  for (const int shadowed : {0, 3, 8}) {
    scene::Scene scene = fromAbove();
    scene.lights = {lampAt({0.2F, 1, 0.1F}, 8, false)};
    const Picture one = drawn(scene, {}, {33, 33});
    scene.lights.clear();
    for (int i = 0; i < 16; ++i) {
      scene.lights.push_back(lampAt({0.2F, 1, 0.1F}, 0, i < shadowed));
      // Every second light is off at time 0. The other lights have twice their mean intensity.
      const float now = i % 2 == 0 ? 1.0F : 0.0F;
      scene.lights.back().intensity = scene::Animated<float>({{0, now}, {1, 1 - now}}, scene::Ease::linear);
      scene.lights.back().shadowSize = 32 + i;
    }
    const Picture several = drawn(scene, {}, {33, 33});
    CHECK(brightest(one) > 300);
    CHECK(compare(several, one).mean < 0.6);
    CHECK(compare(several, one).far == 0);
  }
}

TEST_CASE("lights: every type of drawable is lit") {
  testContext();
  // The light is on the camera's side of the object. There is no other light.
  scene::Scene scene = darkScene();
  scene.sun.intensity = 0.0F;
  const auto gained = [&](const sim::Drawables& drawables) {
    scene.lights.clear();
    const int dark = drawn(scene, drawables, {33, 33}).brightness(16, 16);
    int minimum = 765;
    for (const bool shadow : {false, true}) {
      scene.lights = {lampAt({0, 0.5F, 4}, 40, shadow)};
      minimum = std::min(minimum, drawn(scene, drawables, {33, 33}).brightness(16, 16) - dark);
    }
    return minimum;
  };
  CHECK(gained({}) == 0);

  GridStage sheet({7, 9}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
  CHECK(gained({.surfaces = {sheet.surface}}) > 200);
  sheet.material.metallic = 1;
  CHECK(gained({.surfaces = {sheet.surface}}) > 60);
  sheet.material.metallic = 0;
  sheet.material.roughness = 0.3F;
  CHECK(gained({.surfaces = {sheet.surface}}) > 200);
  MeshStage mesh(squareMesh());
  CHECK(gained({.surfaces = {mesh.surface}}) > 200);

  InstanceStage balls(std::vector<glm::vec3>(1, glm::vec3(0)));
  for (const Shape shape : {Shape::sprite, Shape::sphere})
    for (const float size : {1.5F, 0.25F}) {
      CAPTURE(static_cast<int>(shape));
      CAPTURE(size);
      balls.instances.shape = shape;
      balls.instances.size = size;
      // The small balls have a radius of 1.3 pixels and are drawn by separate kernels.
      CHECK(gained({.instances = {balls.instances}}) > 100);
    }
  const auto file = temporaryFile("lamp_plate.obj");
  writeFileAtomically(file, "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 3 4\n");
  balls.instances.shape = Shape::mesh;
  balls.instances.mesh = file;
  balls.instances.size = 1;
  CHECK(gained({.instances = {balls.instances}}) > 200);
  std::filesystem::remove(file);

  scene = fromAbove();
  scene.ground->roughness = 0.9F;
  CHECK(gained({}) > 60);
  scene.ground->roughness = 0.3F;  // reflective ground
  CHECK(gained({}) > 60);
  // The ground is drawn in two parts, within the bounds of the sun's shadow map and around them.
  scene.sun.shadow = true;
  GridStage left({3, 3}, {-2, 0.5F, -2}, {1, 0, 0}, {0, 0, 1});
  GridStage right({3, 3}, {1, 0.5F, 1}, {1, 0, 0}, {0, 0, 1});
  // The sampled point is outside the bounds of the sun's shadow map.
  CHECK(gained({.surfaces = {right.surface}}) > 60);
  // The sampled point is inside the bounds of the sun's shadow map.
  CHECK(gained({.surfaces = {left.surface, right.surface}}) > 60);
}

TEST_CASE("lights: skins are lit") {
  testContext();
  FieldStage field(sim::Field::Cells::floats, {17, 13}, [](int, int) { return 0.25; });
  field.field.display = nullptr;
  scene::Scene scene = roomWith(grown(scene::Skin::Look::spots));
  scene.sun.intensity = 0.0F;
  MeshStage mesh(squareMesh());
  mesh.surface.material = &scene.objects[0].material;
  const sim::Drawables drawables{.surfaces = {mesh.surface}, .fields = {field.field}};
  const int dark = drawn(scene, drawables, {33, 33}).brightness(16, 16);
  scene.lights = {lampAt({0, 0.5F, 4}, 40, true)};
  CHECK(drawn(scene, drawables, {33, 33}).brightness(16, 16) > dark + 100);
}

TEST_CASE("lights: translucent surfaces transmit lamp light") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.intensity = 0.0F;
  scene.lights = {lampAt({0, 0, -2}, static_cast<float>(4 * pi), true)};
  GridStage sheet({4, 4}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
  sheet.material.color = glm::vec3(0.8F);
  CHECK(drawn(scene, {.surfaces = {sheet.surface}}, {33, 33}).brightness(16, 16) < 6);
  sheet.material.translucency = 0.5F;
  const Picture picture = drawn(scene, {.surfaces = {sheet.surface}}, {33, 33});
  CHECK(near(picture.at(16, 16), filmByte({0.4, 0.4, 0.4}), 2.5));
}

TEST_CASE("lights: one ball of any shape, lit from nearby, looks like a sphere mesh with its shadow") {
  testContext();
  scene::Scene scene;
  scene.camera.position = glm::vec3(0.3F, 1.6F, 4);
  scene.camera.target = glm::vec3(0, 0.5F, 0);
  scene.ground.emplace();
  scene.ground->height = 0;
  scene.sun.intensity = 0.0F;
  scene.sun.shadow = false;
  scene.sky.ambient = 0.1F;
  scene.lights = {lampAt({0.9F, 1.9F, 1.2F}, 16, true), lampAt({-1.6F, 2.3F, 0.2F}, 12, true)};
  for (const float roughness : {0.25F, 0.9F}) {
    CAPTURE(roughness);
    SphereStage sphere({-0.4F, 0.9F, 0.2F}, 0.6F);
    sphere.material.roughness = roughness;
    const Picture wanted = drawn(scene, {{sphere.surface}, {}}, {161, 121});
    CHECK(compare(wanted, drawn(scene, {}, {161, 121})).far > 2000);
    InstanceStage group({{-0.4F, 0.9F, 0.2F, 8}, {-0.4F, 0.9F, 0.2F, 1}}, {glm::vec4(0), {0, 0, 0, -1}});
    group.instances.size = 0.6F;
    group.instances.massExponent = 1.0F / 3;
    group.material.roughness = roughness;
    for (const Shape shape : {Shape::sphere, Shape::sprite}) {
      CAPTURE(static_cast<int>(shape));
      group.instances.shape = shape;
      const Difference d = compare(drawn(scene, {{}, {group.instances}}, {161, 121}), wanted);
      CHECK(d.mean < 0.55);  // The silhouettes of two shadows differ, because the maps use coarser spheres.
      CHECK(d.far < 90);
    }
  }
}

TEST_CASE("lights: a visible light has the brightness of its candela") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.intensity = 0.0F;
  scene.lights = {lampAt({0, 0, 0}, 0.12F, false), lampAt({50, 0, 0}, 1, false)};
  scene.lights[0].glow = 1.0F;
  scene.lights[0].radius = 0.4F;
  for (const int samples : {1, 4}) {
    const Picture picture = drawn(scene, {}, {65, 65}, samples);
    // 65 pixels span 2 * 5 m * tan(20 degrees). At r radii from its centre, the glow disc has the fraction
    // (1 - r^2)^2 of the radiance at the centre.
    const double metres = 10 * std::tan(20 * pi / 180) / 65;
    for (const int aside : {0, 3, 5}) {
      const double r = aside * metres / 0.4;
      const double light = 3 * 0.12 / (pi * 0.16) * std::pow(1 - r * r, 2);
      const double byte = filmByte({light, light, light})[1];
      CHECK(std::abs(picture.at(32 + aside, 32).y - byte) < 8);
    }
    CHECK(picture.brightness(32, 43) < 6);
  }
  GridStage sheet({4, 4}, {-1, 1, 1}, {2, 0, 0}, {0, -2, 0});
  // the sheet hides the light
  CHECK(drawn(scene, {.surfaces = {sheet.surface}}, {65, 65}).brightness(32, 32) < 6);
  scene.lights[0].glow = 0.0F;
  CHECK(drawn(scene, {}, {65, 65}).brightness(32, 32) < 6);
}

TEST_CASE("lights: scenes without lights compile no light code, and too many lights are refused") {
  testContext();
  scene::Scene scene = darkScene();
  const draw::Lamps none(scene);
  CHECK(!none.on());
  CHECK(none.defines().empty());
  CHECK(!draw::LampShadows(none).on());
  scene.lights.assign(8, lampAt({0, 1, 0}, 1, true));
  // eight lights with six maps each; each light has one row of six maps
  const int side = gl::limits().textureSize / 4;
  for (scene::Light& light : scene.lights) light.shadowSize = side;
  const draw::Lamps lamps(scene);
  try {
    const draw::LampShadows shadows(lamps);
    FAIL("a texture of ", 6 * side, "x", 8 * side, " texels");
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::device);
    CHECK(std::string(error.what()).find(fmt::format("{}x{} texels", 6 * side, 8 * side)) !=
          std::string::npos);
    CHECK(std::string(error.what()).find("GL_MAX_TEXTURE_SIZE") != std::string::npos);
  }
}

}  // namespace simreel::test::lamps_draw
