#pragma once
#include "frame/image.hpp"

#include <filesystem>
#include <string>

namespace simreel::golden {

/// At most so many pixels wide and high: means of whole blocks of pixels.
[[nodiscard]] frame::Image thumbnail(const frame::Image& image, int side);
/// "data:image/png;base64,...": a small copy of a picture's file; empty where that cannot be read.
[[nodiscard]] std::string dataAddress(const std::filesystem::path& picture, int side);
/// A path as part of an address: "a%20b/c.png".
[[nodiscard]] std::string addressOf(const std::string& path);

}  // namespace simreel::golden
