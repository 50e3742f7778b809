#include "draw/exact/reflections/reflections.hpp"

#include "draw/exact/bindings.hpp"
#include "gl/element_array.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "reference/reflections_twin.hpp"

#include <cmath>
#include <functional>
#include <optional>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

constexpr glm::ivec2 mirrorPicture(240, 160);

struct MirrorMet {
  double depth = 0;  ///< depth of the hit point (m); equal to the ray parameter, because rays are scaled to
                     ///< a depth of 1
  bool mirror = false;
};
using MirrorSeen = std::function<MirrorMet(glm::dvec3 eye, glm::dvec3 ray)>;

glm::dvec3 mirrorRayThrough(const shader::ExactView& view, glm::dvec2 pixel) {
  return glm::dvec3(view.ray) + pixel.x * glm::dvec3(view.rayAcross) + pixel.y * glm::dvec3(view.rayDown);
}

/// Returns inputs whose light encodes the world position of each pixel, computed by rays in float64. The
/// reflected light therefore reveals the position of the hit point.
ReflectionsTwin mirrorTwinOf(const shader::ExactView& view, const MirrorSeen& seen, float away) {
  ReflectionsTwin twin;
  twin.view = view;
  twin.reach = draw::Reflections::reachOf(away);
  const glm::dvec3 eye(view.eye);
  std::vector<float> nearness;
  std::vector<glm::vec4> light;
  for (int y = 0; y < twin.half().y; ++y)
    for (int x = 0; x < twin.half().x; ++x) {
      double nearest = 0;
      for (const double right : {0.5, 1.5})
        for (const double down : {0.5, 1.5}) {
          const double depth = seen(eye, mirrorRayThrough(view, {2 * x + right, 2 * y + down})).depth;
          nearest = std::max(nearest, depth > 0 ? 1 / depth : 0);
        }
      nearness.push_back(static_cast<float>(nearest));
    }
  for (int y = 0; y < view.size.y; ++y)
    for (int x = 0; x < view.size.x; ++x) {
      const glm::dvec3 ray = mirrorRayThrough(view, {x + 0.5, y + 0.5});
      const double depth = seen(eye, ray).depth;
      light.emplace_back(glm::vec3(eye + depth * ray), depth > 0 ? 1.0F : 0.0F);
      if (depth <= 0) light.back() = glm::vec4(0);
    }
  twin.see(nearness, light);
  return twin;
}

ReflectionsTwin::Ray mirroredRay(const shader::ExactView& view, glm::dvec3 p, glm::dvec3 normal) {
  const glm::dvec3 towards = glm::normalize(glm::dvec3(view.eye) - p);
  return {glm::vec3(p),
          glm::vec3(2 * glm::dot(normal, towards) * normal - towards),
          glm::vec3(normal),
          glm::vec3(towards),
          0,
          0};
}

/// Returns the ray parameter of the intersection with a ball, or nothing.
std::optional<double> rayOnBall(glm::dvec3 from, glm::dvec3 ray, glm::dvec3 middle, double radius) {
  const glm::dvec3 aside = from - middle;
  const double a = glm::dot(ray, ray), b = glm::dot(ray, aside);
  const double root = b * b - a * (glm::dot(aside, aside) - radius * radius);
  if (root <= 0) return std::nullopt;
  const double t = (-b - std::sqrt(root)) / a;
  return t > 0 ? std::optional(t) : std::nullopt;
}

/// Statistics of the distances between the hit points of reflections in the mirror y = 0 and the exact hit
/// points from `truth`. Only rays that hit something within the reach and inside the picture count.
struct MirrorJudged {
  int met = 0, near = 0, missed = 0, invented = 0;  ///< near: number of hit points within 0.03 m of the
                                                    ///< exact point
  double worst = 0, mean = 0;
};

