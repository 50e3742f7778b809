#include "base/error.hpp"
#include "kernels/kernels.hpp"
#include "unit/help.hpp"
#include "unit/kernels/shader_file.hpp"

#include <string>

#include <doctest/doctest.h>

using namespace simreel;
using simreel::test::checkHas;
using simreel::test::has;
using simreel::test::loaded;

namespace {

/// Compiles a kernel K from declarations and a body. Line 1 of the text declares the buffer _Out.
kernels::Kernel kernel(const std::string& declarations, const std::string& body) {
  const kernels::Shader shader = loaded(
      "dialect.hlsl", "RWStructuredBuffer<float> _Out; " + declarations +
                          "\n[numthreads(8, 1, 1)] void K(uint i : SV_GroupIndex) {\n" + body + "\n}\n");
  CHECK(simreel::test::isGlsl(shader.kernels.at(0).glsl));
  return shader.kernels[0];
}

}  // namespace

TEST_CASE("a constant that the kernel assigns to is a variable of each invocation, which begins with it") {
  const kernels::Kernel made = kernel(
      "CBUFFER_START(Other) float _Other; CBUFFER_END\nfloat _Seed, _Scale; uint4 _State[2]; float _Step;\n"
      "float next() { _Seed += 1.0; _State[1].x ^= 3; return _Seed * _Scale + _State[1].x; }\n"
      "void grow(inout float x) { x *= 2; }",
      "  grow(_Step); _Out[i] = next() + _Step + _Other;");
  REQUIRE(made.blocks.size() == 2);
  const kernels::Block& loose = made.blocks[0].name.empty() ? made.blocks[0] : made.blocks[1];
  REQUIRE(loose.members.size() == 4);
  CHECK(loose.members[0].name == "_Seed");
  CHECK(loose.members[1].name == "_Scale");
  CHECK(loose.members[2].name == "_State");
  CHECK(loose.members[3].name == "_Step");
}

TEST_CASE("unsigned int is uint, and groupshared variables leave the constant buffer that they are in") {
  const kernels::Kernel made = kernel(
      "cbuffer Sums { groupshared uint temp[8]; }\ncbuffer Mixed { float a; groupshared float more[2]; "
      "float b; };",
      "  unsigned int n = 3; unsigned m = (unsigned int)a; temp[i] = n + m; more[0] = b; _Out[i] = temp[7 "
      "- i] + more[1];");
  REQUIRE(made.blocks.size() == 1);
  CHECK(made.blocks[0].members.size() == 2);
  checkHas(made.glsl, "shared uint temp[9]");
}

TEST_CASE("the member Length of textures and buffers is their size") {
  checkHas(kernel("Texture2D<float4> _From; RWTexture3D<float> _Volume; StructuredBuffer<float4> _List;",
                  "  _Out[i] = _From.Length.x + _Volume.Length.z + _List.Length + _Out.Length;")
               .glsl,
           "textureSize(");
}

TEST_CASE("a macro that is defined again has its new text, and mistakes keep their lines") {
  checkHas(kernel("\n#define A 1\n#define A \\\n  77\n#define UNITY_REVERSED_Z 500",
                  "  _Out[i] = A + UNITY_REVERSED_Z;")
               .glsl,
           "577.0");
  CHECK_THROWS_WITH_AS(static_cast<void>(kernel("\n#define A 1\n#define A 2", "  _Out[i] = A + missing;")),
                       doctest::Contains("dialect.hlsl:5:17: error: \"missing\" is not declared"),
                       UserError);
}

TEST_CASE("select, and, or of HLSL 2021 work for each component; a function of the user's goes before") {
  kernel("float3 v;", "  _Out[i] = select(and(v > 0, or(v < 1, v == 4)), v, 1.0).x;");
  checkHas(kernel("float select(float a) { return a + 7; }", "  _Out[i] = select(_Out[i]);").glsl, "7.0");
}

TEST_CASE("methods of structs in a namespace find its functions") {
  CHECK(simreel::test::isGlsl(
      loaded("n.compute",
             "#pragma kernel K\nnamespace Bvh { struct Box { float low; };\n"
             "Box Merged(Box a, Box b) { Box c; c.low = min(a.low, b.low); return c; }\n"
             "struct Node { Box l, r; Box Around() { return Merged(l, r); } };\n}\n"
             "RWStructuredBuffer<Bvh::Node> _Nodes; RWStructuredBuffer<float> _Out;\n"
             "[numthreads(8, 1, 1)] void K(uint3 id : SV_DispatchThreadID) {\n"
             "  Bvh::Node node = _Nodes[id.x]; _Out[id.x] = node.Around().low; }\n")
          .kernels.at(0)
          .glsl));
}

TEST_CASE("samplers of Direct3D 9 are textures with a sampler") {
  const kernels::Shader shader =
      loaded("x.compute",
             "#pragma kernel K\nsampler2D _Lut; sampler3D _Noise; RWStructuredBuffer<float4> _Out;\n"
             "float4 Read(sampler2D from, float2 at) { return tex2Dlod(from, float4(at, 0, 0)); }\n"
             "[numthreads(8, 1, 1)] void K(uint3 id : SV_DispatchThreadID) {\n"
             "  _Out[id.x] = Read(_Lut, id.xy / 8.0) + tex3Dlod(_Noise, float4(id, 0)); }\n");
  REQUIRE(shader.kernels.at(0).textures.size() == 2);
  CHECK(shader.kernels[0].textures[0].name == "_Lut");
  CHECK(shader.kernels[0].textures[1].type == "3D");
}
