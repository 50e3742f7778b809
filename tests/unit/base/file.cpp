#include "base/file.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("files: memory below /dev/shm is a disk, what is written there takes the place of what was") {
  if (::access("/dev/shm", W_OK) != 0) return;
  std::string folder = "/dev/shm/simreel-test-XXXXXX";
  REQUIRE(::mkdtemp(folder.data()) != nullptr);
  const std::filesystem::path file = folder + "/a";
  writeFileAtomically(file, std::string_view("first"));
  writeFileAtomically(file, std::string_view("second"));
  CHECK(readFile(file, "text") == "second");
  std::filesystem::remove_all(folder);
}
