// Tests all exact functions of users' kernels by comparison with doubles of the CPU's library, for ordinary
// numbers, for arbitrary bits and for edge cases. The hashes of all results must equal the stored hashes on
// every driver.
#include "gpu/kernel_guards.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/vec2.hpp>

namespace simreel::test {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();

/// An expression of x and y, its value in doubles, its max error, and the domain for which this error
/// holds. The error is relative to the larger of the value's magnitude and 1. `hash`: hash of the results
/// for the first `hashed` inputs.
struct Function {
  const char* expression;
  double (*truth)(double x, double y);
  double relative, absolute;
  bool (*holds)(double x, double y);
  std::uint64_t hash;
};

bool always(double, double) {
  return true;
}
bool positive(double x, double) {
  return x >= 1e-30;
}
bool isNear0(double x) {
  return x != 0 && std::abs(x) < 1e-30;
}
bool notTiny(double x, double y) {
  return !isNear0(x) && !isNear0(y);
}
bool divisor(double, double y) {
  return std::abs(y) <= 0x1p126 || std::isinf(y) || std::isnan(y);
}
bool below(double x, double limit) {
  return std::abs(x) <= limit;
}
double bits(std::uint32_t x) {
  return static_cast<double>(std::bit_cast<float>(x));
}
std::uint32_t bits(double x) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(x));
}
double positiveZero(double x) {
  return x == 0 ? 0 : x;
}
double toInt(double x) {
  return std::isnan(x) ? 0 : std::clamp(std::trunc(x), -2147483648.0, 2147483647.0);
}
double toUint(double x) {
  return std::isnan(x) ? 0 : std::clamp(std::trunc(x), 0.0, 4294967295.0);
}
double minimum(double x, double y) {
  return std::isnan(x) ? y : std::isnan(y) ? x : std::min(x, y);
}
double greatest(double x, double y) {
  return std::isnan(x) ? y : std::isnan(y) ? x : std::max(x, y);
}
double rounded(double x) {
  return static_cast<double>(static_cast<float>(x));
}
const float third = 0.3F;

