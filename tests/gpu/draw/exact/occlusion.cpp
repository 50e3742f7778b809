#include "draw/exact/occlusion/occlusion.hpp"

#include "base/file.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/instance_stage.hpp"
#include "reference/occlusion_twin.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

const draw::PassArray& part(const draw::PassPicture& kept, const std::string& pass,
                            const std::string& name) {
  const auto found = std::find_if(kept.arrays.begin(), kept.arrays.end(), [&](const draw::PassArray& one) {
    return one.pass == pass && one.part == name;
  });
  REQUIRE(found != kept.arrays.end());
  return *found;
}

/// Values of all half pixels, computed by the kernels.
struct Seen {
  draw::PassPicture kept;
  std::vector<float> openness, nearness;
};

Seen seenOf(const scene::Scene& scene, const sim::Drawables& drawables, glm::ivec2 size, int samples) {
  draw::Renderer renderer(scene, size, samples, {.rasterizer = scene::Rasterizer::exact});
  Seen seen;
  renderer.keepPasses(&seen.kept);
  renderer.draw(0, drawables);
  testContext().check();
  const draw::PassArray& array = part(seen.kept, "shadow", "openness");
  CHECK(array.width == (size.x + 1) / 2);
  CHECK(array.height == (size.y + 1) / 2);
  for (std::size_t i = 0; i + 1 < array.words.size(); i += 2) {
    seen.openness.push_back(std::bit_cast<float>(array.words[i]));
    seen.nearness.push_back(std::bit_cast<float>(array.words[i + 1]));
  }
  return seen;
}

scene::Scene standardScene() {
  scene::Scene scene;
  scene.render.rasterizer = scene::Rasterizer::exact;
  scene.render.quality = scene::Quality::standard;
  scene.camera.position = glm::vec3(0.4F, 1.7F, 4.1F);
  return scene;
}

/// A folded slope with balls in front of it and behind it.
struct FoldStage {
  FoldStage()
      : sheet({{-2, 0.9F, -2},
               {2, 0.7F, -2.2F},
               {-2, -0.2F, 0},
               {2, -0.1F, 0.2F},
               {-2, 1.2F, 1},
               {2, 0.1F, 1.4F}},
              {0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5}),
        balls({{0.5F, 0.4F, 0.2F}, {-0.6F, 0.3F, -0.5F}, {0.2F, 0.2F, 1.3F}, {1.3F, 1.1F, -1}}) {
    sheet.surface.doubleSided = true;
    balls.instances.shape = sim::Instances::Shape::sphere;
    balls.instances.size = 0.6F;
    drawables.surfaces = {sheet.surface};
    drawables.instances = {balls.instances};
  }
  TriangleStage sheet;
  InstanceStage balls;
  sim::Drawables drawables;
};

/// Returns the occlusion twin with its nearness (1/depth) filled by rays in float64. `depth` returns the
/// depth (m) along a ray.
OcclusionTwin castTwin(const shader::ExactView& view,
                       const std::function<double(glm::dvec3 eye, glm::dvec3 ray)>& depth) {
  OcclusionTwin twin;
  twin.view = view;
  for (int y = 0; y < twin.half().y; ++y)
    for (int x = 0; x < twin.half().x; ++x) {
      const glm::dvec3 ray = glm::dvec3(view.ray) + (2.0 * x + 1) * glm::dvec3(view.rayAcross) +
                             (2.0 * y + 1) * glm::dvec3(view.rayDown);
      twin.nearness.push_back(static_cast<float>(1 / depth(glm::dvec3(view.eye), ray)));
    }
  // The distance is unlimited, and the search covers 100 half pixels.
  twin.reach = glm::vec3(1e9F, 100, 1e-4F);
  return twin;
}

/// The half-resolution pixel that shows the point `p`, and the world position at that pixel's centre.
struct Shown {
  std::size_t index = 0;
  glm::dvec3 place{0};
};

