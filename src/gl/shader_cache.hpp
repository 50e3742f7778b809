#pragma once

namespace simreel::gl {

/// True if Mesa stores compiled shaders on disk. This requires that the environment does not disable the
/// cache and that the cache folder is writable.
[[nodiscard]] bool shaderCacheKept();

}  // namespace simreel::gl
