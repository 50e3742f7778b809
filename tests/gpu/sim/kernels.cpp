// Tests the shipped example kernels by comparison with their equations in double precision. Also tests that
// an error in a kernel ends the run with a message that names the kernel.
#include "sim/kernels/kernels.hpp"

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"
#include "source_folder.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Returns a scene with one object "k" that runs a shipped shader or the shader file at a given path.
scene::Scene kernelScene(const std::string& file, const std::string& rest) {
  const std::string path = file.find('/') == std::string::npos ? "kernels/" + file : file;
  ::setenv("SIMREEL_ASSETS", (sourceFolder() + "/assets").c_str(), 1);
  return scene::parseScene(
      fmt::format(
          R"({{"version": 1, "time": {{"fps": 60}}, "camera": {{"position": [0, 0, 3], "target": [0, 0, 0]}},
        "objects": {{"k": {{"kernels": {{"file": "{}", {}}}}}}}}})",
          path, rest),
      (sourceFolder() + "/assets/scenes/test.json").c_str(), {}, sim::kinds());
}

/// Returns the floats of a state array, four per element.
std::vector<float> stateOf(const sim::World& world, const std::string& name) {
  for (const sim::StateArray& array : world.object(0).state())
    if (array.name == name) return array.buffer->readAll<float>();
  FAIL("no state array " << name);
  return {};
}

/// Writes a temporary shader file into assets/kernels. The destructor deletes it.
class ShaderText {
 public:
  explicit ShaderText(const std::string& text)
      : path_(sourceFolder() + "/assets/kernels/test-" + std::to_string(::getpid()) + ".compute") {
    std::ofstream(path_) << text;
  }
  ~ShaderText() { std::filesystem::remove(path_); }
  ShaderText(const ShaderText&) = delete;
  ShaderText& operator=(const ShaderText&) = delete;
  [[nodiscard]] std::string name() const { return std::filesystem::path(path_).filename().string(); }

 private:
  std::string path_;
};

/// Returns the error message with which a world's run ends, or "" if it does not fail.
std::string endOf(const scene::Scene& scene, int frames = 2) {
  try {
    sim::World world(scene);
    for (int frame = 0; frame <= frames; ++frame) {
      world.advanceTo(frame);
      world.startSummary();
      static_cast<void>(world.takeSummary(true));
    }
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::device);
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return true;
  MESSAGE(text);
  return false;
}

}  // namespace

TEST_CASE("kernels: gravity of a user's shader follows its equation in double") {
  testContext();
  constexpr int count = 100, frames = 10;  // The count is not a multiple of the workgroup size.
  sim::World world(kernelScene("Gravity.compute", R"j("buffers": {"_Bodies": {"size": 100, "start": {
      "position": ["cos(i)", "0.3*sin(3*i)", "sin(2*i)"], "velocity": ["0.1*sin(i)", 0, "0.1*cos(i)"], "mass": "0.01 + 0.001*i"
}
}
},
      "constants": {"_G": 1, "_Softening": 0.1, "_DeltaTime": "dt", "_Count": "count(_Bodies)"}, "step": ["UpdateGravity", "Move"])j"));
  world.advanceTo(0);
  const auto first = stateOf(world, "_Bodies");
  std::vector<glm::dvec3> x, v;
  std::vector<double> m;
  for (std::size_t i = 0; i < count; ++i) {
    x.emplace_back(first[8 * i], first[8 * i + 1], first[8 * i + 2]);
    m.push_back(first[8 * i + 3]);
    v.emplace_back(first[8 * i + 4], first[8 * i + 5], first[8 * i + 6]);
  }
  for (int frame = 0; frame < frames; ++frame) {
    for (std::size_t i = 0; i < count; ++i) {
      glm::dvec3 sum(0);
      for (std::size_t j = 0; j < count; ++j) {
        const glm::dvec3 to = x[j] - x[i];
        const double squared = glm::dot(to, to) + 0.01;
        sum += to * (m[j] / (squared * std::sqrt(squared)));
      }
      v[i] += sum / 60.0;
    }
    for (std::size_t i = 0; i < count; ++i) x[i] += v[i] / 60.0;
  }
  world.advanceTo(frames);
  const auto last = stateOf(world, "_Bodies");
  double worst = 0, moved = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      worst = std::max(worst, std::abs(static_cast<double>(last[8 * i + c]) - x[i][static_cast<int>(c)]));
      moved = std::max(moved, std::abs(static_cast<double>(last[8 * i + c] - first[8 * i + c])));
    }
  CHECK(worst < 2e-6);
  CHECK(moved > 0.01);
}

