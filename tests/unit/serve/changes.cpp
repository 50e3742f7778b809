#include "serve/script/changes.hpp"

#include <limits>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using simreel::serve::equalUntil;
using simreel::serve::withoutAppearance;

namespace {

using Json = nlohmann::ordered_json;

constexpr double all = std::numeric_limits<double>::infinity();

Json dish() {
  return Json::parse(
      R"({"time": {"fps": 30}, "sun": {"intensity": 3}, "ground": {"height": 0, "color": [1, 1, 1]},
    "objects": {"dish": {"grayScott": {"size": [8, 8], "kill": 0.06, "display": {"opacity": 0.5},
      "feed": {"keys": [[0, 1], [1, 2], [2, 3], [3, 4]]},
      "strokes": [{"radius": 2}, {"at": 2, "radius": 2}, {"at": 1.5, "radius": 2}]}},
      "ball": {"sphere": {"radius": 1, "position": {"keys": [[0, [0, 0, 0]], [2, [1, 0, 0]]]}}, "material": {"ior": 2}}}})");
}

/// Returns the time (s) up to which the dish simulates unchanged if the value at `pointer` is replaced.
double alikeWith(const std::string& pointer, const Json& value) {
  Json other = dish();
  other[Json::json_pointer(pointer)] = value;
  return equalUntil(dish().dump(), other.dump());
}

const std::string field = "/objects/dish/grayScott";

}  // namespace

TEST_CASE("changes of drawing parameters keep all simulated states") {
  CHECK(equalUntil(dish().dump(), dish().dump()) == all);
  CHECK(alikeWith("/sun/intensity", 4) == all);
  CHECK(alikeWith("/ground/color", {0, 0, 0}) == all);
  CHECK(alikeWith("/objects/ball/material/ior", 1.5) == all);
  CHECK(alikeWith("/objects/ball/sphere/visible", false) == all);
  CHECK(alikeWith(field + "/display/opacity", 1) == all);
  CHECK(withoutAppearance(dish().dump()).find("opacity") == std::string::npos);
}

TEST_CASE("changes of strokes keep the states before the first changed stroke") {
  CHECK(alikeWith(field + "/strokes/1/radius", 3) == 2);
  CHECK(alikeWith(field + "/strokes/1/at", 1) == 1);
  CHECK(alikeWith(field + "/strokes/1/at", 3) == 2);
  CHECK(alikeWith(field + "/strokes/0/radius", 3) == 0);
  CHECK(alikeWith(field + "/strokes/3", {{"at", 2.5}}) == 2.5);
  Json less = dish();
  less[Json::json_pointer(field + "/strokes")].erase(1);  // The last stroke counts as changed, because
                                                          // strokes are compared by their index in the
                                                          // list.
  CHECK(equalUntil(dish().dump(), less.dump()) == 1.5);
  less[Json::json_pointer(field)].erase("strokes");
  CHECK(equalUntil(dish().dump(), less.dump()) == 0);
  // Without strokes, the fluid is stirred at the start.
  const std::string still = R"({"objects": {"pool": {"fluid": {}}}})";
  const std::string one = R"({"objects": {"pool": {"fluid": {"strokes": [{"at": 1}]}}}})";
  const std::string two = R"({"objects": {"pool": {"fluid": {"strokes": [{"at": 1}, {"at": 2}]}}}})";
  CHECK(equalUntil(still, one) < 0);
  CHECK(equalUntil(one, two) == 2);
  const std::string dyed =
      R"({"objects": {"pool": {"fluid": {"strokes": [{"at": 1}, {"at": 2, "dye": [1, 0, 0]}]}}}})";
  CHECK(equalUntil(two, dyed) < 0);  // The two scenes have no time in common, because the earlier states
                                     // have no dye.
}

TEST_CASE("changes of keyframes keep the states before the first changed key") {
  const std::string keys = field + "/feed/keys/";
  CHECK(alikeWith(keys + "2", {2, 5}) == 1);
  CHECK(alikeWith(keys + "3/1", 5) == 2);
  CHECK(alikeWith(keys + "4", {5, 5}) == 3);
  CHECK(alikeWith(keys + "0/1", 5) < 0);
  CHECK(alikeWith(field + "/feed/ease", "hold") < 0);
  Json spline = dish(), other = dish();
  for (Json* one : {&spline, &other}) (*one)[Json::json_pointer(field + "/feed/ease")] = "spline";
  other[Json::json_pointer(keys + "3/1")] = 5;
  CHECK(equalUntil(spline.dump(), other.dump()) == 1);  // The speed at a key depends on both neighbouring
                                                        // keys.
  CHECK(alikeWith("/objects/ball/sphere/position/keys/1/1/0", 2) == 0);
}

TEST_CASE("other changes keep no states") {
  CHECK(alikeWith(field + "/kill", 0.05) < 0);
  CHECK(alikeWith(field + "/feed", 0.05) < 0);
  CHECK(alikeWith(field + "/seeds", 1) < 0);
  CHECK(alikeWith("/objects/ball/sphere/radius", 2) < 0);
  CHECK(alikeWith("/objects/more", {{"sphere", Json::object()}}) < 0);
  CHECK(alikeWith("/time/fps", 60) < 0);
  CHECK(alikeWith("/ground/height", 1) < 0);
  CHECK(alikeWith("/seed", 1) < 0);
}
