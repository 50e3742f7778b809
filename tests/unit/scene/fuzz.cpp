// Tests damaged scenes. They must be accepted or refused with a report, and must never cause a crash. Also
// runs in the sanitizer build.
#include "unit/scene/toy.hpp"

#include <cstdint>

#include <doctest/doctest.h>

using namespace simreel::scene;
using namespace simreel::scene::toy;

namespace {

const std::string whole = R"({
  "$schema": "simreel.json", "version": 1, "title": "caf\u00e9 é", "seed": 7, // comment
  "render": {"size": [64, 32], "exposure": {"keys": [[0, 1], [1.5, -2e0]], "ease": "smooth"}},
  "camera": {"position": {"keys": [[0, [1, 2, 3]]]}, "near": 0.1}, /* another */
	"ground": {"height": -1, "visible": true},
  "objects": {"flag": {"cloth": {"wind": [1, 2, 3], "passes": "auto", "sides": ["left"], "holes": [[1, 2]],
    "pins": [{"row": 1}, {}], "worn": {}, "picture": ""}, "material": {"color": [1, 0, 0.5]}}}
})";

}  // namespace

TEST_CASE("the scene used for fuzzing is valid") {
  CHECK(mistakes(whole).empty());
}

TEST_CASE("a scene truncated anywhere is refused with a report") {
  for (std::size_t length = 0; length < whole.size() - 1; ++length) {
    const std::string report = mistakes(std::string_view(whole).substr(0, length));
    INFO(length, report);
    CHECK(has(report, "s.json:"));
    CHECK(has(report, "^"));
    CHECK(!has(report, "json.exception"));
  }
}

TEST_CASE("no damaged byte crashes the reader") {
  std::uint32_t random = 1;
  const auto next = [&] { return random = random * 747796405U + 2891336453U; };
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char put :
         {'"', '\\', '{', '}', '[', ',', '9', '\0', '\n', '\xFF', static_cast<char>(next() >> 24U)}) {
      std::string damaged = whole;
      damaged[at] = put;
      CHECK(!has(mistakes(damaged), "json.exception"));
    }
  }
}

TEST_CASE("no random override crashes the reader") {
  const std::string paths[] = {"objects.flag.cloth", "render.size.0", "camera.position.keys.0.1", "version",
                               "objects"};
  const std::string values[] = {
      "", "null", "[]", "{}", "1e999", "[[[[", "\"", "-", "{\"keys\":[[0,1],[0]]}", "/*", "nan"};
  for (const std::string& path : paths)
    for (const std::string& value : values) {
      const std::string report = mistakes(whole, {path + "=" + value});
      CHECK(!has(report, "json.exception"));
    }
}
