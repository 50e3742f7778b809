#pragma once
#include "frame/image.hpp"
#include "unit/help.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// A temporary PNG file with sRGB colours and alpha. The destructor deletes it.
class ImageFile {
 public:
  ImageFile(int width, int height, const std::vector<std::uint8_t>& rgba)
      : file_("texture.png", encoded({width, height, rgba})) {}
  [[nodiscard]] std::string path() const { return file_.path(); }

 private:
  static std::string encoded(const simreel::frame::Image& image) {
    const auto png = simreel::frame::encodePng(image, {});
    return {reinterpret_cast<const char*>(png.data()), png.size()};
  }
  simreel::test::TemporaryFile file_;
};
