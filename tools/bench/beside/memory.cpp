#include "beside/memory.hpp"

#include "base/clock.hpp"
#include "plain/plain.hpp"

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::bench {

GLuint nextBuffer() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  glDeleteBuffers(1, &name);
  return name;
}

void listBuffers(const char* what, GLuint first, double cells) {
  struct Item {
    std::string label;
    double bytes;
  };
  std::vector<Item> items;
  double sum = 0;
  for (GLuint name = first; name < first + 1024; ++name) {
    if (glIsBuffer(name) == GL_FALSE) continue;
    char label[256] = "";
    glGetObjectLabel(GL_BUFFER, name, sizeof label, nullptr, label);
    GLint64 bytes = 0;
    glGetNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &bytes);
    items.push_back({label, static_cast<double>(bytes)});
    sum += items.back().bytes;
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return a.bytes > b.bytes; });
  const auto line = [&](const std::string& name, double bytes) {
    fmt::print("  {:<28} {:>8.2f} bytes a cell\n", name, bytes / cells);
  };
  for (const Item& item : items) line(item.label, item.bytes);
  line(fmt::format("{} in all", what), sum);
}

Taken leastOf(const std::function<void()>& work) {
  Taken least;
  work();
  glFinish();
  for (int i = 0; i < 5; ++i) {
    const auto begin = Clock::now();
    const std::clock_t used = std::clock();
    work();
    glFinish();
    least.wall = std::min(least.wall, secondsSince(begin));
    least.processor = std::min(least.processor, static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
  }
  return least;
}

void printBytes(double bytes, double cellsPerProcessorSecond) {
  const std::clock_t begin = std::clock();
  double copied = 0;
  for (int i = 0; i < 3; ++i) copied += plain::copying(std::size_t{1} << 28U);
  const double copies = copied / (static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  fmt::print(
      "  {:.0f} bytes a cell and step: {:.2f} GB each processor second, {:.1f}% of the {:.1f} GB that "
      "copying moves\n",
      bytes, 1e-9 * bytes * cellsPerProcessorSecond, 100 * bytes * cellsPerProcessorSecond / copies,
      1e-9 * copies);
}

}  // namespace simreel::bench
