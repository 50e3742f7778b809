#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

// stb_image, which decodes what no decoder of this program does: any PNG, JPEG, BMP and PNM. It gets no
// more memory at once than the promised pixels take, so that a few compressed bytes never become gigabytes.

/// Width and height as a header gives them; a BMP's height is negative where its rows go from the top.
/// Nothing where stbReason() says why.
[[nodiscard]] std::optional<glm::ivec2> stbSize(std::string_view bytes);
/// True if the file has 16 bits per channel.
[[nodiscard]] bool stbIsDeep(std::string_view bytes);

/// The pixels of a file of such a size: 8 or 16 bits a channel (std::uint8_t, std::uint16_t), and 1 (grey)
/// or 4 (RGBA) channels. Nothing where stbReason() says why.
template <class Value>
[[nodiscard]] std::optional<std::vector<Value>> stbDecode(std::string_view bytes, glm::ivec2 size,
                                                          int channels = 4);

/// Why this thread's last picture was not decoded.
[[nodiscard]] std::string stbReason();
/// True if it failed because the file has more pixels than the given size.
[[nodiscard]] bool stbFoundMore();

}  // namespace simreel::sim
