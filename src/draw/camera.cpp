#include "draw/camera.hpp"

#include "base/error.hpp"
#include "base/ieee.hpp"
#include "sim/core/path.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/core/turn.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

constexpr float radiansPerDegree = 0.017453293F;

/// Returns the target of a camera that follows no path.
glm::vec3 targetOf(const scene::Camera& camera, double seconds, const sim::Drawables& drawables) {
  if (!camera.track)
    return drawables.dampedCamera.empty() ? camera.target.at(seconds) : drawables.dampedCamera.front();
  for (const sim::Place& place : drawables.places)
    if (*place.object == camera.track->object) return place.middle + camera.track->offset;
  fail(ExitCode::usage, "the camera looks at \"{}\", which has no place at {:g} s", camera.track->object,
       seconds);
}

Stand standOf(const scene::Camera& camera, double seconds, const sim::Drawables& drawables) {
  if (camera.orbit) return orbitPose(targetOf(camera, seconds, drawables), *camera.orbit, seconds);
  if (!camera.follow) return {camera.position.at(seconds), targetOf(camera, seconds, drawables)};
  if (drawables.dampedCamera.size() == 2)
    return {drawables.dampedCamera.back(), drawables.dampedCamera.front()};
  if (const sim::Path* path = sim::pathOf(drawables, camera.follow->object))
    return standOn(*path->points, *camera.follow, seconds);
  fail(ExitCode::usage,
       "the camera follows \"{}\", which has no path at {:g} s: it has not grown yet, or it has no open "
       "cells",
       camera.follow->object, seconds);
}

/// Returns the distance (m) by which an orthographic camera above the ground must move back so that the
/// lowest corner of its near plane is above the ground. Each metre of movement raises the corner by
/// -forward.y. The distance is limited, because no ground is visible beyond its fade distance.
float setBackAboveGround(const View& view, float near, const scene::Ground& ground) {
  constexpr float level = 1e-4F, slack = 1e-4F;
  const float rise = -view.forward.y, above = view.eye.y - ground.height;
  if (!(rise > level) || !(above > 0)) return 0;
  const float lowest = above - std::abs(view.right.y) - std::abs(view.up.y) - near * rise;
  if (lowest >= 0) return 0;
  const float fades = std::max(ground.fadeStart, ground.fadeEnd);
  const float maximum = 2 * (fades + glm::distance(view.eye, view.target) + view.reach.x + view.reach.y);
  return std::min(-lowest / rise * (1 + slack) + slack, maximum);
}

}  // namespace

Stand orbitPose(const glm::vec3& target, const scene::Orbit& orbit, double seconds) {
  constexpr double perDegree = 0.017453292519943295;
  const double turn = perDegree * static_cast<double>(orbit.turn.at(seconds));
  const double rise = perDegree * static_cast<double>(orbit.elevation.at(seconds));
  const glm::dvec3 back(ieee::cos(rise) * ieee::sin(turn), ieee::sin(rise),
                        ieee::cos(rise) * ieee::cos(turn));
  return {target + orbit.distance.at(seconds) * glm::vec3(back), target};
}

View viewAt(const scene::Camera& camera, double seconds, glm::ivec2 size, const sim::Drawables& drawables,
            const scene::Ground* ground) {
  View view;
  glm::vec3 right, up;
  if (camera.gltf) {
    SIMREEL_CHECK(camera.gltf->shot != nullptr);
    const scene::CameraPose pose = camera.gltf->shot->at(seconds);
    view.eye = glm::vec3(pose.eye);
    view.forward = glm::vec3(-pose.back);
    view.target = glm::vec3(pose.eye - static_cast<double>(camera.gltf->distance) * pose.back);
    right = glm::vec3(pose.right);
    up = glm::vec3(pose.up);
  } else {
    const Stand stand = standOf(camera, seconds, drawables);
    view.eye = stand.eye;
    view.target = stand.target;
    const glm::vec3 along = view.target - view.eye;
    view.forward = glm::length(along) > 1e-6F ? glm::normalize(along) : glm::vec3(0, 0, -1);
    // If the camera looks straight up or down, the top of the picture is -z.
    const bool steep = std::abs(view.forward.y) > 0.9999F;
    right = glm::normalize(glm::cross(view.forward, steep ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0)));
    up = glm::cross(right, view.forward);
  }
  // Does not use the library's sine and cosine, because their results differ between machines.
  const glm::vec2 roll = sim::cosineAndSine(camera.roll.at(seconds));
  const glm::vec3 r = roll.x * right - roll.y * up;
  const glm::vec3 u = roll.y * right + roll.x * up;

  view.parallel = isParallel(camera);
  const float half = 0.5F * radiansPerDegree * camera.fieldOfView.at(seconds);
  const float high =
      view.parallel ? 0.5F * camera.height.at(seconds) : shader::exactSin(half) / shader::exactCos(half);
  const float wide = high * static_cast<float>(size.x) / static_cast<float>(size.y);
  view.right = r * wide;
  view.up = u * high;
  view.reach = glm::vec2(wide, high);
  if (view.parallel && ground != nullptr) view.farther = setBackAboveGround(view, camera.near, *ground);
  if (view.farther > 0) view.eye -= view.farther * view.forward;
  const glm::vec3& f = view.forward;
  const glm::vec3& e = view.eye;
  const glm::mat4 toCamera(glm::vec4(r.x, u.x, -f.x, 0), glm::vec4(r.y, u.y, -f.y, 0),
                           glm::vec4(r.z, u.z, -f.z, 0),
                           glm::vec4(-glm::dot(r, e), -glm::dot(u, e), glm::dot(f, e), 1));
  const float n = camera.near;
  const float far = camera.far + view.farther;
  const float d = far - n;
  const glm::mat4 project(glm::vec4(1 / wide, 0, 0, 0), glm::vec4(0, 1 / high, 0, 0),
                          glm::vec4(0, 0, -(far + n) / d, -1), glm::vec4(0, 0, -2 * far * n / d, 0));
  const glm::mat4 level(glm::vec4(1 / wide, 0, 0, 0), glm::vec4(0, 1 / high, 0, 0),
                        glm::vec4(0, 0, -2 / d, 0), glm::vec4(0, 0, -(far + n) / d, 1));
  view.viewProjection = (view.parallel ? level : project) * toCamera;
  return view;
}

}  // namespace simreel::draw
