// Kernels that users write, with the code that finds their mistakes.
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "gpu/context.hpp"
#include "kernels/kernels.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <climits>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

using namespace simreel;

namespace {

using Numbers = std::vector<std::uint32_t>;
using Buffers = std::map<std::string, Numbers>;

kernels::Kernel guarded(const std::string& text, kernels::Request request,
                        const std::string& name = "guards.hlsl") {
  const auto path = temporaryFile(name);
  std::ofstream(path) << text;
  request.file = path;
  kernels::Shader shader = kernels::load(request);
  std::filesystem::remove(path);
  return std::move(shader.kernels.at(0));
}

kernels::Request reporting(unsigned maxIterations = 0) {
  kernels::Request request;
  request.report = true;
  request.maxIterations = maxIterations;
  return request;
}

Numbers untouched(std::size_t places) {
  Numbers words;
  for (std::size_t i = 0; i < places; ++i)
    words.insert(words.end(),
                 {0, UINT32_MAX, static_cast<std::uint32_t>(INT_MAX), static_cast<std::uint32_t>(INT_MIN)});
  return words;
}

/// Runs a kernel on buffers of words, which get their guards here. The report comes back under its block's
/// name.
Buffers ran(const kernels::Kernel& kernel, const Buffers& given, GLuint groups) {
  std::vector<std::pair<const kernels::Buffer*, gl::Buffer>> bound;
  for (const kernels::Buffer& buffer : kernel.buffers) {
    Numbers words = given.at(buffer.previousOf.empty() ? buffer.name : buffer.previousOf);
    words.resize(words.size() + static_cast<std::size_t>(buffer.guards) *
                                    (buffer.members.back().stride / sizeof(std::uint32_t)));
    bound.emplace_back(&buffer, gl::Buffer::of<std::uint32_t>(buffer.name, words));
    bound.back().second.bindStorage(static_cast<GLuint>(buffer.binding));
  }
  const gl::Buffer report = gl::Buffer::of<std::uint32_t>(
      "report", given.contains("report") ? given.at("report") : untouched(kernel.places.size() + 1));
  if (kernel.report >= 0) report.bindStorage(static_cast<GLuint>(kernel.report));
  gl::Program::computeText("kernel", kernel.body()).dispatchGroups(groups, 1, 1);
  gl::barrier();
  Buffers made;
  for (const auto& one : bound) {
    if (!given.contains(one.first->name)) continue;
    Numbers words = one.second.readAll<std::uint32_t>();
    words.resize(given.at(one.first->name).size());
    made[one.first->name] = std::move(words);
  }
  made["report"] = report.readAll<std::uint32_t>();
  return made;
}

/// "kind what.part:line count invocation least greatest" of each place that something happened at.
std::string faults(const kernels::Kernel& kernel, const Buffers& made) {
  std::vector<std::string> lines;
  const Numbers& words = made.at("report");
  for (std::size_t i = 0; i < kernel.places.size(); ++i) {
    const kernels::Place& place = kernel.places[i];
    if (words[4 * i] != 0)
      lines.push_back(fmt::format("{} {}{}:{} {} {} {} {}", place.kind, place.what,
                                  place.part.empty() ? "" : "." + place.part, place.line, words[4 * i],
                                  words[4 * i + 1], static_cast<int>(words[4 * i + 2]),
                                  static_cast<int>(words[4 * i + 3])));
  }
  return fmt::format("{}", fmt::join(lines, "; "));
}

std::string text(const Numbers& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

Numbers counted(std::uint32_t n, std::uint32_t from = 0) {
  Numbers words(n);
  for (std::uint32_t i = 0; i < n; ++i) words[i] = from + i;
  return words;
}

}  // namespace

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
  // 27 takes 111 steps
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
