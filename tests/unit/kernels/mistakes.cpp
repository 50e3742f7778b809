#include "base/error.hpp"
#include "kernels/kernels.hpp"
#include "unit/help.hpp"
#include "unit/kernels/shader_file.hpp"

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <unistd.h>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;
using simreel::test::checkHas;
using simreel::test::has;

namespace {

/// Returns the error report for a text, without the folder of the text's file.
std::string report(const std::string& name, const std::string& text) {
  try {
    static_cast<void>(simreel::test::loaded(name, text));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    std::string message = error.what();
    const std::string folder =
        std::filesystem::temp_directory_path().string() + fmt::format("/simreel-{}-", ::getpid());
    for (auto at = message.find(folder); at != std::string::npos; at = message.find(folder))
      message.erase(at, folder.size());
    return message;
  }
  return "no error";
}

constexpr const char* head = "RWStructuredBuffer<float> _Out;\r\n[numthreads(1, 1, 1)]\r\n";

}  // namespace

TEST_CASE("a mistake in a shader is told with line, column and caret") {
  CHECK(report("a.hlsl", std::string(head) + "void K() {\r\n  _Out[0] = missing + 1;\r\n}\r\n") ==
        "a.hlsl:4:13: error: \"missing\" is not declared\n"
        "    _Out[0] = missing + 1;\n"
        "              ^~~~~~~");
  checkHas(report("b.comp", "#version 450\nlayout(local_size_x = 1) in;\nvoid main() { int a = b; }\n"),
           "b.comp:3:23: error: \"b\" is not declared\n");
}

TEST_CASE("what has not the same bits everywhere is refused where it stands") {
  checkHas(report("c.hlsl", std::string(head) + "void K() {\n  _Out[0] = WaveActiveSum(_Out[1]);\n}\n"),
           "c.hlsl:4:13: error: subgroup operations depend on the width");
  checkHas(
      report("d.comp",
             "#version 450\n#extension GL_EXT_shader_atomic_float : require\nlayout(local_size_x = 1) in;\n"
             "buffer B { float x[]; };\nvoid main() {\n  atomicAdd(x[0], 1.0);\n}\n"),
      "d.comp:6:3: error: atomic operations on floating numbers");
  checkHas(report("e.comp",
                  "#version 450\nlayout(local_size_x = 1) in;\nbuffer B { double x[]; };\n"
                  "void main() { x[0] = x[1] * 2.0; }\n"),
           "e.comp:3:12: error: numbers of 64 bits");
}

TEST_CASE(
    "ray queries are refused by their name in HLSL and in GLSL, and a constant buffer cannot be written") {
  checkHas(
      report("l.hlsl", "RaytracingAccelerationStructure scene;\n" + std::string(head) + "void K() {}\n"),
      "l.hlsl:1:1: error: \"RaytracingAccelerationStructure\": OpenGL has no ray queries");
  const std::string rays =
      report("m.comp", "#version 460\n#extension GL_EXT_ray_tracing : enable\nvoid main() {}\n");
  checkHas(rays, "m.comp:2:12: error: \"GL_EXT_ray_tracing\": OpenGL has no ray queries");
  CHECK(!has(rays, "extra tokens"));
  checkHas(report("n.hlsl", "cbuffer C { float a; }\n" + std::string(head) + "void K() { a = 1; }\n"),
           "a kernel cannot write to a constant");
}

TEST_CASE("groups without threads, large arrays and too much shared memory are refused at their lines") {
  const auto grouped = [](const std::string& threads) {
    return report("o.hlsl", "RWStructuredBuffer<float> _Out;\n[numthreads(" + threads +
                                ")] void K() { _Out[0] = 1; }\n");
  };
  for (const char* threads : {"0, 1, 1", "-1, 1, 1", "2048, 1, 1", "1, 1, 65", "64, 32, 1"}) {
    CAPTURE(threads);
    checkHas(grouped(threads), "o.hlsl:2:2: error: a group has 1 to 1024 threads");
  }
  CHECK(grouped("1024, 1, 1") == "no error");
  const std::string buffer = "RWStructuredBuffer<float> _Out;\n";
  checkHas(report("o.compute",
                  "#pragma kernel K\n" + buffer + "// [numthreads(1, 1, 1)]\nvoid K() { _Out[0] = 1; }\n"),
           "o.compute:4:6: error: kernel \"K\" has no [numthreads(x, y, z)] before it");
  CHECK(report("o.compute", "#pragma kernel K\n#define ROW [numthreads(8, 1, 1)]\n" + buffer +
                                "ROW\nvoid K() { _Out[0] = 1; }\n") == "no error");
  checkHas(report("p.hlsl",
                  std::string(head) + "void K() {\n  float a[1000000000]; a[0] = 1; _Out[0] = a[0];\n}\n"),
           "p.hlsl:4:9: error: \"a\" takes more than 1048576 bytes in each invocation; use a buffer");
  checkHas(report("q.hlsl", "groupshared float g[8193];\n" + std::string(head) +
                                "void K() { g[0] = 1; _Out[0] = g[1]; }\n"),
           "q.hlsl:1:19: error: the groups share 32772 bytes; OpenGL grants 32768");
}