// clang-format off
const Function functions[] = {
  {"x + y", [](double x, double y) { return x + y; }, 6e-8, 0, always, 0x45da95c6ed80d97f},
  {"x - y", [](double x, double y) { return x - y; }, 6e-8, 0, always, 0x7a338d0bbeebf260},
  {"x * y", [](double x, double y) { return x * y; }, 6e-8, 0, always, 0xa6ad24aba211be87},
  {"x / y", [](double x, double y) { return x / positiveZero(y); }, 1.8e-7, 0, divisor, 0x43305d252e98f07f},
  {"1.0 / y", [](double, double y) { return 1 / positiveZero(y); }, 6e-8, 0, always, 0xf6ede35d67333ab6},
  {"sqrt(x)", [](double x, double) { return std::sqrt(x); }, 6e-8, 0, notTiny, 0xe0ed99732ed908de},
  {"inversesqrt(x)", [](double x, double) { return 1 / std::sqrt(x); }, 3e-7, 0, notTiny, 0x94b75f07cab21a62},
  {"sin(x)", [](double x, double) { return std::sin(x); }, 3e-7, 3e-7, always, 0x87e338b724edd416},
  {"cos(x)", [](double x, double) { return std::cos(x); }, 0, 4e-6, always, 0x2f6645cb9bd892a5},
  {"tan(x)", [](double x, double) { return std::tan(x); }, 1e-6, 1e-6, [](double x, double) { return below(x, 1.2); }, 0xa31705fa1462d276},
  {"asin(x)", [](double x, double) { return std::asin(x); }, 1e-6, 1e-6, always, 0xfc391ec9ee19e874},
  {"acos(x)", [](double x, double) { return std::acos(x); }, 0, 1e-6, always, 0x9800542ef7030974},
  {"atan(x)", [](double x, double) { return std::atan(x); }, 4e-7, 0, always, 0x27c72b793667e964},
  {"atan(y, x)", [](double x, double y) { return std::atan2(y, x); }, 4e-7, 4e-7,
   [](double x, double y) { return (std::isfinite(x) || std::isfinite(y)) && (x != 0 || !std::isnan(y)) && below(x, 1e37) && below(y, 1e37) && notTiny(x, y) && (x != 0 || y != 0); }, 0xc775cfc999914efd},
  {"exp(x)", [](double x, double) { return std::exp(x); }, 4e-6, 1e-29, always, 0x2ed9a9332eb7d2c4},
  {"exp2(x)", [](double x, double) { return std::exp2(x); }, 5e-7, 0, always, 0x9c96aee2815ca868},
  {"log(x)", [](double x, double) { return std::log(x); }, 3e-7, 1e-7, notTiny, 0x23f94d03362930bc},
  {"log2(x)", [](double x, double) { return std::log2(x); }, 3e-7, 1e-7, notTiny, 0x471366f45da40b00},
  {"pow(x, y)", [](double x, double y) { return std::pow(x, y); }, 5e-6, 1e-29,
   [](double x, double y) { return (positive(x, y) && std::isfinite(x) && below(y * std::log(x), 60)); }, 0x4776e2ec63b3ed2},
  {"sinh(x)", [](double x, double) { return std::sinh(x); }, 5e-6, 0, [](double x, double) { return !(std::abs(x) > 88.7); }, 0xc6a38b7fd09cac3},
  {"cosh(x)", [](double x, double) { return std::cosh(x); }, 5e-6, 0, [](double x, double) { return !(std::abs(x) > 88.7); }, 0x420c23cf78c680f6},
  {"tanh(x)", [](double x, double) { return std::tanh(x); }, 2e-6, 0, always, 0x1c0e7b3a225c83eb},
  {"asinh(x)", [](double x, double) { return std::asinh(x); }, 1e-6, 3e-7, [](double x, double) { return below(x, 1e18); }, 0x332ed3a480ec3efd},
  {"acosh(x)", [](double x, double) { return std::acosh(x); }, 1e-6, 4e-4, [](double x, double) { return below(x, 1e18); }, 0xc3325b26d56e6889},
  {"atanh(x)", [](double x, double) { return std::atanh(x); }, 1e-6, 3e-7, [](double x, double) { return below(x, 0.99); }, 0x81b51c510f327a7c},
  {"mod(x, y)", [](double x, double y) { return x - y * std::floor(x / y); }, 0, 0, [](double, double) { return false; }, 0x5986f33707e6f3bc},
  {"floor(x)", [](double x, double) { return std::floor(x); }, 0, 0, always, 0x91813322f5f3bcaa},
  {"ceil(x)", [](double x, double) { return std::ceil(x); }, 0, 0, always, 0xfede31ed202e8d60},
  {"trunc(x)", [](double x, double) { return std::trunc(x); }, 0, 0, always, 0x49ec33d01d81e216},
  {"round(x)", [](double x, double) { return std::nearbyint(x); }, 0, 0, always, 0xb3a9b697d4799c88},
  {"fract(x)", [](double x, double) { return x - std::floor(x); }, 0, 6e-8, [](double x, double) { return std::isfinite(x); }, 0xbeaf2ff1ed17d75},
  {"abs(x)", [](double x, double) { return std::abs(x); }, 0, 0, always, 0xcf49ac7841ec85dd},
  {"sign(x)", [](double x, double) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }, 0, 0, always, 0x40f6a3a4ce872325},
  {"min(x, y)", minimum, 0, 0, always, 0xe3098bb3f40a4621},
  {"max(x, y)", greatest, 0, 0, always, 0x21fca58fe2dbc539},
  {"clamp(x, -1.5, 2.5)", [](double x, double) { return minimum(greatest(x, -1.5), 2.5); }, 0, 0, always, 0xfa4f72682894bc40},
  {"step(x, y)", [](double x, double y) { return y < x ? 0.0 : 1.0; }, 0, 0, [](double x, double y) { return !std::isnan(x) && !std::isnan(y); }, 0x3fe2444c75072325},
  {"smoothstep(-2.0, 3.0, x)", [](double x, double) { const double t = std::clamp((x + 2) / 5, 0.0, 1.0); return t * t * (3 - 2 * t); }, 1e-6, 1e-6, [](double x, double) { return std::isfinite(x); }, 0x28f5430e8e150894},
  {"mix(x, y, 0.3)", [](double x, double y) { return x + rounded(y - x) * static_cast<double>(third); }, 2e-7, 0,
   [](double x, double y) { return below(x, 1e37) && below(y, 1e37) && x * y >= 0; }, 0x77b03cb73aca281},
  {"fma(x, y, 2.0)", [](double x, double y) { return x * y + 2; }, 1.3e-7, 1e-7, [](double x, double y) { return below(x * y, 1) || x * y > 1; }, 0xb67726b38e91cc00},
  {"length(vec2(x, y))", [](double x, double y) { return std::sqrt(x * x + y * y); }, 5e-7, 2e-15, [](double x, double y) { return below(x, 1e18) && below(y, 1e18); }, 0x7f82ec5ffd879824},
  {"normalize(vec3(x, y, 2.0)).x", [](double x, double y) { return x / std::sqrt(x * x + y * y + 4); }, 8e-7, 0, [](double x, double y) { return below(x, 1e18) && below(y, 1e18); }, 0x889ea5b90297ad1},
  {"distance(vec2(x, 1.0), vec2(1.0, x))", [](double x, double) { return std::sqrt(2.0) * std::abs(x - 1); }, 8e-7, 0, [](double x, double) { return below(x, 1e18); }, 0xc57f9f6b1dd3ebad},
  {"dot(vec3(x, y, 1.0), vec3(x, y, 1.0))", [](double x, double y) { return x * x + y * y + 1; }, 3e-7, 0, always, 0xd32918ace1674348},
  {"dot(vec4(x, y, x, y), vec4(1.0, 2.0, 3.0, 4.0))", [](double x, double y) { return 4 * x + 6 * y; }, 5e-7, 0, [](double x, double y) { return x * y >= 0 && below(x, 1e37) && below(y, 1e37); }, 0x51b57df08c8f34c9},
  {"cross(vec3(x, y, 1.0), vec3(-y, x, 0.0)).z", [](double x, double y) { return x * x + y * y; }, 3e-7, 0, always, 0x989a66663b67d1d},
  {"reflect(vec2(x, y), vec2(0.0, 1.0)).y", [](double, double y) { return -y; }, 0, 0, [](double x, double y) { return below(x, 1e37) && below(y, 1e37); }, 0x451473ee5cfbdd1b},
  {"refract(vec2(0.6, -0.8), vec2(0.0, 1.0), 0.5).x", [](double, double) { return 0.3; }, 3e-7, 0, always, 0x9d11e5057eb02325},
  {"(mat2(x, 0.0, 1.0, y) * vec2(2.0, 0.5)).y", [](double, double y) { return y / 2; }, 0, 0, [](double x, double) { return std::isfinite(x); }, 0xb9f852c9345311d5},
  {"(mat3(x) * mat3(y))[2].z", [](double x, double y) { return x * y; }, 6e-8, 0, [](double x, double y) { return std::isfinite(x) && std::isfinite(y); }, 0xa6ad24aba211be87},
  {"determinant(mat2(x, 2.0, 1.0, y))", [](double x, double y) { return x * y - 2; }, 2e-7, 3e-7, always, 0x2829969b40c9808f},
  {"inverse(mat3(x, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0))[0].x", [](double x, double) { return 1 / x; }, 1e-6, 0, [](double x, double) { return below(x, 1e18) && std::abs(x) > 1e-15; }, 0x475371a182ee1b8a},
  {"float(int(x))", [](double x, double) { return rounded(toInt(x)); }, 0, 0, always, 0xe064acb1f256fd7b},
  {"float(uint(x))", [](double x, double) { return rounded(toUint(x)); }, 0, 0, always, 0xce99758c2338632},
  {"ldexp(x, int(clamp(y, -40.0, 40.0)))", [](double x, double y) { return std::ldexp(x, static_cast<int>(minimum(greatest(y, -40.0), 40.0))); }, 0, 0, [](double, double y) { return !std::isnan(y); }, 0x11bf42b4b8dbb4e9},
  {"unpackHalf2x16(packHalf2x16(vec2(x, y))).x", [](double x, double) { return x; }, 4.9e-4, 3e-8, [](double x, double) { return !(std::abs(x) > 65504); }, 0x7bb1e60e6d8e325},
  {"uintBitsToFloat(floatBitsToUint(x) / floatBitsToUint(y))", [](double x, double y) { return bits(bits(y) == 0 ? UINT32_MAX : bits(x) / bits(y)); }, 0, 0, always, 0xa895a297019cb9a2},
  {"uintBitsToFloat(floatBitsToUint(x) % floatBitsToUint(y))", [](double x, double y) { return bits(bits(y) == 0 ? UINT32_MAX : bits(x) % bits(y)); }, 0, 0, always, 0xde2be5cc31b1dda2},
  {"intBitsToFloat(floatBitsToInt(x) / (floatBitsToInt(y) >> 9))", [](double x, double y) {
     const auto a = std::bit_cast<std::int32_t>(bits(x)), b = std::bit_cast<std::int32_t>(bits(y)) >> 9;
     return bits(static_cast<std::uint32_t>(b == 0 ? -1 : static_cast<std::int64_t>(a) / b)); }, 0, 0, always, 0x31b1dabfb38755d3},
  {"intBitsToFloat(floatBitsToInt(x) % (floatBitsToInt(y) >> 9))", [](double x, double y) {
     const auto a = std::bit_cast<std::int32_t>(bits(x)), b = std::bit_cast<std::int32_t>(bits(y)) >> 9;
     return bits(static_cast<std::uint32_t>(b == 0 ? -1 : static_cast<std::int64_t>(a) % b)); }, 0, 0, always, 0x928074e19927147},
  {"uintBitsToFloat(floatBitsToUint(x) << floatBitsToUint(y))", [](double x, double y) { return bits(bits(x) << (bits(y) & 31U)); }, 0, 0, always, 0xed78d22a101439fd},
  {"intBitsToFloat(floatBitsToInt(x) >> floatBitsToInt(y))", [](double x, double y) {
     return bits(static_cast<std::uint32_t>(std::bit_cast<std::int32_t>(bits(x)) >> (bits(y) & 31U))); }, 0, 0, always, 0x66f7b686dbe06738},
};
// clang-format on

