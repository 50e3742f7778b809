#include "base/error.hpp"
#include "kernels/kernels.hpp"
#include "unit/help.hpp"
#include "unit/kernels/shader_file.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::test {

namespace {

kernels::Shader guarded(const std::string& name, const std::string& text, kernels::Request request) {
  const TemporaryFile file(name, text);
  request.file = file.path();
  return kernels::loadHere(request);
}

std::string places(const kernels::Kernel& kernel) {
  std::string all;
  for (const kernels::Place& place : kernel.places)
    all += fmt::format("{} {}{}:{}; ", place.kind, place.what, place.part.empty() ? "" : "." + place.part,
                       place.line);
  return all;
}

constexpr const char* careless =
    "struct Particle { float3 position; uint cells[2]; };\n"
    "RWStructuredBuffer<Particle> _Particles; RWTexture2D<float4> _Image; groupshared float s[16];\n"
    "uint _Count;\n"
    "float Sum(uint n) { float sum = 0;\n"
    "  for (uint i = 0; i < n; ++i) sum += _Particles[i].position.x;\n"
    "  return sum; }\n"
    "[numthreads(16, 1, 1)] void K(uint3 id : SV_DispatchThreadID) {\n"
    "  if (id.x > 3) _Particles[id.x].cells[_Count] = 1;\n"
    "  s[id.x] = Sum(_Count);\n"
    "  while (_Count > 3) if (s[id.y] > 2) return;\n"
    "  [unroll] for (int k = 0; k < 3; ++k) _Particles[0].position[k] = 0;\n"
    "  _Image[id.xy] = _Image[uint2(1, 1)];\n}\n";

}  // namespace

TEST_CASE("a kernel that reports lists its places by kind, name and line, and has a block for them") {
  kernels::Request request;
  request.report = true;
  request.maxIterations = 1000;
  const kernels::Shader shader = guarded("m.hlsl", careless, request);
  const kernels::Kernel& kernel = shader.kernels.at(0);
  CHECK(places(kernel) ==
        "loop :5; loops :5; loop :10; loops :10; write _Particles:8; write cells:8; read _Particles:5; "
        "write s:9; read s:10; "
        "write _Particles:11; read _Image.x:12; read _Image.y:12; write _Image.x:12; write _Image.y:12; ");
  CHECK(kernel.report == 1);
  REQUIRE(kernel.buffers.size() == 1);
  CHECK(kernel.places[0].file.ends_with("m.hlsl"));
  checkHas(kernel.glsl, "binding = 1, std430) buffer simreel_Report");
  CHECK(isGlsl(kernel.glsl));
  CHECK(kernels::fromJson(kernels::toJson(shader)).kernels.at(0).places == kernel.places);
}

TEST_CASE("an index that optimizing makes a constant out of bounds is guarded like any other") {
  kernels::Request request;
  request.report = true;
  const kernels::Kernel kernel = guarded("c.hlsl",
                                         "RWStructuredBuffer<int> _Out;\n"
                                         "[numthreads(1, 1, 1)] void K(uint3 id : SV_DispatchThreadID) {\n"
                                         "  int own[4] = {1, 2, 3, 4}; int k = 31;\n"
                                         "  own[k & 7] = (int)id.x;\n"
                                         "  _Out[id.x] = own[id.x & 3];\n}\n",
                                         request)
                                     .kernels.at(0);
  CHECK(kernel.glsl.find("[7]") == std::string::npos);
  CHECK(places(kernel) == "write an array:4; write _Out:5; ");
}

TEST_CASE("a limit of iterations alone needs no block, and a kernel without either has none") {
  kernels::Request request;
  CHECK(guarded("n.hlsl", careless, request).kernels.at(0).report == -1);
  request.maxIterations = 1000;
  const kernels::Kernel kernel = guarded("o.hlsl", careless, request).kernels.at(0);
  CHECK(kernel.report == -1);
  CHECK(!has(kernel.glsl, "simreel_Report"));
  CHECK(isGlsl(kernel.glsl));
}

TEST_CASE("a loop that was to be unrolled and cannot be is limited, too") {
  kernels::Request request;
  request.report = true;
  request.maxIterations = 1000;
  const kernels::Kernel kernel =
      guarded("p.hlsl",
              "RWStructuredBuffer<uint> _A; uint _N;\n[numthreads(1, 1, 1)] void K() {\n"
              "  [unroll] for (uint i = 0; i < _N; ++i) _A[0] += i;\n}\n",
              request)
          .kernels.at(0);
  CHECK(places(kernel) == "loop :3; loops :3; read _A:3; ");
}