Shown shownAt(const OcclusionTwin& twin, glm::dvec3 p) {
  const shader::ExactView& view = twin.view;
  const glm::dvec3 from = p - glm::dvec3(view.eye);
  const double depth = glm::dot(from, glm::dvec3(view.forward));
  const int x = static_cast<int>(glm::dot(from, glm::dvec3(view.across)) / depth / 2);
  const int y = static_cast<int>(glm::dot(from, glm::dvec3(view.down)) / depth / 2);
  const auto index = static_cast<std::size_t>(y * twin.half().x + x);
  const glm::dvec3 ray = glm::dvec3(view.ray) + (2.0 * x + 1) * glm::dvec3(view.rayAcross) +
                         (2.0 * y + 1) * glm::dvec3(view.rayDown);
  return {index, glm::dvec3(view.eye) + ray / static_cast<double>(twin.nearness[index])};
}

shader::ExactView wideView(glm::vec3 eye, glm::vec3 target, glm::ivec2 size) {
  scene::Camera camera;
  camera.position = eye;
  camera.target = target;
  camera.fieldOfView = 90.0F;
  return draw::exactView(draw::viewAt(camera, 0, size, {}), camera, size);
}

}  // namespace

TEST_CASE("exact: ambient occlusion is the twin's, bit for bit") {
  testContext();
  const FoldStage stage;
  for (const auto& [size, samples] :
       {std::pair(glm::ivec2(75, 61), 4), {{64, 40}, 1}, {{33, 18}, 16}, {{97, 3}, 4}, {{1, 1}, 2}})
    for (const char* layout : LayoutForced::words())
      for (const bool ground : {true, false}) {
        CAPTURE(size.x);
        CAPTURE(samples);
        CAPTURE(layout);
        CAPTURE(ground);
        const LayoutForced asked(layout);
        scene::Scene scene = standardScene();
        if (ground) scene.ground.emplace().height = -0.15F;
        const Seen seen = seenOf(scene, stage.drawables, size, samples);
        const draw::View view = draw::viewAt(scene.camera, 0, size, stage.drawables);
        OcclusionTwin twin;
        twin.view = draw::exactView(view, scene.camera, size);
        twin.reach = draw::searchLimits(twin.view, glm::distance(view.eye, view.target) / 6.0F);
        twin.slices = draw::Occlusion::slices;
        twin.steps = draw::Occlusion::steps;
        twin.see(draw::frameValues(scene, size, 0, stage.drawables), samples,
                 part(seen.kept, "visibility", "keys").words, ground);
        CHECK(seen.nearness == twin.nearness);
        const std::vector<float> openness = twin.openness();
        CHECK(seen.openness == openness);
        if (size.x > 60 && size.y > 30) CHECK(*std::min_element(openness.begin(), openness.end()) < 0.9F);
      }
}

TEST_CASE("exact: occlusionRadius bounds how far away is searched, and scales with the scene") {
  testContext();
  const FoldStage stage;
  scene::Scene scene = standardScene();
  const auto mean = [&](std::optional<double> radius) {
    scene.render.occlusionRadius = radius;
    const Seen seen = seenOf(scene, stage.drawables, {75, 61}, 4);
    double sum = 0;
    for (const float open : seen.openness) sum += static_cast<double>(open);
    return sum / static_cast<double>(seen.openness.size());
  };
  const double sixth = static_cast<double>(glm::length(glm::vec3(0.4F, 1.7F, 4.1F))) / 6;
  CHECK(mean({}) == doctest::Approx(mean(sixth)).epsilon(1e-6));
  CHECK(mean(0.001) > 0.9999);
  CHECK(mean(0.1) > mean(0.3));
  CHECK(mean(0.3) > mean(0.7));
}

