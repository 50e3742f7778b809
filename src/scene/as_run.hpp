#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace simreel::scene {

/// Returns the scene with its overrides applied, as plain JSON. Rendering this text without overrides gives
/// the same result. Throws UserError(usage) if the text or an override cannot be parsed. Does not validate
/// the values.
[[nodiscard]] std::string sceneAsRun(const std::filesystem::path& file, std::span<const Override> overrides,
                                     const Kinds& kinds);

/// Does the same as sceneAsRun() for scene text. Messages use `name` as the name of the text.
[[nodiscard]] std::string textAsRun(std::string_view text, const std::filesystem::path& name,
                                    std::span<const Override> overrides);

/// Returns a hash of all members of the scene text `asRun` that simulation states can depend on. Leaves out
/// the title, the length, the tests and members that only affect lighting or drawing. Scenes with equal
/// hashes have equal states at equal frames if the files that they name are also equal.
[[nodiscard]] std::string simulationHash(std::string_view asRun);

/// True if changing the value at this path may change simulationHash().
[[nodiscard]] bool touchesSimulation(std::string_view path);

}  // namespace simreel::scene