MirrorJudged judgeMirror(const ReflectionsTwin& twin, const MirrorSeen& seen,
                         const std::function<std::optional<double>(glm::dvec3 p, glm::dvec3 ray)>& truth) {
  MirrorJudged judged;
  const shader::ExactView& view = twin.view;
  for (int y = 0; y < view.size.y; ++y)
    for (int x = 0; x < view.size.x; ++x) {
      const glm::dvec3 ray = mirrorRayThrough(view, {x + 0.5, y + 0.5});
      const MirrorMet there = seen(glm::dvec3(view.eye), ray);
      if (!there.mirror || there.depth <= 0) continue;
      const glm::dvec3 p = glm::dvec3(view.eye) + there.depth * ray;
      const ReflectionsTwin::Ray mirrored = mirroredRay(view, p, {0, 1, 0});
      const glm::vec4 light = twin.lightMet(mirrored);
      const glm::dvec3 direction(mirrored.direction);
      const std::optional<double> true_ = truth(p, direction);
      if (!true_) {
        if (light.w > 0.5F) ++judged.invented;
        continue;
      }
      const glm::dvec3 wanted = p + *true_ * direction;
      if (light.w < 0.5F) {
        ++judged.missed;
        continue;
      }
      const double off = glm::distance(glm::dvec3(glm::vec3(light) / light.w), wanted);
      ++judged.met;
      judged.near += off < 0.03 ? 1 : 0;
      judged.worst = std::max(judged.worst, off);
      judged.mean += off;
    }
  judged.mean /= std::max(judged.met, 1);
  return judged;
}

}  // namespace

// There is a wall in the plane z = -1 behind a mirror in the plane y = 0. Rays from the mirror must hit the
// wall at the correct point.
TEST_CASE("reflections: in a plane mirror a wall is where its mirror image is") {
  const shader::ExactView view = exactViewFrom({0.3F, 1.3F, 3}, {0, 0.2F, -0.6F}, mirrorPicture);
  const MirrorSeen seen = [](glm::dvec3 eye, glm::dvec3 ray) {
    const double wall = (-1 - eye.z) / ray.z, floor = -eye.y / ray.y;
    if (ray.y < 0 && eye.z + floor * ray.z > -1) return MirrorMet{floor, true};
    return MirrorMet{ray.z < 0 ? wall : 0, false};
  };
  const ReflectionsTwin twin = mirrorTwinOf(view, seen, 4);
  const MirrorJudged judged =
      judgeMirror(twin, seen, [&](glm::dvec3 p, glm::dvec3 ray) -> std::optional<double> {
        const double t = (-1 - p.z) / ray.z;
        const glm::dvec3 met = p + t * ray;
        const std::optional<glm::dvec2> pixel = draw::pixelOf(view, met);
        const glm::dvec2 inner = 0.12 * mirrorPicture.y * glm::dvec2(1);
        if (!pixel || pixel->x < inner.x || pixel->y < inner.y || pixel->x > mirrorPicture.x - inner.x ||
            t > 1.8 || glm::distance(met, p) < 0.1)
          return std::nullopt;
        return t;
      });
  CAPTURE(judged.worst);
  CAPTURE(judged.mean);
  // A pixel is 0.02 m wide at the wall.
  CHECK(judged.met > 5000);
  CHECK(judged.missed == 0);
  CHECK(judged.mean < 0.01);
  CHECK(judged.worst < 0.05);
}

