#pragma once
#include "base/strict_json.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::batch {

// What the plans of sweeps and of pieces have in common.

using PlanJson = nlohmann::ordered_json;

[[nodiscard]] PlanJson overrideList(const std::vector<scene::Override>& overrides);
[[nodiscard]] PlanJson folderList(const std::vector<std::filesystem::path>& folders);
/// Throws JsonError.
[[nodiscard]] std::vector<scene::Override> overridesIn(const JsonValue& list);
[[nodiscard]] std::vector<std::filesystem::path> foldersIn(const JsonValue& list);
/// On one line.
[[nodiscard]] std::string lineOf(const PlanJson& value);
/// The members of an object, ready for more.
[[nodiscard]] std::string openObject(const PlanJson& members);
/// Reads a plan's file; `what` it is called. Throws UserError(usage) where it is not there.
[[nodiscard]] std::string readPlan(const std::filesystem::path& file, const char* what);
/// Throws JsonError where the object is of another format or version.
void expectFormat(const JsonValue& object, const char* format, int version);

}  // namespace simreel::batch
