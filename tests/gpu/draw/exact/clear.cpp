// Tests path-traced glass against closed forms of Fresnel's equations, Snell's and Beer's law.
#include "gpu/draw/exact/ray_stage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

using namespace simreel;  // NOLINT

namespace {

/// Mesh of a box. Each face has separate corners with the normal of the face.
struct BoxMesh {
  std::vector<glm::vec3> places, normals;
  std::vector<unsigned> corners;
  BoxMesh(glm::vec3 low, glm::vec3 high) {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto first = static_cast<unsigned>(places.size());
        glm::vec3 normal(0);
        normal[axis] = upper ? 1.0F : -1.0F;
        for (int i = 0; i < 4; ++i) {
          glm::vec3 p = low;
          p[axis] = upper ? high[axis] : low[axis];
          p[u] = (i & 1) != 0 ? high[u] : low[u];
          p[v] = (i & 2) != 0 ? high[v] : low[v];
          places.push_back(p);
          normals.push_back(normal);
        }
        if (upper)
          corners.insert(corners.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
        else
          corners.insert(corners.end(), {first, first + 2, first + 1, first + 1, first + 2, first + 3});
      }
  }
};

struct GlassBox : TriangleStage {
  GlassBox(glm::vec3 low, glm::vec3 high, float ior) : GlassBox(BoxMesh(low, high), ior) {}
  GlassBox(const BoxMesh& box, float ior) : TriangleStage(box.places, box.corners, box.normals) {
    material.color = glm::vec3(1);
    material.roughness = 0;
    material.finish.transmission = 1;
    material.finish.ior = ior;
  }
};

/// A black square that emits light and faces +z.
struct Lit : GridStage {
  Lit(glm::vec3 corner, glm::vec2 size, float light)
      : GridStage({2, 2}, corner, {size.x, 0, 0}, {0, -size.y, 0}) {
    material.color = glm::vec3(0);
    material.roughness = 1;
    material.finish.emission = glm::vec3(light);
  }
};

scene::Scene night(int raySamples) {
  scene::Scene scene = furnace(raySamples);
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0);
  return scene;
}

/// Returns the fraction of light that is reflected, by Fresnel's equations.
double mirrored(double cosine, double index) {
  const double beyond = std::sqrt(1 - (1 - cosine * cosine) / (index * index));
  const double across = (cosine - index * beyond) / (cosine + index * beyond);
  const double along = (index * cosine - beyond) / (index * cosine + beyond);
  return 0.5 * (across * across + along * along);
}

/// Returns the fraction of light that passes both sides, including all internal reflections. `mirror`:
/// fraction that one side reflects. `left`: fraction that is not absorbed between the sides.
double through(double mirror, double left) {
  return (1 - mirror) * (1 - mirror) * left / (1 - mirror * mirror * left * left);
}

}  // namespace

TEST_CASE("clear: in a furnace glass is not to be seen") {
  testContext();
  // Light that is reflected inside a cube more than 24 times is lost. For diamond, this is a few
  // thousandths.
  for (const auto& [ior, maximum] : {std::pair(1.5F, 2e-3), {2.4F, 0.02}}) {
    CAPTURE(ior);
    const GlassBox box({-1, -0.7F, -1}, {1, 0.7F, 1}, ior);
    scene::Scene scene = furnace(16);
    scene.camera.position = glm::vec3(2.1F, 1.4F, 4);
    const RayPicture picture = rayPicture(scene, {.surfaces = {box.surface}}, {48, 48});
    double worst = 0;
    for (int y = 18; y < 30; ++y)
      for (int x = 18; x < 30; ++x) worst = std::max(worst, std::abs(picture.at(x, y).x - 1));
    CHECK(worst < maximum);
  }
}

