// Tests that a separate thread copies pictures.
#include "draw/screen/copy_thread.hpp"

#include <array>
#include <numeric>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("copies: each copy task receives its own bytes, in any order of waiting") {
  std::array<std::vector<std::uint8_t>, 3> pictures;
  std::array<draw::CopyThread::Task, 3> tasks;
  draw::CopyThread thread;
  for (int round = 0; round < 50; ++round) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      pictures[i].resize(1000 * (i + 1) + static_cast<std::size_t>(round));
      std::iota(pictures[i].begin(), pictures[i].end(),
                static_cast<std::uint8_t>(round + 7 * static_cast<int>(i)));
      tasks[i].from = pictures[i].data();
      tasks[i].count = pictures[i].size();
      REQUIRE(thread.start(tasks[i]));
    }
    for (const std::size_t i : {2U, 0U, 1U}) CHECK(thread.wait(tasks[i]) == pictures[i]);
  }
}

TEST_CASE("copies: an abandoned copy thread finishes its current task and ends") {
  const std::vector<std::uint8_t> picture(1 << 20, 9);
  std::array<draw::CopyThread::Task, 8> tasks;
  draw::CopyThread thread;
  for (auto& task : tasks) {
    task.from = picture.data();
    task.count = picture.size();
    REQUIRE(thread.start(task));
  }
}
