// Tests the lists of visible instances, their levels of detail and small sprites by comparison with
// double-precision references. Also compares balls very close to the camera with an equal surface.
#include "gl/element_array.hpp"
#include "gpu/draw/ball_stage.hpp"
#include "gpu/draw/pass_stage.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/packing.hpp>
#include <glm/trigonometric.hpp>

using namespace simreel;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using Shape = sim::Instances::Shape;

namespace {

constexpr float exponent = 4;

/// Returns balls of very different sizes around the camera's target. All are alive. Some are behind the
/// eye, some are outside the picture.
std::vector<glm::vec4> cloud(int count) {
  Dice dice(11);
  std::vector<glm::vec4> places;
  for (int i = 0; i < count; ++i) places.emplace_back(4.5F * dice.cube(), 0.3F + 1.2F * dice());
  return places;
}

/// The camera of a frame in double precision.
struct Eye {
  explicit Eye(const shader::Frame& frame)
      : place(frame.eye),
        forward(frame.rayForward),
        matrix(frame.viewProjection),
        pixels(0.5 * double{frame.size.y} / glm::length(dvec3(frame.rayUp))) {}
  dvec3 place, forward;
  glm::dmat4 matrix;
  double pixels;  ///< size (pixels) of 1 m at a distance of 1 m

  [[nodiscard]] double depth(dvec3 p) const { return glm::dot(p - place, forward); }
  [[nodiscard]] dvec4 clip(dvec3 p) const { return matrix * dvec4(p, 1); }
};

/// Returns whether value > bound. Returns nothing if `value` is so close to `bound` that rounding may
/// decide.
std::optional<bool> above(double value, double bound, double near = 1e-4) {
  if (std::abs(value - bound) < near * std::max(1.0, std::abs(bound))) return std::nullopt;
  return value > bound;
}

/// Returns the logical and of all parts, or nothing if the result depends on an unknown part.
std::optional<bool> all(const std::vector<std::optional<bool>>& parts) {
  if (std::any_of(parts.begin(), parts.end(), [](auto part) { return part == false; })) return false;
  return std::find(parts.begin(), parts.end(), std::nullopt) == parts.end() ? std::optional(true)
                                                                            : std::nullopt;
}

/// Returns whether a ball is at least partly on the inner side of all six frustum planes.
std::optional<bool> inSight(const Eye& eye, dvec3 p, double radius) {
  std::vector<std::optional<bool>> parts;
  const glm::dmat4 rows = glm::transpose(eye.matrix);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      const dvec4 plane = rows[3] + sign * rows[axis];
      parts.push_back(above(glm::dot(plane, dvec4(p, 1)) / glm::length(dvec3(plane)), -radius));
    }
  return all(parts);
}

std::optional<bool> middleInSight(const Eye& eye, dvec3 p) {
  const dvec4 clip = eye.clip(p);
  return all({above(0.9999 * clip.w, std::abs(clip.x)), above(0.9999 * clip.w, std::abs(clip.y)),
              above(0.9999 * clip.w, std::abs(clip.z))});
}

/// Returns, for each instance, the level of detail whose list contains it, or -1 if no list does.
std::vector<int> levelsOf(const draw::VisibleList& visible) {
  std::vector<int> levels(static_cast<std::size_t>(visible.capacity()), -1);
  const auto arguments = visible.arguments().readAll<unsigned>();
  const auto list = visible.list().readAll<unsigned>();
  for (int level = 0; level < visible.levels(); ++level) {
    const unsigned* a = &arguments[static_cast<std::size_t>(8 * level)];
    for (unsigned i = 0; i < a[6]; ++i) levels[list[a[5] + i]] = level;
  }
  return levels;
}

/// Compares the levels with the expected levels. Skips instances whose expected level is unknown.
void compareLevels(const std::vector<int>& levels, int levelCount,
                   const std::function<std::optional<int>(std::size_t)>& expected) {
  std::size_t wrong = 0, unknown = 0;
  std::vector<int> used(static_cast<std::size_t>(levelCount) + 1, 0);
  for (std::size_t slot = 0; slot < levels.size(); ++slot) {
    const auto wanted = expected(slot);
    unknown += wanted ? 0 : 1;
    if (!wanted) continue;
    wrong += *wanted == levels[slot] ? 0 : 1;
    ++used[static_cast<std::size_t>(*wanted + 1)];
  }
  CHECK(wrong == 0);
  CHECK(unknown < levels.size() / 100);
  CHECK(*std::min_element(used.begin(), used.end()) > 3);
}

/// An unpacked small sprite, written by the kernel of small sprites that ran last.
struct Square {
  dvec3 place;
  double side;
  dvec3 light;
  dvec2 slope;
};

