// Tests the checks that are compiled into users' kernels to detect mistakes.
#include "gpu/kernel_guards.hpp"

#include "gl/texture.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace simreel::test {

TEST_CASE("kernel guards: reads and writes one beyond each end are told with line, index and invocation") {
  testContext();
  const std::string source =
      "RWStructuredBuffer<uint> _A; RWStructuredBuffer<uint> _B; groupshared uint s[8];\n"
      "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID, uint l : SV_GroupIndex) {\n"
      "  s[l] = i; GroupMemoryBarrierWithGroupSync();\n"
      "  uint own[3] = {1, 2, 3};\n"
      "  if (i < 4) _B[i] = _A[(int)i - 1];\n"
      "  else if (i < 8) _B[i == 7 ? 16 : i] = 1;\n"
      "  else if (i < 12) _B[i] = s[l + 5];\n"
      "  else _B[i] = own[i - 12];\n}\n";
  const kernels::Kernel kernel = guarded(source, reporting());
  const Buffers given = {{"_A", counted(4)}, {"_B", Numbers(16)}};
  const Buffers made = ran(kernel, given, 2);
  CHECK(faults(kernel, made) ==
        "read _A:5 1 0 -1 -1; write _B:6 1 7 16 16; read s:7 1 11 8 8; read an array:8 1 15 3 3");
  CHECK(text(ran(guarded(source, {}), given, 2)["_B"]) == text(made.at("_B")));
}

TEST_CASE("kernel guards: the lowest invocation's own indices are told when the dispatch runs again") {
  testContext();
  const kernels::Kernel kernel = guarded(
      "RWStructuredBuffer<uint> _A;\n"
      "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n"
      "  if (i > 4) _A[40 - i] = 1; }\n",
      reporting());
  const Buffers given = {{"_A", Numbers(8)}};
  const Buffers made = ran(kernel, given, 4);
  CHECK(faults(kernel, made) == "write _A:3 27 5 9 35");
  Buffers again = given;
  again["report"] = untouched(kernel.places.size());
  again["report"][0] = 0x80000000U;
  again["report"][1] = made.at("report")[1];
  const Numbers words = ran(kernel, again, 4)["report"];
  CHECK(text(Numbers(words.begin(), words.begin() + 4)) == "2147483649 5 35 35");
}

TEST_CASE("kernel guards: texels beyond a picture read as zero, and are told with their axis") {
  testContext();
  const kernels::Kernel kernel = guarded(
      "RWTexture2D<uint> _Image; Texture2D<float> _Texels; RWStructuredBuffer<uint> _Out;\n"
      "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n"
      "  if (i < 6) _Out[i] = _Image[int2(3, (int)i - 3)];\n"
      "  else if (i < 10) _Out[i] = (uint)_Texels[uint2(i - 5, 1)];\n"
      "  else _Image[uint2(i - 10, 0)] = 7;\n}\n",
      reporting());
  const gl::Texture image = gl::Texture::image("image", GL_R32UI, 4, 4);
  const gl::Texture texels = gl::Texture::image("texels", GL_R32F, 4, 4);
  const Numbers full(16, 5);
  glTextureSubImage2D(image.name(), 0, 0, 0, 4, 4, GL_RED_INTEGER, GL_UNSIGNED_INT, full.data());
  const std::vector<float> nines(16, 9.0F);
  glTextureSubImage2D(texels.name(), 0, 0, 0, 4, 4, GL_RED, GL_FLOAT, nines.data());
  for (const kernels::Texture& texture : kernel.textures)
    if (texture.name == "_Image")
      glBindImageTexture(static_cast<GLuint>(texture.binding), image.name(), 0, GL_FALSE, 0, GL_READ_WRITE,
                         GL_R32UI);
    else
      texels.bind(static_cast<GLuint>(texture.binding));
  const Buffers made = ran(kernel, {{"_Out", Numbers(16)}}, 2);
  CHECK(faults(kernel, made) ==
        "read _Image.y:3 3 0 -3 -1; read _Texels.x:4 1 9 4 4; write _Image.x:5 2 14 4 5");
  CHECK(text(made.at("_Out")) == "0 0 0 5 5 5 9 9 9 0 0 0 0 0 0 0");
}

