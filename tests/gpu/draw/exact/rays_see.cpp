// Tests materials at ray hits by comparison with closed forms and with directly visible materials.
#include "draw/surface/skin_look.hpp"
#include "gpu/draw/exact/ray_stage.hpp"
#include "gpu/draw/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

using namespace simreel;  // NOLINT

namespace {

scene::Map mapOfTexels(glm::ivec2 size, const std::vector<std::uint8_t>& rgba) {
  return {{},
          std::make_shared<const scene::Image>(scene::Image{"test", size, rgba}),
          scene::Wrap::clamp,
          scene::Wrap::clamp};
}

/// A black matt rectangle, given by a corner and two edges.
struct Sheet : GridStage {
  Sheet(glm::vec3 corner, glm::vec3 across, glm::vec3 down) : GridStage({2, 2}, corner, across, down) {
    material.color = glm::vec3(0);
    material.roughness = 1;
  }
};

scene::Scene lightless(int raySamples) {
  scene::Scene scene = furnace(raySamples);
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0);
  return scene;
}

/// Returns the form factor from a small patch to a parallel rectangle a by b, one corner of which is at
/// `height` above the patch (Howell, B-3).
double cornerFactor(double a, double b, double height) {
  const double x = a / height, y = b / height;
  const double rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
  return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * std::numbers::pi);
}

}  // namespace

TEST_CASE("rays see: what shines lights the ground by its form factor") {
  testContext();
  scene::Scene scene = furnace(256);
  setGround(scene, 0.5F);
  lookDown(scene, 0.8F, 4);
  const double open = rayPicture(scene, {}, {8, 8}).mean({1, 1}, {7, 7}).x;
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0);
  Sheet lit({-1.5F, 1, -1}, {3, 0, 0}, {0, 0, 2});
  lit.material.finish.emission = glm::vec3(1, 0.5F, 0);
  lit.material.finish.emissionStrength = 2;
  const glm::dvec3 found = rayPicture(scene, {.surfaces = {lit.surface}}, {8, 8}).mean({1, 1}, {7, 7});
  const double factor = 4 * cornerFactor(1.5, 1, 1);
  CHECK(found.x == doctest::Approx(2 * factor * open).epsilon(0.02));
  CHECK(found.y == doctest::Approx(factor * open).epsilon(0.02));
  CHECK(found.z == 0);
}

TEST_CASE("rays see: what lies within a lamp's radius keeps out none of its light") {
  testContext();
  scene::Scene scene = lightless(64);
  setGround(scene, 0.5F);
  lookDown(scene, 0.8F, 4);
  scene::Light& lamp = scene.lights.emplace_back();
  lamp.position = glm::vec3(0, 2, 0);
  lamp.shadow = true;
  const auto under = [&](float radius) {
    lamp.radius = radius;
    const Sheet sheet({-0.2F, 1.9F, -0.2F}, {0.4F, 0, 0}, {0, 0, 0.4F});
    return rayPicture(scene, {.surfaces = {sheet.surface}}, {8, 8}).mean({1, 1}, {7, 7}).x;
  };
  const double open = rayPicture(scene, {}, {8, 8}).mean({1, 1}, {7, 7}).x;
  CHECK(open > 0);
  CHECK(under(0.4F) == doctest::Approx(open).epsilon(0.02));
  CHECK(under(0.05F) < 0.1 * open);
}