TEST_CASE("exact: flat ground, a lone ball and a lone box are open") {
  testContext();
  scene::Scene scene = standardScene();
  scene.ground.emplace();
  scene.ground->height = 0;
  // A plane does not occlude itself, so its occlusion consists only of rounding errors. They are about 3e-4
  // for directions that are half a pixel long.
  for (const float height : {0.2F, 1.7F, 30.0F}) {
    CAPTURE(height);
    scene.camera.position = glm::vec3(0.4F, height, 4.1F);
    const Seen seen = seenOf(scene, {}, {161, 91}, 4);
    CHECK(*std::max_element(seen.nearness.begin(), seen.nearness.end()) > 0);
    CHECK(*std::min_element(seen.openness.begin(), seen.openness.end()) > 0.998F);
  }
  // A convex object does not occlude itself. Slopes are computed over whole half-resolution pixels, so the
  // object's curvature causes errors, which are largest at its outline.
  scene.ground.reset();
  InstanceStage ball(std::vector<glm::vec3>{{0.1F, 0.2F, 0}});
  ball.instances.shape = sim::Instances::Shape::sphere;
  ball.instances.size = 2.5F;
  sim::Drawables lone;
  lone.instances = {ball.instances};
  scene.camera.position = glm::vec3(0.4F, 1.7F, 4.1F);
  for (const glm::ivec2 size : {glm::ivec2(161, 91), glm::ivec2(640, 360)}) {
    const Seen seen = seenOf(scene, lone, size, 4);
    CHECK(*std::max_element(seen.nearness.begin(), seen.nearness.end()) > 0);
    CHECK(*std::min_element(seen.openness.begin(), seen.openness.end()) > 0.98F);
  }
  const TriangleStage box({{-1, 0, 1}, {1, 0, 1}, {1, 1, 1}, {-1, 1, 1}, {-1, 1, -1}, {1, 1, -1}},
                          {0, 1, 2, 0, 2, 3, 3, 2, 5, 3, 5, 4});
  sim::Drawables boxes;
  boxes.surfaces = {box.surface};
  const Seen seen = seenOf(scene, boxes, {161, 91}, 4);
  CHECK(*std::min_element(seen.openness.begin(), seen.openness.end()) > 0.99F);
}

// A long wall of height h at the distance d hides the cosine-weighted fraction (1 - d / sqrt(d^2 + h^2)) /
// 2 of the sky.
TEST_CASE("occlusion: before a long wall") {
  const shader::ExactView view = wideView({1.5F, 6, 0.3F}, {0.6F, 0, 0}, {240, 200});
  const double high = 1.2;
  OcclusionTwin twin = castTwin(view, [&](glm::dvec3 eye, glm::dvec3 ray) {
    const double ground = -eye.y / ray.y;
    if (eye.x + ground * ray.x > 0) return ground;
    const double top = (high - eye.y) / ray.y;
    return eye.x + top * ray.x < 0 ? top : -eye.x / ray.x;
  });
  const auto worst = [&] {
    const std::vector<float> open = twin.openness();
    double maximum = 0;
    for (double away = 0.4; away < 2.5; away += 0.2) {
      const Shown shown = shownAt(twin, {away, 0, 0});
      const double d = shown.place.x;
      const double wanted = 1 - 0.5 * (1 - d / std::sqrt(d * d + high * high));
      maximum = std::max(maximum, std::abs(static_cast<double>(open[shown.index]) - wanted));
    }
    return maximum;
  };
  // A half-resolution pixel is 0.06 m wide. The mean over seven pixels differs from the exact values,
  // because the values are a curved function of the position.
  twin.slices = 32;
  twin.steps = 100;
  CHECK(worst() < 0.02);
  // With the few steps of real pictures, the top of the wall may be between two steps, so the wall appears
  // lower.
  twin.slices = draw::Occlusion::slices;
  twin.steps = draw::Occlusion::steps;
  twin.reach.y = draw::searchLimits(view, 1).y;
  CHECK(worst() < 0.08);
}

