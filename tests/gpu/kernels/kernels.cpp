// Tests user kernels on the GPU. Their results must have the same bits as the program's exact functions
// compiled as C++.
#include "kernels/kernels.hpp"

#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "gpu/context.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/kernels/arithmetic.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

using namespace simreel;

namespace {

kernels::Kernel lowered(const std::string& name, const std::string& text) {
  const auto path = temporaryFile(name);
  std::ofstream(path) << text;
  kernels::Request request;
  request.file = path;
  request.careful = sim::kernelArithmetic() == sim::Arithmetic::careful;
  kernels::Shader shader = kernels::load(request);
  std::filesystem::remove(path);
  return std::move(shader.kernels.at(0));
}

int bindingOf(const kernels::Kernel& kernel, const std::string& name) {
  for (const kernels::Buffer& buffer : kernel.buffers)
    if (buffer.name == name) return buffer.binding;
  return -1;
}

constexpr std::size_t guards = 2;

/// Returns the values of `expression`, evaluated by an HLSL kernel for each pair (x, y) of `pairs`.
std::vector<float> results(const std::string& expression, const std::vector<float>& pairs) {
  const kernels::Kernel kernel = lowered("expression.hlsl",
                                         "StructuredBuffer<float2> _In; RWStructuredBuffer<float> _Out;\n"
                                         "[numthreads(32, 1, 1)] void K(uint i : SV_DispatchThreadID) { "
                                         "float x = _In[i].x, y = _In[i].y; _Out[i] = " +
                                             expression + "; }\n");
  std::vector<float> given = pairs;
  given.resize(pairs.size() + 2 * guards, 0.0F);
  const gl::Buffer in = gl::Buffer::of<float>("in", given);
  const gl::Buffer out("out", (pairs.size() / 2 + guards) * sizeof(float));
  in.bindStorage(static_cast<GLuint>(bindingOf(kernel, "_In")));
  out.bindStorage(static_cast<GLuint>(bindingOf(kernel, "_Out")));
  const gl::Program program = sim::kernelProgram("kernel", kernel.body());
  program.dispatchGroups(static_cast<GLuint>((pairs.size() / 2 + 31) / 32), 1, 1);
  gl::barrier();
  std::vector<float> made = out.readAll<float>();
  made.resize(pairs.size() / 2);
  return made;
}

std::vector<float> pairs(float low, float high, float lowY, float highY) {
  std::vector<float> all;
  constexpr int count = 512;
  for (int i = 0; i < count; ++i) {
    all.push_back(low + (high - low) * static_cast<float>(i) / count);
    all.push_back(lowY + (highY - lowY) * static_cast<float>((i * 197) % count) / count);
  }
  return all;
}

template <class Function>
void checkBits(const std::string& expression, const std::vector<float>& given, Function expected) {
  const std::vector<float> made = results(expression, given);
  int wrong = 0;
  for (std::size_t i = 0; i < made.size(); ++i)
    wrong +=
        std::bit_cast<std::uint32_t>(made[i]) !=
                std::bit_cast<std::uint32_t>(static_cast<float>(expected(given[2 * i], given[2 * i + 1])))
            ? 1
            : 0;
  CHECK_MESSAGE(wrong == 0, expression);
}

/// Checks that the max of |error| / max(1, |truth|) is below `bound`.
template <class Function>
void checkNear(const std::string& expression, const std::vector<float>& given, double bound,
               Function truth) {
  const std::vector<float> made = results(expression, given);
  double worst = 0.0;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const double right = truth(static_cast<double>(given[2 * i]), static_cast<double>(given[2 * i + 1]));
    worst =
        std::max(worst, std::abs(static_cast<double>(made[i]) - right) / std::max(1.0, std::abs(right)));
  }
  CHECK_MESSAGE(worst < bound, expression, " is ", worst, " off");
}

}  // namespace

TEST_CASE("user kernels: shader functions have the same bits as the program's exact functions") {
  testContext();
  const auto some = pairs(0.01F, 50.0F, -20.0F, 20.0F);
  checkBits("sin(y)", some, [](float, float y) { return shader::exactSin(y); });
  checkBits("cos(y)", some, [](float, float y) { return shader::exactCos(y); });
  checkBits("exp(y)", some, [](float, float y) { return shader::exactExp(y); });
  checkBits("log(x)", some, [](float x, float) { return shader::exactLog(x); });
  checkBits("sqrt(x)", some, [](float x, float) { return std::sqrt(x); });
  checkBits("rsqrt(x)", some, [](float x, float) { return 1.0F / std::sqrt(x); });
  checkBits("y / x", some, [](float x, float y) { return y * (1.0F / x); });
  checkBits("x * y + x", some, [](float x, float y) { return x * y + x; });
  checkBits("pow(x, y * 0.1)", some, [](float x, float y) { return shader::exactPow(x, y * 0.1F); });
  checkBits("lerp(x, y, 0.3)", some, [](float x, float y) { return x + (y - x) * 0.3F; });
  checkBits("(x + 1e6) - 1e6", some, [](float x, float) { return (x + 1e6F) - 1e6F; });
  checkBits("(x * 3.7) * 0.77", some, [](float x, float) { return (x * 3.7F) * 0.77F; });
}

