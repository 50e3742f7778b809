// Tests that a camera without a position frames all objects that request it.
#include "scene/framing.hpp"

#include "draw/camera.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/vec4.hpp>

using namespace simreel;

namespace {

struct Boxed final : scene::Parameters {
  explicit Boxed(const scene::Box& given) : box(given) {}
  void describe(scene::Fields& /*fields*/) override {}
  [[nodiscard]] std::optional<scene::Box> framed() const override { return box; }
  scene::Box box;
};

scene::Scene with(std::initializer_list<scene::Box> boxes, glm::ivec2 size) {
  scene::Scene scene;
  scene.render.size = size;
  for (const scene::Box& box : boxes) {
    scene::Object& object = scene.objects.emplace_back();
    object.parameters = std::make_unique<Boxed>(box);
  }
  if (boxes.size() > 0) scene::frameObjects(scene, scene::framedObjects(scene));
  return scene;
}

/// Returns the largest picture coordinate of the box's corners. The edges of the picture are at 1. Returns
/// 100 if a corner is behind the camera or outside the near and far distance.
float reach(const scene::Scene& scene, const scene::Box& box) {
  const draw::View view = draw::viewAt(scene.camera, 0, scene.render.size, {});
  float maximum = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::vec4 corner((i & 1) == 0 ? box.min.x : box.max.x, (i & 2) == 0 ? box.min.y : box.max.y,
                           (i & 4) == 0 ? box.min.z : box.max.z, 1);
    const glm::vec4 seen = view.viewProjection * corner;
    if (seen.w <= 0 || std::abs(seen.z) > seen.w) return 100;
    maximum = std::max({maximum, std::abs(seen.x / seen.w), std::abs(seen.y / seen.w)});
  }
  return maximum;
}

}  // namespace

TEST_CASE("an automatic camera frames a whole solid tightly") {
  for (const glm::ivec2 size : {glm::ivec2(1280, 720), glm::ivec2(300, 900)})
    for (const float scale : {0.01F, 1.0F, 500.0F})
      for (const glm::vec3& extent :
           {glm::vec3(5, 0.3F, 3), glm::vec3(1, 1, 6), glm::vec3(0.2F, 4, 0.2F)}) {
        const glm::vec3 middle(3, -2, 1);
        const scene::Box box{scale * (middle - 0.5F * extent), scale * (middle + 0.5F * extent)};
        const float maximum = reach(with({box}, size), box);
        CHECK(maximum < 0.93F);
        CHECK(maximum > 0.9F);
      }
}

TEST_CASE("an automatic camera looks down on flat objects and almost horizontally at tall ones") {
  const auto way = [](const glm::vec3& extent) {
    const scene::Scene scene = with({{-0.5F * extent, 0.5F * extent}}, {640, 360});
    const glm::vec3 back = scene.camera.position.at(0);
    return back / std::sqrt(back.x * back.x + back.y * back.y + back.z * back.z);
  };
  CHECK(way({4, 1, 4}).x == 0);
  CHECK(way({4, 1, 4}).y > 0.7F);
  CHECK(way({3, 3, 3}).y < 0.4F);
  CHECK(way({3, 3, 3}).x < -0.3F);
  CHECK(way({3, 3, 3}).z > 0.8F);
}

TEST_CASE("an automatic camera frames all objects together, and a placed camera does not move") {
  const scene::Box left{{-5, 0, 0}, {-4, 1, 1}};
  const scene::Box right{{6, 0, -3}, {7, 2, 1}};
  const scene::Scene both = with({left, right}, {640, 360});
  CHECK(reach(both, left) < 0.93F);
  CHECK(reach(both, right) < 0.93F);
  scene::Scene placed;
  placed.camera.placed = true;
  placed.objects.emplace_back().parameters = std::make_unique<Boxed>(left);
  scene::frameObjects(placed, scene::framedObjects(placed));
  CHECK(placed.camera.position.at(0) == scene::Camera().position.at(0));
  CHECK(with({}, {64, 64}).camera.position.at(0) == scene::Camera().position.at(0));
}

TEST_CASE("an orbiting camera keeps all objects in view, tightly at some angle") {
  for (const bool round : {false, true})
    for (const float elevation : {-15.0F, 0.0F, 20.0F, 70.0F}) {
      CAPTURE(round);
      CAPTURE(elevation);
      const scene::Box box{{-1, 0.5F, -0.2F}, {2, 1.5F, 0.4F}, round};
      scene::Scene scene;
      scene.camera.orbit.emplace();
      scene.camera.orbit->elevation = elevation;
      scene.camera.orbit->turn = scene::Animated<float>({{0.0, 0.0F}, {4.0, 360.0F}}, scene::Ease::linear);
      scene::Object& object = scene.objects.emplace_back();
      object.parameters = std::make_unique<Boxed>(box);
      scene::frameObjects(scene, {{box}});
      float maximum = 0;
      for (int turn = 0; turn < 360; turn += 5) {
        scene.camera.orbit->turn = static_cast<float>(turn);
        const float reached = reach(scene, box);
        CHECK(reached <
              (round ? 1.75F : 0.93F));  // The corners of a box around a sphere are outside the sphere.
        maximum = std::max(maximum, reached);
      }
      CHECK(maximum > 0.85F);
    }
}
