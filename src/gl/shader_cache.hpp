#pragma once

namespace simreel::gl {

/// True if Mesa keeps compiled shaders on disk: the environment does not switch it off, and the folder can
/// be written to.
[[nodiscard]] bool shaderCacheKept();

}  // namespace simreel::gl