TEST_CASE("user kernels: functions without an exact version are within error bounds") {
  testContext();
  const auto wide = pairs(1e4F, 3e6F, -0.999F, 0.999F);
  checkNear("sin(x)", wide, 2.5e-7, [](double x, double) { return std::sin(x); });
  checkNear("cos(x)", wide, 5e-7, [](double x, double) { return std::cos(x); });
  checkNear("asin(y)", wide, 1e-6, [](double, double y) { return std::asin(y); });
  checkNear("acos(y)", wide, 1e-6, [](double, double y) { return std::acos(y); });
  checkNear("tanh(y * 9)", wide, 3e-7,
            [](double, double y) { return std::tanh(static_cast<double>(static_cast<float>(y) * 9.0F)); });
  checkNear("log2(x)", wide, 3e-7, [](double x, double) { return std::log2(x); });
  const auto near = pairs(-30.0F, 30.0F, -8.0F, 8.0F);
  checkNear("atan2(x, y)", near, 4e-7, [](double x, double y) { return std::atan2(x, y); });
  checkNear("exp2(x)", near, 4e-7, [](double x, double) { return std::exp2(x); });
  checkNear("sinh(y)", near, 1e-6, [](double, double y) { return std::sinh(y); });
  checkNear("fmod(x, 3.0)", near, 1e-6, [](double x, double) { return std::fmod(x, 3.0); });
  checkNear("f16tof32(f32tof16(x))", near, 1e-3, [](double x, double) { return x; });
}

TEST_CASE("user kernels: NaN, infinities, out-of-range conversions and zeros have defined results") {
  testContext();
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<float> given = {nan,    2,      inf, 0, -inf, -0.0F, 1e38F, 1e38F,
                                    1e-20F, 1e-20F, -3,  0, 5e9F, -1,    0,     0};
  const auto of = [&](const std::string& expression) { return results(expression, given); };
  CHECK(of("(int)x == 0 ? 1 : 2")[0] == 1.0F);
  CHECK(of("(float)(int)x")[1] == 2147483648.0F);
  CHECK(of("(float)(int)x")[2] == -2147483648.0F);
  CHECK(of("(float)(uint)x")[5] == 0.0F);
  CHECK(of("(float)(uint)x")[6] == 4294967296.0F);
  CHECK(of("min(x, y)")[0] == 2.0F);
  CHECK(of("max(x, y)")[0] == 2.0F);
  CHECK(of("x * y")[4] == 0.0F);
  CHECK(of("x * y")[3] == inf);
  CHECK(of("1.0 / y")[1] == inf);
  CHECK(of("1.0 / y")[2] == inf);
  CHECK(of("x / y")[5] == -inf);
  CHECK(std::isnan(of("x / y")[7]));
  CHECK(std::isnan(of("sqrt(x)")[5]));
  CHECK(std::isnan(of("sin(x)")[1]));
  CHECK(of("exp(x)")[2] == 0.0F);
  CHECK(of("log(y)")[1] == -inf);
  CHECK(of("(int)x / (int)y")[5] == -1.0F);
}

