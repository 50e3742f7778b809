#pragma once
#include "frame/image.hpp"

#include <string>

namespace simreel::serve {

/// Returns a JPEG file (quality 1 to 100, colour at half resolution) of a picture without its alpha, for
/// drafts, which need not be exact. Throws UserError(inputOutput).
[[nodiscard]] std::string encodeJpeg(const frame::Image& image, int quality);

}  // namespace simreel::serve
