// Tests which instances are drawn, their order, their positions and their colours.
#include "gpu/draw/pass_stage.hpp"
#include "gpu/gl_calls.hpp"

#include <algorithm>
#include <limits>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

using namespace simreel;
using Shape = sim::Instances::Shape;

namespace {

/// Returns positions in a cube around the camera's target, and velocities. Some instances are dead; some
/// have NaN or infinite values.
std::pair<std::vector<glm::vec4>, std::vector<glm::vec4>> mixed(int count) {
  Dice dice(3);
  std::vector<glm::vec4> places;
  std::vector<glm::vec4> speeds;
  for (int i = 0; i < count; ++i) {
    places.emplace_back(4.0F * dice.cube(), 0.5F + dice());
    speeds.emplace_back(dice.cube(), dice() < 0.25F ? -1.0F : dice());
  }
  const float lost = std::numeric_limits<float>::quiet_NaN();
  if (count > 40) {
    places[7].x = lost;
    places[33].z = std::numeric_limits<float>::infinity();
    speeds[40].w = lost;
    places[31] = glm::vec4(0, 0, 0, 1);
    speeds[31].w = 0;  // This instance is alive at age 0.
  }
  return {places, speeds};
}

enum class Sight { out, in, edge };

/// Tests a sphere against the six frustum planes in double precision. Returns `edge` if the result is too
/// close to decide.
Sight inSight(const glm::mat4& matrix, glm::vec4 place, double radius) {
  if (!(std::abs(place.x) + std::abs(place.y) + std::abs(place.z) < 1e6F)) return Sight::out;
  const glm::dvec4 at(place.x, place.y, place.z, 1);
  Sight sight = Sight::in;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      const glm::dvec4 plane = glm::dvec4(glm::row(matrix, 3)) + sign * glm::dvec4(glm::row(matrix, axis));
      const double distance = glm::dot(plane, at) / glm::length(glm::dvec3(plane));
      if (distance < -radius - 1e-4) return Sight::out;
      if (distance < -radius + 1e-4) sight = Sight::edge;
    }
  return sight;
}

long callsOfFrame(int count) {
  Dice dice(5);
  std::vector<glm::vec4> places;
  for (int i = 0; i < count; ++i) places.emplace_back(dice.cube(), 1.0F);
  // Most instances are dead, so that rasterizing a million of them is cheap.
  std::vector<glm::vec4> speeds(places.size(), glm::vec4(0, 0, 0, -1));
  for (std::size_t i = 0; i < places.size(); i += 97) speeds[i].w = 0;
  const InstanceStage balls(places, speeds);
  const InstanceStage glows(places, speeds);
  sim::Drawables drawables;
  drawables.instances = {balls.instances, balls.instances, glows.instances};
  drawables.instances[0].size = drawables.instances[2].size = 0.01F;
  drawables.instances[1].shape = Shape::sphere;
  drawables.instances[1].size = 0.001F;
  drawables.instances[2].additive = true;
  scene::Scene scene = darkScene();
  scene.render.bloom.strength = 1.0F;
  draw::Renderer renderer(scene, {33, 17}, 4, testOptions());
  renderer.draw(0, drawables);  // compiles the programs and allocates the buffers
  const GlCalls calls;
  renderer.draw(0, drawables);
  glFinish();
  return GlCalls::count;
}

}  // namespace