TEST_CASE("reflections: a ball over a plane mirror is where its mirror image is") {
  const glm::dvec3 middle(0.1, 0.55, -0.3);
  const double radius = 0.4;
  const shader::ExactView view = exactViewFrom({0.3F, 0.9F, 3}, {0, 0.3F, -0.3F}, mirrorPicture);
  const MirrorSeen seen = [&](glm::dvec3 eye, glm::dvec3 ray) {
    if (const auto ball = rayOnBall(eye, ray, middle, radius)) return MirrorMet{*ball, false};
    return MirrorMet{ray.y < 0 ? -eye.y / ray.y : 0, true};
  };
  const ReflectionsTwin twin = mirrorTwinOf(view, seen, 4);
  int hidden = 0;  // number of rays that hit a part of the ball that is invisible to the eye
  const MirrorJudged judged =
      judgeMirror(twin, seen, [&](glm::dvec3 p, glm::dvec3 ray) -> std::optional<double> {
        const auto t = rayOnBall(p, ray, middle, radius);
        if (!t) return std::nullopt;
        const glm::dvec3 there = p + *t * ray;
        if (glm::dot(there - middle, glm::dvec3(view.eye) - there) > 0.1 * radius) return t;
        ++hidden;
        return std::nullopt;
      });
  CAPTURE(judged.worst);
  CAPTURE(judged.mean);
  CAPTURE(judged.missed);
  CAPTURE(judged.invented);
  CAPTURE(hidden);
  CHECK(judged.met > 800);
  CAPTURE(judged.near);
  CHECK(judged.missed < 0.03 * judged.met);
  CHECK(judged.invented < hidden + 60);  // Wrong reflections may occur for hits on hidden parts and at the
                                         // outline of the ball.
  // At the outline of the ball, some of the light of a half-resolution pixel comes from the background.
  CHECK(judged.near > 0.8 * judged.met);
}

TEST_CASE("reflections: the light of a ball's edge is the ball's, also on its hidden side") {
  const glm::dvec3 middle(0.1, 0.55, -0.3);
  const double radius = 0.4;
  const shader::ExactView view = exactViewFrom({0.3F, 0.9F, 3}, {0, 0.3F, -0.3F}, mirrorPicture);
  const MirrorSeen seen = [&](glm::dvec3 eye, glm::dvec3 ray) {
    if (const auto ball = rayOnBall(eye, ray, middle, radius)) return MirrorMet{*ball, false};
    return MirrorMet{ray.y < 0 ? -eye.y / ray.y : 0, true};
  };
  const ReflectionsTwin twin = mirrorTwinOf(view, seen, 4);
  int met = 0;
  int mixed = 0;  // number of rays whose light also comes from behind the ball
  for (int y = 0; y < view.size.y; ++y)
    for (int x = 0; x < view.size.x; ++x) {
      const glm::dvec3 ray = mirrorRayThrough(view, {x + 0.5, y + 0.5});
      const MirrorMet there = seen(glm::dvec3(view.eye), ray);
      if (!there.mirror || there.depth <= 0) continue;
      const glm::dvec3 p = glm::dvec3(view.eye) + there.depth * ray;
      const glm::vec4 light = twin.lightMet(mirroredRay(view, p, {0, 1, 0}));
      if (light.w < 0.5F) continue;
      const glm::dvec3 from(glm::vec3(light) / light.w);
      ++met;
      mixed += std::abs(glm::distance(from, middle) - radius) > 0.03 ? 1 : 0;
    }
  CAPTURE(met);
  CAPTURE(mixed);
  CHECK(met > 800);
  CHECK(mixed < 0.03 * met);
}

