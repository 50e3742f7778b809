#include "scene/framing.hpp"

#include "base/ieee.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace simreel::scene {

namespace {

/// Shares of the picture's half height and width that the box may take.
constexpr float taken = 0.92F;

/// From the target to the camera. What lies is looked at from above; what stands or hangs almost level, and
/// from the side a little, so that its depth shows.
glm::vec3 backFrom(const Box& box) {
  const glm::vec3 extent = box.max - box.min;
  const bool tall = extent.y > 0.5F * std::max(extent.x, extent.z);
  return glm::normalize(tall ? glm::vec3(-0.5F, 0.4F, 1) : glm::vec3(0, 1.15F, 1));
}

std::optional<Box> boxOf(const Scene& scene) {
  std::optional<Box> all;
  for (const Object& object : scene.objects) {
    const std::optional<Box> one = object.parameters ? object.parameters->framed() : std::nullopt;
    if (!one) continue;
    if (!all) all = one;
    all = Box{glm::min(all->min, one->min), glm::max(all->max, one->max)};
  }
  return all;
}

}  // namespace

void frameObjects(Scene& scene) {
  Camera& camera = scene.camera;
  const std::optional<Box> box = camera.placed ? std::nullopt : boxOf(scene);
  if (!box) return;
  const glm::vec3 back = backFrom(*box);
  const glm::vec3 right = glm::normalize(glm::vec3(back.z, 0, -back.x));
  const glm::vec3 up = glm::normalize(glm::vec3(0, 1, 0) - back * back.y);
  const float half = 0.5F * glm::radians(camera.fieldOfView.at(0));
  const float high = taken * static_cast<float>(ieee::tan(static_cast<double>(half)));
  const float wide =
      high * static_cast<float>(scene.render.size.x) / static_cast<float>(scene.render.size.y);
  const glm::vec3 middle = 0.5F * (box->min + box->max);
  // A corner c is in view from the distance d where |c . up| <= high (d - c . back), and so with right.
  float distance = 0;
  float nearest = 0;  // of the corners, towards the camera
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 corner =
        glm::vec3((i & 1) == 0 ? box->min.x : box->max.x, (i & 2) == 0 ? box->min.y : box->max.y,
                  (i & 4) == 0 ? box->min.z : box->max.z) -
        middle;
    const float before = glm::dot(corner, back);
    nearest = std::max(nearest, before);
    distance = std::max({distance, before + std::abs(glm::dot(corner, up)) / high,
                         before + std::abs(glm::dot(corner, right)) / wide});
  }
  camera.target = middle;
  camera.position = middle + distance * back;
  camera.near = std::min(camera.near, 0.5F * (distance - nearest));
  camera.far = std::max(camera.far, 4.0F * distance);
}

}  // namespace simreel::scene
