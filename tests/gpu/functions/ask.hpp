#pragma once
// Tests single shader functions of the simulation models. The GPU must return the same values as the same
// file compiled as C++. Many of the inputs are equal, zero or on an edge, because scenes rarely produce
// cases such as a distance of exactly 0.
#include "base/error.hpp"
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

/// Returns the text of a file in this folder. Replaces includes of files in this folder by their text,
/// because the shader include path does not contain the folder.
inline std::string functionsText(const std::string& name) {
  const std::string there = "gpu/functions/";
  std::string text = simreel::readFile(sourceFolder() + "/tests/" + there + name, "shader");
  const std::string include = "#include \"" + there;
  for (auto at = text.find(include); at != std::string::npos; at = text.find(include)) {
    const auto begin = at + include.size(), end = text.find('"', begin);
    text.replace(at, end + 1 - at, functionsText(text.substr(begin, end - begin)));
  }
  return text;
}

/// Returns asked(i) of tests/gpu/functions/`name` for all i, computed on the GPU.
inline std::vector<glm::vec4> answersOfDevice(const std::string& name, const std::string& before) {
  testContext();
  const std::string text = "#include \"common/exact.glsl\"\n#include \"common/hash.glsl\"\n" + before +
                           "layout(local_size_x = 64) in;\n"
                           "layout(std430, binding = 0) writeonly buffer AnswerBlock { vec4 answers[]; };\n"
                           "uniform int questions;\n" +
                           functionsText("inputs.glsl") + functionsText(name) +
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
  std::vector<glm::vec4> found = answers.readAll<glm::vec4>();
  try {
    testContext().check();
  } catch (const simreel::UserError& error) {
    // Mesa warns "used uninitialized" about globals that asked() sets. The warning is discarded, because
    // otherwise check() in the next test would report it.
    if (std::string(error.what()).find("used uninitialized") == std::string::npos) throw;
  }
  return found;
}

// True if two results count as equal. Zeros with either sign count as equal, because GLSL's min, max and
// clamp may return either of them, and no model depends on the sign.
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
  CHECK(different > questions / 10);  // Neighbouring inputs must give different outputs.
}
