#include "base/file.hpp"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("files: writing to /dev/shm replaces the file, like on any disk") {
  if (::access("/dev/shm", W_OK) != 0) return;
  std::string folder = "/dev/shm/simreel-test-XXXXXX";
  REQUIRE(::mkdtemp(folder.data()) != nullptr);
  const std::filesystem::path file = folder + "/a";
  writeFileAtomically(file, std::string_view("first"));
  writeFileAtomically(file, std::string_view("second"));
  CHECK(readFile(file, "text") == "second");
  std::filesystem::remove_all(folder);
}

TEST_CASE("files: writing through a /proc/self/fd link writes into the open file instead of replacing it") {
  std::string folder = (std::filesystem::temp_directory_path() / "simreel-test-XXXXXX").string();
  REQUIRE(::mkdtemp(folder.data()) != nullptr);
  const std::filesystem::path file = folder + "/a", other = folder + "/b";
  writeFileAtomically(file, std::string_view(""));
  std::filesystem::create_hard_link(file, other);  // The file keeps its inode unless it is replaced.
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  REQUIRE(descriptor >= 0);
  writeFileAtomically("/proc/self/fd/" + std::to_string(descriptor), std::string_view("told"));
  ::close(descriptor);
  CHECK(readFile(other, "text") == "told");
  writeFileAtomically(file, std::string_view("new"));
  CHECK(readFile(other, "text") == "told");
  std::filesystem::remove_all(folder);
}

TEST_CASE("files: two concurrent writers of one file each write it completely") {
  std::string folder = (std::filesystem::temp_directory_path() / "simreel-test-XXXXXX").string();
  REQUIRE(::mkdtemp(folder.data()) != nullptr);
  const std::filesystem::path file = folder + "/a";
  const auto bytes = [](std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
  };
  writeFileAtomically(file.string() + ".part", std::string_view("left by one that was killed"));
  {
    PartFile first(file), second(file);
    first.append(bytes("first"));
    second.append(bytes("second one"));
    CHECK_NOTHROW(checkWritable(file));  // The check must not remove the part file of another writer.
    first.finish();
    CHECK(readFile(file, "text") == "first");
    PartFile third(file);
    third.append(bytes("3"));
    second.finish();
    CHECK(readFile(file, "text") == "second one");
    third.finish();
    CHECK(readFile(file, "text") == "3");
    const PartFile dropped(file);
  }
  std::size_t left = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    left += entry.is_regular_file() ? 1 : 0;
  CHECK(left == 1);
  std::filesystem::remove_all(folder);
}

TEST_CASE("files: a link in /dev/shm is treated like a link on any disk") {
  if (::access("/dev/shm", W_OK) != 0) return;
  std::vector<std::string> left;
  for (const std::string& disk :
       {std::filesystem::temp_directory_path().string(), std::string("/dev/shm")}) {
    std::string folder = disk + "/simreel-test-XXXXXX";
    REQUIRE(::mkdtemp(folder.data()) != nullptr);
    const std::filesystem::path file = folder + "/a", link = folder + "/link", other = folder + "/b";
    writeFileAtomically(file, std::string_view("first, and longer"));
    std::filesystem::create_hard_link(file, other);
    std::filesystem::create_symlink(file, link);
    writeFileAtomically(link, std::string_view("second"));
    left.push_back(readFile(link, "text") + "|" + readFile(file, "text") + "|" + readFile(other, "text"));
    std::filesystem::remove_all(folder);
  }
  CHECK(left[0] == left[1]);
}
