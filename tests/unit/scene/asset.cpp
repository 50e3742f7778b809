#include "scene/load.hpp"
#include "unit/scene/toy.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <doctest/doctest.h>

using namespace simreel::scene;
using namespace simreel::scene::toy;
namespace fs = std::filesystem;

namespace {

/// Creates scenes/, assets/ and outside/ in a new folder, sets $SIMREEL_ASSETS to assets/, and removes
/// everything in the destructor.
class Folders {
 public:
  Folders()
      : root(fs::canonical(fs::temp_directory_path()) / ("simreel-assets-" + std::to_string(::getpid()))) {
    for (const char* name : {"scenes", "assets", "outside"}) {
      fs::create_directories(root / name / "sub");
      std::ofstream(root / name / (std::string(name) + ".png")) << "x";
    }
    fs::create_symlink(root / "outside" / "outside.png", root / "scenes" / "leak.png");
    fs::create_symlink(root / "outside", root / "scenes" / "leak");
    fs::create_symlink(root / "assets" / "assets.png", root / "scenes" / "fine.png");
    ::setenv("SIMREEL_ASSETS", (root / "assets").c_str(), 1);
  }
  ~Folders() {
    ::unsetenv("SIMREEL_ASSETS");
    std::error_code ignored;
    fs::remove_all(root, ignored);
  }
  Folders(const Folders&) = delete;
  Folders& operator=(const Folders&) = delete;

  [[nodiscard]] std::string errors(const std::string& picture) const {
    return mistakes(withCloth("\"picture\": \"" + picture + "\""), {}, root / "scenes" / "s.json");
  }
  [[nodiscard]] fs::path found(const std::string& picture) const {
    return clothOf(parse(withCloth("\"picture\": \"" + picture + "\""), {}, root / "scenes" / "s.json"))
        .picture;
  }

  fs::path root;
};

}  // namespace

TEST_CASE("assets are found in the scene's folder and in the asset folder") {
  const Folders folders;
  CHECK(folders.found("scenes.png") == folders.root / "scenes" / "scenes.png");
  CHECK(folders.found("sub/../scenes.png") == folders.root / "scenes" / "scenes.png");
  CHECK(folders.found("assets.png") == folders.root / "assets" / "assets.png");
  CHECK(folders.found("../assets/assets.png") == folders.root / "assets" / "assets.png");
  CHECK(folders.found("fine.png") == folders.root / "assets" / "assets.png");
  CHECK(folders.found("").empty());
}

TEST_CASE("files outside the allowed folders are refused") {
  const Folders folders;
  const std::string outside = "lies outside the folders a scene may read";
  CHECK(
      has(folders.errors("../outside/outside.png"), ":3:13: error: \"../outside/outside.png\" " + outside));
  CHECK(has(folders.errors("leak.png"), outside));
  CHECK(has(folders.errors("leak/outside.png"), outside));
  CHECK(has(folders.errors("/etc/passwd"), outside));
  CHECK(has(folders.errors("../scenes2/x.png"), outside));
  CHECK(has(folders.errors((folders.root / "outside" / "outside.png").string()), outside));
}

TEST_CASE("a scene may read folders that the user allows") {
  const Folders folders;
  const std::vector<fs::path> given = {folders.root / "none", folders.root / "outside"};
  const auto parseWith = [&](const std::string& picture, std::span<const fs::path> extra) {
    return parseScene(withCloth("\"picture\": \"" + picture + "\""), folders.root / "scenes" / "s.json", {},
                      toyKinds(), extra);
  };
  for (const char* name : {"outside.png", "../outside/outside.png", "leak.png"}) {
    CHECK(clothOf(parseWith(name, given)).picture == folders.root / "outside" / "outside.png");
    CHECK_THROWS_AS(static_cast<void>(parseWith(name, {})), simreel::UserError);
  }
  CHECK(clothOf(parseWith("assets.png", given)).picture == folders.root / "assets" / "assets.png");
  CHECK_THROWS_AS(static_cast<void>(parseWith("/etc/passwd", given)), simreel::UserError);
  CHECK(has(folders.errors("leak.png"), "; --assets DIR lets it read another"));
}

TEST_CASE("a missing asset lists the searched folders") {
  const Folders folders;
  const std::string report = folders.errors("nope.png");
  CHECK(has(report, "no file \"nope.png\" in " + (folders.root / "scenes").string() + " and " +
                        (folders.root / "assets").string()));
  CHECK(has(folders.errors("sub"), "\"sub\" is not a file"));
  CHECK(has(folders.errors("a\\u0000b"), "zero byte"));
  CHECK(has(folders.errors(std::string(5000, 'x')), "no file"));
}

TEST_CASE("a scene is loaded from a file") {
  const Folders folders;
  const fs::path file = folders.root / "scenes" / "s.json";
  std::ofstream(file) << "{\"version\": 1, \"sed\": 2}";
  try {
    static_cast<void>(loadScene(file, {}, toyKinds()));
    FAIL("no error");
  } catch (const simreel::UserError& error) {
    CHECK(has(error.what(), file.string() + ":1:16: error: unknown key \"sed\""));
  }
  std::ofstream(file) << "{\"version\": 1, \"seed\": 2}";
  CHECK(loadScene(file, {}, toyKinds()).seed == 2);
  CHECK_THROWS_AS(static_cast<void>(loadScene(folders.root / "none.json", {}, toyKinds())),
                  simreel::UserError);
}