/// Returns pairs of numbers. All pairs of edge cases come first. Then the numbers alternate between
/// arbitrary bits, moderate magnitudes, and the range -10 to 10. Numbers below 1e-30 become zero, because
/// the functions treat them as zero.
std::vector<float> inputs(std::size_t count) {
  std::vector<float> edges = {
      0,     1,           0.5F,      2,     3,      1e-30F,     1e30F,    1.1e30F,       8e37F,
      3e38F, 1e-15F,      69,        88.9F, 127.5F, 1.5707964F, 16777216, 2147483648.0F, 4294967296.0F,
      1e10F, 0.99999994F, 1.0000001F};
  edges.push_back(std::numeric_limits<float>::infinity());
  for (std::size_t i = 0, n = edges.size(); i < n; ++i) edges.push_back(-edges[i]);
  edges.push_back(std::numeric_limits<float>::quiet_NaN());
  std::vector<float> pairs;
  for (const float x : edges)
    for (const float y : edges) pairs.insert(pairs.end(), {x, y});
  std::uint32_t state = 1;
  const auto next = [&] {
    state = state * 747796405U + 2891336453U;
    const std::uint32_t word = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
    return (word >> 22U) ^ word;
  };
  const auto one = [&](std::size_t kind) {
    const std::uint32_t word = next();
    if (kind == 0) return std::bit_cast<float>(word);
    if (kind == 1)
      return std::bit_cast<float>((word & 0x807fffffU) | ((110U + (word >> 23U) % 32U) << 23U));
    return static_cast<float>(static_cast<std::int32_t>(word)) * (10.0F / 2147483648.0F);
  };
  while (pairs.size() < 2 * count)
    for (std::size_t kind = 0; kind < 3; ++kind) pairs.insert(pairs.end(), {one(kind), one(kind)});
  pairs.resize(2 * count);
  for (float& x : pairs) {
    if (std::abs(x) < std::numeric_limits<float>::min()) x = 0;
    if (std::isnan(x)) x = std::numeric_limits<float>::quiet_NaN();
  }
  return pairs;
}