TEST_CASE("kernels: the Game of Life of a user's shader has the cells of its rule") {
  testContext();
  constexpr int width = 37, height = 21;
  sim::World world(
      kernelScene("GameOfLife.compute",
                  R"j("textures": {"_Current": {"size": [37, 21], "start": {"r": "step(0.2, random(1))"
}
}
, "_Next" : [ 37, 21 ]
},
      "constants": {"_Width": 37, "_Height": "height(_Current)"}, "step": [{"kernel": "Step", "swap": ["_Current", "_Next"]}])j"));
  world.advanceTo(0);
  const auto first = stateOf(world, "_Current");
  std::vector<int> cells(width * height);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = static_cast<int>(first[4 * i]);
  CHECK(std::count(cells.begin(), cells.end(), 1) > 100);
  for (int step = 0; step < 20; ++step) {
    std::vector<int> next = cells;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        int around = 0;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            if (dx != 0 || dy != 0)
              around += cells[static_cast<std::size_t>((y + dy + height) % height * width +
                                                       (x + dx + width) % width)];
        const auto here = static_cast<std::size_t>(y * width + x);
        next[here] = around == 3 || (around == 2 && cells[here] == 1) ? 1 : 0;
      }
    cells = next;
  }
  world.advanceTo(20);
  const auto last = stateOf(world, "_Current");
  for (std::size_t i = 0; i < cells.size(); ++i) REQUIRE(static_cast<int>(last[4 * i]) == cells[i]);
}

TEST_CASE("kernels: Gray-Scott of a user's shader follows its equation in double") {
  testContext();
  constexpr int width = 24, height = 17;
  sim::World world(
      kernelScene("GrayScott.compute", R"j("textures": {"_Current": {"size": [24, 17], "start": {
      "r": "1 - 0.5*step((x - 12)^2 + (y - 8)^2, 16)", "g": "0.25*step((x - 12)^2 + (y - 8)^2, 16)"
}
}
, "_Next" : [ 24, 17 ]
},
      "constants": {"_Width": 24, "_Height": 17, "_DiffuseU": 1, "_DiffuseV": 0.5, "_Feed": 0.0367, "_Kill": 0.0649, "_DeltaTime": 1},
      "steps": 10, "step": [{"kernel": "React", "swap": ["_Current", "_Next"]}])j"));
  world.advanceTo(0);
  const auto first = stateOf(world, "_Current");
  std::vector<std::array<double, 2>> cells(width * height);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = {first[4 * i], first[4 * i + 1]};
  for (int step = 0; step < 40; ++step) {
    auto next = cells;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const auto at = [&](int dx, int dy, int c) {
          return cells[static_cast<std::size_t>((y + dy + height) % height * width +
                                                (x + dx + width) % width)][static_cast<std::size_t>(c)];
        };
        const double u = at(0, 0, 0), v = at(0, 0, 1), reaction = u * v * v;
        const auto laplacian = [&](int c) {
          return 0.2 * (at(-1, 0, c) + at(1, 0, c) + at(0, -1, c) + at(0, 1, c)) +
                 0.05 * (at(-1, -1, c) + at(1, -1, c) + at(-1, 1, c) + at(1, 1, c)) - at(0, 0, c);
        };
        next[static_cast<std::size_t>(y * width + x)] = {
            std::clamp(u + laplacian(0) - reaction + 0.0367 * (1 - u), 0.0, 1.0),
            std::clamp(v + 0.5 * laplacian(1) + reaction - (0.0649 + 0.0367) * v, 0.0, 1.0)};
      }
    cells = next;
  }
  world.advanceTo(4);
  const auto last = stateOf(world, "_Current");
  double worst = 0, moved = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c) {
      worst = std::max(worst, std::abs(static_cast<double>(last[4 * i + c]) - cells[i][c]));
      moved = std::max(moved, std::abs(static_cast<double>(last[4 * i + c] - first[4 * i + c])));
    }
  CHECK(worst < 1e-5);
  CHECK(moved > 0.1);
}

TEST_CASE("kernels: the ripple of a user's shader is its closed form") {
  testContext();
  sim::World world(kernelScene(
      "Ripple.compute",
      R"j("buffers": {"_Rest": {"size": [9, 7], "start": ["(x - 4)*0.5", "0", "(y - 3)*0.5"]}, "_Vertices": [9, 7]},
      "constants": {"_Time": "time + dt", "_Amplitude": 0.14, "_Frequency": 6, "_Speed": 5, "_Decay": 0.35, "_Count": "count(_Rest)"
})j"));
  world.advanceTo(30);
  const auto vertices = stateOf(world, "_Vertices");
  double worst = 0;
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 9; ++x) {
      const double r = std::hypot((x - 4) * 0.5, (y - 3) * 0.5);
      const double height = 0.14 * std::exp(-0.35 * r) * std::sin(6 * r - 5 * 0.5);
      worst = std::max(
          worst,
          std::abs(static_cast<double>(vertices[static_cast<std::size_t>(8 * (y * 9 + x) + 1)]) - height));
    }
  CHECK(worst < 3e-6);
}

