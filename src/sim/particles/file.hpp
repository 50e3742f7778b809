#pragma once
#include "sim/particles/plan.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Reads particles from a CSV or PLY file.
/// - CSV: the first line names the columns x,y,z and optionally vx,vy,vz and mass; lines that start with #
///   are comments.
/// - PLY: properties with the same names in the element "vertex".
///
/// Without a mass column, each particle gets an equal part of `totalMass` (kg). Unknown columns and
/// properties are reported once. Throws UserError with the file, the line or vertex, and the problem:
/// inputOutput for a file without particles, a malformed number, NaN, infinity or a mass that is not
/// positive; usage for more than `maxParticles` particles.
[[nodiscard]] ParticleCloud readParticles(const std::filesystem::path& file, float totalMass,
                                          int maxParticles);
/// Parses particles from the bytes of a file like readParticles(). `name` is the file's name in messages.
[[nodiscard]] ParticleCloud parseParticles(std::string_view text, const std::string& name, float totalMass,
                                           int maxParticles);

}  // namespace simreel::sim