TEST_CASE("visible instances are listed in slot order, without dead and NaN instances") {
  testContext();
  const scene::Scene scene = plainScene();
  // The size is large enough that the min size of glows has no effect, and small enough that some glows
  // count as small.
  PassStage stage(scene, draw::GlowSums::used() ? glm::ivec2(160, 90) : glm::ivec2(640, 360));
  for (const int count : {1, 31, 1021, 70001}) {
    CAPTURE(count);
    const auto [places, speeds] = mixed(count);
    InstanceStage group(places, speeds);
    group.instances.size = 0.5F;
    group.instances.massExponent = 1.0F / 3;
    group.instances.massReference = 2.0F;
    group.instances.additive = true;
    stage.pass.cull({{}, {group.instances}});
    const auto& visible = stage.pass.visible(0);
    const auto arguments = visible.arguments().readAll<unsigned>();
    auto list = visible.list().readAll<unsigned>();
    REQUIRE(arguments.size() == 16);
    // Small instances are points or squares, and large ones are squares. A batch of b squares has 6 b
    // indices.
    for (const std::size_t level : {0U, 1U}) {
      const unsigned* a = &arguments[level * 8];
      const unsigned corners = level == 0 && draw::SmallSprites::points() ? 1 : 6;
      CHECK(a[0] % corners == 0);
      const unsigned batch = a[0] / corners;
      CHECK(a[1] == (a[6] + batch - 1) / batch);
      for (const int zero : {3, 4}) CHECK(a[zero] == 0);
      REQUIRE(a[5] + a[6] <= list.size());
      CHECK(std::is_sorted(list.begin() + a[5], list.begin() + a[5] + a[6]));
    }
    const unsigned small = arguments[6];
    const unsigned all = small + arguments[14];
    CHECK(arguments[5] == 0);
    CHECK(arguments[13] == small);
    if (count > 1000) CHECK((small > 0 && small < all));
    std::inplace_merge(list.begin(), list.begin() + small, list.begin() + all);
    std::size_t at = 0;
    int edges = 0;
    for (unsigned slot = 0; slot < places.size(); ++slot) {
      const double mass = static_cast<double>(places[slot].w);
      const Sight sight = inSight(stage.values.viewProjection, places[slot], 0.25 * std::cbrt(mass / 2));
      const bool listed = at < all && list[at] == slot;
      at += listed ? 1 : 0;
      edges += sight == Sight::edge ? 1 : 0;
      if (sight == Sight::edge) continue;
      const bool wanted = sight == Sight::in && speeds[slot].w >= 0;
      if (listed != wanted) CAPTURE(slot);
      CHECK(listed == wanted);
    }
    CHECK(at == all);
    CHECK(edges < count / 500 + 1);
    if (count == 1021) CHECK((at > 100 && at < 700));
  }
}

TEST_CASE("each visible instance is in exactly one level of detail, and each level's list is sorted") {
  testContext();
  const scene::Scene scene = plainScene();
  PassStage stage(scene, {640, 360});
  const auto [places, speeds] = mixed(5003);
  InstanceStage group(places, speeds);
  group.instances.massExponent = 8.0F;
  group.instances.size = 0.3F;
  group.instances.shape = Shape::sphere;
  stage.pass.cull({{}, {group.instances}});
  const auto arguments = stage.pass.visible(0).arguments().readAll<unsigned>();
  const auto list = stage.pass.visible(0).list().readAll<unsigned>();
  const std::size_t levels = arguments.size() / 8;
  CHECK(levels == 5);
  unsigned first = 0;
  int used = 0;
  std::vector<unsigned> all;
  for (std::size_t level = 0; level < levels; ++level) {
    const unsigned* a = &arguments[level * 8];
    CHECK(a[5] == first);
    first += a[6];
    used += a[6] > 0 ? 1 : 0;
    const auto begin = list.begin() + a[5];
    CHECK(std::is_sorted(begin, begin + a[6]));
    all.insert(all.end(), begin, begin + a[6]);
    CHECK(a[0] % (60U << (2 * level)) == 0);  // A sphere of level `level` has 20 * 4^level triangles.
  }
  CHECK(used >= 3);
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
  group.instances.shape = Shape::sprite;
  group.instances.additive = true;
  PassStage flat(scene, {640, 360});
  flat.pass.cull({{}, {group.instances}});
  // Glows are enlarged to a min size. Therefore all instances that are visible as spheres are also visible
  // as glows, and a few more may be.
  const auto sprites = flat.pass.visible(0).arguments().readAll<unsigned>();
  CHECK(sprites[6] + sprites[14] >= all.size());
}

TEST_CASE("the GL calls of a frame do not depend on the number of instances") {
  testContext();
  const long few = callsOfFrame(1000);
  CHECK(few > 100);
  CHECK(few < 1000);
  CHECK(callsOfFrame(1000000) == few);
}

TEST_CASE("light of overlapping glows is added, also over the sky") {
  testContext();
  for (const float sky : {0.0F, 0.1F})
    for (const int samples : {1, 4}) {
      scene::Scene scene = plainScene();
      scene.sun.intensity = 0.0F;
      scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(sky);
      InstanceStage one(std::vector<glm::vec3>(1, glm::vec3(0)));
      InstanceStage two(std::vector<glm::vec3>(2, glm::vec3(0)));
      for (InstanceStage* stage : {&one, &two}) {
        stage->instances.additive = true;
        stage->instances.size = 1.0F;
        stage->instances.brightness = 0.5F;
        stage->material.color = glm::vec3(0.4F, 0.2F, 0.1F);
      }
      const auto light = [&](const Picture& p) { return p.at(16, 16); };
      const glm::ivec3 single = light(drawn(scene, {{}, {one.instances}}, {33, 33}, samples));
      const glm::ivec3 pair = light(drawn(scene, {{}, {two.instances}}, {33, 33}, samples));
      const glm::ivec3 separate =
          light(drawn(scene, {{}, {one.instances, one.instances}}, {33, 33}, samples));
      const double s = static_cast<double>(sky);
      const auto wantedOne = filmByte({s + 0.2, s + 0.1, s + 0.05});
      const auto wantedTwo = filmByte({s + 0.4, s + 0.2, s + 0.1});
      for (int i = 0; i < 3; ++i) {
        CHECK(std::abs(single[i] - wantedOne[static_cast<std::size_t>(i)]) <= 2);
        CHECK(std::abs(pair[i] - wantedTwo[static_cast<std::size_t>(i)]) <= 2);
        CHECK(std::abs(separate[i] - pair[i]) <= 1);
      }
    }
}

