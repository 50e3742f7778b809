#pragma once
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace simreel::cli {

/// Writes OUTPUT/NAME.csv for each object that measures quantities (`simreel list KIND`), or for `object`
/// alone: the columns frame, time (s) and each quantity, one row for each of `frames`. Numbers read back as
/// the same doubles. An interrupt leaves whole tables of the frames so far. Throws UserError.
void bakeSeries(const scene::Scene& scene, sim::World& world, const std::filesystem::path& output,
                const std::string& object, std::span<const int> frames, bool overwrite);

}  // namespace simreel::cli