TEST_CASE("reflections: a flat mirror, a lone ball and what is far away or matt bring nothing") {
  const shader::ExactView view = exactViewFrom({0.3F, 0.5F, 3}, {0, 0.2F, -0.6F}, mirrorPicture);
  const MirrorSeen flat = [](glm::dvec3 eye, glm::dvec3 ray) {
    return MirrorMet{ray.y < 0 ? -eye.y / ray.y : 0, true};
  };
  const ReflectionsTwin floor = mirrorTwinOf(view, flat, 3);
  const MirrorJudged judged = judgeMirror(floor, flat, [](glm::dvec3, glm::dvec3) { return std::nullopt; });
  CHECK(judged.invented == 0);
  const glm::dvec3 middle(0, 0.3, -0.6);
  const MirrorSeen ball = [&](glm::dvec3 eye, glm::dvec3 ray) {
    return MirrorMet{rayOnBall(eye, ray, middle, 0.9).value_or(0), true};
  };
  const ReflectionsTwin round = mirrorTwinOf(view, ball, 3);
  int places = 0;
  for (int y = 0; y < mirrorPicture.y; ++y)
    for (int x = 0; x < mirrorPicture.x; ++x) {
      const glm::dvec3 ray = mirrorRayThrough(view, {x + 0.5, y + 0.5});
      const MirrorMet there = ball(glm::dvec3(view.eye), ray);
      if (there.depth <= 0) continue;
      const glm::dvec3 p = glm::dvec3(view.eye) + there.depth * ray;
      CHECK(round.lightMet(mirroredRay(view, p, (p - middle) / 0.9)).w == 0.0F);
      ++places;
    }
  CHECK(places > 3000);
  // The reflection of a wall decreases with roughness and is 0 beyond the reach.
  const MirrorSeen wall = [](glm::dvec3 eye, glm::dvec3 ray) {
    const double behind = (-1 - eye.z) / ray.z, below = -eye.y / ray.y;
    return ray.y < 0 && below < behind ? MirrorMet{below, true} : MirrorMet{behind, false};
  };
  ReflectionsTwin twin = mirrorTwinOf(view, wall, 3);
  ReflectionsTwin::Ray ray = mirroredRay(view, {0, 0, 0.2}, {0, 1, 0});
  const auto share = [&](float roughness) {
    ray.roughness = roughness;
    return twin.lightMet(ray).w;
  };
  CHECK(share(0) == doctest::Approx(1).epsilon(1e-3));
  CHECK(share(0.1F) == doctest::Approx(1).epsilon(1e-3));
  CHECK(share(0.2F) == doctest::Approx(0.5).epsilon(1e-3));
  CHECK(share(0.3F) == 0.0F);
  twin.reach.x = 1;
  CHECK(share(0) == 0.0F);
  twin.reach.x = 1.2F / 0.75F;
  CHECK(share(0) > 0.1F);
  CHECK(share(0) < 0.9F);
}

