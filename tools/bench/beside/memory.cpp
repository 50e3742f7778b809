#include "beside/memory.hpp"

#include "base/clock.hpp"
#include "gl/context.hpp"
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

Taken minimumOf(const std::function<void()>& work) {
  Taken minimum;
  work();
  glFinish();
  for (int i = 0; i < 5; ++i) {
    const auto begin = Clock::now();
    const std::clock_t used = std::clock();
    work();
    glFinish();
    minimum.wall = std::min(minimum.wall, secondsSince(begin));
    minimum.processor =
        std::min(minimum.processor, static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
  }
  return minimum;
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

namespace {

/// Compiles a kernel that writes `value`, a GLSL expression, to element `i` of the buffer `to`. The
/// expression may read the buffer `from`.
GLuint copier(const char* value) {
  const std::string text = fmt::format(
      "#version 450\nlayout(local_size_x = 256) in;\n"
      "layout(std430, binding = 0) readonly restrict buffer From {{ uvec4 from[]; }};\n"
      "layout(std430, binding = 1) writeonly restrict buffer To {{ uvec4 to[]; }};\n"
      "void main() {{\n"
      "  uint i = gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 256u + gl_GlobalInvocationID.x;\n"
      "  to[i] = {};\n"
      "}}\n",
      value);
  const char* lines = text.c_str();
  return glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &lines);
}

}  // namespace

// On a GPU, a kernel copies, because some graphics drivers copy between buffers slowly. The copied data is
// noise, because graphics cards copy zeros faster.
double copiedBySecond() {
  const std::size_t bytes = std::size_t{1} << (gl::softwareDriver() ? 27U : 30U);
  const gl::Buffer from("copied", bytes), to("copy", bytes);
  const GLuint noise = copier("(uvec4(4u * i) + uvec4(0u, 1u, 2u, 3u)) * 2654435769u");
  const GLuint program = copier("from[i]");
  const auto groups = static_cast<GLuint>(bytes / 16 / 256);
  from.bindStorage(1);
  glUseProgram(noise);
  glDispatchCompute(1024, groups / 1024, 1);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  const Taken taken = minimumOf([&] {
    for (int i = 0; i < 8; ++i) {
      if (gl::softwareDriver()) {
        glCopyNamedBufferSubData(from.name(), to.name(), 0, 0, static_cast<GLsizeiptr>(bytes));
      } else {
        from.bindStorage(0);
        to.bindStorage(1);
        glUseProgram(program);
        glDispatchCompute(1024, groups / 1024, 1);
      }
    }
  });
  glDeleteProgram(noise);
  glDeleteProgram(program);
  return 16 * static_cast<double>(bytes) / taken.wall;
}

void printSpeed(const char* name, double cells, int steps, const std::function<void()>& turn,
                const std::function<double()>& bytes) {
  std::vector<double> wall, processor;
  const auto begun = Clock::now();
  while (wall.size() < 3 || secondsSince(begun) < 5) {
    glFinish();
    const auto begin = Clock::now();
    const std::clock_t used = std::clock();
    turn();
    glFinish();
    wall.push_back(secondsSince(begin) / steps);
    processor.push_back(static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC / steps);
  }
  const auto median = [](std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  const double step = median(wall), moved = bytes() * cells / step, copied = copiedBySecond();
  fmt::print(
      "{}: {:.4g}e9 whole steps of a cell a second ({:.4g} ms a step, {:.4g} to {:.4g} in {} turns of {}; "
      "{:.4g} ms of a processor)\n",
      name, 1e-9 * cells / step, 1e3 * step, 1e3 * *std::min_element(wall.begin(), wall.end()),
      1e3 * *std::max_element(wall.begin(), wall.end()), wall.size(), steps, 1e3 * median(processor));
  fmt::print("  {:.0f} bytes a cell and step: {:.4g} GB/s, {:.1f}% of the {:.4g} GB/s that copying moves\n",
             moved * step / cells, 1e-9 * moved, 100 * moved / copied, 1e-9 * copied);
}

}  // namespace simreel::bench
