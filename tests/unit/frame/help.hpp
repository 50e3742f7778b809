#pragma once
#include "base/error.hpp"
#include "base/file.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"

#include <cstdint>
#include <filesystem>
#include <stdlib.h>
#include <string>
#include <vector>

#include <doctest/doctest.h>

namespace simreel::frame::test {

/// A temporary, empty folder. The destructor removes it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "simreel-test-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  [[nodiscard]] std::string string() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// Returns an opaque picture of smooth colours with some texture. It is different for each seed.
inline Image picture(int width, int height, int seed = 0) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int weave = (x * 7 + y * 13 + seed * 31) % 11 < 2 ? 25 : 0;
      for (const int value : {x * 2 + y / 3 + seed, y * 3 + weave, (x + y) / 2 + 40 + weave, 255})
        image.bytes.push_back(static_cast<std::uint8_t>(value));
    }
  return image;
}

inline RunInfo runInfo(int width = 32, int height = 18) {
  return {"Test", "scenehash", 7, width, height, 30, "exact", "fingerprint", "llvmpipe 1"};
}

inline FrameInfo frameInfo(int frame) {
  return {frame, fmt::format("state{}", frame)};
}

/// Returns the code and message of the UserError that `action` throws.
template <class Action>
std::pair<ExitCode, std::string> errorOf(const Action& action) {
  try {
    action();
  } catch (const UserError& error) {
    return {error.code(), error.what()};
  }
  return {ExitCode::ok, "no error"};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace simreel::frame::test