// In a ditch between two planes, each plane hides the fraction (1 - cos e) / 2 of the sky from the opposite
// plane. e is the elevation angle of the upper edge of the hiding plane above the opposite plane.
TEST_CASE("occlusion: in a ditch") {
  const shader::ExactView view = wideView({0.2F, 8, 0.3F}, {0, 0, 0}, {240, 200});
  const double deep = 1.5;
  for (const double angle : {70.0, 90.0, 120.0, 150.0}) {
    CAPTURE(angle);
    const double rise = 1 / std::tan(0.5 * angle * 0.017453292519943295);  // the planes are y = rise |x|
    OcclusionTwin twin = castTwin(view, [&](glm::dvec3 eye, glm::dvec3 ray) {
      const double top = (deep - eye.y) / ray.y;
      if (std::abs(eye.x + top * ray.x) * rise >= deep) return top;
      double nearest = 1e9;
      for (const double side : {1.0, -1.0}) {
        const double depth = (side * rise * eye.x - eye.y) / (ray.y - side * rise * ray.x);
        if (depth > 0 && side * (eye.x + depth * ray.x) >= 0) nearest = std::min(nearest, depth);
      }
      return nearest;
    });
    twin.slices = 32;
    twin.steps = 100;
    const std::vector<float> open = twin.openness();
    for (const double part : {-0.6, -0.4, 0.4, 0.6}) {
      CAPTURE(part);
      const double x = part * deep / rise;
      const Shown shown = shownAt(twin, {x, rise * std::abs(x), 0});
      const glm::dvec2 place(std::abs(shown.place.x), shown.place.y);
      const glm::dvec2 edge = glm::dvec2(-deep / rise, deep) - place;
      const double cosine = glm::dot(glm::normalize(edge), glm::normalize(glm::dvec2(-1, -rise)));
      CHECK(std::abs(static_cast<double>(open[shown.index]) - (1 - 0.5 * (1 - cosine))) < 0.02);
    }
  }
}

// At the centre of the floor of a round pit with radius r and depth h, the openness is r^2 / (r^2 + h^2).
TEST_CASE("occlusion: in a pit, in the picture's middle and towards its side") {
  for (const glm::vec3 target : {glm::vec3(0, 0, 0), glm::vec3(1.6F, 0, 1)}) {
    CAPTURE(target.x);
    const shader::ExactView view = wideView({0.1F, 4, 0.15F}, target, {240, 200});
    const double radius = 0.9;
    const double high = 0.7;
    OcclusionTwin twin = castTwin(view, [&](glm::dvec3 eye, glm::dvec3 ray) {
      const double top = (high - eye.y) / ray.y;
      const glm::dvec3 over = eye + top * ray;
      if (std::hypot(over.x, over.z) > radius) return top;
      const double floor = -eye.y / ray.y;
      const glm::dvec3 under = eye + floor * ray;
      if (std::hypot(under.x, under.z) <= radius) return floor;
      // Intersection with the inner side of the wall.
      const double a = ray.x * ray.x + ray.z * ray.z;
      const double b = eye.x * ray.x + eye.z * ray.z;
      const double c = eye.x * eye.x + eye.z * eye.z - radius * radius;
      return (-b + std::sqrt(b * b - a * c)) / a;
    });
    twin.slices = 32;
    twin.steps = 100;
    const std::vector<float> open = twin.openness();
    const double wanted = radius * radius / (radius * radius + high * high);
    CHECK(std::abs(static_cast<double>(open[shownAt(twin, {0, 0, 0}).index]) - wanted) < 0.02);
  }
}