TEST_CASE("exact: reflections of half pixels and of pixels are the twin's, bit for bit") {
  testContext();
  for (const glm::ivec2 size : {glm::ivec2(75, 61), {33, 18}, {97, 3}, {1, 1}, {128, 64}}) {
    CAPTURE(size.x);
    const shader::ExactView view = exactViewFrom({0.3F, 0.9F, 3}, {0, 0.3F, -0.3F}, size);
    const MirrorSeen seen = [](glm::dvec3 eye, glm::dvec3 ray) {
      if (const auto ball = rayOnBall(eye, ray, {0.1, 0.45, -0.3}, 0.5)) return MirrorMet{*ball, false};
      return MirrorMet{ray.y < 0 ? -eye.y / ray.y : 0, true};
    };
    ReflectionsTwin twin = mirrorTwinOf(view, seen, 4);
    std::vector<float> nearness(static_cast<std::size_t>(twin.half().x * twin.half().y));
    const glm::dvec3 eye(view.eye);
    std::vector<glm::vec4> light;
    std::vector<glm::vec4> rays;
    std::vector<glm::vec4> wanted;
    std::vector<glm::vec4> wantedOfPixels;
    std::vector<float> pixelNearness;
    for (int y = 0; y < twin.half().y; ++y)
      for (int x = 0; x < twin.half().x; ++x) {
        const double depth = seen(eye, mirrorRayThrough(view, {2 * x + 1, 2 * y + 1})).depth;
        nearness[static_cast<std::size_t>(y * twin.half().x + x)] =
            depth > 0 ? static_cast<float>(1 / depth) : 0.0F;
      }
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const double depth = seen(eye, mirrorRayThrough(view, {x + 0.5, y + 0.5})).depth;
        const float there = depth > 0 ? 1.0F : 0.0F;
        pixelNearness.push_back(depth > 0 ? static_cast<float>(1 / depth) : 0.0F);
        light.push_back(there *
                        glm::vec4(0.01F * static_cast<float>(x), 0.3F, 0.02F * static_cast<float>(y), 1));
      }
    twin.see(nearness, light);
    ReflectionsTwin refined = twin;
    refined.refine(pixelNearness);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::dvec3 through = mirrorRayThrough(view, {x + 0.5, y + 0.5});
        const MirrorMet met = seen(eye, through);
        const glm::dvec3 p = eye + std::max(met.depth, 0.5) * through;
        const glm::dvec3 normal =
            met.mirror ? glm::dvec3(0, 1, 0) : glm::normalize(p - glm::dvec3(0.1, 0.45, -0.3));
        ReflectionsTwin::Ray ray = mirroredRay(view, p, normal);
        ray.roughness = 0.06F * static_cast<float>((x + y) % 8);
        ray.turns = 0.003F * static_cast<float>(x % 7);
        ray.ground = y % 3 == 0 ? 0.07F * static_cast<float>(x % 11) : -1;
        rays.emplace_back(ray.p, ray.roughness);
        rays.emplace_back(ray.direction, ray.turns);
        rays.emplace_back(ray.facing, ray.ground);
        rays.emplace_back(ray.towards, 0);
        wanted.push_back(twin.lightMet(ray));
        wantedOfPixels.push_back(refined.lightMet(ray));
      }
    const gl::Buffer nearBuffer = gl::Buffer::of<float>("nearness", nearness);
    const gl::Texture nearView = gl::Texture::view("nearness", GL_R32F, nearBuffer, sizeof(float));
    const gl::Texture sums = gl::Texture::image("light", GL_RGBA32F, size.x, size.y);
    glTextureSubImage2D(sums.name(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, light.data());
    const draw::Reflections reflections(size);
    reflections.see(sums, nearView);
    const draw::Occlusion::PixelNearness pixels = reflections.pixelNearness();
    gl::barrier();
    glNamedBufferSubData(pixels.buffer->name(), static_cast<GLintptr>(sizeof(float)) * pixels.first,
                         static_cast<GLsizeiptr>(sizeof(float) * pixelNearness.size()),
                         pixelNearness.data());
    sums.bindImage(draw::lightImage, GL_READ_ONLY);
    reflections.light().bindImage(draw::litImage, GL_READ_ONLY);
    reflections.nearest().bindImage(draw::nearnessImage, GL_READ_ONLY);
    const gl::Buffer block = gl::Buffer::of<shader::ExactView>("view", std::vector{view});
    block.bindUniform(draw::viewBinding, 0, sizeof view);
    const gl::Program kernel = gl::Program::computeText("rays from mirrors", R"(
#define EXACT_PICTURE
#define REFLECTED
#include "draw/exact/view_block.glsl"
#include "draw/exact/reflections/reflections_read.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 1) readonly restrict buffer RayBlock { vec4 rays[]; };
layout(std430, binding = 2) writeonly restrict buffer FoundBlock { vec4 found[]; };
uniform int count;
void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  facing_ = rays[4 * i + 2].xyz;
  turns_ = rays[4 * i + 1].w;
  found[i] = lightMet(rays[4 * i].xyz, rays[4 * i + 1].xyz, rays[4 * i + 2].w, rays[4 * i + 3].xyz, rays[4 * i].w);
}
)");
    const gl::Buffer rayBuffer = gl::Buffer::of<glm::vec4>("rays", rays);
    const gl::Buffer found("found", wanted.size() * sizeof(glm::vec4));
    rayBuffer.bindStorage(1);
    found.bindStorage(2);
    kernel.set("mirrorReach", twin.reach);
    kernel.set("count", static_cast<int>(wanted.size()));
    for (const bool ofPixels : {false, true}) {
      CAPTURE(ofPixels);
      const std::vector<glm::vec4>& all = ofPixels ? wantedOfPixels : wanted;
      kernel.set("refined", ofPixels ? 1 : 0);
      kernel.dispatch(static_cast<int>(all.size()));
      gl::barrier();
      testContext().check();
      CHECK(found.readAll<glm::vec4>() == all);
      int met = 0;
      for (const glm::vec4& one : all) met += one.w > 0.1F ? 1 : 0;
      if (size.x > 60 && size.y > 30) CHECK(met > 100);
    }
  }
}
