#include "serve/play/jpeg.hpp"

#include "base/error.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <jpeglib.h>

namespace simreel::serve {

namespace {

[[noreturn]] void giveUpJpeg(j_common_ptr coder) {
  std::array<char, JMSG_LENGTH_MAX> text{};
  coder->err->format_message(coder, text.data());
  fail(ExitCode::inputOutput, "a picture cannot be made a JPEG file: {}", text.data());
}

/// Owns the JPEG encoder and the memory that it writes to.
struct Coder {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  unsigned char* file = nullptr;
  unsigned long bytes = 0;

  Coder() {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = giveUpJpeg;
    jpeg_create_compress(&jpeg);
    jpeg_mem_dest(&jpeg, &file, &bytes);
  }
  ~Coder() {
    jpeg_destroy_compress(&jpeg);
    std::free(file);
  }
  Coder(const Coder&) = delete;
  Coder& operator=(const Coder&) = delete;
};

}  // namespace

std::string encodeJpeg(const frame::Image& image, int quality) {
  Coder coder;
  coder.jpeg.image_width = static_cast<JDIMENSION>(image.width);
  coder.jpeg.image_height = static_cast<JDIMENSION>(image.height);
  coder.jpeg.input_components = 4;
  coder.jpeg.in_color_space = JCS_EXT_RGBX;
  jpeg_set_defaults(&coder.jpeg);
  jpeg_set_quality(&coder.jpeg, quality, TRUE);
  coder.jpeg.dct_method = JDCT_IFAST;
  jpeg_start_compress(&coder.jpeg, TRUE);
  const std::size_t stride = std::size_t{4} * static_cast<std::size_t>(image.width);
  while (coder.jpeg.next_scanline < coder.jpeg.image_height) {
    // The library's interface takes rows as non-const pointers but only reads them.
    auto* row = const_cast<JSAMPROW>(image.bytes.data() + stride * coder.jpeg.next_scanline);
    jpeg_write_scanlines(&coder.jpeg, &row, 1);
  }
  jpeg_finish_compress(&coder.jpeg);
  return {reinterpret_cast<const char*>(coder.file), coder.bytes};
}

}  // namespace simreel::serve