// If only the sky gives light, the light equals the light of a draft picture times the openness.
TEST_CASE("exact: all that is shaded gets as much of the sky's light as it is open") {
  testContext();
  const auto mesh = temporaryFile("occlusion_dart.obj");
  writeFileAtomically(mesh,
                      "v 0 0 0.6\nv 0.34 0.03 -0.4\nv -0.34 0.03 -0.4\nv 0 -0.14 -0.4\n"
                      "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  FoldStage stage;
  InstanceStage darts({{-0.2F, 0.5F, 1}, {0.9F, 0.3F, 0.5F}, {-1.1F, 0.5F, 0.2F}});
  darts.instances.shape = sim::Instances::Shape::mesh;
  darts.instances.mesh = mesh;
  darts.instances.size = 0.8F;
  stage.drawables.instances.push_back(darts.instances);
  scene::Scene scene = standardScene();
  scene.ground.emplace();
  scene.ground->height = -0.15F;
  scene.sun.intensity = 0.0F;
  scene.sun.shadow = false;
  const glm::ivec2 size(120, 81);
  const Seen seen = seenOf(scene, stage.drawables, size, 4);
  scene.render.quality = scene::Quality::draft;
  draw::Renderer renderer(scene, size, 4, {.rasterizer = scene::Rasterizer::exact});
  draw::PassPicture draft;
  renderer.keepPasses(&draft);
  renderer.draw(0, stage.drawables);
  for (const draw::PassArray& array : draft.arrays) CHECK(array.part != "openness");
  const std::vector<std::uint32_t>& keys = part(seen.kept, "visibility", "keys").words;
  const std::vector<std::uint32_t>& numbers = part(seen.kept, "visibility", "numbers").words;
  CHECK(part(draft, "visibility", "numbers").words == numbers);
  const std::vector<std::uint32_t>& lit = part(seen.kept, "light", "").words;
  const std::vector<std::uint32_t>& drafted = part(draft, "light", "").words;
  OcclusionTwin twin;
  twin.view = draw::exactView(draw::viewAt(scene.camera, 0, size, stage.drawables), scene.camera, size);
  twin.nearness = seen.nearness;
  int checked[3] = {0, 0, 0};  // numbers of checked pixels of the ground, the sheet and the instances
  float minimum[3] = {1, 1, 1};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto pixel = static_cast<std::size_t>(y * size.x + x);
      const std::uint32_t number = numbers[4 * pixel];
      if (number == 0xffffffffU || std::count(&numbers[4 * pixel], &numbers[4 * pixel] + 4, number) != 4)
        continue;
      const bool ground = number == 0xfffffffeU;
      const glm::vec3 ray = glm::vec3(twin.view.ray) +
                            (static_cast<float>(x) + 0.5F) * glm::vec3(twin.view.rayAcross) +
                            (static_cast<float>(y) + 0.5F) * glm::vec3(twin.view.rayDown);
      float depth = (scene.ground->height - twin.view.eye.y) / ray.y;
      if (!ground) {
        float near = 0;
        for (std::size_t s = 0; s < 4; ++s)
          near += 0.25F * std::bit_cast<float>(0x7fffffffU - keys[4 * pixel + s]);
        depth = twin.view.near / near;
      }
      const float before = std::bit_cast<float>(drafted[4 * pixel + 1]),
                  after = std::bit_cast<float>(lit[4 * pixel + 1]);
      if (before < 1e-4F) continue;
      const float open = twin.opennessOn(seen.openness, {x, y}, glm::vec3(twin.view.eye) + depth * ray);
      const int kind = ground ? 0 : number < 4 ? 1 : 2;
      CAPTURE(kind);
      CAPTURE(x);
      CAPTURE(y);
      // The mean of the samples' depths differs slightly from the depth of the shaded point.
      CHECK(std::abs(after / before - open) < (ground ? 1e-4F : 0.05F));
      ++checked[kind];
      minimum[kind] = std::min(minimum[kind], after / before);
    }
  for (int kind = 0; kind < 3; ++kind) {
    CAPTURE(kind);
    CHECK(checked[kind] > 100);
    CHECK(minimum[kind] < 0.95F);
  }
}

TEST_CASE("occlusion: shading takes what is as far away") {
  // There are two near and two far half-resolution pixels. A point at either depth has the openness of the
  // pixels at that depth. A point between the depths has the mean.
  OcclusionTwin twin;
  scene::Camera camera;
  twin.view = draw::exactView(draw::viewAt(camera, 0, {4, 4}, {}), camera, {4, 4});
  twin.nearness = {0.5F, 0.2F, 0.5F, 0.2F};
  const std::vector<float> open = {0.25F, 0.75F, 0.25F, 0.75F};
  const auto at = [&](glm::ivec2 pixel, float depth) {
    return twin.opennessOn(open, pixel, glm::vec3(twin.view.eye) + depth * glm::vec3(twin.view.forward));
  };
  for (int x = 1; x < 3; ++x) {
    CHECK(at({x, 1}, 2) == doctest::Approx(0.25).epsilon(0.03));
    CHECK(at({x, 1}, 5) == doctest::Approx(0.75).epsilon(0.03));
  }
  twin.nearness = {0.5F, 0.5F, 0.5F, 0.5F};
  CHECK(at({1, 1}, 2) == doctest::Approx(0.375));
  CHECK(at({2, 1}, 2) == doctest::Approx(0.625));
}