TEST_CASE("kernels: a sheet of springs of a user's shader follows its equations in double") {
  testContext();
  constexpr int n = 8;
  constexpr double dt = 1.0 / 240, rest = 0.1, k = 50, damping = 0.9;
  sim::World world(kernelScene("Cloth.compute", R"j("buffers": {"_Particles": {"size": [8, 8], "start": {
      "position": ["0.104*x", "0.01*sin(x + 2*y)", "0.102*y"], "invMass": "if(y == 0, 0, 10)"
}
}
, "_Solved" : [ 8, 8 ]
},
      "constants": {"_Width": 8, "_Height": 8, "_DeltaTime": "dt", "_SpringK": 50, "_RestLength": 0.1, "_Damping": 0.9,
                    "_Gravity": [0, -9.8, 0], "_Wind": [0.05, 0, 0.03]},
      "steps": 4, "step": ["ApplyForces", "IntegratePos"])j"));
  world.advanceTo(0);
  const auto first = stateOf(world, "_Particles");
  std::vector<glm::dvec3> x, v(n * n, glm::dvec3(0));
  for (std::size_t i = 0; i < n * n; ++i) x.emplace_back(first[8 * i], first[8 * i + 1], first[8 * i + 2]);
  for (int step = 0; step < 20; ++step) {
    const auto before = x;
    for (int row = 1; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const auto i = static_cast<std::size_t>(row * n + column);
        glm::dvec3 force(0.05, 0, 0.03);
        const auto pull = [&](int dx, int dy, double length, double stiffness) {
          const int c = column + dx, r = row + dy;
          if (c < 0 || r < 0 || c >= n || r >= n) return;
          const glm::dvec3 d = before[static_cast<std::size_t>(r * n + c)] - before[i];
          force += stiffness * (glm::length(d) - length) * d / glm::length(d);
        };
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            if (dx != 0 || dy != 0) pull(dx, dy, rest * std::sqrt(1.0 * dx * dx + dy * dy), k);
        for (const auto& [dx, dy] : {std::pair{2, 0}, {-2, 0}, {0, 2}, {0, -2}})
          pull(dx, dy, 2 * rest, 0.3 * k);
        v[i] = (v[i] + (force * 10.0 + glm::dvec3(0, -9.8, 0)) * dt) * std::exp(-damping * dt);
      }
    for (std::size_t i = n; i < n * n; ++i) x[i] += v[i] * dt;
  }
  world.advanceTo(5);
  const auto last = stateOf(world, "_Particles");
  double worst = 0, moved = 0;
  for (std::size_t i = 0; i < n * n; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      worst = std::max(worst, std::abs(static_cast<double>(last[8 * i + c]) - x[i][static_cast<int>(c)]));
      moved = std::max(moved, std::abs(static_cast<double>(last[8 * i + c] - first[8 * i + c])));
    }
  CHECK(worst < 3e-6);
  CHECK(moved > 0.02);
}

TEST_CASE("kernels: reads and writes out of bounds stop a run, or are told") {
  testContext();
  const ShaderText text(R"(#pragma kernel Go
RWStructuredBuffer<float> _Data;
[numthreads(8,1,1)] void Go(uint3 id : SV_DispatchThreadID) {
  float left = _Data[id.x - 1];
  _Data[id.x] = left + 1;
}
)");
  const std::string rest = R"j("buffers": {"_Data": {"size": 16, "start": "i"}})j";
  const std::string message = endOf(kernelScene(text.name(), rest));
  CHECK(has(message, R"(frame 1: )"));
  CHECK(has(
      message,
      R"(.compute:4: kernel "Go" reads "_Data" at -1, but it has 16 elements (1 invocation; the first is (0, 0, 0)))"));
  CHECK(endOf(kernelScene(text.name(), R"j("bounds": "ignore", )j" + rest)).empty());
}

TEST_CASE("kernels: a loop that does not end stops a run") {
  testContext();
  const ShaderText text(R"(#pragma kernel Go
RWStructuredBuffer<float> _Data;
[numthreads(8,1,1)] void Go(uint3 id : SV_DispatchThreadID) {
  float x = _Data[id.x];
  while (x >= 0) x += 1;
  _Data[id.x] = x;
}
)");
  const std::string message = endOf(kernelScene(
      text.name(), R"j("iterations": 1000, "buffers": {"_Data": {"size": 16, "start": "i"}})j"));
  CHECK(has(message, R"(kernel "Go" has a loop that did not end within "iterations" (16 invocations)"));
}

