#include "base/error.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/rehearsal.hpp"
#include "gpu/context.hpp"
#include "gpu/gl_calls.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

struct CopyKernel {
  static constexpr auto file = "copy";
  struct Variant {
    gl::Flag<"TWICE"> twice;
    gl::Choice<"STEP", 1, 2, 5> step;
  };
  struct Range {
    gl::Uniform<"first", int> first;
    gl::Uniform<"scale", float> scale;
  };
  Range range;
  gl::Out<"Words"> words;
  gl::In<"picture"> picture;
  gl::In<"level"> level;
};

const std::string copyText =
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = 1) buffer Words { float words[]; };\n"
    "layout(binding = 2) uniform samplerBuffer picture;\n"
    "layout(rgba32f, binding = 3) uniform readonly imageBuffer level;\n"
    "uniform int first;\n"
    "#ifdef TWICE\nuniform int STEP;\n#else\nuniform float scale;\n#endif\n"
    "void main() {\n"
    "  int i = int(gl_WorkGroupID.x);\n"
    "  words[i] = scale * texelFetch(picture, first + i).x + imageLoad(level, first + i).x;\n"
    "}\n";

struct Stage {
  std::array<glm::vec4, 3> numbers = {glm::vec4(1), glm::vec4(2), glm::vec4(3)};
  gl::Vec4Array picture{"picture", numbers};
  gl::Vec4Array level{"level", numbers};
  gl::Buffer words{"words", 8};

  [[nodiscard]] CopyKernel given(int first, float scale) const {
    return {.range = {.first = first, .scale = scale},
            .words = words,
            .picture = picture.view(),
            .level = level.view()};
  }
};