/// Returns the results of all functions for all pairs, ordered by function.
std::vector<float> results(const std::vector<float>& pairs) {
  const std::size_t count = pairs.size() / 2;
  std::string text =
      "#version 450\nlayout(local_size_x = 64) in;\nlayout(std430, binding = 0) buffer In { vec2 given[]; "
      "};\n"
      "layout(std430, binding = 1) buffer Out { float made[]; };\nlayout(std140, binding = 0) uniform U { "
      "uint n; };\n"
      "void main() { uint i = gl_GlobalInvocationID.x; if (i >= n) return; float x = given[i].x, y = "
      "given[i].y;\n";
  for (std::size_t i = 0; i < std::size(functions); ++i)
    text += fmt::format("  made[i + {}u * n] = {};\n", i, functions[i].expression);
  const kernels::Kernel kernel = guarded(text + "}\n", {}, "truth.comp");
  std::vector<float> given = pairs;
  given.resize(pairs.size() + 4);
  const gl::Buffer in = gl::Buffer::of<float>("in", given);
  const gl::Buffer out("out", (count * std::size(functions) + 2) * sizeof(float));
  const std::vector<std::uint32_t> sizes = {static_cast<std::uint32_t>(count), 0, 0, 0};
  const gl::Buffer block = gl::Buffer::of<std::uint32_t>("sizes", sizes);
  for (const kernels::Buffer& buffer : kernel.buffers)
    (buffer.name == "In" ? in : out).bindStorage(static_cast<GLuint>(buffer.binding));
  block.bindUniform(static_cast<GLuint>(kernel.blocks.at(0).binding), 0, 16);
  sim::kernelProgram("kernel", kernel.body()).dispatchGroups(static_cast<GLuint>((count + 63) / 64), 1, 1);
  gl::barrier();
  return out.readAll<float>();
}