TEST_CASE("a group size that the shader leaves to others is a mistake") {
  const std::string rest = "buffer B { float x[]; };\nvoid main() { x[0] = 1.0; }\n";
  checkHas(report("a.comp", "#version 450\n" + rest),
           "a.comp:1:1: error: the shader has no size of its groups");
  checkHas(report("b.comp", "#version 450\nlayout(local_size_x_id = 0) in;\n" + rest),
           "b.comp:2:8: error: a scene does not set the size of groups");
  CHECK(report("c.comp", "#version 450\nlayout(local_size_x = 8, local_size_y_id = 1) in;\n" + rest) ==
        "no error");
  checkHas(report("d.hlsl",
                  "cbuffer C { uint width; };\nRWStructuredBuffer<float> _Out;\n"
                  "[numthreads(width, 1, 1)] void K() { _Out[0] = 1; }\n"),
           "d.hlsl:3:13: error: the size of groups is a number, a macro or a static const");
  CHECK(report("e.compute",
               "#pragma kernel K\nuint width; RWStructuredBuffer<float> _Out;\n"
               "[numthreads(width, 1, 1)] void L() { _Out[0] = 2; }\n"
               "[numthreads(8, 1, 1)] void K() { _Out[0] = 1; }\n") == "no error");
}

TEST_CASE("lane numbers, float atomics, twofold declarations and derivatives are refused in plain words") {
  checkHas(report("r.hlsl", std::string(head) + "void K() {\n  _Out[0] = WaveGetLaneIndex();\n}\n"),
           "r.hlsl:4:13: error: subgroup operations depend on the width");
  checkHas(report("s.hlsl", std::string(head) + "void K() { InterlockedAdd(_Out[0], 1.5); }\n"),
           "atomic operations are for int and uint");
  checkHas(report("t.hlsl",
                  "RWStructuredBuffer<float> _Out;\n" + std::string(head) + "void K() { _Out[0] = 1; }\n"),
           "\"_Out\" is declared twice; a file that is included twice needs");
  checkHas(report("u.comp",
                  "#version 450\nlayout(local_size_x = 1) in;\nbuffer B { float x[]; };\n"
                  "void main() { x[0] = fwidth(x[1]); }\n"),
           "\"fwidth\": a compute shader has no neighbouring pixels");
}

TEST_CASE("a function that returns something or lacks semantics is no kernel") {
  const std::string helper = "[numthreads(16, 1, 1)] bool Above(float a, float b) { return a > b; }\n";
  const auto shader = simreel::test::loaded(
      "v.hlsl", helper + std::string(head) +
                    "void K(uint3 id : SV_DispatchThreadID) { _Out[id.x] = Above(id.x, 2); }\n");
  REQUIRE(shader.kernels.size() == 1);
  CHECK(shader.kernels[0].name == "K");
  checkHas(report("w.compute", "#pragma kernel Above\n" + helper),
           "\"Above\" is not a kernel; a kernel must return void");
}

TEST_CASE("a kernel without a function, and a file without kernels, are told") {
  CHECK(has(report("f.compute", "#pragma kernel Gone\n" + std::string(head) + "void K() {}\n"),
            "f.compute:1:16: error: the file has no function \"Gone\"\n"));
  checkHas(report("g.compute", "float x;\n"), "has no kernel: it needs a line \"#pragma kernel NAME\"");
}

