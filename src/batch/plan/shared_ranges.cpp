#include "batch/plan/shared_ranges.hpp"

#include "scene/load.hpp"
#include "scene/override.hpp"
#include "sim/world/list.hpp"
#include "sim/world/survey.hpp"

#include <algorithm>
#include <utility>

namespace simreel::batch {

namespace {

scene::Scene sceneOf(const SweepPlan& plan, std::size_t job, const std::string& text) {
  return scene::parseScene(text, plan.sceneFile(), plan.overridesOf(job), sim::kinds(), plan.assets);
}

bool isLowEnd(const std::string& path) {
  return path.ends_with(".low") || path.ends_with(".colorFrom");
}

}  // namespace

bool hasAutoRanges(const SweepPlan& plan, const std::string& text) {
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    scene::Scene scene = sceneOf(plan, job, text);
    if (sim::needsRanges(scene)) return true;
  }
  return false;
}

std::vector<scene::Override> sharedRanges(const SweepPlan& plan, const std::string& text) {
  std::vector<std::pair<std::string, std::string>> ends;  // pairs of path and value, in the scene's order
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) {
    scene::Scene scene = sceneOf(plan, job, text);
    if (!sim::needsRanges(scene)) continue;
    for (const std::string& one : sim::setRanges(scene, sim::surveyMotion(scene, {}, 0).ranges)) {
      const std::size_t equals = one.find('=');
      const std::string path = one.substr(0, equals), value = one.substr(equals + 1);
      const auto known =
          std::find_if(ends.begin(), ends.end(), [&](const auto& end) { return end.first == path; });
      if (known == ends.end()) {
        ends.emplace_back(path, value);
        continue;
      }
      const bool wider = isLowEnd(path) ? std::stod(value) < std::stod(known->second)
                                        : std::stod(value) > std::stod(known->second);
      if (wider) known->second = value;
    }
  }
  std::vector<scene::Override> given;
  for (const auto& end : ends) {
    const std::string& path = end.first;
    if (std::none_of(plan.varied.begin(), plan.varied.end(), [&](const std::string& varied) {
          return path == varied || path.starts_with(varied + ".");
        }))
      given.push_back({path, end.second});
  }
  return given;
}

}  // namespace simreel::batch
