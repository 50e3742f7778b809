#pragma once
#include "kernels/request.hpp"
#include "kernels/shader/shader.hpp"

#include <optional>

namespace simreel::kernels {

/// Returns what this program has made of the same request and files before, from the user's cache folder
/// ($XDG_CACHE_HOME/simreel, else ~/.cache/simreel); nothing if there is no such entry, or $SIMREEL_GLSL is
/// set.
[[nodiscard]] std::optional<Shader> cachedShader(const Request& request);
/// Keeps it for the next run. A folder that cannot be written is no mistake. Of more than 64 MiB the oldest
/// entries go.
void keepShader(const Request& request, const Shader& shader);

}  // namespace simreel::kernels