TEST_CASE(
    "an include is read below the shader's folder and given folders alone, its mistakes at its lines") {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("simreel-{}-includes", ::getpid());
  std::filesystem::create_directories(folder / "shader");
  std::ofstream(folder / "shader" / "near.cginc") << "float twice(float x) {\n  return x * tow;\n}\n";
  std::ofstream(folder / "far.cginc") << "#define FAR 1\n";
  std::ofstream(folder / "shader" / "loop.cginc") << "#include \"loop.cginc\"\n";
  const auto messageFor = [&](const std::string& include, std::vector<std::filesystem::path> folders = {}) {
    std::ofstream(folder / "shader" / "k.compute") << "#pragma kernel K\n"
                                                   << include << "\n"
                                                   << head << "void K() { _Out[0] = 1; }\n";
    kernels::Request request;
    request.file = folder / "shader" / "k.compute";
    request.folders = std::move(folders);
    try {
      static_cast<void>(kernels::loadHere(request));
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string("fine");
  };
  checkHas(messageFor("#include \"near.cginc\""), "near.cginc:2:14: error: \"tow\" is not declared");
  checkHas(messageFor("#include \"../far.cginc\""),
           "k.compute:2:11: error: \"../far.cginc\" lies outside the folders");
  CHECK(messageFor("#include \"../far.cginc\"", {folder}) == "fine");
  checkHas(messageFor("#include \"gone.cginc\""), "\"gone.cginc\" is not in the shader's folder");
  checkHas(messageFor("#include \"/etc/passwd\""), "is not in the shader's folder");
  checkHas(messageFor("#include \"loop.cginc\""), "deep");
  CHECK(messageFor("#include \"UnityCG.cginc\"") == "fine");
  checkHas(messageFor("#include \"UnityDeferredLibrary.cginc\""),
           "is a file of Unity that simreel does not include");
  std::filesystem::create_directories(folder / "shader" / "Util");
  std::ofstream(folder / "shader" / "Util" / "Deep.hlsl") << "#define DEEP 1\n";
  CHECK(messageFor("#include \"Util\\Deep.hlsl\"") == "fine");
  CHECK(messageFor("#include \"util/deep.HLSL\"") == "fine");
  std::ofstream(folder / "shader" / "Util" / "deep.hlsl") << "#define DEEP 1\n";
  checkHas(messageFor("#include \"util/deep.HLSL\""), "is not in the shader's folder");
  std::ofstream(folder / "shader" / "both.cginc") << "#include \"near.cginc\"\n#include \"../far.cginc\"\n";
  CHECK(!has(messageFor("#include \"both.cginc\"", {folder}), "preceded by another token"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("a shader that calls itself, nests too deeply or is no text ends in one message") {
  checkHas(report("h.hlsl", std::string(head) + "void K() { K(); }\n"), "error: ");
  checkHas(
      report("i.comp",
             "#version 450\nlayout(local_size_x = 1) in;\nint f(int x);\nint g(int x) { return f(x); }\n"
             "int f(int x) { return g(x); }\nvoid main() { f(1); }\n"),
      "calls itself");
  checkHas(
      report("j.hlsl", std::string(head) + "void K() { _Out[0] = " + std::string(100000, '(') + "; }\n"),
      "brackets are nested more than");
  checkHas(report("k.hlsl", std::string("a\0b", 3)), "this is not a text file");
}

TEST_CASE("garbage and cut shaders end in a message, and no crash of the compiler reaches the program") {
  const std::string whole =
      "#pragma kernel K\nstruct P { float3 a; int b[4]; };\nRWStructuredBuffer<P> _P; Texture2D<float4> t; "
      "SamplerState s; groupshared float g[8];\n#define F(x) (x * 2)\n[numthreads(8, 1, 1)] void K(uint3 "
      "id : "
      "SV_DispatchThreadID) {\n  for (int i = 0; i < 4; i++) { _P[id.x].b[i] = F(i) + t.SampleLevel(s, "
      "0.5, 0).x; }\n}\n";
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    std::string text = whole;
    for (int i = 0; i < 1 + round % 4; ++i) {
      const std::size_t at = random() % text.size();
      if (round % 3 == 0) text.resize(std::max<std::size_t>(at, 1));
      if (round % 3 == 1) text[at] = static_cast<char>(33 + random() % 90);
      if (round % 3 == 2) text.erase(at, random() % 9);
      if (text.empty()) text = "x";
    }
    const simreel::test::TemporaryFile file("garbage.compute", text);
    kernels::Request request;
    request.file = file.path();
    try {
      static_cast<void>(kernels::load(request));
    } catch (const UserError& error) {
      CHECK_MESSAGE(error.code() == ExitCode::usage, text);
    }
  }
}
