#pragma once

namespace simreel::draw {

/// Who draws. driver: the driver's own rasterizer. exact: kernels in exact arithmetic, the same bits on
/// every machine.
enum class Rasterizer { driver, exact };

}  // namespace simreel::draw
