// simreel explain: lists every value of a scene that takes effect, and the value's origin.
#include "scene/texts/explain.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/wrap.hpp"
#include "cli/commands.hpp"
#include "cli/options/device_options.hpp"
#include "cli/options/scene_options.hpp"
#include "gl/context.hpp"
#include "scene/json/words.hpp"
#include "sim/world/list.hpp"
#include "sim/world/survey.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace simreel::cli {

namespace {

struct ExplainOptions {
  SceneOptions scene;
  std::string only;
  std::string format = "text";
  bool changed = false, quick = false;
  gl::ContextOptions on;
};

/// Returns lines with path, value and origin in columns. If a path or value is too wide, the columns after
/// it are shifted.
std::string explainedText(const std::vector<scene::ExplainedValue>& values) {
  constexpr std::size_t maxPath = 44, maxValue = 36;
  std::size_t path = 0, value = 0;
  for (const scene::ExplainedValue& one : values) {
    if (const std::size_t size = textColumns(one.path); size <= maxPath) path = std::max(path, size);
    if (const std::size_t size = textColumns(one.value); size <= maxValue) value = std::max(value, size);
  }
  std::string out;
  for (const scene::ExplainedValue& one : values) {
    const auto padded = [](const std::string& text, std::size_t width) {
      const std::size_t size = textColumns(text);
      return text + std::string(size < width ? width - size : 0, ' ');
    };
    out += padded(one.path, path) + "  " + padded(one.value, value) + "  " + one.origin + "\n";
  }
  return out;
}

std::string explainedJson(const std::vector<scene::ExplainedValue>& values) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const scene::ExplainedValue& one : values) {
    auto value = nlohmann::ordered_json::parse(one.value, nullptr, false);
    if (value.is_discarded()) value = nullptr;  // JSON has no value for "off".
    list.push_back({{"path", one.path}, {"value", value}, {"from", one.origin}});
  }
  return list.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void explain(const ExplainOptions& o) {
  scene::Scene scene = o.scene.load();
  for (const std::string& remark : scene.remarks) warnLinesOnce(remark);
  if (!o.quick && (sim::needsSurvey(scene) || sim::needsRanges(scene))) {
    const gl::Context context(o.on);
    const sim::MotionFraming framing = sim::frameMotion(scene);
    for (const std::string& remark : {framing.remark, framing.rangeRemark})
      if (!remark.empty()) info("{}", remark);
  }
  const std::vector<scene::Override> changes = o.scene.changes();
  auto values = scene::explainScene(scene, o.scene.file, changes, sim::kinds());
  std::erase_if(values, [&](const scene::ExplainedValue& one) {
    return !o.only.empty() && one.path != o.only && !one.path.starts_with(o.only + ".");
  });
  if (values.empty())
    fail(ExitCode::usage, "{} has no value {}; `simreel explain {}` prints all", o.scene.file,
         scene::inQuotes(o.only), o.scene.file);
  std::erase_if(values, [&](const scene::ExplainedValue& one) { return o.changed && one.standard; });
  printText(o.format == "json" ? explainedJson(values) : explainedText(values));
}

}  // namespace

void addExplain(CLI::App& app) {
  auto o = std::make_shared<ExplainOptions>();
  auto* command = app.add_subcommand(
      "explain", "Print every value of a scene as it will be used, and where it came from");
  o->scene.add(*command);
  command->add_option("path", o->only, "Only this part, for example camera or objects.flag.cloth");
  command->add_flag("--changed", o->changed, "Leave out the values that are plain defaults");
  command->add_flag(
      "--quick", o->quick,
      "Do not simulate the scene to find out where its camera will stand; no device is needed");
  command->add_option("--format", o->format, "text (the default) or json")
      ->check(CLI::IsMember({"text", "json"}));
  addDevice(*command, o->on);
  for (const char* name : {"--device", "--memory-path"})
    command->get_option(name)->excludes(command->get_option("--quick"));
  command->callback([o] { explain(*o); });
}

}  // namespace simreel::cli
