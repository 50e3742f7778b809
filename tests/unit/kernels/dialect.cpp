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

/// Compiles a kernel K with the given declarations and body. Line 1 of the text declares the buffer _Out.
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

TEST_CASE("flat initializers fill arrays, vectors and structs in order") {
  const kernels::Kernel made = kernel(
      "struct Ray { float3 from; uint hits; float3 to; float last[2]; };\n"
      "static const float2 corners[] = {0, 0, 1, 0, 1, 1};\n#define N 2\n"
      "static const Ray rest = {1, 2, 3, 4, 5, 6, 7, 8, 9};",
      "  float m[N][2] = {i, 2, i + 1, 4}; float3 v = 5;\n"
      "  Ray one = {v + 1, i, v, m[1]  [0], 6};\n"
      "  _Out[i] = m[1][0] + m[0][1] + corners[2].y + rest.to.z + one.to.x + one.last[1] + rest.last[1];");
  checkHas(made.glsl, "+ 7.0");
  CHECK_THROWS_WITH_AS(static_cast<void>(kernel("", "  float m[2][2] = {1, 2, 3};\n  _Out[i] = m[0][0];")),
                       doctest::Contains("dialect.hlsl:3:"), UserError);
}

TEST_CASE("a vector given for a number, and a larger matrix, are shortened") {
  const kernels::Kernel made = kernel(
      "float4x4 _To; float3 unpacked(uint x) { return x * 0.5; }\n"
      "float3 turned(const uint n, float2 at, const float3x3 by) { return mul(by, float3(at, n)); }",
      "  uint2 two = uint2(i, 7); float4 at = i;\n"
      "  _Out[i] = unpacked(two).x + turned(two, at.xy, _To).y + turned(3, at.xy, (float3x3)_To).z;");
  CHECK(made.blocks.size() == 1);
  CHECK_THROWS_WITH_AS(static_cast<void>(kernel("float f(uint x) { return x; }", "  _Out[i] = f(1, 2);")),
                       doctest::Contains("\"f\" has no function with these arguments"), UserError);
}

TEST_CASE("a loop variable lives on behind its loop") {
  checkHas(
      kernel("",
             "  for (int n = 0, k = 3; n < 5; ++n) { if (_Out[n] > 2) break; k += n; }\n  _Out[i] = n + k;")
          .glsl,
      "for (");
}

TEST_CASE("interfaces are left out, and functions that a namespace and the file both have are different") {
  const kernels::Kernel made = kernel(
      "interface ICount { void Add(int n); }; interface IOther { void Set(int n); };\n"
      "class Count : ICount, IOther { int n; void Add(int m) { n += m; } void Set(int m) { n = m; } };\n"
      "namespace Tree { int leaf(int n) { return -n; } struct Node { int a; int next() { return leaf(a); } "
      "}; }\n"
      "int leaf(int n) { return n + 41; }",
      "  Count count; count.Set(1); count.Add(2); Tree::Node node; node.a = 5;\n"
      "  _Out[i] = count.n + leaf(1) + Tree::leaf(2) + node.next();");
  checkHas(made.glsl, "= 38.0;");
}

TEST_CASE("a static variable is initialized by a function, in each kernel") {
  const kernels::Shader shader = loaded(
      "s.compute",
      "#pragma kernel A\n#pragma kernel B\nstruct Hit { float at; uint what; };\nfloat _Far;\n"
      "Hit none() { Hit hit; hit.at = _Far; hit.what = 9; return hit; }\nconst static Hit first = none();\n"
      "RWStructuredBuffer<float> _Out;\n"
      "[numthreads(8, 1, 1)] void A(uint3 id : SV_DispatchThreadID) { _Out[id.x] = first.at + 1; }\n"
      "[numthreads(8, 1, 1)] void B(uint3 id : SV_DispatchThreadID) { _Out[id.x] = first.what; }\n");
  REQUIRE(shader.kernels.size() == 2);
  CHECK(shader.kernels[0].blocks.at(0).members.at(0).name == "_Far");
  checkHas(shader.kernels[1].glsl, "= 9.0;");
}

TEST_CASE("typed buffers are structured buffers") {
  const kernels::Kernel made =
      kernel("Buffer<float4> _From; RWBuffer<uint> _Counts;",
             "  InterlockedAdd(_Counts[i], 1); _Out[i] = _From[i].x + _From.Load(3).y + _Counts[0];");
  CHECK(made.textures.empty());
  REQUIRE(made.buffers.size() == 3);
}

TEST_CASE("functions of numbers take matrices, column by column") {
  const kernels::Kernel made =
      kernel("float2x2 _A, _B;",
             "  float2x2 m = min(_A, clamp(_B, _A, pow(_B, _A))); _Out[i] = m[0][1] + m[1][0];");
  checkHas(made.glsl, "xMin");
}

TEST_CASE("the attribute of a kernel may stand before the #include of its function") {
  const simreel::test::TemporaryFile body("body.hlsl",
                                          "void K(uint3 id : SV_DispatchThreadID) { _Out[id.x] = 1; }\n");
  CHECK(loaded("outer.compute",
               "#pragma kernel K\n#define ROW [numthreads(8, 1, 1)]\nRWStructuredBuffer<float> _Out;\nROW\n"
               "#include \"" +
                   body.path().filename().string() + "\"\n")
            .kernels.at(0)
            .threads[0] == 8);
}

TEST_CASE("an argument of another type for an inout parameter gets the result") {
  const kernels::Kernel made =
      kernel("bool moved(inout float2 at, float by) { at += by; return at.x > 3; }",
             "  int2 at = int2(i, 2); bool far = moved(at, 1.5); _Out[i] = at.x + at.y + (far ? 100 : 0);");
  checkHas(made.glsl, "xToInt");
  CHECK_THROWS_WITH_AS(static_cast<void>(kernel("void grow(inout float2 a) { a *= 2; }",
                                                "  int4 n = i;\n  grow(n.wy);\n  _Out[i] = n.y;")),
                       doctest::Contains("dialect.hlsl:4"), UserError);
}

TEST_CASE("an object ConstantBuffer<T> may be an argument of type T") {
  const kernels::Kernel made = kernel(
      "struct Given { uint shift; float scale; };\nConstantBuffer<Given> given : register(b1);\n"
      "float scaled(uint i, Given by) { return (i << by.shift) * by.scale; }",
      "  _Out[i] = scaled(i, given) + given.scale;");
  REQUIRE(made.blocks.size() == 1);
  REQUIRE(made.blocks[0].members.size() == 1);
  CHECK(made.blocks[0].members[0].name == "given");
  CHECK(made.blocks[0].members[0].members.at(1).name == "scale");
}

TEST_CASE("a variable of GLSL for OpenGL may be called sampler") {
  const kernels::Shader made =
      loaded("named.comp",
             "#version 450\nlayout(local_size_x = 8) in;\nlayout(binding = 0) uniform sampler2D sky;\n"
             "layout(std430, binding = 0) buffer Out { vec4 seen[]; };\n"
             "vec4 read(sampler2D sampler, vec2 at) { return textureLod(sampler, at, 0.0); }\n"
             "void main() { seen[gl_GlobalInvocationID.x] = read(sky, vec2(0.5)); }\n");
  CHECK(made.kernels.at(0).textures.at(0).name == "sky");
}
