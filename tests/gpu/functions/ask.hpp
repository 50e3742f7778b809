#pragma once
// Functions of the models by themselves: what a kernel makes of them, over many inputs of which many are
// alike or on an edge, equals what the same files as C++ do. Scenes seldom come to where a distance is
// exactly 0.
#include "base/file.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gpu/context.hpp"
#include "source_folder.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

constexpr int questions = 30011;

/// What asked(i) of tests/gpu/functions/`name` is on the device.
inline std::vector<glm::vec4> answersOfDevice(const std::string& name, const std::string& before) {
  testContext();
  const std::string here = sourceFolder() + "/tests/gpu/functions/";
  const std::string text = "#include \"common/exact.glsl\"\n#include \"common/hash.glsl\"\n" + before +
                           "layout(local_size_x = 64) in;\n"
                           "layout(std430, binding = 0) writeonly buffer AnswerBlock { vec4 answers[]; };\n"
                           "uniform int questions;\n" +
                           simreel::readFile(here + "inputs.glsl", "shader") +
                           simreel::readFile(here + name, "shader") +
                           "void main() {\n"
                           "  int i = int(gl_GlobalInvocationID.x);\n"
                           "  if (i < questions) answers[i] = asked(i);\n"
                           "}\n";
  const simreel::gl::Program program = simreel::gl::Program::computeText(name, text);
  simreel::gl::Buffer answers =
      simreel::gl::Buffer::of("answers", std::span<const glm::vec4>(std::vector<glm::vec4>(questions)));
  answers.bindStorage(0);
  program.set("questions", questions);
  program.dispatch(questions);
  glMemoryBarrier(GL_ALL_BARRIER_BITS);
  return answers.readAll<glm::vec4>();
}

// GLSL's min, max and clamp may give either zero where both meet; models never ask which one it is.
inline bool alike(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

template <class Model>
void checkAll(const std::string& name, const std::string& before = "") {
  const std::vector<glm::vec4> found = answersOfDevice(name, before);
  Model model{};
  int wrong = 0, first = -1;
  std::size_t different = 0;
  for (int i = 0; i < questions; ++i) {
    const glm::vec4 wanted = model.asked(i), there = found[static_cast<std::size_t>(i)];
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
