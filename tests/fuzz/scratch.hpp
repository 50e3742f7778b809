#pragma once
#include "base/error.hpp"

#include <filesystem>
#include <string>
#include <system_error>
#include <unistd.h>

namespace simreel::fuzz {

/// Returns a folder in memory for readers that need a path. It is removed when the process ends.
inline const std::filesystem::path& scratchFolder() {
  struct Folder {
    std::filesystem::path path;
    Folder() {
      std::string name = "/dev/shm/simreel_fuzz_XXXXXX";
      SIMREEL_CHECK(::mkdtemp(name.data()) != nullptr);
      path = name;
    }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path;
}

}  // namespace simreel::fuzz
