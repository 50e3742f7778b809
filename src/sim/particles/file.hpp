#pragma once
#include "sim/particles/plan.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Particles of a CSV file (first line names the columns: x,y,z, then any of vx,vy,vz and mass) or a PLY
/// file (properties of its element "vertex" by the same names). Lines of a CSV
/// that start with # are comments. Without a mass column the particles share `totalMass` (kg) equally.
/// Throws UserError with file, line or vertex, and what is wrong: inputOutput for no particles, a malformed
/// number, NaN or infinity, a mass that is not positive; usage for more than `maxParticles`. Columns and
/// properties of other names are told once.
[[nodiscard]] ParticleCloud readParticles(const std::filesystem::path& file, float totalMass,
                                          int maxParticles);
/// The same from the file's bytes; `name` is what messages call it.
[[nodiscard]] ParticleCloud parseParticles(std::string_view text, const std::string& name, float totalMass,
                                           int maxParticles);

}  // namespace simreel::sim
