#include "base/error.hpp"
#include "gl/condition.hpp"
#include "gl/element_array.hpp"
#include "gl/large_pages.hpp"
#include "gl/limits.hpp"
#include "gl/program.hpp"
#include "gl/shader_source.hpp"
#include "gl/texture.hpp"
#include "gpu/context.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <utility>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// A temporary folder of shaders. The environment variable SIMREEL_GLSL contains its path.
class ShaderFolder {
 public:
  ShaderFolder() : path_(temporaryFile("test_glsl")) {
    std::filesystem::create_directories(path_);
    setenv("SIMREEL_GLSL", path_.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
  }
  ~ShaderFolder() {
    unsetenv("SIMREEL_GLSL");  // NOLINT(concurrency-mt-unsafe): one thread
    std::filesystem::remove_all(path_);
  }
  ShaderFolder(const ShaderFolder&) = delete;
  ShaderFolder& operator=(const ShaderFolder&) = delete;
  void write(const char* name, const char* text) const { std::ofstream(path_ / name) << text; }

 private:
  std::filesystem::path path_;
};

std::string messageOf(const char* shader) {
  try {
    static_cast<void>(gl::Program::compute(shader).name());
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::device);
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("shader errors name the source file and line, also inside includes") {
  testContext();
  const ShaderFolder folder;
  folder.write(
      "part.glsl",
      "float half_(float x) {\n  return x * 0.5;\n}\nfloat broken(float x) { return nonsense; }\n");
  folder.write("good.comp", "layout(local_size_x = 1) in;\nvoid main() {}\n");
  folder.write("user.comp", "layout(local_size_x = 1) in;\n#include \"part.glsl\"\nvoid main() {}\n");
  folder.write("late.comp",
               "#include \"good2.glsl\"\nlayout(local_size_x = 1) in;\nvoid main() { wrong(); }\n");
  folder.write("good2.glsl", "float one() {\n  return 1.0;\n}\n");
  folder.write("missing.comp", "\n#include \"nowhere.glsl\"\nvoid main() {}\n");
  CHECK(messageOf("good.comp").empty());
  CHECK(messageOf("user.comp").find("glsl/part.glsl:4") != std::string::npos);
  CHECK(messageOf("late.comp").find("glsl/late.comp:3") != std::string::npos);
  CHECK(messageOf("missing.comp").find("nowhere.glsl") != std::string::npos);
  try {
    testContext().check();  // Some drivers also report the error here. It must not reach the next test.
  } catch (const UserError&) {
  }
}

TEST_CASE(
    "defines that a shader's files do not mention are removed, so that drivers compile each text once") {
  const ShaderFolder folder;
  folder.write("part.glsl", "const int part = IN_PART;  // not IN_COMMENT\n");
  folder.write("kernel.comp",
               "#include \"part.glsl\"\n#if IN_CONDITION == 1\nint x = IN_KERNEL;\n#endif\n");
  const std::string text = gl::loadShader("kernel.comp", {{"IN_PART", "1"},
                                                          {"IN_COMMENT", "2"},
                                                          {"IN_CONDITION", "3"},
                                                          {"IN_KERNEL", "IN_VALUE"},
                                                          {"IN_VALUE", "4"},
                                                          {"IN", "5"},
                                                          {"N_KERNEL", "6"},
                                                          {gl::extensionDefine, "GL_ARB_gpu_shader_int64"}})
                               .text;
  const auto defined = [&](const char* name) {
    return text.find(fmt::format("#define {} ", name)) != text.npos;
  };
  for (const char* name : {"IN_PART", "IN_CONDITION", "IN_KERNEL", "IN_VALUE"})
    CHECK_MESSAGE(defined(name), name);
  for (const char* name : {"IN_COMMENT", "IN", "N_KERNEL"}) CHECK_MESSAGE(!defined(name), name);
  CHECK(text.find("#version 450 core\n#extension GL_ARB_gpu_shader_int64 : require\n") == 0);
  CHECK(text == gl::loadShader("kernel.comp", {{"IN_PART", "1"},
                                               {"IN_CONDITION", "3"},
                                               {"IN_KERNEL", "IN_VALUE"},
                                               {"IN_VALUE", "4"},
                                               {"IN_COMMENT", "7"},
                                               {gl::extensionDefine, "GL_ARB_gpu_shader_int64"}})
                    .text);
}

TEST_CASE("a buffer keeps its contents when it is moved") {
  testContext();
  const std::array<int, 5> items = {1, 2, 3, 4, 5};
  auto buffer = gl::Buffer::of<int>("five", items);
  gl::Buffer other = std::move(buffer);
  CHECK(other.readAll<int>() == std::vector<int>(items.begin(), items.end()));
  CHECK(buffer.name() == 0);  // NOLINT(bugprone-use-after-move): that it is empty is the point
  other = gl::Buffer("zeros", 12);
  CHECK(other.readAll<int>() == std::vector<int>{0, 0, 0});
}

TEST_CASE("large buffers are written completely, at creation and later") {
  testContext();
  for (const std::size_t count :
       {std::size_t{1} << 20, (std::size_t{17} << 20) + 13}) {  // 4 MiB, and slightly more than 68 MiB
    CAPTURE(count);
    std::vector<int> items(count);
    for (std::size_t i = 0; i < count; ++i) items[i] = static_cast<int>(i * 2654435761U);
    CHECK((gl::Buffer::of<int>("large", items).readAll<int>() == items));
    gl::Buffer later("large, written later", count * sizeof(int));
    CHECK((later.readAll<int>() == std::vector<int>(count)));
    later.write(0, std::as_bytes(std::span(items)));
    CHECK((later.readAll<int>() == items));
    const std::array<int, 3> three = {1, 2, 3};
    later.write(4 * (count - 3), std::as_bytes(std::span(three)));
    std::copy(three.begin(), three.end(), items.end() - 3);
    CHECK((later.readAll<int>() == items));
  }
}

TEST_CASE("memory in large pages comes back: allocating many times the device memory succeeds") {
  testContext();
  constexpr std::size_t bytes = std::size_t{1} << 30;
  for (int i = 0; i < 256; ++i) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    const gl::Handle<gl::DeleteBuffer> buffer(name);
    const bool stored = gl::storeInLargePages(name, bytes);
    if (i == 0 && !stored) return;  // Skips the test if the driver does not support large pages.
    REQUIRE(stored);
    GLint64 has = 0;
    glGetNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &has);
    REQUIRE(has == static_cast<GLint64>(bytes));
  }
}

