#include "base/error.hpp"
#include "sim/cloth/parameters.hpp"
#include "sim/core/collider.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

std::optional<scene::Box> ClothParameters::framedMesh() const {
  std::optional<scene::Box> box;
  try {
    const glm::mat4 turn = rotationMatrix(rotation);
    for (const glm::vec3& at : mesh->make().positions)
      scene::include(box, position + glm::vec3(turn * glm::vec4(at, 0)));
  } catch (const UserError&) {
    return std::nullopt;  // The constructor of the simulation reports this error.
  }
  if (!box) return box;
  const glm::vec3 extent = box->max - box->min;
  const float width = std::max(extent.x, extent.z);
  // If the cloth has no pins, it falls to the ground. Otherwise, it sags at most by its width.
  const float falls = box->min.y > 0 ? 0.0F : box->min.y - width;
  box->min.y = std::min(box->min.y, pins.empty() ? falls : box->max.y - width);
  return box;
}

std::optional<scene::Box> ClothParameters::framed() const {
  if (mesh) return framedMesh();
  const glm::mat4 turn = rotationMatrix(rotation);
  const glm::vec2 half = 0.5F * glm::vec2(size - 1);
  const auto restAt = [&](glm::ivec2 at) {
    const glm::vec2 from = spacing * (glm::vec2(at) - half);
    return position + glm::vec3(turn * glm::vec4(from.x, 0, from.y, 0));
  };
  const glm::ivec2 last = size - 1;
  const glm::ivec2 corners[] = {{0, 0}, {last.x, 0}, {0, last.y}, last};
  scene::Box box{position, position};
  const auto include = [&](const glm::vec3& point) {
    box = {glm::min(box.min, point), glm::max(box.max, point)};
  };
  for (const glm::ivec2 corner : corners) include(restAt(corner));
  std::set<int> pinned;
  for (const PinGroup& group : pins)
    for (const int i : pinnedBy(group)) pinned.insert(i);
  const float width = spacing * static_cast<float>(std::max(last.x, last.y));
  if (pinned.empty()) include({position.x, position.y > 0 ? 0.0F : box.min.y - width, position.z});
  float hanging = 0;  // distance in metres by which the corner farthest from all pins can sag
  for (const glm::ivec2 corner : corners) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const int i : pinned)
      nearest = std::min(nearest, glm::length(glm::vec2(corner - glm::ivec2(i % size.x, i / size.x))));
    if (!pinned.empty()) hanging = std::max(hanging, spacing * nearest);
  }
  for (const int i : pinned) include(restAt({i % size.x, i / size.x}) - glm::vec3(0, hanging, 0));
  return box;
}

}  // namespace simreel::sim
