#pragma once
#include "frame/image.hpp"

#include <string>

namespace simreel::serve {

/// Returns a JPEG file of a picture without its alpha channel. It is used for drafts, which need not be
/// exact. `quality` is 1 to 100. Colour has half the resolution of brightness. Throws
/// UserError(inputOutput).
[[nodiscard]] std::string encodeJpeg(const frame::Image& image, int quality);

}  // namespace simreel::serve