TEST_CASE(
    "rays see: maps of colour and of light, a texture's relief, and vertices' colours, are in mirrors as "
    "the "
    "eye sees them") {
  testContext();
  enum class Of { map, light, vertices, relief };
  // A ramp along x from black to white, 1 m wide, at the centre.
  const ImageFile ramp(2, 1, {0, 0, 0, 255, 255, 255, 255, 255});
  for (const Of of : {Of::map, Of::light, Of::vertices, Of::relief}) {
    CAPTURE(static_cast<int>(of));
    const bool shines = of == Of::light;
    scene::Scene scene = lightless(64);
    scene.sun.intensity = shines ? 0.0F : 3.0F;
    scene.sun.direction = glm::vec3(0, 0.3F, 1);
    Sheet sheet({-1, 2, 0}, {2, 0, 0}, {0, -1, 0});  // an upright, double-sided sheet
    const scene::Map texels =
        mapOfTexels({2, 2}, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
    if (shines) {
      sheet.material.finish.emission = glm::vec3(1);
      sheet.material.finish.emissionMap = texels;
    } else {
      sheet.material.color = glm::vec3(0.9F);
      if (of == Of::map) sheet.material.finish.color = texels;
      if (of == Of::relief) {
        scene.sun.direction = glm::vec3(1, 0.3F, 1);  // The light comes from the side, so that the relief
                                                      // changes it.
        sheet.material.texture = ramp.path();
        sheet.material.bump = 0.3F;
      }
      if (of == Of::vertices) sheet.tint({{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}});
    }
    TriangleStage mirror({{-9, 0, -9}, {9, 0, -9}, {-9, 0, 9}, {9, 0, 9}}, {0, 2, 1, 1, 2, 3});
    mirror.material.color = glm::vec3(1);
    mirror.material.metallic = 1;
    mirror.material.roughness = 0;
    scene.camera.position = glm::vec3(0, 1.5F, 6);
    scene.camera.target = glm::vec3(0, -1.5F, 0);
    scene.camera.fieldOfView = 20;
    const sim::Drawables drawables{.surfaces = {sheet.surface, mirror.surface}};
    const RayPicture mirrored = rayPicture(scene, drawables, {48, 48});
    // The camera is the mirror image of the first camera.
    scene.camera.position = glm::vec3(0, -1.5F, 6);
    scene.camera.target = glm::vec3(0, 1.5F, 0);
    const RayPicture seen = rayPicture(scene, {.surfaces = {sheet.surface}}, {48, 48});
    double worst = 0, maximum = 0;
    for (int y = 16; y < 32; ++y)
      for (int x = 12; x < 36; ++x) {
        const glm::dvec3 a = mirrored.at(x, y), b = seen.at(x, 47 - y);
        for (int i = 0; i < 3; ++i) {
          worst = std::max(worst, std::abs(a[i] - b[i]));
          maximum = std::max(maximum, b[i]);
        }
      }
    CHECK(maximum > 0.5);                             // The brightest pixel proves that the sheet is
                                                      // visible.
    CHECK(worst < (of == Of::relief ? 0.03 : 0.05));  // For the relief, the difference would be 0.11 if the
                                                      // reflected sheet were flat.
  }
}

TEST_CASE("rays see: light comes through holes, and through what is blended as far as it lets it") {
  testContext();
  scene::Scene scene = lightless(64);
  scene.sun.intensity = 3.0F;
  scene.sun.color = glm::vec3(1);
  scene.sun.direction = glm::vec3(0, 1, 0);
  setGround(scene, 0.5F);
  lookDown(scene, 0.8F, 40);
  Sheet sheet({-2, 1, -2}, {4, 0, 0}, {0, 0, 4});
  const RayPicture open = rayPicture(scene, {}, {32, 32});
  const auto shares = [&] {
    const RayPicture covered = rayPicture(scene, {.surfaces = {sheet.surface}}, {32, 32});
    return std::pair(covered.mean({2, 2}, {14, 30}).x / open.mean({2, 2}, {14, 30}).x,
                     covered.mean({18, 2}, {30, 30}).x / open.mean({18, 2}, {30, 30}).x);
  };
  CHECK(shares().first < 1e-6);
  // The left half is opaque, the right half is a hole.
  sheet.material.finish.color = mapOfTexels({2, 1}, {0, 0, 0, 255, 0, 0, 0, 0});
  sheet.material.finish.alpha = scene::Alpha::cut;
  CHECK(shares().first < 1e-6);
  CHECK(shares().second == doctest::Approx(1).epsilon(1e-3));
  sheet.material.finish.alpha = scene::Alpha::blend;
  sheet.material.finish.color = {};
  sheet.material.finish.opacity = 0.3F;
  CHECK(shares().first == doctest::Approx(0.7).epsilon(0.01));
  CHECK(shares().second == doctest::Approx(0.7).epsilon(0.01));
}

TEST_CASE("rays see: blended layers before what is opaque, and in a mirror") {
  testContext();
  scene::Scene scene = lightless(256);
  Sheet behind({-9, 9, -2}, {18, 0, 0}, {0, -18, 0}), before({-9, 9, 0}, {18, 0, 0}, {0, -18, 0});
  behind.material.finish.emission = glm::vec3(1, 0, 0);
  before.material.finish.emission = glm::vec3(0, 1, 0);
  before.material.finish.alpha = scene::Alpha::blend;
  before.material.finish.opacity = 0.4F;
  const auto wanted = [](const glm::dvec3& found, double maximum) {
    CHECK(std::abs(found.x - 0.6) < maximum);
    CHECK(std::abs(found.y - 0.4) < maximum);
  };
  wanted(rayPicture(scene, {.surfaces = {before.surface, behind.surface}}, {16, 16}).mean({4, 4}, {12, 12}),
         0.01);
  // The mirror is behind the eye.
  Sheet mirror({-9, 9, 8}, {18, 0, 0}, {0, -18, 0});
  mirror.material.color = glm::vec3(1);
  mirror.material.metallic = 1;
  mirror.material.roughness = 0;
  scene.camera.target = glm::vec3(0, 0, 8);
  wanted(rayPicture(scene, {.surfaces = {before.surface, behind.surface, mirror.surface}}, {16, 16})
             .mean({4, 4}, {12, 12}),
         0.02);
  // Rays light a white blended layer under a uniform sky, and the sheet behind the layer.
  scene = furnace(256);
  before.material.finish.emission = behind.material.finish.emission = glm::vec3(0);
  before.material.color = glm::vec3(1);
  before.material.finish.opacity = 0.5F;
  behind.material.color = glm::vec3(0);
  scene.render.samples = 4;
  const double half = rayPicture(scene, {.surfaces = {before.surface, behind.surface}}, {16, 16}, 4)
                          .mean({4, 4}, {12, 12})
                          .x;
  behind.material.color = glm::vec3(1);
  const double all =
      rayPicture(scene, {.surfaces = {before.surface}}, {16, 16}, 4).mean({4, 4}, {12, 12}).x;
  // Without the sheet behind, half of the light comes from the white layer. The other half comes from the
  // sky, which is not included in this sum.
  CHECK(all == doctest::Approx(0.5).epsilon(0.03));
  CHECK(half > 0.5);
  CHECK(half < 0.62);
}

TEST_CASE("rays see: a coat in a furnace takes from what is below what it mirrors") {
  testContext();
  TriangleStage sheet({{-9, -9, 0}, {9, -9, 0}, {-9, 9, 0}, {9, 9, 0}}, {0, 1, 2, 2, 1, 3},
                      std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
  sheet.material.roughness = 1;
  sheet.material.finish.coat = 1;
  sheet.material.finish.coatRoughness = 0.1F;
  const auto light = [&](float color) {
    sheet.material.color = glm::vec3(color);
    return rayPicture(furnace(256), {.surfaces = {sheet.surface}}, {24, 24}).mean({8, 8}, {16, 16}).x;
  };
  CHECK(std::abs(light(1) - 1) < 0.012);
  // A black sheet under a sky of 1 still reflects light: about 0.02 by the base's specular lobe (at
  // roughness 1), plus 0.04 by the coat.
  const double black = light(0);
  CHECK(black > 0.045);
  CHECK(black < 0.075);
  sheet.material.finish.coat = 0;
  CHECK(black - light(0) == doctest::Approx(0.04).epsilon(0.15));
}

TEST_CASE("rays see: sheen in a furnace has its lobe's albedo") {
  testContext();
  TriangleStage sheet({{-9, -9, 0}, {9, -9, 0}, {-9, 9, 0}, {9, 9, 0}}, {0, 1, 2, 2, 1, 3},
                      std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
  sheet.material.color = glm::vec3(0);
  sheet.material.roughness = 1;
  scene::Scene scene = furnace(512);
  const float angle = glm::radians(60.0F);
  scene.camera.position = glm::vec3(std::sin(angle), 0, std::cos(angle)) * 4.0F;
  scene.camera.fieldOfView = 2;
  const auto light = [&] {
    return rayPicture(scene, {.surfaces = {sheet.surface}}, {16, 16}).mean({4, 4}, {12, 12});
  };
  const glm::dvec3 plain = light();
  sheet.material.finish.sheen = glm::vec3(1, 0.5F, 0);
  sheet.material.finish.sheenRoughness = 0.6F;
  const glm::dvec3 with = light();
  // Integral of D V cos over the hemisphere, by the midpoint rule.
  const double nv = 0.5, alpha = 0.36;
  const glm::dvec3 view(std::sqrt(1 - nv * nv), 0, nv);
  double albedo = 0;
  const int steps = 600;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double nl = (i + 0.5) / steps, turn = 2 * std::numbers::pi * (k + 0.5) / steps;
      const double aside = std::sqrt(1 - nl * nl);
      const glm::dvec3 towards(aside * std::cos(turn), aside * std::sin(turn), nl);
      const glm::dvec3 half = glm::normalize(towards + view);
      const double d =
          (2 + 1 / alpha) * std::pow(1 - half.z * half.z, 0.5 / alpha) / (2 * std::numbers::pi);
      albedo += d / (4 * (nl + nv - nl * nv)) * nl * 2 * std::numbers::pi / (steps * steps);
    }
  CHECK(with.x - with.z == doctest::Approx(albedo).epsilon(0.03));
  CHECK(with.y - with.z == doctest::Approx(0.5 * albedo).epsilon(0.03));
  CHECK(with.z < plain.z);
}

TEST_CASE("rays see: light goes through sheets that are round by their normals, and not back onto them") {
  testContext();
  // The surface is a flat cap of six triangles. There is nothing below it, so the light that its lobe
  // reflects is not halved.
  std::vector<glm::vec3> places(1, glm::vec3(0, 0.25F, 0)), normals(1, glm::vec3(0, 1, 0));
  std::vector<unsigned> corners;
  for (unsigned i = 0; i < 6; ++i) {
    const float angle = glm::radians(60.0F * static_cast<float>(i));
    places.emplace_back(std::cos(angle), 0, std::sin(angle));
    normals.push_back(glm::normalize(glm::vec3(std::cos(angle), 2, std::sin(angle))));
    corners.insert(corners.end(), {0, 1 + (i + 1) % 6, 1 + i});
  }
  TriangleStage cap(places, corners, normals);
  cap.surface.doubleSided = true;
  cap.material.color = glm::vec3(0.8F);
  cap.material.roughness = 1;
  scene::Scene scene = lightless(64);
  lookDown(scene, 5, 6);
  const auto light = [&](float height, float translucency) {
    scene.sun.intensity = 1;
    scene.sun.color = glm::vec3(1);
    scene.sun.direction = glm::vec3(0.2F, height, 0.1F);
    cap.material.translucency = translucency;
    return rayPicture(scene, {.surfaces = {cap.surface}}, {16, 16}).mean({2, 2}, {14, 14}).x;
  };
  const double matt = light(1, 0);
  CHECK(matt > 0.1);
  CHECK(light(1, 0.5F) == doctest::Approx(0.5 * matt).epsilon(0.1).scale(0));
  CHECK(light(-1, 0.5F) == doctest::Approx(0.5 * matt).epsilon(0.1).scale(0));
}
