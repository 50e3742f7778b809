// Tests reflections of the ground, inside and outside the picture, by comparison with the directly visible
// ground.
#include "draw/camera.hpp"
#include "draw/exact/exact_view.hpp"
#include "draw/screen/renderer.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

constexpr glm::ivec2 groundPicture(221, 173);
constexpr double ballRadius = 0.4;
const glm::dvec3 ballMiddle(0.1, 1.5, -0.2);
constexpr GLuint groundNumber = 0xfffffffeU;

/// A ball of white metal above the ground, with the sun directly overhead.
struct OverGround {
  OverGround(scene::Quality quality, scene::Projection projection) : ball({glm::vec3(ballMiddle)}) {
    scene.render.rasterizer = scene::Rasterizer::exact;
    scene.render.quality = quality;
    scene.render.occlusionRadius = 1e-3;
    scene.camera.position = glm::vec3(0.4F, 2.3F, 4);
    scene.camera.target = glm::vec3(0.1F, 0.9F, 0);
    scene.camera.projection = projection;
    scene.camera.height = 3.1F;
    scene.sun.direction = glm::vec3(0, 1, 0);
    scene.ground.emplace();
    scene.ground->height = 0;
    scene.ground->color = glm::vec3(0.3F, 0.12F, 0.05F);
    scene.ground->roughness = 1;
    scene.ground->fadeStart = 60;
    scene.ground->fadeEnd = 90;
    ball.instances.shape = sim::Instances::Shape::sphere;
    ball.instances.size = static_cast<float>(2 * ballRadius);
    ball.material.color = glm::vec3(1);
    ball.material.metallic = 1;
    ball.material.roughness = 0.02F;
    drawables.instances = {ball.instances};
  }

  /// Light of a pixel, and the id that all the pixel's samples show. Empty if the samples show different
  /// ids.
  struct Seen {
    glm::dvec3 light{0};
    std::optional<GLuint> number;
  };
  [[nodiscard]] std::vector<Seen> draw() const {
    draw::PassPicture kept;
    draw::Renderer renderer(scene, groundPicture, 4, {.rasterizer = scene::Rasterizer::exact});
    renderer.keepPasses(&kept);
    renderer.draw(0, drawables);
    std::vector<Seen> pixels(static_cast<std::size_t>(groundPicture.x * groundPicture.y));
    for (const draw::PassArray& array : kept.arrays)
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const GLuint* four = &array.words[4 * i];
        if (array.pass == "light" && array.part.empty())
          for (int k = 0; k < 3; ++k)
            pixels[i].light[k] = static_cast<double>(std::bit_cast<float>(four[k]));
        if (array.pass == "visibility" && array.part == "numbers")
          if (four[0] == four[1] && four[0] == four[2] && four[0] == four[3]) pixels[i].number = four[0];
      }
    return pixels;
  }

  /// Origin and direction of the ray through a pixel's centre.
  struct Ray {
    glm::dvec3 from{0}, along{0};
  };
  [[nodiscard]] Ray rayThrough(int pixel) const {
    const shader::ExactView view =
        draw::exactView(draw::viewAt(scene.camera, 0, groundPicture, {}), scene.camera, groundPicture);
    const glm::dvec2 at(pixel % groundPicture.x + 0.5, pixel / groundPicture.x + 0.5);
    const glm::dvec3 aside =
        glm::dvec3(view.ray) + at.x * glm::dvec3(view.rayAcross) + at.y * glm::dvec3(view.rayDown);
    if (draw::isParallel(scene.camera))
      return {glm::dvec3(view.eye) + aside, glm::normalize(glm::dvec3(view.forward))};
    return {glm::dvec3(view.eye), glm::normalize(aside)};
  }

  scene::Scene scene;
  InstanceStage ball;
  sim::Drawables drawables;
};

/// Returns the point where the ray hits the ground, or nothing.
std::optional<glm::dvec3> groundOn(const glm::dvec3& from, const glm::dvec3& along) {
  if (along.y > -0.02) return std::nullopt;
  return from - along * (from.y / along.y);
}