TEST_CASE("clear: glass lets through what Fresnel's equations and Beer's law leave") {
  testContext();
  for (const float turned : {0.0F, 55.0F})
    for (const bool absorbs : {false, true}) {
      CAPTURE(turned);
      CAPTURE(absorbs);
      GlassBox box({-40, -40, -0.3F}, {40, 40, 0.3F}, 1.5F);
      if (absorbs) {
        box.material.finish.attenuation = glm::vec3(0.5F, 0.9F, 0.25F);
        box.material.finish.attenuationDistance = 0.5F;
      }
      box.surface.model = glm::mat4(1);
      const Lit light({-90, 90, -8}, {180, 180}, 1);
      scene::Scene scene = night(1024);
      const float angle = glm::radians(turned);
      scene.camera.position = glm::vec3(0, std::sin(angle), std::cos(angle)) * 4.0F;
      scene.camera.fieldOfView = 1;
      const RayPicture picture = rayPicture(scene, {.surfaces = {box.surface, light.surface}}, {12, 12});
      const glm::dvec3 mean = picture.mean({2, 2}, {10, 10});
      const double cosine = std::cos(static_cast<double>(angle));
      const double beyond = std::sqrt(1 - (1 - cosine * cosine) / 2.25);
      for (int i = 0; i < 3; ++i) {
        const double white = absorbs ? static_cast<double>(box.material.finish.attenuation[i]) : 1.0;
        const double left = std::pow(white, 0.6 / beyond / 0.5);
        CHECK(std::abs(mean[i] - through(mirrored(cosine, 1.5), left)) < 0.004);
      }
    }
}

TEST_CASE("clear: a sheet lets through what both its sides do, straight on") {
  testContext();
  GridStage sheet({2, 2}, {-40, 40, 0}, {80, 0, 0}, {0, -80, 0});
  sheet.material.color = glm::vec3(0.8F, 0.5F, 1);
  sheet.material.roughness = 0;
  sheet.material.finish.transmission = 1;
  sheet.material.finish.thin = true;
  const Lit light({0, 90, -8}, {90, 180}, 1);
  scene::Scene scene = night(1024);
  scene.camera.position = glm::vec3(0, 3, 4);
  scene.camera.fieldOfView = 2;
  const RayPicture picture = rayPicture(scene, {.surfaces = {sheet.surface, light.surface}}, {32, 12});
  const double mirror = mirrored(0.8, 1.5);
  const glm::dvec3 lit = picture.mean({20, 2}, {31, 10});
  for (int i = 0; i < 3; ++i) {
    const double color = static_cast<double>(sheet.material.color[i]);
    CHECK(std::abs(lit[i] - color * (1 - mirror) / (1 + mirror)) < 0.004);
  }
  CHECK(picture.mean({1, 2}, {12, 10}).x < 0.002);
}

TEST_CASE("clear: a slab shifts what lies behind it as Snell's law has it") {
  testContext();
  for (const float ior : {1.33F, 1.5F, 2.0F}) {
    CAPTURE(ior);
    const float thickness = 1.2F;
    const GlassBox box({-40, -40, -thickness}, {40, 40, 0}, ior);
    // The left half of the plane behind the slab emits light.
    const Lit light({0, 90, -6}, {90, 180}, 1);
    scene::Scene scene = night(64);
    const double angle = glm::radians(50.0);
    const glm::ivec2 size(400, 4);
    scene.camera.fieldOfView = 0.1F;
    const auto edgeOf = [&](const sim::Drawables& drawables) {
      const RayPicture picture = rayPicture(scene, drawables, size);
      double dark = 0;
      const double maximum = picture.mean({size.x - 20, 0}, {size.x, 4}).x;
      for (int x = 0; x < size.x; ++x) dark += picture.mean({x, 0}, {x + 1, 4}).x < 0.5 * maximum ? 1 : 0;
      return dark;
    };
    // Without the slab, the edge at z = -6 is seen along a straight line. The slab shifts this line
    // sideways.
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const double index = static_cast<double>(ior);
    const double shift =
        static_cast<double>(thickness) * sine * (1 - cosine / std::sqrt(index * index - sine * sine));
    // The camera is moved back by the shift, so that the edge seen through the slab is at the picture's
    // centre.
    const glm::dvec3 towards(-sine, 0, -cosine), across(cosine, 0, -sine);
    const glm::dvec3 edge(0, 0, -6);
    const auto lookAt = [&](double aside) {
      const glm::dvec3 eye = edge - towards * 12.0 + across * aside;
      scene.camera.position = glm::vec3(eye);
      scene.camera.target = glm::vec3(eye + towards * 12.0);
    };
    lookAt(0);
    const double middle = edgeOf({.surfaces = {light.surface}});
    CHECK(middle == doctest::Approx(200).epsilon(0.01));
    lookAt(-shift);
    const double found = edgeOf({.surfaces = {box.surface, light.surface}});
    // At the edge, a column of pixels is 12 m * 2 tan(0.05 degrees) / 4 wide.
    const double column = 12 * 2 * std::tan(glm::radians(0.05)) / 4;
    CAPTURE(shift);
    CHECK(std::abs(found - middle) * column < 0.02 * shift);
  }
}