/// Reads the first `count` words of the buffer texture bound to texture unit `unit`.
template <class T>
std::vector<T> wordsAt(int unit, std::size_t count) {
  GLint texture = 0, buffer = 0;
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &texture);
  glGetTextureLevelParameteriv(static_cast<GLuint>(texture), 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING,
                               &buffer);
  std::vector<T> words(count);
  glGetNamedBufferSubData(static_cast<GLuint>(buffer), 0, static_cast<GLsizeiptr>(count * sizeof(T)),
                          words.data());
  return words;
}

std::vector<Square> squares(std::size_t count) {
  gl::barrier();
  std::vector<Square> made;
  for (const glm::uvec4& w : wordsAt<glm::uvec4>(draw::spriteUnit, count)) {
    const double steps[3] = {double(w.x & 0xfffffU), double(w.x >> 20U | (w.y & 0xffU) << 12U),
                             double(w.y >> 8U)};
    const double exponentOf = std::exp2(double(w.w >> 27U) - 15 - 9);
    made.push_back({2.0 * dvec3(steps[0] / 1048575, steps[1] / 1048575, steps[2] / 16777215) - 1.0,
                    double{glm::unpackHalf2x16(w.z).x},
                    exponentOf * dvec3(w.w & 511U, w.w >> 9U & 511U, w.w >> 18U & 511U),
                    (dvec2(w.z >> 16U & 255U, w.z >> 24U) - 127.0) / 127.0});
  }
  return made;
}

double radiusAt(const sim::Instances& instances, const glm::vec4& place) {
  return 0.5 * double{instances.size} * std::pow(double{place.w}, double{exponent});
}

}  // namespace

TEST_CASE("instances: visible instances are listed in the level of detail for their size on the picture") {
  testContext();
  const auto places = cloud(20001);
  for (const auto& [shape, additive] :
       {std::pair(Shape::sprite, false), {Shape::sprite, true}, {Shape::sphere, false}})
    for (const glm::ivec2 size : {glm::ivec2(16, 9), glm::ivec2(320, 180)}) {
      CAPTURE(static_cast<int>(shape));
      CAPTURE(additive);
      CAPTURE(size.y);
      PassStage stage(plainScene(), size);
      InstanceStage group(places, std::vector<glm::vec4>(places.size(), glm::vec4(0)));
      sim::Instances& instances = group.instances;
      instances.shape = shape;
      instances.additive = additive;
      instances.massExponent = exponent;
      instances.size = size.y < 20 ? 1.0F : shape == Shape::sphere ? 0.4F : additive ? 0.7F : 0.1F;
      stage.pass.cull({{}, {instances}});
      const Eye eye(stage.values);
      const bool sphere = shape == Shape::sphere;
      const double reach = sphere ? double{draw::InstanceShape::sphere().radius()} : 0.5;
      const double minimum = sphere ? 0 : additive ? 1.75 : 0.57;  // min radius in pixels
      const double points = !additive ? 1.6 : draw::GlowSums::used() ? 5 : 64;
      const double error = gl::softwareDriver() ? 0.5 : 0.2;
      const int levels = stage.pass.visible(0).levels();
      CHECK(levels == (sphere ? 5 : 2));
      const auto expected = [&](std::size_t slot) -> std::optional<int> {
        const dvec3 p(places[slot]);
        const double own = 2 * reach * radiusAt(instances, places[slot]);
        const double radius = std::max(own, minimum * std::max(eye.depth(p), 0.0) / eye.pixels);
        const auto seen = inSight(eye, p, radius);
        if (seen != true) return seen ? std::optional(-1) : std::nullopt;
        const double pixels = radius * eye.pixels / std::max(eye.depth(p) - radius, 1e-3);
        if (!sphere) {
          const auto small = all({above(points, pixels), middleInSight(eye, p)});
          return small ? std::optional(*small ? 0 : 1) : std::nullopt;
        }
        int level = 0;
        for (const double missed : {0.149, 0.0489, 0.0123, 0.0031}) {
          const auto finer = above(pixels * missed, error);
          if (!finer) return std::nullopt;
          level += *finer ? 1 : 0;
        }
        return level;
      };
      // At this picture size, all of the smallest sprites are enlarged. None of them may be missing at the
      // picture's borders.
      if (size.y < 20 && !sphere) {
        std::size_t wrong = 0;
        const auto found = levelsOf(stage.pass.visible(0));
        for (std::size_t slot = 0; slot < found.size(); ++slot)
          if (const auto wanted = expected(slot)) wrong += *wanted == found[slot] ? 0 : 1;
        CHECK(wrong == 0);
      } else if (size.y > 20) {
        compareLevels(levelsOf(stage.pass.visible(0)), levels, expected);
      }
    }
}