/// Returns the ray after its reflection by the ball, or nothing if it misses the ball.
std::optional<OverGround::Ray> mirroredBy(const OverGround::Ray& ray) {
  const glm::dvec3 aside = ray.from - ballMiddle;
  const double b = glm::dot(ray.along, aside);
  const double root = b * b - glm::dot(aside, aside) + ballRadius * ballRadius;
  if (root <= 0) return std::nullopt;
  const glm::dvec3 p = ray.from + ray.along * (-b - std::sqrt(root));
  return OverGround::Ray{p, glm::reflect(ray.along, (p - ballMiddle) / ballRadius)};
}

/// Returns the point where the reflected ray hits the ground, or nothing.
std::optional<glm::dvec3> groundMirroredOn(const OverGround::Ray& ray) {
  const auto mirrored = mirroredBy(ray);
  return mirrored ? groundOn(mirrored->from, mirrored->along) : std::nullopt;
}

/// Returns the distance (m) from the centre of the ball's shadow.
double fromShadow(const glm::dvec3& p) {
  return std::hypot(p.x - ballMiddle.x, p.z - ballMiddle.z);
}

}  // namespace

TEST_CASE("exact: a ball of metal mirrors the ground as the picture shows it, its shadow too") {
  testContext();
  for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
    CAPTURE(static_cast<int>(projection));
    const OverGround stage(scene::Quality::standard, projection);
    const std::vector<OverGround::Seen> pixels = stage.draw();
    // mean light of the ground: index 0 in the sun, index 1 in the shadow
    glm::dvec3 seen[2] = {glm::dvec3(0), glm::dvec3(0)};
    int places[2] = {0, 0};
    const auto lightOf = [](const glm::dvec3& p) {
      const double aside = fromShadow(p);
      return aside > 0.65 && aside < 3 ? 0 : aside < 0.2 ? 1 : -1;
    };
    for (int i = 0; i < static_cast<int>(pixels.size()); ++i) {
      const OverGround::Seen& pixel = pixels[static_cast<std::size_t>(i)];
      const OverGround::Ray ray = stage.rayThrough(i);
      const auto p = groundOn(ray.from, ray.along);
      if (pixel.number != groundNumber || !p || lightOf(*p) < 0) continue;
      seen[lightOf(*p)] += pixel.light;
      ++places[lightOf(*p)];
    }
    CHECK(places[0] > 2000);
    CHECK(places[1] > 10);
    for (int k = 0; k < 2; ++k) seen[k] /= std::max(places[k], 1);
    CHECK(seen[0].r > 2 * seen[1].r);
    int mirrored[2] = {0, 0};
    double worst = 0;
    for (int i = 0; i < static_cast<int>(pixels.size()); ++i) {
      const OverGround::Seen& pixel = pixels[static_cast<std::size_t>(i)];
      const auto p = groundMirroredOn(stage.rayThrough(i));
      if (!pixel.number || *pixel.number == groundNumber || !p || lightOf(*p) < 0) continue;
      const int which = lightOf(*p);
      ++mirrored[which];
      for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(pixel.light[k] / seen[which][k] - 1));
    }
    CAPTURE(mirrored[0]);
    CAPTURE(mirrored[1]);
    CAPTURE(worst);
    CHECK(mirrored[0] > 200);
    CHECK(mirrored[1] > 5);
    CHECK(worst < 0.21);  // The fraction of light that the ground reflects differs, because the eye and the
                          // mirror see the ground from different angles. In the other case (sun or shadow),
                          // the light differs by a factor of 2.
  }
}

