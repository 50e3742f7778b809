#pragma once
#include "frame/image.hpp"

#include <filesystem>
#include <string>

namespace simreel::golden {

/// Shrinks a picture to at most `side` pixels in width and height by averaging blocks of pixels.
[[nodiscard]] frame::Image thumbnail(const frame::Image& image, int side);
/// Returns a small copy of a picture as "data:image/png;base64,...", or an empty text if the file cannot be
/// read.
[[nodiscard]] std::string dataAddress(const std::filesystem::path& picture, int side);
/// Percent-encodes a path for a URL: "a%20b/c.png".
[[nodiscard]] std::string addressOf(const std::string& path);

}  // namespace simreel::golden
