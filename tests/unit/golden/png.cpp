// Tests the detection of files with equal pixels without decoding them. tests/cli/golden/test_diff.py tests
// rejected files.
#include "golden/files/png_check.hpp"
#include "unit/frame/help.hpp"

#include <span>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;
using frame::test::contains;
using frame::test::errorOf;
using frame::test::picture;

namespace {

bool same(const std::vector<std::byte>& a, const std::vector<std::byte>& b) {
  return golden::sameEncodedPixels(a, b);
}

}  // namespace

TEST_CASE("PNG files that differ only in text chunks have equal pixels") {
  const auto plain = frame::encodePng(picture(30, 20), {});
  const auto text =
      frame::encodePng(picture(30, 20), {{"Software", "simreel"}, {"Title", "a flag \xe2\x9a\x91"}});
  const auto other = frame::encodePng(picture(30, 20, 1), {});
  REQUIRE(plain != text);
  CHECK(same(plain, plain));
  CHECK(same(plain, text));
  CHECK(same(text, plain));
  CHECK_FALSE(same(plain, other));
  CHECK_FALSE(same(plain, frame::encodePng(picture(20, 30), {})));
  auto cut = plain;
  cut.resize(cut.size() - 12);  // removes the end chunk
  CHECK_FALSE(same(plain, cut));
  CHECK_FALSE(same(cut, plain));
  CHECK_FALSE(same(plain, {}));
}

TEST_CASE("a written PNG is read back, and any flipped bit is detected") {
  const frame::test::TemporaryFolder folder;
  const auto image = picture(13, 7);
  const auto file = frame::encodePng(image, {{"Software", "simreel"}});
  writeFileAtomically(folder / "a.png", file);
  CHECK(golden::readPng(folder / "a.png", "baseline").bytes == image.bytes);
  for (std::size_t i = 0; i < file.size(); ++i) {
    auto bad = file;
    bad[i] ^= std::byte{1};
    const auto [code, message] = errorOf([&] { golden::checkPng(bad, "baseline", "a.png"); });
    CHECK_MESSAGE(code == ExitCode::inputOutput, "byte ", i);
    CHECK(message.starts_with("baseline a.png is "));
  }
  for (std::size_t size = 0; size < file.size(); ++size)
    CHECK(errorOf([&] { golden::checkPng(std::span(file).first(size), "baseline", "a"); }).first ==
          ExitCode::inputOutput);
  const auto [code, message] =
      errorOf([&] { static_cast<void>(golden::readPng(folder / "b.png", "baseline")); });
  CHECK(code == ExitCode::inputOutput);
  CHECK(contains(message, "baseline"));
  CHECK(contains(message, "b.png"));
}
