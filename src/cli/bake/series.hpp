#pragma once
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace simreel::cli {

/// Writes OUTPUT/NAME.csv for each object that measures quantities (`simreel list KIND`), or only for
/// `object`. The columns are frame, time (s) and each quantity. There is one row for each of `frames`.
/// Numbers are written so that they read back as the same doubles. After an interrupt, the tables contain
/// all frames so far. Throws UserError.
void bakeSeries(const scene::Scene& scene, sim::World& world, const std::filesystem::path& output,
                const std::string& object, std::span<const int> frames, bool overwrite);

}  // namespace simreel::cli