TEST_CASE("kernels: iterations of loops are all made, or a run stops") {  // This test takes 1 s.
  testContext();
  const ShaderText text(R"(#pragma kernel Go
RWStructuredBuffer<uint> _Data;
uint _Outer, _Inner;
[numthreads(8,1,1)] void Go(uint3 id : SV_DispatchThreadID) {
  uint n = 0, k = 0;
  if (id.x % 3 == 1) do { for (uint j = 0; j < _Inner; ++j) { if (j % 5 == id.x) continue; ++n; } } while (++k < _Outer);
  else if (id.x % 3 == 2) n = 7;
  else while (k < _Outer) { for (uint j = 0; j < _Inner; ++j) for (uint i = 0; i < _Inner; ++i) { if (i > id.x * 30) break; ++n; } ++k; }
  _Data[id.x] = n;
}
)");
  const auto count = [](unsigned id, unsigned outer, unsigned inner) {
    if (id % 3 == 2) return 7U;
    if (id % 3 == 1) return outer * (id < 5 ? inner - (inner + 4 - id) / 5 : inner);
    return outer * inner * std::min(inner, id * 30 + 1);
  };
  const auto scene = [&](unsigned outer, unsigned inner) {
    return kernelScene(text.name(), fmt::format(R"j("constants": {{"_Outer": {}, "_Inner": {}}},
      "buffers": {{"_Data": 16}})j",
                                                outer, inner));
  };
  for (const auto& [outer, inner] : {std::array{3U, 40U}, {50U, 11U}, {300U, 200U}, {100U, 3000U}}) {
    CAPTURE(outer);
    const std::string message = endOf(scene(outer, inner));
    if (!message.empty()) {
      CHECK(outer >= 100);
      CHECK(has(message, R"(kernel "Go" has loops that this driver ended)"));
      continue;
    }
    sim::World world(scene(outer, inner));
    world.advanceTo(1);
    for (const sim::StateArray& array : world.object(0).state()) {
      const auto made = array.buffer->readAll<unsigned>();
      for (unsigned id = 0; id < 16; ++id) CHECK(made[id] == count(id, outer, inner));
    }
  }
}

TEST_CASE(
    "kernels: races are found by kernel, line, element and invocations; the state before the dispatch "
    "cures them") {
  testContext();
  const ShaderText text(R"(#pragma kernel Blur
RWStructuredBuffer<float> _Data;
[numthreads(8,1,1)] void Blur(uint3 id : SV_DispatchThreadID) {
  float left = _Data[id.x == 0 ? 0 : id.x - 1];
  _Data[id.x] = 0.5 * (left + _Data[id.x]);
}
)");
  const auto racing = [&](const std::string& more) {
    sim::World world(
        kernelScene(text.name(), R"j("buffers": {"_Data": {"size": 32, "start": "i^2")j" + more + "}}"));
    world.advanceTo(0);
    const auto before = stateOf(world, "_Data");
    auto found = world.races();
    CHECK(stateOf(world, "_Data") == before);
    return found;
  };
  const auto found = racing("");
  REQUIRE(found.size() == 1);
  CHECK(has(found[0], R"(.compute:4: kernel "Blur" races: invocation )"));
  CHECK(has(found[0], R"(of "_Data", which invocation )"));
  CHECK(racing(R"(, "previous": true)").empty());
}

TEST_CASE("kernels: whole numbers divide exactly") {
  // Runs for 0.3 s. Divisors are random, of 1 to 32 bits. One third of the dividends are random; the others
  // are a multiple of the divisor, or one less.
  const ShaderText shader(R"(#pragma kernel Divide
RWStructuredBuffer<uint4> _Out;
uint Next(inout uint state) { state = state * 1664525u + 1013904223u; return state ^ (state >> 16); }
[numthreads(64, 1, 1)] void Divide(uint3 id : SV_DispatchThreadID)
{
    uint state = id.x * 2654435761u;
    uint b = max(Next(state) >> (id.x % 32u), 1u);
    uint a = id.x % 3u == 0u ? Next(state) : b * (Next(state) % (4294967295u / b) + 1u) - id.x % 2u;
    _Out[id.x] = uint4(a, b, a / b, uint(int(a) % int(b)));
}
)");
  testContext();
  constexpr std::size_t count = 1 << 16;
  sim::World world(
      kernelScene("kernels/" + shader.name(), R"("buffers": {"_Out": 65536}, "step": ["Divide"])"));
  world.advanceTo(1);
  const std::vector<float> state = stateOf(world, "_Out");
  REQUIRE(state.size() >= 4 * count);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < 4 * count; i += 4) {
    const auto word = [&](std::size_t k) { return std::bit_cast<std::uint32_t>(state[i + k]); };
    const std::int64_t a = static_cast<std::int32_t>(word(0)), b = static_cast<std::int32_t>(word(1));
    wrong += word(2) != word(0) / word(1) ? 1 : 0;
    wrong += word(3) != static_cast<std::uint32_t>(a % b) ? 1 : 0;
  }
  CHECK(wrong == 0);
}
