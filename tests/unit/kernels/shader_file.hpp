#pragma once
#include "kernels/kernels.hpp"
#include "unit/help.hpp"

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace simreel::test {

/// Compiles a shader from text in this process.
[[nodiscard]] inline kernels::Shader loaded(const std::string& name, const std::string& text,
                                            std::vector<std::string> only = {},
                                            std::vector<std::string> keywords = {}, bool fast = false) {
  const TemporaryFile file(name, text);
  kernels::Request request;
  request.file = file.path();
  request.kernels = std::move(only);
  request.keywords = std::move(keywords);
  request.fast = fast;
  return kernels::loadHere(request);
}

/// True if glslangValidator accepts the text as an OpenGL compute shader, or if it is not installed.
[[nodiscard]] inline bool isGlsl(const std::string& text) {
  const TemporaryFile file("check.comp", text);
  // NOLINTNEXTLINE(concurrency-mt-unsafe,cert-env33-c): the file name is our own
  const int ended =
      std::system(("command -v glslangValidator >/dev/null || exit 0; glslangValidator -S comp '" +
                   file.path().string() + "' >&2")
                      .c_str());
  return ended == 0;
}

}  // namespace simreel::test
