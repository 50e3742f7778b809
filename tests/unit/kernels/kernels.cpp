#include "kernels/kernels.hpp"

#include "base/error.hpp"
#include "unit/help.hpp"
#include "unit/kernels/shader_file.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;
using kernels::Shader;
using simreel::test::checkHas;
using simreel::test::has;
using simreel::test::loaded;

namespace {

constexpr const char* particles =
    "\xEF\xBB\xBF#pragma kernel Move LIMIT=3 TWICE\r\n"
    "#pragma kernel Clear\r\n"
    "#pragma multi_compile _ WINDY\r\n"
    "struct Particle { float3 position; float mass; uint2 cell[2]; };\r\n"
    "RWStructuredBuffer<Particle> _Particles;\r\n"
    "StructuredBuffer<float> _Masses;\r\n"
    "AppendStructuredBuffer<uint> _Found;\r\n"
    "RWTexture2D<float4> _Picture;\r\n"
    "Texture3D<float> _Field; SamplerState sampler_Field;\r\n"
    "CBUFFER_START(Settings)\r\n  float _Speed; float3 _Wind; float4x4 _Turn;\r\nCBUFFER_END\r\n"
    "int _Count;\r\n"
    "[numthreads(8, LIMIT_OR_2, 1)] void Move(uint3 id : SV_DispatchThreadID) {\r\n"
    "  if (id.x >= (uint)_Count) return;\r\n"
    "  Particle p = _Particles[id.x];\r\n"
    "  p.position += _Wind * _Speed * _Masses[id.x] + mul(_Turn, float4(p.position, 1)).xyz;\r\n"
    "#ifdef WINDY\r\n  p.position.x += _Field.SampleLevel(sampler_Field, p.position, 0);\r\n#endif\r\n"
    "  _Particles[id.x] = p; _Found.Append(id.x); _Picture[id.xy] = p.mass;\r\n}\r\n"
    "[numthreads(64, 1, 1)] void Clear(uint3 id : SV_DispatchThreadID) { _Particles[id.x].mass = 0; }\r\n";

std::string withLimit() {
  std::string text = particles;
  return text.replace(text.find("LIMIT_OR_2"), 10, "2");
}

}  // namespace

TEST_CASE("a shader's kernels have thread groups, buffers with members, textures and constants") {
  const Shader shader = loaded("a.compute", withLimit());
  REQUIRE(shader.kernels.size() == 2);
  CHECK(shader.language == "HLSL");
  CHECK(shader.keywords == std::vector<std::vector<std::string>>{{"_", "WINDY"}});
  const kernels::Kernel& move = shader.kernels[0];
  CHECK(move.name == "Move");
  CHECK(move.line == 1);
  CHECK(move.threads == std::array<unsigned, 3>{8, 2, 1});
  REQUIRE(move.buffers.size() == 4);
  CHECK(move.buffers[0].name == "_Particles");
  CHECK(move.buffers[0].reads);
  CHECK(move.buffers[0].writes);
  CHECK(move.buffers[0].guards == 2);
  const kernels::Member& element = move.buffers[0].members.at(0);
  CHECK(element.type == "Particle");
  CHECK(element.array == std::vector<std::size_t>{0});
  CHECK(element.stride == 32);
  REQUIRE(element.members.size() == 3);
  CHECK(element.members[0].type == "float3");
  CHECK(element.members[1].name == "mass");
  CHECK(element.members[1].offset == 12);
  CHECK(element.members[2].type == "uint2");
  CHECK(element.members[2].array == std::vector<std::size_t>{2});
  CHECK(!move.buffers[1].writes);
  CHECK(move.buffers[2].name == "_Found");
  CHECK(move.buffers[3].counterOf == "_Found");
  REQUIRE(move.textures.size() == 1);
  CHECK(move.textures[0].format == "rgba32f");
  CHECK(move.textures[0].writes);
  CHECK(!move.textures[0].reads);
  REQUIRE(move.blocks.size() == 2);
  const auto settings = std::find_if(move.blocks.begin(), move.blocks.end(),
                                     [](const kernels::Block& block) { return block.name == "Settings"; });
  REQUIRE(settings != move.blocks.end());
  CHECK(settings->members.at(1).offset == 16);
  CHECK(settings->members.at(2).type == "float4x4");
  CHECK(settings->members.at(2).bytes == 64);
  CHECK(shader.kernels[1].textures.empty());
}

TEST_CASE("a kernel has the axes along which it asks for its number") {
  const auto axes = [](const std::string& parameter, const std::string& index) {
    return loaded("axes.compute", "RWStructuredBuffer<float> _Out;\n[numthreads(1, 1, 1)] void K(" +
                                      parameter + ") { _Out[" + index + "] = 1; }\n")
        .kernels.at(0)
        .axes;
  };
  CHECK(axes("uint3 id : SV_DispatchThreadID", "0") == 0);
  CHECK(axes("uint3 id : SV_DispatchThreadID", "id.x") == 1);
  CHECK(axes("uint id : SV_DispatchThreadID", "id") == 1);
  CHECK(axes("uint3 id : SV_GroupID", "id.z * 4 + id.x") == 5);
  CHECK(axes("uint id : SV_GroupIndex", "id") == 0);
}

