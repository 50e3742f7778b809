#include "cli/options/shipped_scene.hpp"

#include "scene/shipped_scene.hpp"

#include <string>

#include <CLI/CLI.hpp>

namespace simreel::cli {

void findShipped(CLI::Option& option, bool* shipped) {
  option.transform(CLI::Validator(
      [shipped](std::string& word) {
        const std::string file = scene::sceneFile(word);
        if (shipped != nullptr) *shipped = file != word;
        word = file;
        return std::string();
      },
      ""));
}

}  // namespace simreel::cli