TEST_CASE("loops that count to a constant, indices in range and a second access at an index cost nothing") {
  kernels::Request request;
  request.report = true;
  request.maxIterations = 1000;
  const auto with = [&](const std::string& name, const std::string& code) {
    return guarded(name,
                   "RWStructuredBuffer<uint> _A; uint _N; groupshared uint s[64];\n"
                   "[numthreads(8, 8, 1)] void K(uint i : SV_DispatchThreadID, uint l : SV_GroupIndex, "
                   "uint3 t : "
                   "SV_GroupThreadID) {\n" +
                       code + "\n  GroupMemoryBarrierWithGroupSync(); _A[0] = s[l];\n}\n",
                   request)
        .kernels.at(0);
  };
  const kernels::Kernel counted = with("c.hlsl", "for (uint k = 0; k < 64; ++k) s[k] += k;");
  CHECK(places(counted) == "loops :3; write _A:4; ");
  CHECK(!has(counted.glsl, "simreel_left"));
  CHECK(places(with("d.hlsl", "for (int k = 63; k >= 0; k -= 3) s[_N] += k;")) ==
        "loops :3; read s:3; write _A:4; ");
  CHECK(places(with("e.hlsl", "for (int k = 0; k < 60; ++k) s[k + 4] += k;")) == "loops :3; write _A:4; ");
  CHECK(places(with("f.hlsl", "for (int k = 0; k < 60; ++k) s[k + 5] += k;")) ==
        "loops :3; read s:3; write _A:4; ");
  CHECK(places(with("g.hlsl", "for (int k = 0; k < 2000; ++k) _A[0] += k;")) ==
        "loop :3; loops :3; read _A:3; write _A:4; ");
  CHECK(places(with("h.hlsl", "for (uint k = 0; k < 64; ++k) { if (_A[0] == k) k += 2; }")) ==
        "loop :3; loops :3; read _A:3; write _A:4; ");
  CHECK(places(with("i.hlsl", "for (uint k = 0; k < 64; ++k) { if (_A[0] == k) break; }")) ==
        "loop :3; loops :3; read _A:3; write _A:4; ");
  CHECK(
      places(with("j.hlsl",
                  "s[l] = 1; s[t.y * 8 + t.x] = 2; s[_N & 63] = 3; s[min(_N, 63)] = 4; s[_N % 64] = 5;")) ==
      "write _A:4; ");
  CHECK(places(with("k.hlsl", "s[t.y * 9 + t.x] = 2;")) == "write s:3; write _A:4; ");
  CHECK(places(with("l.hlsl", "if (_N < 64) s[_N] = 1; else if (_N == 64) s[_N] = 2;")) ==
        "write s:3; write _A:4; ");
  CHECK(places(with("m.hlsl", "int k = (int)_N; if (k < 64) s[k] = 1;")) == "write s:3; write _A:4; ");
  CHECK(places(with("n.hlsl", "_A[i] = 1;\n if (i > 3) _A[i] += 2;\n _A[l] = 3;")) ==
        "write _A:3; write _A:5; write _A:6; ");
}

TEST_CASE("a buffer read as it was before the dispatch is two buffers, and counts no atomic operations") {
  const std::string text =
      "RWStructuredBuffer<uint> _A, _B;\n[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) {\n"
      "  _A[i] = _A[i + 1] + 1; _B[i] = 1;\n}\n";
  kernels::Request request;
  request.previous = {"_A", "_B", "_C"};
  request.report = true;
  const kernels::Kernel kernel = guarded("q.hlsl", text, request).kernels.at(0);
  REQUIRE(kernel.buffers.size() == 3);
  const kernels::Buffer& previous = kernel.buffers[2];
  CHECK(previous.name == "_A.previous");
  CHECK(previous.previousOf == "_A");
  CHECK(previous.reads);
  CHECK(!previous.writes);
  CHECK(previous.guards == 2);
  CHECK(previous.members.at(0).stride == 4);
  CHECK(kernel.buffers[0].writes);
  CHECK(!kernel.buffers[0].reads);
  CHECK(places(kernel) == "read _A:3; write _A:3; write _B:3; ");
  CHECK(isGlsl(kernel.glsl));
  std::string counts = text;
  counts.replace(counts.find("_B[i] = 1"), 9, "InterlockedAdd(_A[0], 1)");
  CHECK_THROWS_WITH_AS(static_cast<void>(guarded("r.hlsl", counts, request)),
                       doctest::Contains("r.hlsl:3:3: error: an atomic operation works on the present"),
                       UserError);
}

TEST_CASE(
    "a kernel that records has a shadow for each buffer and image it stores to, one that checks places") {
  const std::string text =
      "struct P { float3 at; uint id; }; RWStructuredBuffer<P> _P; RWTexture2D<float> _Image;\n"
      "RWStructuredBuffer<uint> _Count, _Read;\n"
      "[numthreads(8, 1, 1)] void K(uint3 i : SV_DispatchThreadID) {\n"
      "  _P[i.x].at = _P[i.x + 1].id; _Image[i.xy] = _Read[i.x];\n"
      "  InterlockedAdd(_Count[0], 1);\n}\n";
  kernels::Request request;
  request.race = kernels::Race::record;
  const kernels::Kernel records = guarded("s.hlsl", text, request).kernels.at(0);
  std::string shadows;
  for (const kernels::Buffer& buffer : records.buffers)
    if (!buffer.shadowOf.empty())
      shadows += fmt::format("{} of {}, {} words, {} guards; ", buffer.name, buffer.shadowOf,
                             buffer.shadowWords, buffer.guards);
  CHECK(shadows == "_P.shadow of _P, 3 words, 0 guards; _Image.shadow of _Image, 3 words, 0 guards; ");
  CHECK(records.report == -1);
  CHECK(isGlsl(records.glsl));
  request.race = kernels::Race::check;
  request.report = true;
  const kernels::Kernel checks = guarded("t.hlsl", text, request).kernels.at(0);
  CHECK(places(checks) == "race-read _P.id:4; race-write _P.at:4; race-write _Image:4; ");
  CHECK(checks.buffers.size() == records.buffers.size());
  CHECK(checks.report == 5);
  CHECK(isGlsl(checks.glsl));
}

}  // namespace simreel::test