TEST_CASE("exceeding a limit is reported before memory is allocated") {
  testContext();
  const auto tooMany = static_cast<std::size_t>(gl::limits().storageBlockBytes) + 16;
  CHECK_THROWS_WITH_AS(gl::Buffer("sheet positions", tooMany),
                       doctest::Contains("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"), UserError);
  CHECK_THROWS_WITH_AS(gl::Texture::image("wide", GL_RGBA8, gl::limits().textureSize + 1, 1),
                       doctest::Contains("GL_MAX_TEXTURE_SIZE"), UserError);
  // A buffer that shaders read only as texels has the texel limit, which is larger on software drivers.
  if (tooMany > std::size_t{256} << 20 || gl::limits().texelBufferTexels < 1 << 27) return;
  const std::vector<glm::vec2> texels(tooMany / sizeof(glm::vec2));
  const gl::Buffer buffer = gl::Buffer::ofTexels<glm::vec2>("maps", texels);
  CHECK(buffer.bytes() == tooMany);
  CHECK(gl::Texture::view("maps", GL_RG32F, buffer, sizeof(glm::vec2)).name() != 0);
  CHECK_THROWS_WITH_AS(static_cast<void>(gl::Texture::view("maps", GL_R8UI, buffer, 1)),
                       doctest::Contains("GL_MAX_TEXTURE_BUFFER_SIZE"), UserError);
}

TEST_CASE("a conditional dispatch without groups is skipped, and no other GL state changes") {
  testContext();
  const gl::Program count = gl::Program::computeText(
      "count",
      "layout(local_size_x = 1) in;\nlayout(std430, binding = 0) buffer Counts { uint counts[]; };\n"
      "void main() { counts[3] += 1u; }\n");
  const gl::Condition condition;
  GLint before[4] = {}, after[4] = {};
  glGetIntegerv(GL_VIEWPORT, before);
  for (const unsigned groups : {0U, 1U, 5U}) {
    const unsigned words[] = {groups, 1, 1, 0};
    const gl::Buffer buffer = gl::Buffer::of<unsigned>("counts", words);
    const auto step = [&] {
      gl::barrier();
      count.use();
      buffer.bindStorage(0);
      glDispatchCompute(1, 1, 1);
    };
    step();
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
    condition.begin(buffer.name(), 0);
    step();
    step();
    condition.end();
    step();
    gl::barrier();
    unsigned found = 0;
    buffer.read(12, std::as_writable_bytes(std::span(&found, 1)));
    CHECK(found == (groups == 0 ? 2U : 4U));
  }
  glGetIntegerv(GL_VIEWPORT, after);
  CHECK(std::equal(before, before + 4, after));
}
