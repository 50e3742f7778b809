#include "sim/life/life_scene.hpp"

#include "sim/life/cell_pattern.hpp"

#include <nlohmann/json.hpp>

namespace simreel::sim {

std::string sceneAroundPattern(const std::filesystem::path& file) {
  if (!isPatternName(file)) return {};
  const CellPattern pattern = readPattern(file);
  using Json = nlohmann::ordered_json;
  const std::string name = file.filename().string();
  Json life = {{"patterns", {{{"file", name}}}}, {"stepsPerSecond", 15}, {"trail", 45}};
  if (!pattern.ruleName.empty() || pattern.rule.value_or(CellRule()).states > 2) life["trail"] = 0;
  // The rule is always written, so that users can edit it. If it is empty, the rule that the pattern's file
  // names is used.
  life["rule"] = pattern.ruleName.empty() ? pattern.rule.value_or(CellRule()).text() : "";
  // On a torus, gliders would return and hit the pattern that emitted them.
  if (!pattern.shape) life["border"] = "dead";
  const auto color = [](double r, double g, double b) { return Json{{"color", {r, g, b}}}; };
  life["display"] = {
      {"layer", "behind"},
      {"border", {0.004, 0.006, 0.016}},
      {"stops",
       {color(0.004, 0.006, 0.016), color(0.016, 0.014, 0.070), color(0.100, 0.018, 0.140),
        color(0.360, 0.050, 0.100), color(0.600, 0.190, 0.050), color(2.600, 1.900, 0.900)}}};
  const Json scene = {
      {"version", 2},
      {"title", name},
      {"render",
       {{"exposure", 0.2}, {"bloom", {{"strength", 0.25}, {"threshold", 0.8}, {"radius", 0.05}}}}},
      {"time", {{"fps", 30}, {"duration", 10}}},
      {"objects", {{"cells", {{"life", life}}}}}};
  return scene.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace simreel::sim