TEST_CASE("instances: the sun's map lists instances that reach into it, small ones as squares of texels") {
  testContext();
  const auto places = cloud(4001);
  scene::Scene scene = darkScene();
  scene.sun.direction = glm::vec3(0.4F, 0.8F, 0.45F);
  scene.sun.shadowSize = 256;
  PassStage stage(scene, {64, 36});
  InstanceStage group(places, std::vector<glm::vec4>(places.size(), glm::vec4(0)));
  sim::Instances& instances = group.instances;
  instances.massExponent = exponent;
  instances.size = 0.35F;
  instances.boundsMin = glm::vec3(-2.1F, -1.8F, -1.9F);  // The bounds are smaller than the true ones.
  instances.boundsMax = glm::vec3(2, 2, 2);
  const sim::Drawables drawables{{}, {instances}};
  stage.shadow.fit(drawables, [&](const gl::Buffer& bounds) { stage.pass.growBounds(drawables, bounds); });
  stage.pass.cullForLight(drawables);
  gl::barrier();
  const auto light = wordsAt<glm::vec4>(draw::lightUnit, 4);
  const auto placeOf = [&](dvec3 p) {
    return dvec3(glm::dot(dvec4(light[0]), dvec4(p, 1)), glm::dot(dvec4(light[1]), dvec4(p, 1)),
                 glm::dot(dvec4(light[2]), dvec4(p, 1)));
  };
  const double texel = double{light[3].x};
  const auto expected = [&](std::size_t slot) -> std::optional<int> {
    const dvec3 place = placeOf(places[slot]);
    const double radius = radiusAt(instances, places[slot]);
    const dvec3 reach = radius / dvec3(light[3].y, light[3].y, light[3].z);
    std::vector<std::optional<bool>> inside, middle = {above(4, radius / texel)};
    for (int i = 0; i < 3; ++i) {
      inside.push_back(above(place[i] + reach[i], 0, 1e-5));
      inside.push_back(above(1, place[i] - reach[i], 1e-5));
      middle.push_back(above(0.4999, std::abs(place[i] - 0.5), 1e-5));
    }
    const auto seen = all(inside), small = all(middle);
    if (seen != true || !small) return seen == false ? std::optional(-1) : std::nullopt;
    return *small ? 0 : 1;
  };
  compareLevels(levelsOf(stage.pass.visibleToSun(0)), 2, expected);

  draw::SmallSprites small({});
  small.prepare({.use = draw::SmallSprites::Use::shadow},
                {.instance = draw::instanceFields(instances, 0.5F, 0),
                 .listed = stage.pass.visibleToSun(0).fields(0)},
                instances.capacity);
  const auto arguments = stage.pass.visibleToSun(0).arguments().readAll<unsigned>();
  const auto list = stage.pass.visibleToSun(0).list().readAll<unsigned>();
  const auto made = squares(arguments[6]);
  REQUIRE(made.size() > 100);
  for (std::size_t i = 0; i < made.size(); ++i) {
    const glm::vec4& place = places[list[i]];
    CHECK(glm::length(made[i].place - (2.0 * placeOf(place) - 1.0)) < 1e-5);
    const double side = std::sqrt(std::numbers::pi) * radiusAt(instances, place) / texel;
    CHECK(made[i].side == doctest::Approx(side).epsilon(0.001).scale(0));
  }
}