// Beyond the fade distance of the ground, mirrors reflect the same environment as without a ground.
TEST_CASE("exact: mirrors show the ground fade out where it does, and none that is not there or matt") {
  testContext();
  const auto drawn = [](scene::Quality quality, const auto& change) {
    OverGround stage(quality, scene::Projection::perspective);
    stage.scene.ground->fadeStart = 0.9F;
    stage.scene.ground->fadeEnd = 1.3F;
    stage.scene.sun.shadow = false;
    change(stage);
    return stage.draw();
  };
  const OverGround stage(scene::Quality::standard, scene::Projection::perspective);
  const auto compare = [&](const auto& change, double nearer, double& minimum, double& maximum) {
    const auto plain = drawn(scene::Quality::draft, change),
               mirrored = drawn(scene::Quality::standard, change);
    minimum = 1e9;
    maximum = 0;
    int places = 0;
    for (int i = 0; i < static_cast<int>(plain.size()); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const auto p = groundMirroredOn(stage.rayThrough(i));
      if (!plain[at].number || *plain[at].number == groundNumber || !p) continue;
      const double aside = glm::distance(*p, glm::dvec3(0.1, 0, 0));
      if (nearer > 0 ? aside > nearer : aside < 1.32) continue;
      ++places;
      const double pixelDifference =
          glm::distance(plain[at].light, mirrored[at].light) / glm::length(plain[at].light);
      minimum = std::min(minimum, pixelDifference);
      maximum = std::max(maximum, pixelDifference);
    }
    CHECK(places > 20);
  };
  double minimum = 0;
  double maximum = 0;
  compare([](OverGround&) {}, 0.8, minimum, maximum);
  CHECK(minimum > 0.1);
  compare([](OverGround&) {}, 0, minimum, maximum);
  CHECK(maximum < 1e-3);
  compare([](OverGround& matt) { matt.ball.material.roughness = 0.3F; }, 0.8, minimum, maximum);
  CHECK(maximum < 1e-3);
  compare([](OverGround& bare) { bare.scene.ground->visible = false; }, 0.8, minimum, maximum);
  CHECK(maximum < 1e-3);
}

// Ambient occlusion darkens the ground at the foot of the mirror, but it must not darken reflections of the
// distant ground.
TEST_CASE("exact: mirrors near the ground show it as bright as it is, farther away") {
  testContext();
  OverGround stage(scene::Quality::standard, scene::Projection::perspective);
  stage.scene.render.occlusionRadius.reset();
  stage.scene.sun.shadow = false;
  stage.scene.ground->height = 1.08F;  // The ground is 0.02 m below the ball.
  const std::vector<OverGround::Seen> pixels = stage.draw();
  const auto onGround = [](const OverGround::Ray& ray) {
    return groundOn(ray.from - glm::dvec3(0, 1.08, 0), ray.along);
  };
  glm::dvec3 seen(0);
  int places = 0;
  for (int i = 0; i < static_cast<int>(pixels.size()); ++i) {
    const OverGround::Seen& pixel = pixels[static_cast<std::size_t>(i)];
    const auto p = onGround(stage.rayThrough(i));
    if (pixel.number != groundNumber || !p || fromShadow(*p) < 1.2) continue;
    seen += pixel.light;
    ++places;
  }
  seen /= std::max(places, 1);
  int far = 0;
  int near = 0;
  double worst = 0;
  double darkest = 1;
  for (int i = 0; i < static_cast<int>(pixels.size()); ++i) {
    const OverGround::Seen& pixel = pixels[static_cast<std::size_t>(i)];
    const OverGround::Ray ray = stage.rayThrough(i);
    const auto mirrored = mirroredBy(ray);
    if (!pixel.number || *pixel.number == groundNumber || !mirrored) continue;
    const auto p = onGround(*mirrored);
    if (!p) continue;
    const double metres = glm::distance(*p, mirrored->from - glm::dvec3(0, 1.08, 0));
    if (metres > 0.5 && metres < 3) {
      ++far;
      worst = std::max(worst, std::abs(pixel.light.r / seen.r - 1));
    }
    if (metres < 0.3) {
      ++near;
      darkest = std::min(darkest, pixel.light.r / seen.r);
    }
  }
  CAPTURE(worst);
  CAPTURE(darkest);
  CHECK(places > 2000);
  CHECK(far > 100);
  CHECK(near > 20);
  CHECK(worst < 0.06);
  CHECK(darkest < 0.93);
}
