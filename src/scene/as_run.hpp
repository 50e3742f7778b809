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

/// Does the same as sceneAsRun() for scene text; messages call the text `name`.
[[nodiscard]] std::string textAsRun(std::string_view text, const std::filesystem::path& name,
                                    std::span<const Override> overrides);

/// Returns a hash of everything in the scene text `asRun` that simulation states can depend on. Members
/// that only affect lighting, drawing, the title, the length or tests are left out. Scenes with equal
/// hashes have equal states at equal frames, if the files that they name are equal too.
[[nodiscard]] std::string simulationHash(std::string_view asRun);

/// True if changing the value at this path may change simulationHash().
[[nodiscard]] bool touchesSimulation(std::string_view path);

}  // namespace simreel::scene
