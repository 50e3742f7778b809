#include "batch/plan/shared_camera.hpp"

#include "scene/framing.hpp"
#include "scene/load.hpp"
#include "scene/outline.hpp"
#include "scene/override.hpp"
#include "sim/world/list.hpp"
#include "sim/world/survey.hpp"

#include <algorithm>
#include <string_view>

namespace simreel::batch {

namespace {

bool changesView(const std::string& path) {
  constexpr std::string_view camera = "camera";
  return path == camera || path.starts_with("camera.") || path == "render" || path == "render.size";
}

/// Extends each extent in `all` to contain the extent of the same object in `more`, the extents in another
/// job.
void merge(std::vector<scene::Framed>& all, const std::vector<scene::Framed>& more) {
  for (std::size_t i = 0; i < more.size(); ++i) {
    if (i == all.size()) {
      all.push_back(more[i]);
      continue;
    }
    all[i].box.round = all[i].box.round && more[i].box.round;
    all[i].box.min = glm::min(all[i].box.min, more[i].box.min);
    all[i].box.max = glm::max(all[i].box.max, more[i].box.max);
    all[i].points.insert(all[i].points.end(), more[i].points.begin(), more[i].points.end());
    if (!all[i].points.empty()) all[i].points = scene::outermost(all[i].points);
  }
}

}  // namespace

std::vector<scene::Override> sharedCamera(const SweepPlan& plan, const std::string& text) {
  if (plan.jobs.size() < 2 || std::any_of(plan.varied.begin(), plan.varied.end(), changesView)) return {};
  const auto sceneOf = [&](std::size_t job) {
    return scene::parseScene(text, plan.sceneFile(), plan.overridesOf(job), sim::kinds(), plan.assets);
  };
  scene::Scene first = sceneOf(0);
  if (first.camera.placed || sim::needsSurvey(first)) return {};
  std::vector<scene::Framed> framed = scene::framedObjects(first);
  for (std::size_t job = 1; job < plan.jobs.size(); ++job) {
    const scene::Scene other = sceneOf(job);
    if (other.camera.placed || sim::needsSurvey(other)) return {};
    merge(framed, scene::framedObjects(other));
  }
  if (framed.empty()) return {};
  scene::frameObjects(first, framed);
  std::vector<scene::Override> camera;
  for (const std::string& one : sim::cameraOverrides(first.camera, scene::Camera()))
    camera.push_back(scene::parseOverride(one));
  return camera;
}

}  // namespace simreel::batch