TEST_CASE("kernel guards: endless loops end at the limit, and loops around them with them") {
  testContext();
  const std::string source =
      "RWStructuredBuffer<uint> _A;\n"
      "uint Steps(uint x) { uint c = 0;\n"
      "  while (x != 1) { x = x % 2 == 0 ? x / 2 : 3 * x + 1; ++c; }\n"
      "  return c; }\n"
      "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n"
      "  _A[i] = Steps(i + 1);\n"
      "  if (i == 3) for (;;) { for (;;) {\n"
      "      if (_A[i] == 99) break; } if (_A[i] == 98) return; }\n"
      "  _A[i] += 1000;\n}\n";
  const kernels::Kernel kernel = guarded(source, reporting(50));
  const Buffers made = ran(kernel, {{"_A", Numbers(8)}}, 1);
  CHECK(text(made.at("_A")) == "1000 1001 1007 2 1005 1008 1016 1003");
  CHECK(faults(kernel, made) == "loop :7 1 3 50 50");
  // The Collatz sequence of 27 takes 111 steps.
  std::string more = source;
  more.replace(more.find("i + 1"), 5, "i + 24");
  more.replace(more.find("i == 3"), 6, "false");
  const kernels::Kernel ends = guarded(more, reporting(50));
  CHECK(faults(ends, ran(ends, {{"_A", Numbers(8)}}, 1)) == "loop :3 2 3 50 50");
  kernels::Request quiet;
  quiet.maxIterations = 1000;
  CHECK(ran(guarded(more, quiet), {{"_A", Numbers(8)}}, 1)["_A"] ==
        ran(guarded(more, {}), {{"_A", Numbers(8)}}, 1)["_A"]);
}

TEST_CASE("kernel guards: a loop within a function of GLSL ends, too") {
  testContext();
  const kernels::Kernel kernel = guarded(
      "#version 450\nlayout(local_size_x = 4) in;\n"
      "layout(std430, binding = 0) buffer Values { uint first; uint values[]; };\n"
      "uint f(uint n) {\n  for (;;) { if (values[n] > 100) return values[n]; values[n] += n; }\n}\n"
      "void main() { uint i = gl_GlobalInvocationID.x;\n"
      "  do { values[i] += f(i); } while (values[i] < 300); values[i + 4] = 1; }\n",
      reporting(80), "guards.comp");
  const Buffers made = ran(kernel, {{"Values", Numbers(7)}}, 1);
  CHECK(faults(kernel, made) == "loop :5 2 0 80 80; write values:8 2 2 6 7");
}

TEST_CASE("kernel guards: a buffer read as it was before the dispatch turns by one place exactly") {
  testContext();
  kernels::Request request;
  request.previous = {"_A", "Values"};
  const kernels::Kernel kernel = guarded(
      "RWStructuredBuffer<uint> _A;\n[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n"
      "  uint n, stride; _A.GetDimensions(n, stride); _A[i] = _A[(i + 1) % n] + _A[n + 3]; }\n",
      request);
  Numbers turned = counted(64, 1);
  turned.back() = 0;
  CHECK(text(ran(kernel, {{"_A", counted(64)}}, 8)["_A"]) == text(turned));
  const kernels::Kernel glsl = guarded(
      "#version 450\nlayout(local_size_x = 8) in;\n"
      "layout(std430, binding = 0) buffer Values { mat3 turn; vec2 pairs[]; } all;\n"
      "void main() { uint i = gl_GlobalInvocationID.x, n = all.pairs.length();\n"
      "  all.pairs[i] = all.pairs[(i + 1) % n].yx; }\n",
      request, "guards.comp");
  turned = counted(12 + 32, 2);
  std::copy_n(counted(12).begin(), 12, turned.begin());
  for (std::size_t i = 12; i < turned.size(); i += 2) std::swap(turned[i], turned[i + 1]);
  turned[12 + 30] = 13;
  turned[12 + 31] = 12;
  CHECK(text(ran(glsl, {{"Values", counted(12 + 32)}}, 2)["Values"]) == text(turned));
}

