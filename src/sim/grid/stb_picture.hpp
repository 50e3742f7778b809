#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

// Wrapper of stb_image, the fallback decoder for PNG, JPEG, BMP and PNM files of all kinds. Limits each
// allocation to the size of the declared pixels, so that a small compressed file cannot expand to
// gigabytes.

/// Returns width and height from the header. The height of a BMP is negative if its rows start at the top.
/// Returns nothing on errors (see stbReason()).
[[nodiscard]] std::optional<glm::ivec2> stbSize(std::string_view bytes);
/// Returns true if the file has 16 bits per channel.
[[nodiscard]] bool stbIsDeep(std::string_view bytes);

/// Decodes the pixels of a file whose image has the given size. `Value` is std::uint8_t for 8 or
/// std::uint16_t for 16 bits per channel; there are 1 (grey) or 4 (RGBA) channels. Returns nothing on
/// errors (see stbReason()).
template <class Value>
[[nodiscard]] std::optional<std::vector<Value>> stbDecode(std::string_view bytes, glm::ivec2 size,
                                                          int channels = 4);

/// Returns the reason why the last image on this thread could not be decoded.
[[nodiscard]] std::string stbReason();
/// Returns true if decoding failed because the file has more pixels than the given size.
[[nodiscard]] bool stbFoundMore();

}  // namespace simreel::sim
