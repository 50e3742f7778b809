#include "golden/baseline/inputs.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "unit/frame/help.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::golden;

TEST_CASE("inputs: inputs are the scene, its sidecar, referenced files and glTF buffers") {
  const frame::test::TemporaryFolder folder;
  const auto file = [&](const std::string& name) { return folder / name; };
  const auto write = [&](const std::string& name, std::string_view text) {
    writeFileAtomically(file(name), text);
  };
  write("a.json", "{}");
  // Files outside the scene's folder are not inputs, because they are not loaded for meshes.
  write(
      "m.gltf",
      R"({"buffers": [{"uri": "my%20buffer.bin"}, {"uri": "data:;base64,AA"}, {}, {"uri": "/etc/hostname"},
      {"uri": "..%2f..%2fetc/hostname"}, {"uri": "link.bin"}]})");
  std::filesystem::create_symlink("/etc/hostname", file("link.bin"));
  write("my buffer.bin", "123");
  write("torn.gltf", "{");
  const std::vector<std::filesystem::path> named = {file("m.gltf"), file("torn.gltf"),
                                                    assetFolder() / "scenes/flag.json"};
  const Inputs inputs = inputsOf(file("a.json"), named);
  CHECK(inputs.size() == 6);
  CHECK(inputs.at(file("a.json").string()) == hashHex(std::string_view("{}")));
  CHECK(inputs.at(file("a.test.json").string()).empty());
  CHECK(inputs.at(file("my buffer.bin").string()) == hashHex(std::string_view("123")));
  CHECK(inputs.contains("<assets>/scenes/flag.json") != inputs.contains("assets/scenes/flag.json"));
  CHECK_NOTHROW(checkUnchanged(inputs));
  write("my buffer.bin", "124");
  CHECK_THROWS_WITH_AS(checkUnchanged(inputs),
                       doctest::Contains("my buffer.bin has changed since that run"), UserError);
  removeFile(file("my buffer.bin"));
  CHECK_THROWS_WITH_AS(checkUnchanged(inputs), doctest::Contains("my buffer.bin is gone since that run"),
                       UserError);
}