TEST_CASE("glows are hidden by opaque surfaces and hide nothing") {
  testContext();
  const scene::Scene scene = plainScene();
  InstanceStage ball(std::vector<glm::vec3>(1, glm::vec3(0)));
  ball.instances.size = 1.0F;
  InstanceStage behind(std::vector<glm::vec3>(1, glm::vec3(0, 0, -1)));
  InstanceStage before(std::vector<glm::vec3>(1, glm::vec3(0, 0, 1)));
  for (InstanceStage* stage : {&behind, &before}) {
    stage->instances.additive = true;
    stage->instances.size = 0.5F;
    stage->instances.brightness = 5.0F;
  }
  const Picture alone = drawn(scene, {{}, {ball.instances}}, {33, 33});
  CHECK(drawn(scene, {{}, {behind.instances, ball.instances}}, {33, 33}).bytes == alone.bytes);
  CHECK(drawn(scene, {{}, {before.instances, ball.instances}}, {33, 33}).brightness(16, 16) >
        alone.brightness(16, 16) + 50);
}

TEST_CASE("small glows conserve their light at any size") {
  testContext();
  scene::Scene scene = plainScene();
  const auto total = [&](float size, float brightness, glm::vec3 place) {
    InstanceStage glow(std::vector<glm::vec3>(1, place));
    glow.instances.additive = true;
    glow.instances.size = size;
    glow.instances.brightness = brightness;
    glow.material.color = glm::vec3(1);
    const Picture p = drawn(scene, {{}, {glow.instances}}, {65, 65});
    // Converts bytes to approximate light. The film curve is nearly linear for small values.
    double sum = 0;
    for (int y = 0; y < 65; ++y)
      for (int x = 0; x < 65; ++x) sum += std::pow(std::max(p.at(x, y).y - 3, 0) / 255.0, 2.2);
    return sum;
  };
  // The scale is 17.9 pixels per metre. The radii are 1.75 and 0.3 pixels. The product of brightness and
  // area is the same for both.
  const double wide = total(0.196F, 0.3F, glm::vec3(0));
  const double fine = total(0.0336F, 0.3F * 0.196F * 0.196F / (0.0336F * 0.0336F), glm::vec3(0));
  CHECK(fine == doctest::Approx(wide).epsilon(0.05).scale(0));
  // The total depends little on the position within a pixel.
  CHECK(total(0.0336F, 10.2F, glm::vec3(0.028F, 0.028F, 0)) == doctest::Approx(fine).epsilon(0.3).scale(0));
}

TEST_CASE("a glow looks the same among many dead instances") {
  testContext();
  const scene::Scene scene = plainScene();
  const auto picture = [&](std::size_t count) {
    const std::vector<glm::vec4> places(count, glm::vec4(0.1F, 0.2F, 0, 1));
    std::vector<glm::vec4> speeds(count, glm::vec4(0, 0, 0, -1));
    speeds[count / 2].w = 0;
    InstanceStage glow(places, speeds);
    glow.instances.additive = true;
    // The glow is a hundredth of a pixel wide, so its light is spread over many times its area.
    glow.instances.size = 0.001F;
    glow.instances.brightness = 2000;
    return drawn(scene, {{}, {glow.instances}}, {65, 65}, 1);
  };
  const Picture alone = picture(1);
  CHECK(alone.brightness(34, 28) > 30);
  CHECK(picture(400001).bytes == alone.bytes);
}

