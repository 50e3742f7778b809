#pragma once
#include "kernels/request.hpp"
#include "kernels/shader/shader.hpp"

#include <optional>

namespace simreel::kernels {

/// Returns the cached result of an equal request, if the files have not changed since. The cache is in the
/// user's folder $XDG_CACHE_HOME/simreel or ~/.cache/simreel. Returns nullopt if there is no such entry or
/// if $SIMREEL_GLSL is set.
[[nodiscard]] std::optional<Shader> cachedShader(const Request& request);
/// Stores a shader in the cache. A folder without write permission is not an error. If the cache exceeds 64
/// MiB, the oldest entries are deleted.
void keepShader(const Request& request, const Shader& shader);

}  // namespace simreel::kernels