TEST_CASE(
    "instances: small balls and glows are squares of the right size and light, also on coarse and wide "
    "pictures") {
  testContext();
  const auto places = cloud(2001);
  scene::Scene scene = plainScene();
  scene.camera.fieldOfView = 100.0F;
  scene.sun.direction = glm::vec3(0.3F, 0.2F, 1);
  for (const bool glows : {false, true}) {
    CAPTURE(glows);
    PassStage stage(scene, {16, 9});
    InstanceStage group(places, std::vector<glm::vec4>(places.size(), glm::vec4(0)));
    sim::Instances& instances = group.instances;
    instances.massExponent = exponent;
    instances.size = 1.5F;
    instances.additive = glows;
    instances.brightness = 0.5F;
    group.material.color = glm::vec3(0.4F, 0.3F, 0.2F);
    stage.pass.cull({{}, {instances}});
    const auto arguments = stage.pass.visible(0).arguments().readAll<unsigned>();
    const auto list = stage.pass.visible(0).list().readAll<unsigned>();
    draw::SmallSprites small({});
    draw::InstanceColors colors;
    colors.update(instances);
    small.prepare({.use = glows ? draw::SmallSprites::Use::glow : draw::SmallSprites::Use::ball},
                  {.instance = draw::instanceFields(instances, 0.5F, draw::minPixelsOf(instances)),
                   .look = colors.look(instances),
                   .material = {.roughness = 1.0F, .metallic = 0.0F, .translucency = 0.0F},
                   .listed = stage.pass.visible(0).fields(0)},
                  instances.capacity);
    const auto made = squares(arguments[6]);
    REQUIRE(made.size() > 100);
    const Eye eye(stage.values);
    const dvec3 sun = glm::normalize(dvec3(0.3, 0.2, 1));
    int near = 0, lit = 0;
    for (std::size_t i = 0; i < made.size(); ++i) {
      const Square& square = made[i];
      const dvec3 p(places[list[i]]);
      const dvec4 clip = eye.clip(p);
      CHECK(glm::length(square.place - dvec3(clip) / clip.w) < 1e-5);
      const double own = radiusAt(instances, places[list[i]]);
      const double minimum = (glows ? 1.75 : 0.57) * eye.depth(p) / eye.pixels,
                   radius = std::max(own, minimum);
      const double sine = radius / glm::length(eye.place - p);
      const double outline = radius / std::sqrt(1 - sine * sine);
      near += outline > 1.02 * radius ? 1 : 0;
      const double side = glows ? 2 * radius : std::sqrt(std::numbers::pi) * outline;
      CHECK(square.side == doctest::Approx(side * eye.pixels / eye.depth(p)).epsilon(0.001).scale(0));
      if (glows) {
        const double share = std::min(own / minimum, 1.0);
        const dvec3 light = dvec3(0.4, 0.3, 0.2) * 0.5 * share * share;
        if (light.z > 1e-6) CHECK(glm::length(square.light - light) < 0.004 * glm::length(light) + 6e-8);
        continue;
      }
      // The normals of the visible hemisphere face the eye with a mean cosine of 2/3. Light is evaluated at
      // four corners with unit normals.
      const dvec3 towards = glm::normalize(eye.place - p);
      const dvec3 right = glm::normalize(glm::cross(dvec3(stage.values.rayUp), towards)),
                  up = glm::cross(towards, right);
      const double aside = std::sqrt((1 - 4.0 / 9) / 2);
      const double middle = glm::dot(towards, sun) * 2 / 3;
      const dvec2 gain = aside * dvec2(glm::dot(right, sun), glm::dot(up, sun));
      if (middle < std::abs(gain.x) + std::abs(gain.y) + 0.1)
        continue;  // Skips balls with a corner that faces away from the sun.
      ++lit;
      CHECK(std::abs(square.slope.x - gain.x / middle) < 0.008 + 0.02 * std::abs(gain.x / middle));
      CHECK(std::abs(square.slope.y - gain.y / middle) < 0.008 + 0.02 * std::abs(gain.y / middle));
      CHECK(square.light.x == doctest::Approx(0.4 * middle).epsilon(0.04).scale(0));
    }
    CHECK(near > (glows ? -1 : 50));
    CHECK(lit > (glows ? -1 : 100));
  }
}

TEST_CASE("instances: a small ball covers the pixels whose centres lie in a square of its area") {
  testContext();
  // GPUs round the point size to an eighth of a pixel.
  for (const auto& [side, pixels] : {std::pair(1.87, 1), {2.13, 9}}) {
    InstanceStage ball(std::vector<glm::vec3>(1, glm::vec3(0)));
    const double perMetre = 0.5 * 65 / std::tan(glm::radians(20.0)) / 5;
    ball.instances.size = static_cast<float>(2 * side / std::sqrt(std::numbers::pi) / perMetre);
    ball.material.color = glm::vec3(0.5F);
    const Picture picture =
        drawn(plainScene(), {{}, {ball.instances}}, {65, 65}, 1, {.rasterizer = scene::Rasterizer::driver});
    int covered = 0;
    for (int y = 0; y < 65; ++y)
      for (int x = 0; x < 65; ++x) covered += picture.brightness(x, y) > 30 ? 1 : 0;
    CHECK(covered == pixels);
  }
}

TEST_CASE("instances: a ball close to the eye has its true perspective outline") {
  testContext();
  scene::Scene scene = plainScene();
  scene.camera.position = glm::vec3(0, 0, 0.75F);
  scene.camera.target = glm::vec3(0.05F, -0.03F, 0);
  scene.camera.fieldOfView = 130.0F;
  SphereStage sphere(glm::vec3(0), 0.6F);
  InstanceStage ball(std::vector<glm::vec3>(1, glm::vec3(0)));
  ball.instances.size = 1.2F;
  const draw::RendererOptions driver{.rasterizer = scene::Rasterizer::driver};
  const Picture wanted = drawn(scene, {{sphere.surface}, {}}, {161, 121}, 4, driver);
  CHECK(compare(wanted, drawn(scene, {}, {161, 121}, 4, driver)).far > 2000);
  const Difference d = compare(drawn(scene, {{}, {ball.instances}}, {161, 121}, 4, driver), wanted);
  CHECK(d.mean < 0.5);
  CHECK(d.far < 60);
}