TEST_CASE("user kernels: out-of-bounds reads return zero, and out-of-bounds writes are dropped") {
  testContext();
  const kernels::Kernel kernel = lowered(
      "bounds.hlsl",
      "RWStructuredBuffer<uint> _Data; RWStructuredBuffer<uint> _Read; groupshared uint s[4];\n"
      "[numthreads(4, 1, 1)] void K(uint i : SV_GroupIndex) {\n"
      "  uint own[3] = {5, 6, 7};\n  s[i] = 100 + i; s[i + 3] = 50; GroupMemoryBarrierWithGroupSync();\n"
      "  uint n, stride; _Data.GetDimensions(n, stride);\n"
      "  own[i + 2] = 9;\n"
      "  _Data[i * 3] = i + 1; _Read[i] = _Data[i + 1000] + own[i + 3] + s[i + 7];\n"
      "  uint old; InterlockedAdd(_Data[i + 77], 5, old); _Read[4 + i] = old + own[i < 3 ? i : 0];\n"
      "  if (i == 0) _Read[8] = n; if (i == 1) _Read[9] = _Data[(int)i - 2]; if (i == 2) _Read[10] = "
      "s[2];\n}\n");
  const gl::Buffer data("data", (8 + guards) * sizeof(std::uint32_t)),
      read("read", (12 + guards) * sizeof(std::uint32_t));
  data.bindStorage(static_cast<GLuint>(bindingOf(kernel, "_Data")));
  read.bindStorage(static_cast<GLuint>(bindingOf(kernel, "_Read")));
  sim::kernelProgram("kernel", kernel.body()).dispatchGroups(1, 1, 1);
  gl::barrier();
  const auto stored = data.readAll<std::uint32_t>(), reported = read.readAll<std::uint32_t>();
  CHECK(std::vector(stored.begin(), stored.begin() + 9) ==
        std::vector<std::uint32_t>{1, 0, 0, 2, 0, 0, 3, 0, 0});
  INFO(fmt::format("{}", fmt::join(reported.begin(), reported.begin() + 11, " ")));
  CHECK(std::vector(reported.begin(), reported.begin() + 11) ==
        std::vector<std::uint32_t>{0, 0, 0, 0, 5, 6, 7, 5, 8, 0, 102});
}

TEST_CASE("user kernels: texture filtering uses weights in full precision") {
  testContext();
  const kernels::Kernel kernel = lowered(
      "sampling.hlsl",
      "Texture2D<float4> _Tex; SamplerState sampler_Tex; RWStructuredBuffer<float> _Out; "
      "StructuredBuffer<float2> _At;\n"
      "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n"
      "  _Out[i] = _Tex.SampleLevel(sampler_Tex, _At[i], 0).x; _Out[8 + i] = _Tex[uint2(i, 0)].y; }\n");
  const gl::Texture texture = gl::Texture::image("texels", GL_RGBA32F, 4, 2);
  std::vector<float> texels;
  for (int i = 0; i < 8; ++i)
    texels.insert(texels.end(), {static_cast<float>(i * i), static_cast<float>(i), 0, 0});
  glTextureSubImage2D(texture.name(), 0, 0, 0, 4, 2, GL_RGBA, GL_FLOAT, texels.data());
  REQUIRE(kernel.textures.size() == 1);
  texture.bind(static_cast<GLuint>(kernel.textures[0].binding));
  // The texels are 0 1 4 9 in the first row and 16 25 36 49 in the second row.
  std::vector<float> at = {0.5F, 0.25F, 0.375F, 0.25F, 0.3F, 0.6F, 0.0F,   0.25F,
                           1.0F, 0.75F, -0.3F,  0.4F,  2.2F, 0.5F, 0.875F, 0.25F};
  at.resize(at.size() + 2 * guards);
  const gl::Buffer places = gl::Buffer::of<float>("places", at);
  places.bindStorage(static_cast<GLuint>(bindingOf(kernel, "_At")));
  const auto filtered = [&](std::uint32_t state) {
    const std::vector<std::uint32_t> states = {state, 0, 0, 0};
    const gl::Buffer block = gl::Buffer::of<std::uint32_t>("states", states),
                     out("out", (16 + guards) * sizeof(float));
    REQUIRE(kernel.blocks.at(0).members.at(0).name == "_Tex_sampler_Tex");
    block.bindUniform(static_cast<GLuint>(kernel.blocks[0].binding), 0, 16);
    out.bindStorage(static_cast<GLuint>(bindingOf(kernel, "_Out")));
    sim::kernelProgram("kernel", kernel.body()).dispatchGroups(1, 1, 1);
    gl::barrier();
    return out.readAll<float>();
  };
  constexpr std::uint32_t linear = 1, clamped = (1U << 2U) | (1U << 4U), mirrored = (2U << 2U) | (2U << 4U);
  const std::vector<float> clampedLinear = filtered(linear | clamped);
  CHECK(clampedLinear[0] == 2.5F);
  CHECK(clampedLinear[1] == 1.0F);
  CHECK(clampedLinear[3] == 0.0F);
  CHECK(clampedLinear[4] == 49.0F);
  CHECK(clampedLinear[7] == 9.0F);
  CHECK(clampedLinear[8 + 3] == 3.0F);
  CHECK(clampedLinear[8 + 4] == 0.0F);  // Reads outside of the image return 0.
  const std::vector<float> repeated = filtered(0);
  CHECK(repeated[0] == 4.0F);
  CHECK(repeated[4] == 16.0F);
  CHECK(repeated[5] == 4.0F);
  CHECK(filtered(linear)[3] == 4.5F);
  CHECK(filtered(mirrored)[5] == 1.0F);
  CHECK(filtered(linear | mirrored)[3] == 0.0F);
}
