// Tests the values that scenes give to constants of users' kernels, arrays above all. 0.3 s
#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/kernels/parameters.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace simreel::constant_test {

using test::checkHas;
using test::TemporaryFile;

constexpr const char* shader = R"(#pragma kernel Run
struct Light { float3 at; float power; };
float4 _Points[100];
float4x4 _Turns[20];
float _Weights[5];
float _Scale;
Light _Lights[3];
RWStructuredBuffer<float4> _Sum;
[numthreads(64, 1, 1)] void Run(uint3 id : SV_DispatchThreadID)
{
    float4 sum = 0;
    for (int i = 0; i < 100; ++i) sum += mul(_Turns[i % 20], _Points[i]) * _Weights[i % 5] * _Scale;
    for (int j = 0; j < 3; ++j) sum.xyz += _Lights[j].at * _Lights[j].power;
    _Sum[id.x] = sum;
}
)";

/// Values of all constants except those that a test sets.
const std::vector<std::pair<std::string, std::string>> plain = {
    {"_Points", "0"}, {"_Turns", "0"},     {"_Weights", "1"},
    {"_Scale", "1"},  {"_Lights.at", "0"}, {"_Lights.power", "0"},
};

/// Reads a scene with the given constants and returns its plan.
std::shared_ptr<const sim::KernelPlan> planWith(const std::string& constants, const std::string& files = "",
                                                const std::string& text = shader) {
  const TemporaryFile file("constants.compute", text);
  std::string all = constants;
  for (const auto& [name, value] : plain)
    if (text == shader && constants.find('"' + name + '"') == std::string::npos &&
        files.find(name) == std::string::npos)
      all += fmt::format("{}\"{}\": {}", all.empty() ? "" : ", ", name, value);
  const scene::Scene scene = scene::parseScene(
      fmt::format(
          R"({{"version": 1, "objects": {{"k": {{"kernels": {{"file": "{}", "buffers": {{"_Sum": 64}},
        "constants": {{{}}}, "constantFiles": {{{}}}}}}}}}}})",
          file.path().string(), all, files),
      file.path().parent_path() / "s.json", {}, sim::kinds());
  return dynamic_cast<const sim::KernelsParameters&>(*scene.objects.at(0).parameters).plan;
}

std::string mistakeWith(const std::string& constants, const std::string& files = "",
                        const std::string& text = shader) {
  try {
    static_cast<void>(planWith(constants, files, text));
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

/// Returns the numbers of a constant at the time 2 s with the seed 7, in order of the components.
std::vector<double> numbersOf(const sim::KernelPlan& plan, const std::string& path) {
  const kernels::Block& block = plan.shader().kernels.at(0).blocks.at(0);
  const auto bytes = plan.blockBytes(block, {.dt = 0.5, .time = 2, .seed = 7});
  const std::vector<sim::KernelSlot> slots = sim::slotsOf(block.members);
  const sim::KernelSlot* slot = sim::slotNamed(slots, path);
  REQUIRE(slot != nullptr);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < slot->offsets.size(); ++i)
    numbers.push_back(sim::loadSlot(bytes.data(), *slot, i));
  return numbers;
}

}  // namespace simreel::constant_test

using namespace simreel::constant_test;  // NOLINT

TEST_CASE("kernel constants: arrays take all their numbers") {
  std::string points;
  for (int i = 0; i < 100; ++i) points += fmt::format("{}[{}, 0, 0.5, 1]", i == 0 ? "" : ", ", i);
  const auto numbers = numbersOf(*planWith(fmt::format("\"_Points\": [{}]", points)), "_Points");
  REQUIRE(numbers.size() == 400);
  CHECK(numbers[4 * 99] == 99);
  CHECK(numbers[4 * 99 + 2] == 0.5);
  checkHas(mistakeWith("\"_Points\": [1, 2, 3]"),
           "\"_Points\" is a float4[100]: expected 400 numbers, or 4 for each element, found 3");
}

TEST_CASE("kernel constants: formulas of one element count the elements of an array") {
  const auto plan = planWith(R"~("_Points": ["i", "time*i", "random(1)", 1], "_Weights": "2^i",
    "_Turns": ["i", 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "_Lights.at": ["i", 1, 2], "_Lights.power": "10*i")~");
  const auto points = numbersOf(*plan, "_Points");
  CHECK(points[4 * 30] == 30);
  CHECK(points[4 * 30 + 1] == 60);
  CHECK(points[4 * 30 + 2] != points[4 * 31 + 2]);
  CHECK(points[4 * 30 + 3] == 1);
  CHECK(numbersOf(*plan, "_Weights") == std::vector<double>{1, 2, 4, 8, 16});
  CHECK(numbersOf(*plan, "_Turns")[16 * 19] == 19);
  CHECK(numbersOf(*plan, "_Turns")[16 * 19 + 5] == 1);
  CHECK(numbersOf(*plan, "_Lights[2].at") == std::vector<double>{2, 1, 2});
  CHECK(numbersOf(*plan, "_Lights[2].power") == std::vector<double>{20});
  checkHas(mistakeWith(R"("_Scale": "i")"), "i counts the elements of an array; \"_Scale\" is a float");
}

TEST_CASE("kernel constants: arrays take the rows of a file") {
  const TemporaryFile table("lights.csv", "x,y,z,power\n1,2,3,4\n5,6,7,8\n");
  const std::string given = fmt::format("\"_Points\": \"{}\"", table.path().string());
  const auto plan = planWith(R"~("_Scale": "count(_Points)")~", given);
  const auto points = numbersOf(*plan, "_Points");
  CHECK(std::vector<double>(points.begin() + 4, points.begin() + 9) == std::vector<double>{5, 6, 7, 8, 0});
  CHECK(numbersOf(*plan, "_Scale") == std::vector<double>{2});
  const auto chosen = numbersOf(*planWith(R"~("_Points": ["z", "time*power", "i", 1])~", given), "_Points");
  CHECK(std::vector<double>(chosen.begin() + 4, chosen.begin() + 8) == std::vector<double>{7, 16, 1, 1});
  const std::string path = table.path().string();
  checkHas(mistakeWith("", fmt::format("\"_Turns\": \"{}\"", path)),
           "\"_Turns\" is a float4x4[20]: expected 320 numbers, or 16 for each element, found 4 columns");
  checkHas(mistakeWith(R"("_Scale": "power")", fmt::format("\"_Scale\": \"{}\"", path)),
           "the file has 2 rows; \"_Scale\" is a float of 1 element(s)");
  checkHas(mistakeWith("", fmt::format("\"_Pionts\": \"{}\"", path)), "_Points");
}

TEST_CASE("kernel constants: a block that no uniform block holds is refused") {
  checkHas(mistakeWith("\"_Many\": 1", "",
                       "#pragma kernel Run\nfloat4 _Many[5000]; RWStructuredBuffer<float4> _Sum;\n"
                       "[numthreads(64, 1, 1)] void Run(uint3 id : SV_DispatchThreadID) { _Sum[id.x] = "
                       "_Many[id.x]; }\n"),
           "take 80000 bytes; a uniform block holds 65536: make the largest array a StructuredBuffer");
}
