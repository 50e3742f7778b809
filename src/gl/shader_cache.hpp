#pragma once

namespace simreel::gl {

/// True if Mesa stores compiled shaders on disk: the environment does not disable the cache, and the cache
/// folder is writable.
[[nodiscard]] bool shaderCacheKept();

}  // namespace simreel::gl