TEST_CASE("clear: the light of the sun comes straight through glass, less what it mirrors and absorbs") {
  testContext();
  scene::Scene scene = night(64);
  scene.sun.intensity = 3.0F;
  scene.sun.color = glm::vec3(1);
  scene.sun.direction = glm::vec3(0, 1, 0);
  setGround(scene, 0.05F);  // the ground is dark, so that the glass reflects little of its light
  lookDown(scene, 0.8F, 20);
  GlassBox box({-5, 1, -5}, {5, 1.5F, 5}, 1.5F);
  box.material.finish.attenuation = glm::vec3(0.5F, 1, 0.2F);
  const RayPicture open = rayPicture(scene, {}, {16, 16});
  const RayPicture covered = rayPicture(scene, {.surfaces = {box.surface}}, {16, 16});
  const glm::dvec3 share = covered.mean({4, 4}, {12, 12}) / open.mean({4, 4}, {12, 12});
  const double sides = 0.96 * 0.96;
  for (int i = 0; i < 3; ++i) {
    const double white = static_cast<double>(box.material.finish.attenuation[i]);
    CAPTURE(share[i]);
    CHECK(std::abs(share[i] - sides * std::sqrt(white)) < 0.015);
  }
}

TEST_CASE("clear: rough glass spreads what lies behind it, and keeps its light") {
  testContext();
  GridStage sheet({2, 2}, {-40, 40, 0}, {80, 0, 0}, {0, -80, 0});
  sheet.material.color = glm::vec3(1);
  sheet.material.finish.transmission = 1;
  sheet.material.finish.thin = true;
  const Lit light({0, 400, -8}, {400, 800}, 1);
  scene::Scene scene = night(256);
  scene.camera.fieldOfView = 1;
  std::vector<double> steps;
  for (const float roughness : {0.0F, 0.25F, 0.5F}) {
    sheet.material.roughness = roughness;
    const RayPicture picture = rayPicture(scene, {.surfaces = {sheet.surface, light.surface}}, {16, 4});
    steps.push_back(picture.mean({15, 0}, {16, 4}).x - picture.mean({0, 0}, {1, 4}).x);
    CHECK(std::abs(picture.mean({0, 0}, {16, 4}).x - 0.5 * 0.923) < 0.03);
  }
  CHECK(steps[0] > 0.9);
  CHECK(steps[1] < 0.5 * steps[0]);
  CHECK(steps[2] < 0.5 * steps[1]);
}

TEST_CASE(
    "clear: a coat on glass mirrors what it keeps from the glass, where rays meet it on their way, too") {
  testContext();
  const double cosine = std::cos(glm::radians(70.0)), sine = std::sin(glm::radians(70.0));
  const auto x = static_cast<float>(cosine), z = static_cast<float>(sine);
  GridStage mirror({2, 2}, {-9, 9, 0}, {18, 0, 0}, {0, -18, 0});
  mirror.material.color = glm::vec3(1);
  mirror.material.metallic = 1;
  mirror.material.roughness = 0;
  GridStage pane({2, 2}, glm::vec3(-8 * x, 9, 12 - 8 * z), {16 * x, 0, 16 * z}, {0, -18, 0});
  GridStage roof({2, 2}, {-40, 1, -40}, {80, 0, 0}, {0, 0, 80});
  for (GridStage* clear : {&pane, &roof}) {
    clear->material.color = glm::vec3(1);
    clear->material.roughness = 0;
    clear->material.finish.transmission = 1;
    clear->material.finish.thin = true;
    clear->material.finish.coat = 1;
    clear->material.finish.coatRoughness = 0;
  }
  scene::Scene scene = furnace(256);
  scene.camera.fieldOfView = 1;
  const RayPicture picture = rayPicture(scene, {.surfaces = {mirror.surface, pane.surface}}, {8, 8});
  CHECK(std::abs(picture.mean({0, 0}, {8, 8}).x - 1) < 0.012);
  // The coat reflects part of the sun's light (Schlick). The layer below does not receive that part.
  scene = night(64);
  scene.sun.intensity = 3.0F;
  scene.sun.direction = glm::vec3(0, x, z);
  setGround(scene, 0.05F);
  lookDown(scene, 0.8F, 20);
  const auto light = [&](float coat) {
    roof.material.finish.coat = coat;
    return rayPicture(scene, {.surfaces = {roof.surface}}, {8, 8}).mean({0, 0}, {8, 8}).x;
  };
  const double schlick = 0.04 + 0.96 * std::pow(1 - cosine, 5);
  CHECK(light(1) / light(0) == doctest::Approx(1 - schlick).epsilon(0.015));
}