TEST_CASE("a keyword of multi_compile is chosen by name, and the first holds otherwise") {
  CHECK(loaded("b.compute", withLimit(), {"Move"}).kernels[0].textures.size() == 1);
  const Shader windy = loaded("c.compute", withLimit(), {"Move"}, {"WINDY"});
  REQUIRE(windy.kernels[0].textures.size() == 2);
  CHECK(windy.kernels[0].textures[1].name == "_Field");
  CHECK(windy.kernels[0].textures[1].type == "3D");
  CHECK_THROWS_WITH_AS(static_cast<void>(loaded("d.compute", withLimit(), {}, {"WINDZ"})),
                       doctest::Contains("did you mean \"WINDY\"?"), UserError);
}

TEST_CASE("what a shader's description is as JSON reads back as the same") {
  const std::string json = kernels::toJson(loaded("e.compute", withLimit()));
  CHECK(kernels::toJson(kernels::fromJson(json)) == json);
}

TEST_CASE("GLSL in OpenGL's and in Vulkan's style has a kernel main, push constants are a block") {
  const Shader gl = loaded("f.comp",
                           "#version 430\nlayout(local_size_x = 32) in;\nuniform float speed;\n"
                           "layout(std430, binding = 3) buffer Values { vec4 first; float values[]; };\n"
                           "void main() { values[gl_GlobalInvocationID.x] *= speed + first.x; }\n");
  CHECK(gl.language == "GLSL");
  CHECK(gl.kernels.at(0).name == "main");
  CHECK(gl.kernels[0].buffers.at(0).name == "Values");
  CHECK(gl.kernels[0].buffers[0].members.at(0).type == "vec4");
  CHECK(gl.kernels[0].buffers[0].members.at(1).offset == 16);
  CHECK(gl.kernels[0].blocks.at(0).members.at(0).name == "speed");
  const Shader vulkan = loaded("g.comp",
                               "#[compute]\n#version 450\nlayout(local_size_x = 4) in;\n"
                               "layout(push_constant) uniform Push { float a[3]; vec2 b; } push;\n"
                               "layout(set = 1, binding = 2) buffer Values { float values[]; };\n"
                               "void main() { values[gl_GlobalInvocationID.x] = push.a[1] + push.b.y; }\n");
  CHECK(vulkan.kernels.at(0).blocks.at(0).name == "Push");
  CHECK(vulkan.kernels[0].blocks[0].members.at(0).stride == 16);
  checkHas(vulkan.kernels[0].glsl, "std140) uniform Push");
}

TEST_CASE("each operation that a driver may choose is a call of its exact function, unless fast") {
  struct Case {
    const char *expression, *function;
  };
  static constexpr Case cases[] = {
      {"a / b", "xDiv"},
      {"a * 1e-25", "xMul"},
      {"fmod(a, b)", "xRem"},
      {"sqrt(a)", "xSqrt"},
      {"rsqrt(a)", "xInverseSqrt"},
      {"sin(a)", "xSin"},
      {"cos(a)", "xCos"},
      {"tan(a)", "xTan"},
      {"asin(a)", "xAsin"},
      {"acos(a)", "xAcos"},
      {"atan(a)", "xAtan"},
      {"atan2(a, b)", "xAtan2"},
      {"sinh(a)", "xSinh"},
      {"cosh(a)", "xCosh"},
      {"tanh(a)", "xTanh"},
      {"exp(a)", "xExp"},
      {"exp2(a)", "xExp2"},
      {"log(a)", "xLog"},
      {"log2(a)", "xLog2"},
      {"pow(a, b)", "xPow"},
      {"dot(v, w)", "xDot"},
      {"length(v)", "xLength"},
      {"distance(v, w)", "xDistance"},
      {"normalize(v).x", "xNormalize"},
      {"cross(v, w).x", "xCross"},
      {"reflect(v, w).x", "xReflect"},
      {"refract(v, w, a).x", "xRefract"},
      {"faceforward(v, w, v).x", "xFaceForward"},
      {"mul(m, v).x", "xTimes"},
      {"determinant(m)", "xDeterminant"},
      {"lerp(a, b, v.x)", "xMix"},
      {"smoothstep(a, b, v.x)", "xSmoothstep"},
      {"step(a, b)", "xStep"},
      {"min(a, b)", "xMin"},
      {"max(a, b)", "xMax"},
      {"clamp(a, b, v.x)", "xClamp"},
      {"frac(a)", "xFract"},
      {"sign(a)", "xSign"},
      {"mad(a, b, v.x)", "xFma"},
      {"ldexp(a, b)", "xExp2"},
      {"degrees(a)", "xDegrees"},
      {"radians(a)", "xRadians"},
      {"isnan(a) ? 1 : 2", "xIsNan"},
      {"isinf(a) ? 1 : 2", "xIsInf"},
      {"(int)a", "xToInt"},
      {"(uint)a", "xToUint"},
      {"i / j", "xSdiv"},
      {"i % j", "xSrem"},
      {"i % 3", "xSremBy"},
      {"(uint)i / (uint)j", "xUdiv"},
      {"(uint)i % (uint)j", "xUmod"},
      {"f16tof32(i)", "xUnpackHalf2x16"},
      {"f32tof16(a)", "xPackHalf2x16"},
  };
  std::string text =
      "RWStructuredBuffer<float> _Out; float a, b; float3 v, w; float3x3 m; int i, j;\n"
      "[numthreads(1, 1, 1)] void All() {\n";
  for (std::size_t i = 0; i < std::size(cases); ++i)
    text += fmt::format("  _Out[{}] = {};\n", i, cases[i].expression);
  text += "}\n";
  const std::string glsl = loaded("h.hlsl", text).kernels.at(0).glsl;
  const std::string fast = loaded("i.hlsl", text, {}, {}, true).kernels.at(0).glsl;
  for (const Case& one : cases) {
    CHECK_MESSAGE(has(glsl, std::string(" ") + one.function + "("), std::string(one.expression));
    CHECK_MESSAGE(!has(fast, one.function), std::string(one.expression));
  }
  checkHas(fast, "sin(");
  CHECK(simreel::test::isGlsl(glsl));
  CHECK(simreel::test::isGlsl(fast));
}

