#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace simreel::scene {

/// The scene with its overrides applied, as plain JSON: without them it renders the same. Throws
/// UserError(usage) where the text or an override cannot be read; what they mean is not looked at.
[[nodiscard]] std::string sceneAsRun(const std::filesystem::path& file, std::span<const Override> overrides,
                                     const Kinds& kinds);

/// The same from text; `name` names it in messages.
[[nodiscard]] std::string textAsRun(std::string_view text, const std::filesystem::path& name,
                                    std::span<const Override> overrides);

/// Hash of all in such a text that the states of its simulations may depend on, and of nothing that only
/// lights, draws, names, ends or tests them. Scenes of one hash are in the same state at the same frame, as
/// long as the files that they name are the same.
[[nodiscard]] std::string simulationHash(std::string_view asRun);

/// Whether that hash may change with the value of this path.
[[nodiscard]] bool touchesSimulation(std::string_view path);

}  // namespace simreel::scene