bool right(float made, double truth, double relative, double absolute) {
  const double value = static_cast<double>(made);
  if (std::isnan(truth)) return std::isnan(value);
  if (std::isnan(value)) return false;
  const double maximum = static_cast<double>(std::numeric_limits<float>::max());
  if (std::abs(truth) > maximum * (1 - relative))
    return value == std::copysign(inf, truth) || std::abs(value / truth - 1) <= relative;
  return std::abs(value - truth) <= relative * std::abs(truth) + absolute + 1.01e-30 ||
         rounded(truth) == value;
}

void check(std::size_t count, std::size_t hashed) {
  const std::vector<float> pairs = inputs(count);
  const std::vector<float> made = results(pairs);
  for (std::size_t f = 0; f < std::size(functions); ++f) {
    const Function& function = functions[f];
    std::uint64_t hash = 0xcbf29ce484222325U;
    std::size_t wrong = 0, first = count;
    for (std::size_t i = 0; i < count; ++i) {
      const float value = made[f * count + i];
      const double x = static_cast<double>(pairs[2 * i]), y = static_cast<double>(pairs[2 * i + 1]);
      if (i < hashed)
        hash = (hash ^ (std::isnan(value) ? 0x7fc00000U
                        : value == 0      ? 0
                                          : std::bit_cast<std::uint32_t>(value))) *
               0x100000001b3U;
      if (!function.holds(x, y) || right(value, function.truth(x, y), function.relative, function.absolute))
        continue;
      if (wrong++ == 0) first = i;
    }
    INFO(std::string(function.expression));
    if (first < count) {
      INFO(fmt::format("x {} y {}: {} instead of {}", pairs[2 * first], pairs[2 * first + 1],
                       made[f * count + first],
                       function.truth(static_cast<double>(pairs[2 * first]),
                                      static_cast<double>(pairs[2 * first + 1]))));
      CHECK(wrong == 0);
    }
    CHECK(fmt::format("{:#x}", hash) == fmt::format("{:#x}", function.hash));
  }
}

}  // namespace

TEST_CASE("user kernels: every exact function is near the truth and has the same bits everywhere") {
  testContext();
  check(100'000, std::size_t{1} << 14U);
}

TEST_CASE("user kernels: reciprocals and roots are rounded to nearest for every mantissa") {
  testContext();
  constexpr std::uint32_t count = 1U << 22U;
  const kernels::Kernel kernel =
      guarded(fmt::format("#version 450\nlayout(local_size_x = 64) in;\n"
                          "layout(std430, binding = 0) buffer In {{ uint first[]; }};\n"
                          "layout(std430, binding = 1) buffer Out {{ vec2 made[]; }};\n"
                          "void main() {{ for (uint i = gl_GlobalInvocationID.x; i < {}u; i += 65536u) {{\n"
                          "  float x = uintBitsToFloat(first[0] + i);\n"
                          "  made[i] = vec2(1.0 / x, sqrt(x));\n}} }}\n",
                          count),
              {}, "mantissas.comp");
  const gl::Buffer out("out", (count + 2) * sizeof(glm::vec2));
  const gl::Program program = sim::kernelProgram("kernel", kernel.body());
  // Quarters of the range from 1 to 4
  for (std::uint32_t part = 0; part < 4; ++part) {
    const std::uint32_t first = 0x3f800000U + part * count;
    const gl::Buffer in = gl::Buffer::of<std::uint32_t>("in", std::vector<std::uint32_t>{first, 0, 0, 0});
    for (const kernels::Buffer& buffer : kernel.buffers)
      (buffer.name == "In" ? in : out).bindStorage(static_cast<GLuint>(buffer.binding));
    program.dispatchGroups(1024, 1, 1);
    gl::barrier();
    const auto made = out.readAll<glm::vec2>();
    std::size_t wrong = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto x = std::bit_cast<float>(first + i);
      wrong += made[i].x == 1 / x && made[i].y == std::sqrt(x) ? 0U : 1U;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("user kernels: every exact function is near the truth for half a million pairs") {
  testContext();
  check(std::size_t{1} << 19U, std::size_t{1} << 14U);
}

}  // namespace simreel::test