TEST_CASE(
    "kernel guards: a kernel that reads what others write has a race, one with two buffers has none") {
  testContext();
  const Buffers given = {{"_A", counted(32)}, {"_B", Numbers(32)}};
  const auto turn = [](const std::string& to) {
    return "RWStructuredBuffer<uint> _A, _B;\n"
           "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n"
           "  uint next = _A[(i + 1) % 32];\n  " +
           to + "[i] = next;\n}\n";
  };
  CHECK(races(turn("_B"), given, 4) == "");
  CHECK(races(turn("_A"), given, 4) == "race-read _A:3 32 0 0 31");
}

TEST_CASE(
    "kernel guards: an invocation that reads what it wrote itself has no race, nor have equal writes") {
  testContext();
  const Buffers given = {{"_A", counted(32)}, {"_B", Numbers(2)}};
  const auto kernel = [](const std::string& code) {
    return "RWStructuredBuffer<uint> _A, _B;\n"
           "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n" +
           code + "\n}\n";
  };
  CHECK(races(kernel("  _A[i] += 3; _A[i] *= 2; _B[0] = 5; _A[(i + 7) % 32] = (i + 7) % 32;"), given, 4) !=
        "");
  CHECK(races(kernel("  _A[i] += 3; _A[i] *= 2; _B[0] = 5;"), given, 4) == "");
  CHECK(races(kernel("  InterlockedAdd(_B[0], i); _A[i] = 4;"), given, 4) == "");
  CHECK(races(kernel("  _A[i + 32] = i;"), given, 4) == "");  // out-of-range writes are dropped
  CHECK(races(kernel("  if (i % 8 == 3)\n    _B[1] = i;"), given, 4) == "race-write _B:4 3 3 27 1");
  // One of the two invocations stores a value that is already there, so only the other invocation counts.
  CHECK(races(kernel("  if (i % 16 == 3)\n    _B[1] = i - 3;"), given, 4) == "race-write _B:4 1 3 19 1");
}

namespace {

/// Returns the source of a kernel in the style of tutorials. The kernel computes spring forces between
/// neighbouring particles of an 8 x 8 cloth.
std::string cloth(const std::string& in, const std::string& out) {
  return "struct Particle { float3 position; float invMass; float3 velocity; float padding; };\n"
         "RWStructuredBuffer<Particle> " +
         (in == out ? in : in + ", " + out) +
         ";\n"
         "float3 Force(float3 a, int x, int y) {\n"
         "  if (x < 0 || y < 0 || x > 7 || y > 7) return 0;\n"
         "  float3 d = " +
         in +
         "[y * 8 + x].position - a;\n"
         "  return 50 * (length(d) - 0.1) * normalize(d); }\n"
         "[numthreads(8, 1, 1)] void K(uint3 id : SV_DispatchThreadID) {\n"
         "  int x = id.x % 8, y = id.x / 8; Particle p = " +
         in +
         "[id.x];\n"
         "  if (p.invMass <= 0) return;\n"
         "  float3 f = float3(0, -9.81, 0);\n"
         "  for (int k = -1; k <= 1; k += 2) f += Force(p.position, x + k, y) + Force(p.position, x, y + "
         "k);\n"
         "  p.velocity += f * 0.01; p.position += p.velocity * 0.01;\n  " +
         out + "[id.x] = p;\n}\n";
}

Numbers particles() {
  std::vector<float> values;
  for (int i = 0; i < 64; ++i)
    values.insert(values.end(), {0.1F * static_cast<float>(i % 8), 0.12F * static_cast<float>(i / 8), 0.0F,
                                 i < 8 ? 0.0F : 1.0F, 0.0F, 0.0F, 0.0F, 0.0F});
  Numbers words;
  for (const float value : values) words.push_back(std::bit_cast<std::uint32_t>(value));
  return words;
}

}  // namespace

