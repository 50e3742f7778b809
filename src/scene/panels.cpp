#include "scene/panels.hpp"

#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::scene {

namespace {

/// Returns the unit vector from the target to the camera. From above, the vector is tilted a little, so
/// that "up" in the picture is defined.
glm::vec3 sideOf(Panel::View view) {
  switch (view) {
    case Panel::View::back:
      return {0, 0, -1};
    case Panel::View::left:
      return {-1, 0, 0};
    case Panel::View::right:
      return {1, 0, 0};
    case Panel::View::top:
      return glm::normalize(glm::vec3(0, 1, 1e-3F));
    default:
      return {0, 0, 1};
  }
}

}  // namespace

PanelGrid panelGrid(glm::ivec2 picture, std::size_t panels) {
  const int count = std::max(static_cast<int>(panels), 1);
  constexpr int gaps = 240;  // gaps in the smaller side of a picture
  PanelGrid best;
  for (int columns = 1; columns <= count; ++columns) {
    PanelGrid grid{columns, count > 1 ? std::max(std::min(picture.x, picture.y) / gaps, 1) : 0, {}};
    const glm::ivec2 cells(columns, (count + columns - 1) / columns);
    grid.cell = glm::max((picture - grid.gap * (cells - 1)) / cells, glm::ivec2(1));
    if (std::min(grid.cell.x, grid.cell.y) > std::min(best.cell.x, best.cell.y)) best = grid;
  }
  return best;
}

glm::ivec2 viewSize(const Scene& scene) {
  return scene.panels.empty() ? scene.render.size : panelGrid(scene.render.size, scene.panels.size()).cell;
}

Camera cameraOf(const Panel& panel, const Camera& camera) {
  if (panel.camera) return *panel.camera;
  if (panel.view == Panel::View::camera) return camera;
  Camera side = camera;
  const glm::vec3 target = camera.target.at(0);
  const float distance =
      camera.orbit ? camera.orbit->distance.at(0) : glm::distance(camera.position.at(0), target);
  // Another side may be wider than the one that the camera shows.
  constexpr float farther = 1.35F;
  side.position = target + farther * distance * sideOf(panel.view);
  side.height = farther * camera.height.at(0);
  side.target = target;
  side.roll = 0.0F;
  side.damping = 0;
  side.orbit.reset();
  side.follow.reset();
  side.track.reset();
  side.gltf.reset();
  return side;
}

void checkShown(const Node& root, const Scene& scene, Diagnostics& diagnostics) {
  const Node* panels = root.find("panels");
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  for (const Panel& panel : scene.panels) {
    const Node* own = panels == nullptr ? nullptr : panels->find(panel.name);
    constexpr std::size_t maximum = 64;  // bytes that LabelWords draws
    if (const std::size_t length = panel.caption.size(); length > maximum && own != nullptr)
      diagnostics.add(own->headPlace(),
                      fmt::format("the caption has {} bytes; at most {} fit", length, maximum));
    const Node* list = own == nullptr ? nullptr : own->find("objects");
    for (std::size_t i = 0; list != nullptr && i < panel.objects.size() && i < list->children.size(); ++i)
      if (const std::string& shown = panel.objects[i].name;
          std::find(names.begin(), names.end(), shown) == names.end())
        diagnostics.add(list->children[i].place(), fmt::format("no object is named {}; {}", inQuotes(shown),
                                                               suggestion(shown, names)));
  }
}

}  // namespace simreel::scene