TEST_CASE("many glows have the light of one glow with their total brightness") {
  testContext();
  scene::Scene scene = plainScene();
  scene.render.exposure = -11.0F;
  const auto picture = [&](std::size_t count, float brightness) {
    InstanceStage glow(std::vector<glm::vec3>(count, glm::vec3(0.01F)));
    glow.instances.additive = true;
    glow.instances.size = 0.5F;
    glow.instances.brightness = brightness;
    return drawn(scene, {{}, {glow.instances}}, {33, 33}, 1);
  };
  const Picture one = picture(1, 1400);
  CHECK(one.brightness(16, 16) > 150);
  CHECK(one.brightness(16, 16) < 700);
  for (const auto& [count, each] : {std::pair{7U, 200.0F}, {700U, 2.0F}}) {
    const Picture many = picture(count, each);
    int pixelDifference = 0;
    for (std::size_t i = 0; i < one.bytes.size(); ++i)
      pixelDifference = std::max(pixelDifference, std::abs(int{one.bytes[i]} - int{many.bytes[i]}));
    CHECK(pixelDifference <= (draw::GlowSums::used() ? 1 : 20));  // The tolerance is larger with half-float
                                                                  // blending, which rounds at each step.
  }
}

TEST_CASE("colours follow speed, mass and age through the gradient, and light fades with age") {
  testContext();
  const std::vector<glm::vec3> stops = {{0, 0, 0}, {0.4F, 0, 0}, {0.4F, 0.4F, 0}};
  const scene::Scene scene = plainScene();
  const auto shown = [&](sim::Instances::ColorBy by, glm::vec4 velocity, float mass, float fade) {
    InstanceStage glow({glm::vec4(0, 0, 0, mass)}, {velocity});
    glow.instances.additive = true;
    glow.instances.size = 1;
    glow.instances.colorBy = by;
    glow.instances.colorRange = {1, 3};
    glow.instances.colors = &stops;
    glow.instances.fade = fade;
    return drawn(scene, {{}, {glow.instances}}, {33, 33}).at(16, 16);
  };
  const auto near = [](glm::ivec3 c, const std::array<double, 3>& light) {
    const auto wanted = filmByte(light);
    for (int i = 0; i < 3; ++i)
      if (std::abs(c[i] - wanted[static_cast<std::size_t>(i)]) > 2.5) return false;
    return true;
  };
  using By = sim::Instances::ColorBy;
  CHECK(near(shown(By::speed, {0, 2.5F, 0, 0}, 1, 0), {0.4, 0.2, 0}));
  CHECK(near(shown(By::speed, {1.5F, 0, 0, 0}, 1, 0), {0.2, 0, 0}));
  CHECK(near(shown(By::speed, {9, 9, 9, 0}, 1, 0), {0.4, 0.4, 0}));
  CHECK(near(shown(By::mass, {9, 0, 0, 0}, 2, 0), {0.4, 0, 0}));
  CHECK(near(shown(By::mass, {9, 0, 0, 0}, 0.5F, 0), {0, 0, 0}));
  CHECK(near(shown(By::material, {0, 0, 0, 0.5F}, 1, 0), {0.8, 0.7, 0.6}));
  // Halfway through fading in or out, the light is halved.
  CHECK(near(shown(By::material, {0, 0, 0, 0.1F}, 1, 0.2F), {0.4, 0.35, 0.3}));
  CHECK(near(shown(By::material, {0, 0, 0, 0.9F}, 1, 0.2F), {0.4, 0.35, 0.3}));
  CHECK(near(shown(By::material, {0, 0, 0, 0.002F}, 1, 0.004F), {0.4, 0.35, 0.3}));
  CHECK(near(shown(By::material, {0, 0, 0, 1.0F}, 1, 0.2F), {0, 0, 0}));
  CHECK(near(shown(By::material, {0, 0, 0, 0.0F}, 1, 0.2F), {0.8, 0.7, 0.6}));
}

TEST_CASE("repeated runs draw identical pictures of instances") {
  testContext();
  const auto [places, speeds] = mixed(30011);
  const std::vector<glm::vec3> stops = {{0.01F, 0.2F, 0}, {0.4F, 0.03F, 0}, {0.1F, 0.1F, 0.7F}};
  InstanceStage balls(places, speeds);
  InstanceStage glows(places, speeds);
  balls.instances.size = 0.05F;
  glows.instances.size = 0.2F;
  glows.instances.additive = true;
  glows.instances.brightness = 0.037F;
  for (InstanceStage* stage : {&balls, &glows}) {
    stage->instances.colors = &stops;
    stage->instances.colorBy = sim::Instances::ColorBy::speed;
  }
  scene::Scene scene = darkScene();
  scene.render.bloom.strength = 0.3F;
  const sim::Drawables drawables = {{}, {balls.instances, glows.instances}};
  const Picture first = drawn(scene, drawables, {257, 145});
  for (int run = 0; run < 3; ++run) CHECK(drawn(scene, drawables, {257, 145}).bytes == first.bytes);
}
