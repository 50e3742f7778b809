#pragma once
#include "base/strict_json.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::batch {

// Functions that the plans of sweeps and the plans of pieces use.

using PlanJson = nlohmann::ordered_json;

[[nodiscard]] PlanJson overrideList(const std::vector<scene::Override>& overrides);
[[nodiscard]] PlanJson folderList(const std::vector<std::filesystem::path>& folders);
/// These functions read lists from a plan. They throw JsonError if an item has the wrong form.
[[nodiscard]] std::vector<scene::Override> overridesIn(const JsonValue& list);
[[nodiscard]] std::vector<std::filesystem::path> foldersIn(const JsonValue& list);
/// Returns the value as JSON on one line.
[[nodiscard]] std::string lineOf(const PlanJson& value);
/// Returns an object as JSON without the closing brace, so that more members can be appended.
[[nodiscard]] std::string openObject(const PlanJson& members);
/// Reads the file of a plan. `what`: name of the plan in messages. Throws UserError(usage) if the file does
/// not exist.
[[nodiscard]] std::string readPlan(const std::filesystem::path& file, const char* what);
/// Throws JsonError if the object has another format or version.
void expectFormat(const JsonValue& object, const char* format, int version);

}  // namespace simreel::batch
