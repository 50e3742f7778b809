// Functions of the models by themselves: what a kernel makes of them, over many inputs of which many are
// alike or on an edge, equals what the same files as C++ do. Scenes seldom come to where a distance is
// exactly 0.
#include "base/file.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gpu/context.hpp"
#include "sim/collide/colliders.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/mesh/height_plan.hpp"
#include "sim/spread/wildfire_plan.hpp"
#include "sim/water/float_plan.hpp"
#include "sim/water/plan.hpp"
#include "source_folder.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

using namespace simreel::shader;

constexpr int questions = 30011;
#define SEA 1
#define FUNCTION
#define precise
#include "gpu/functions/inputs.glsl"

struct Nearest {
#include "gpu/functions/closest.glsl"
};
struct Fires {
#include "gpu/functions/wildfire.glsl"
};
struct Grounds {
#include "gpu/functions/heights.glsl"
};
struct Solids {
#include "gpu/functions/colliders.glsl"
};
struct Lakes {
#include "gpu/functions/water.glsl"
};
struct Bodies {
#include "gpu/functions/floats.glsl"
};
#undef precise
#undef FUNCTION

/// What asked(i) of tests/gpu/functions/`name` is on the device.
std::vector<vec4> ofDevice(const std::string& name, const std::string& before) {
  testContext();
  const std::string here = sourceFolder() + "/tests/gpu/functions/";
  const std::string text = "#include \"common/exact.glsl\"\n#include \"common/hash.glsl\"\n" + before +
                           "layout(local_size_x = 64) in;\n"
                           "layout(std430, binding = 0) writeonly buffer AnswerBlock { vec4 answers[]; };\n"
                           "uniform int questions;\n" +
                           readFile(here + "inputs.glsl", "shader") + readFile(here + name, "shader") +
                           "void main() {\n"
                           "  int i = int(gl_GlobalInvocationID.x);\n"
                           "  if (i < questions) answers[i] = asked(i);\n"
                           "}\n";
  const gl::Program program = gl::Program::computeText(name, text);
  gl::Buffer answers = gl::Buffer::of("answers", std::span<const vec4>(std::vector<vec4>(questions)));
  answers.bindStorage(0);
  program.set("questions", questions);
  program.dispatch(questions);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  return answers.readAll<vec4>();
}

// GLSL's min, max and clamp may give either zero where both meet; models never ask which one it is.
bool alike(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

template <class Model>
void checkAll(const std::string& name, const std::string& before = "") {
  const std::vector<vec4> found = ofDevice(name, before);
  Model model{};
  int wrong = 0, first = -1;
  std::size_t different = 0;
  for (int i = 0; i < questions; ++i) {
    const vec4 wanted = model.asked(i), there = found[static_cast<std::size_t>(i)];
    bool same = true;
    for (int k = 0; k < 4; ++k) same = same && alike(wanted[k], there[k]);
    wrong += same ? 0 : 1;
    if (first < 0 && !same) {
      first = i;
      for (int k = 0; k < 4; ++k) MESSAGE(wanted[k], " there ", there[k]);
    }
    different += i > 0 && wanted != found[static_cast<std::size_t>(i - 1)] ? 1U : 0U;
  }
  CHECK_MESSAGE(wrong == 0, wrong, " of ", questions, " differ, the first at ", first);
  CHECK(different > questions / 10);  // they ask something
}

}  // namespace

TEST_CASE("functions: closest points of triangles and segments") {
  checkAll<Nearest>("closest.glsl");
}

TEST_CASE("functions: fire on slopes, in wind, and where its embers fall") {
  checkAll<Fires>("wildfire.glsl", "#include \"spread/cells.glsl\"\n");
}

TEST_CASE("functions: ground of a deformed grid, its sides and corners") {
  checkAll<Grounds>("heights.glsl");
}

TEST_CASE("functions: out of shapes and of a mesh's distances") {
  checkAll<Solids>("colliders.glsl");
}

TEST_CASE("functions: a step of shallow water, its look and its drops") {
  checkAll<Lakes>("water.glsl",
                  "#define SEA 1\n#include \"water/types.glsl\"\n#include "
                  "\"water/look_types.glsl\"\n#include \"water/model.glsl\"\n");
}

TEST_CASE("functions: floats on water and against each other") {
  checkAll<Bodies>("floats.glsl",
                   "#include \"water/types.glsl\"\n#include \"water/float_types.glsl\"\n#include "
                   "\"water/model.glsl\"\n");
}
