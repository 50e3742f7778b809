#include "base/error.hpp"
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/linked_program.hpp"
#include "gl/program.hpp"
#include "gl/rehearsal.hpp"
#include "gl/texture.hpp"
#include "gpu/context.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr const char* sumText =
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = 0) buffer Words { int words[]; };\n"
    "uniform int first;\nuniform int second;\n"
    "void main() { words[gl_WorkGroupID.x] = 10 * first + second; }\n";

int resultOf(const gl::Program& program) {
  const std::array<int, 1> none = {-1};
  const gl::Buffer words = gl::Buffer::of<int>("words", none);
  words.bindStorage(0);
  program.dispatch(1);
  gl::barrier();
  return words.readAll<int>().front();
}

}  // namespace

TEST_CASE("programs of equal source share one GL program and keep separate uniforms") {
  testContext();
  const gl::Program a = gl::Program::computeText("sum", sumText);
  const gl::Program b = gl::Program::computeText("sum", sumText);
  a.set("first", 1);
  a.set("second", 2);
  b.set("first", 3);
  b.set("second", 0);
  CHECK(a.name() == b.name());
  CHECK(resultOf(a) == 12);
  CHECK(resultOf(b) == 30);
  a.set("second", 4);
  CHECK(resultOf(b) == 30);
  CHECK(resultOf(a) == 14);
  {
    const gl::Program c = gl::Program::computeText("sum", sumText);
    c.set("first", 0);
    c.set("second", 9);
    CHECK(resultOf(c) == 9);
  }
  CHECK(resultOf(a) == 14);
}

TEST_CASE("an unset uniform that the shader reads is an error with file and name") {
  testContext();
  const gl::Program misspelt = gl::Program::computeText("sum", sumText);
  misspelt.set("first", 1);
  misspelt.set("secnd", 2);
  try {
    misspelt.dispatch(1);
    FAIL("it ran");
  } catch (const UserError& error) {
    CHECK(std::string(error.what()).find("glsl/sum reads the uniform \"second\"") != std::string::npos);
  }
  misspelt.set("second", 2);
  CHECK(resultOf(misspelt) == 12);
}

TEST_CASE("a program is linked at its first use") {
  testContext();
  const gl::Program wrong =
      gl::Program::computeText("wrong", "layout(local_size_x = 1) in;\nvoid main() { nowhere(); }\n");
  CHECK(static_cast<bool>(wrong));
  CHECK_THROWS(wrong.dispatch(1));
  CHECK(!static_cast<bool>(gl::Program()));
  try {
    testContext().check();
  } catch (const std::exception&) {  // Some drivers also report the failed compilation as a debug message.
  }
}

TEST_CASE("a rehearsal runs no kernel and records each once, with its bindings") {
  testContext();
  const std::string text = std::string(sumText) + "// of this test alone\n";
  const gl::Program program = gl::Program::computeText("rehearsed", text);
  program.set("first", 7);
  program.set("second", 0);
  const gl::Buffer texels("texels", 4096);
  const gl::Texture view = gl::Texture::view("texels", GL_RGBA32F, texels);
  {
    gl::Rehearsal rehearsal;
    view.bind(3);
    CHECK(resultOf(program) == -1);
    program.dispatchGroups(2, 1, 1);
    const auto kernels = rehearsal.extractKernels();
    REQUIRE(kernels.size() == 1);
    CHECK(kernels[0].program->label() == "rehearsed");
    CHECK(!kernels[0].program->linked());
    REQUIRE(kernels[0].uses.size() == 2);
    const gl::TextureShape shape = kernels[0].uses[0].textures.at(3);
    CHECK(shape.format == GL_RGBA32F);
    CHECK(shape.levels == 0);
    CHECK(shape.bufferBytes == 4096);
    CHECK(shape.viewBytes == 4096);
  }
  CHECK(resultOf(program) == 70);
}

TEST_CASE("a rehearsal of endless dispatches stops") {
  testContext();
  const gl::Program program = gl::Program::computeText("sum", sumText);
  gl::Rehearsal rehearsal;
  CHECK_THROWS([&] {
    for (int i = 0; i < 1000000; ++i) program.dispatchGroups(1, 1, 1);
  }());
}

TEST_CASE("an indirect dispatch runs the number of groups in its buffer") {
  testContext();
  for (const unsigned groups : {0U, 2U, 0U}) {
    const gl::Program program = gl::Program::computeText("sum", std::string(sumText) + "// indirect\n");
    program.set("first", 1);
    program.set("second", 0);
    const std::array<unsigned, 4> words = {9, groups, 1, 1};
    const gl::Buffer commands = gl::Buffer::of<unsigned>("commands", words);
    const std::array<int, 3> none = {-1, -1, -1};
    const gl::Buffer out = gl::Buffer::of<int>("words", none);
    out.bindStorage(0);
    program.dispatchIndirect(commands, sizeof(unsigned));
    gl::barrier();
    const std::vector<int> found = out.readAll<int>();
    CHECK(found[0] == (groups > 0 ? 10 : -1));
    CHECK(found[1] == (groups > 1 ? 10 : -1));
    CHECK(found[2] == -1);
  }
}
