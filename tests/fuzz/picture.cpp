// Fuzzes the readers of images: PNG, PNM and any other format that the bytes declare.
#include "base/error.hpp"
#include "fuzz/reader.hpp"
#include "sim/grid/picture_file.hpp"

namespace simreel::fuzz {
namespace {

void readPicture(std::string_view bytes) {
  constexpr int maxSide = 16384;
  const sim::Picture picture = sim::decodePicture(bytes, "fuzz.png", "texture", maxSide);
  SIMREEL_CHECK(picture.size.x >= 1 && picture.size.x <= maxSide && picture.size.y >= 1 &&
                picture.size.y <= maxSide);
  SIMREEL_CHECK_EQ(picture.rgba.size(),
                   4 * static_cast<std::size_t>(picture.size.x) * static_cast<std::size_t>(picture.size.y));
}

const Reader pictureReader("picture", readPicture);

}  // namespace
}  // namespace simreel::fuzz