TEST_CASE("kernel guards: a cloth in one buffer has a race, in two or read as before it has none") {
  testContext();
  const Buffers given = {{"_A", particles()}, {"_B", particles()}};
  CHECK(races(cloth("_A", "_B"), given, 8) == "");
  const std::string found = races(cloth("_A", "_A"), given, 8);
  CAPTURE(found);
  CHECK(found == "race-read _A.position:5 56 8 8 62");
}

TEST_CASE("kernel guards: instruments change no bits of a kernel without mistakes") {
  testContext();
  const Buffers given = {{"_A", particles()}, {"_B", particles()}};
  const std::string source = cloth("_A", "_B");
  const std::string plain = text(ran(guarded(source, {}), given, 8)["_B"]);
  CHECK(plain != text(particles()));
  CHECK(text(ran(guarded(source, reporting(100)), given, 8)["_B"]) == plain);
  kernels::Request request;
  request.previous = {"_A"};
  CHECK(text(ran(guarded(cloth("_A", "_A"), request), given, 8)["_A"]) == plain);
  for (const kernels::Race race : {kernels::Race::record, kernels::Race::check}) {
    request = reporting(100);
    request.race = race;
    CHECK(text(ran(guarded(source, request), given, 8)["_B"]) == plain);
  }
}

TEST_CASE("kernel guards: Game of Life on one image has a race, on two it has none") {
  testContext();
  const auto life = [](const std::string& images, const std::string& in, const std::string& out) {
    return "RWTexture2D<uint> " + images +
           ";\n"
           "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n"
           "  int2 at = int2(i % 8, i / 8); uint n = 0;\n"
           "  for (int y = -1; y < 2; ++y) for (int x = -1; x < 2; ++x)\n"
           "    if (x != 0 || y != 0) n += " +
           in +
           "[(at + int2(x, y)) & 7];\n"
           "  uint alive = n == 3 || (n == 2 && " +
           in + "[at] == 1);\n  " + out + "[at] = alive;\n}\n";
  };
  const gl::Texture first = gl::Texture::image("first", GL_R32UI, 8, 8),
                    second = gl::Texture::image("second", GL_R32UI, 8, 8);
  const auto blinker = [&](const kernels::Kernel& kernel) {
    Numbers cells(64);
    cells[8 * 3 + 2] = cells[8 * 3 + 3] = cells[8 * 3 + 4] = 1;
    for (const gl::Texture* one : {&first, &second})
      glTextureSubImage2D(one->name(), 0, 0, 0, 8, 8, GL_RED_INTEGER, GL_UNSIGNED_INT, cells.data());
    for (const kernels::Texture& texture : kernel.textures)
      glBindImageTexture(static_cast<GLuint>(texture.binding),
                         texture.name == "_A" ? first.name() : second.name(), 0, GL_FALSE, 0, GL_READ_WRITE,
                         GL_R32UI);
  };
  CHECK(racesWith(blinker, life("_A, _B", "_A", "_B"), {}, 8) == "");
  const std::string found = racesWith(blinker, life("_A", "_A", "_A"), {}, 8);
  CHECK(found.starts_with("race-read _A:5 "));
}