/// Returns copyText with one name replaced, to simulate a changed shader.
std::string renamed(const std::string& from, const std::string& to) {
  std::string text = copyText;
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string complaint(const std::string& text, const CopyKernel& given) {
  try {
    gl::Kernel<CopyKernel>::ofText(text.c_str()).dispatchGroups({2, 1, 1}, given);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a kernel finds uniforms, blocks, samplers and images by their names in the shader") {
  testContext();
  const Stage stage;
  const auto kernel = gl::Kernel<CopyKernel>::ofText(copyText.c_str());
  kernel.dispatchGroups({2, 1, 1}, stage.given(0, 10));
  CHECK(stage.words.readAll<float>() == std::vector<float>{11, 22});
  kernel.dispatchGroups({2, 1, 1}, stage.given(1, 100));
  CHECK(stage.words.readAll<float>() == std::vector<float>{202, 303});
  const auto other = gl::Kernel<CopyKernel>::ofText(copyText.c_str());
  other.dispatchGroups({1, 1, 1}, stage.given(0, 1));
  kernel.dispatchGroups({1, 1, 1}, stage.given(1, 100));
  CHECK(stage.words.readAll<float>().front() == 202);
}

TEST_CASE(
    "a renamed uniform, block, image or sampler stops a kernel at its first use, with file and name") {
  testContext();
  const Stage stage;
  for (const char* name : {"first", "Words", "level", "picture"}) {
    const std::string said = complaint(renamed(name, std::string(name) + "Renamed"), stage.given(0, 1));
    CAPTURE(said);
    CHECK(said.find("glsl/copy declares no ") != std::string::npos);
    CHECK(said.find('"' + std::string(name) + '"') != std::string::npos);
  }
}

TEST_CASE("what a shader reads and a kernel is not given stops it, with file and name") {
  testContext();
  const Stage stage;
  CopyKernel given = stage.given(0, 1);
  given.range.first = {};
  CHECK(complaint(copyText, given).find("glsl/copy reads the uniform \"first\"") != std::string::npos);
  given = stage.given(0, 1);
  given.words = {};
  CHECK(complaint(copyText, given).find("glsl/copy reads the block \"Words\"") != std::string::npos);
  given = stage.given(0, 1);
  given.picture = {};
  CHECK(complaint(copyText, given).find("\"picture\"") != std::string::npos);
  const std::string more = renamed("first + i).x;", "first + i).x + other;") + "\n";
  const std::string text = "uniform float other;\n" + more;
  CHECK(complaint(text, stage.given(0, 1)).find("glsl/copy reads the uniform \"other\"") !=
        std::string::npos);
  CHECK(complaint(renamed("float scale", "int scale"), stage.given(0, 1)).find("another type") !=
        std::string::npos);
}

TEST_CASE("a name that the driver dropped may be given to a kernel") {
  testContext();
  const Stage stage;
  CHECK(complaint(renamed("scale * ", ""), stage.given(0, 1)).empty());
}

TEST_CASE("a kernel waits for what was written of what it reads, and makes no other barriers") {
  testContext();
  const Stage stage;
  const auto kernel = gl::Kernel<CopyKernel>::ofText(copyText.c_str());
  const gl::Texture words = gl::Texture::view("words", GL_R32F, stage.words, 4);
  kernel.dispatchGroups({1, 1, 1}, stage.given(0, 1));
  gl::barrier();
  const auto callsOf = [&](const CopyKernel& given) {
    const GlCalls calls;
    kernel.dispatchGroups({1, 1, 1}, given);
    return GlCalls::count;
  };
  const long without = callsOf(stage.given(0, 1));  // The dispatch writes resources that have not been
                                                    // accessed since the last barrier.
  CopyKernel reading = stage.given(0, 1);
  const gl::Buffer apart("words", 8);
  reading.words = apart;
  CHECK(callsOf(reading) == without);
  reading.picture = words;
  CHECK(callsOf(reading) == without + 1);
  CHECK(callsOf(stage.given(0, 1)) == without + 1);  // The dispatch needs a barrier after the read.
  gl::barrier();
  CHECK(callsOf(reading) == without);
}

namespace {

struct TallyKernel {
  static constexpr auto file = "copy";
  gl::Ambient<"First"> first = {};
  gl::Shared<"Words"> words;
};

const char* const tallyText =
    "layout(local_size_x = 1) in;\n"
    "layout(std140, binding = 5) uniform First { uint first; };\n"
    "layout(std430, binding = 1) buffer Words { uint words[]; };\n"
    "void main() { atomicAdd(words[0], first); }\n";

}  // namespace

TEST_CASE("kernels that share what they write do not wait for each other, but others do") {
  testContext();
  const Stage stage;
  const auto tally = gl::Kernel<TallyKernel>::ofText(tallyText);
  const auto kernel = gl::Kernel<CopyKernel>::ofText(copyText.c_str());
  const gl::Buffer first = gl::Buffer::of<GLuint>("first", std::array<GLuint, 4>{7, 0, 0, 0});
  const gl::Buffer words = gl::Buffer::of<GLuint>("words", std::array<GLuint, 2>{});
  first.bindUniform(5, 0, first.bytes());
  const auto callsOf = [&] {
    const GlCalls calls;
    tally.dispatchGroups({1, 1, 1}, {.words = words});
    return GlCalls::count;
  };
  gl::barrier();
  tally.dispatchGroups({1, 1, 1}, {.words = words});
  const long without = callsOf();
  CHECK(callsOf() == without);
  CHECK(words.readAll<GLuint>().front() == 21);
  CopyKernel copies = stage.given(0, 1);
  copies.words = words;
  kernel.dispatchGroups({1, 1, 1}, copies);
  CHECK(callsOf() == without + 1);
}

TEST_CASE("what may stay bound of a kernel's blocks is bound where a dispatch is given it") {
  testContext();
  const auto tally = gl::Kernel<TallyKernel>::ofText(tallyText);
  const gl::Buffer first = gl::Buffer::of<GLuint>("first", std::array<GLuint, 4>{5, 0, 0, 0});
  const gl::Buffer words = gl::Buffer::of<GLuint>("words", std::array<GLuint, 2>{});
  tally.dispatchGroups({1, 1, 1}, {.first = first, .words = words});
  tally.dispatchGroups({1, 1, 1}, {.words = words});
  CHECK(words.readAll<GLuint>().front() == 10);
}

TEST_CASE("a rehearsal notes a kernel once, with what it is given by name") {
  testContext();
  const Stage stage;
  const std::string text = copyText + "// of this test alone\n";
  const auto kernel = gl::Kernel<CopyKernel>::ofText(text.c_str());
  gl::Rehearsal rehearsal;
  kernel.dispatchGroups({2, 1, 1}, stage.given(0, 1));
  const auto kernels = rehearsal.extractKernels();
  REQUIRE(kernels.size() == 1);
  CHECK(kernels[0].program->label() == "copy");
  REQUIRE(kernels[0].uses.size() == 1);
  CHECK(kernels[0].uses[0].named.at("picture").shape.format == GL_RGBA32F);
  CHECK(kernels[0].uses[0].named.at("level").access == GL_READ_ONLY);
  CHECK(!kernels[0].program->linked());
}

TEST_CASE("a kernel's variants are known") {
  const auto all = gl::variantsOf<CopyKernel::Variant>();
  CHECK(all.size() == 6);
  CHECK(std::ranges::find(all, gl::Defines{{"TWICE", "1"}, {"STEP", "5"}}) != all.end());
}

TEST_CASE("all that the program's kernels name is declared in their shaders") {
  CHECK(gl::kernelInterfaces().size() > 3);
  for (const gl::KernelNames* names : gl::kernelInterfaces()) {
    const std::string file = names->file;
    CAPTURE(file);
    // Skips the inline text "copy" and the worked example, whose shaders are in another folder
    // (tests/example/heat.cpp).
    if (file == "copy" || file.starts_with("heat/")) continue;
    CHECK_NOTHROW(gl::checkDeclared(*names, gl::loadShader(file, {}).text));
  }
}