TEST_CASE("a whole number by a constant keeps its own division, a shift counts modulo 32") {
  const std::string glsl = loaded("j.hlsl",
                                  "RWStructuredBuffer<uint> _Out; uint a;\n"
                                  "[numthreads(1, 1, 1)] void K() { _Out[0] = a / 3 + (a << _Out[1]); }\n")
                               .kernels.at(0)
                               .glsl;
  CHECK(!has(glsl, "xUdiv"));
  checkHas(glsl, "& 31u");
}

TEST_CASE("an index of a buffer ends in a guard element, of shared memory in one more") {
  const std::string glsl =
      loaded("k.hlsl",
             "RWStructuredBuffer<float> _Out; groupshared float s[16]; uint n;\n"
             "[numthreads(16, 1, 1)] void K(uint i : SV_GroupIndex) {\n"
             "  s[i + n] = i; GroupMemoryBarrierWithGroupSync(); _Out[i * n] = s[n];\n}\n")
          .kernels.at(0)
          .glsl;
  checkHas(glsl, "shared float s[17]");
  checkHas(glsl, ".length()) - 2u");
  CHECK(simreel::test::isGlsl(glsl));
}

TEST_CASE("buffers whose elements have one type keep their own names") {
  const Shader shader = loaded(
      "l.hlsl", "RWStructuredBuffer<uint> _A, _B;\n[numthreads(1, 1, 1)] void K() { _A[0] = _B[1]; }\n");
  REQUIRE(shader.kernels.at(0).buffers.size() == 2);
  CHECK(shader.kernels[0].buffers[0].name == "_A");
  CHECK(shader.kernels[0].buffers[1].name == "_B");
}

TEST_CASE(
    "what Microsoft's compiler forgives is read: loop variables, long numbers, const globals, matrix "
    "elements") {
  const Shader shader = loaded("m.hlsl",
                               "const uint2 Resolution; float4x4 m; RWStructuredBuffer<float3> _Out;\n"
                               "float3 K(float3 x) { return x * 0x100000002; }\n"
                               "[numthreads(1, 1, 1)] void K(uint i : SV_GroupIndex) {\n"
                               "  for (uint j = 0; j < Resolution.x; j++) _Out[j] = K(m._m00_m10_m20);\n"
                               "  for (j = 0; j < 3; j++) _Out[j] += 1;\n}\n");
  CHECK(shader.kernels.at(0).name == "K");
  CHECK(shader.kernels[0].blocks.at(0).members.at(0).name == "Resolution");
  CHECK(simreel::test::isGlsl(shader.kernels[0].glsl));
}
TEST_CASE("a value that a loop leaves behind is also set where its test ends it") {
  const std::string text =
      "RWStructuredBuffer<float> _A; uint _N;\n"
      "float f(float a, uint n) { for (uint i = 0; i < n; ++i) { if (a > 3) return a; a += 1.5; } return "
      "7; }\n"
      "[numthreads(8, 1, 1)] void K(uint i : SV_DispatchThreadID) { _A[i] = f(_A[i], _N); }\n";
  for (const bool fast : {true, false}) {
    const std::string glsl = loaded("left.hlsl", text, {}, {}, fast).kernels.at(0).glsl;
    checkHas(glsl, "= false;");
    CHECK(simreel::test::isGlsl(glsl));
  }
}