TEST_CASE("kernel guards: words of GLSL's blocks have their own shadows, matrices by rows too") {
  testContext();
  const auto kernel = [](const std::string& code) {
    return "#version 450\nlayout(local_size_x = 4) in;\nstruct Body { vec3 at; float w; mat2x3 turn; };\n"
           "layout(std430, row_major) buffer Values { uint total; mat3 all; Body bodies[]; };\n"
           "void main() { uint i = gl_GlobalInvocationID.x; \n" +
           code + "\n}\n";
  };
  // Layout in words: 4 for the total and padding, 12 for a matrix, then 16 per body. A body has the members
  // `at` and `w`, and three rows of two numbers with padding.
  const Buffers given = {{"Values", counted(4 + 12 + 16 * 8)}};
  const auto racesOf = [&](const std::string& code) {
    return races(kernel(code), given, 2, "guards.comp");
  };
  CHECK(racesOf("bodies[i].at = vec3(total) + bodies[(i + 1) % 8].w;") == "");
  CHECK(racesOf("bodies[i].turn[1][2] = 5; bodies[i].at.x = bodies[(i + 1) % 8].turn[0][2] +\n"
                "  bodies[(i + 2) % 8].turn[1][1];") == "");
  CHECK(racesOf("bodies[i].turn[1][2] = i;\nbodies[i].at.x = bodies[(i + 1) % 8].turn[1][2];") ==
        "race-read bodies.turn:7 8 0 0 7");
  CHECK(racesOf("bodies[i].at.y = i;\nif (i == 2) all[1] = bodies[6].at;") ==
        "race-read bodies.at:7 1 2 6 6");
  CHECK(racesOf("if (i == 3) all[1] = vec3(total); if (i == 4) total = uint(all[2].x);") == "");
  CHECK(racesOf("if (i == 3) all[1] = vec3(total); if (i == 4)\n  total = 7 + uint(all[1].y);") ==
        "race-read total:6 1 3 4 0; race-read all:7 1 4 3 0");
}

TEST_CASE("kernel guards: a reduction in shared memory has a race where a barrier is missing") {
  testContext();
  const auto sums = [](const std::string& wait, const std::string& last) {
    return "RWStructuredBuffer<uint> _A; RWStructuredBuffer<uint> _B; groupshared uint s[16];\n"
           "[numthreads(16, 1, 1)] void K(uint i : SV_DispatchThreadID, uint l : SV_GroupIndex) {\n"
           "  s[l] = _A[i] + 1;\n  " +
           wait + "\n  for (uint k = 8; k > 0; k /= 2) {\n    if (l < k)\n      s[l] += s[l + k];\n    " +
           last + "\n  }\n  if (l == 0) _B[i / 16] = s[0];\n}\n";
  };
  const Buffers given = {{"_A", counted(48)}, {"_B", Numbers(3)}};
  const std::string barrier = "GroupMemoryBarrierWithGroupSync();";
  CHECK(races(sums(barrier, barrier), given, 3) == "");
  CHECK(races(sums("", barrier), given, 3).starts_with("race-"));
  CHECK(races(sums(barrier, ""), given, 3).starts_with("race-read s:7 "));
  kernels::Request request = reporting();
  request.race = kernels::Race::check;
  CHECK(text(ran(guarded(sums(barrier, barrier), request), given, 3)["_B"]) == "136 392 648");
}

TEST_CASE("kernel guards: a word of shared memory that is read and then written by another has a race") {
  testContext();
  const auto kernel = [](const std::string& wait) {
    return "RWStructuredBuffer<uint> _A; groupshared float3 s[8];\n"
           "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID, uint l : SV_GroupIndex) {\n"
           "  s[l] = l + 1; GroupMemoryBarrierWithGroupSync();\n"
           "  float y = s[(l + 7) % 8].y; " +
           wait + "\n  if (l == 5)\n    s[l].xy = y;\n  _A[i] = y;\n}\n";
  };
  const Buffers given = {{"_A", Numbers(16)}};
  CHECK(races(kernel("GroupMemoryBarrierWithGroupSync();"), given, 2) == "");
  CHECK(races(kernel(""), given, 2) == "race-write s:6 2 5 6 5");
}

}  // namespace simreel::test
