// Tests, for every kind with a file, that the file implies the shape and that another shape is an error.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/value/value_writer.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"

#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

/// Returns every value of an object after parsing, or the error. In `object`, the word SHAPE is replaced by
/// `shape`.
std::string understoodAs(std::string object, const std::string& shape) {
  object.replace(object.find("SHAPE"), 5, shape);
  try {
    const scene::Scene scene =
        scene::parseScene(fmt::format(R"({{"version": 1, "objects": {{"x": {}}}}})", object),
                          sourceFolder() + "/assets/scenes/x.json", {}, sim::kinds());
    scene::ValueWriter values;
    scene.objects.at(0).parameters->describe(values);
    return values.values().dump();
  } catch (const UserError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a given file or image implies the matching shape") {
  const struct {
    const char* object;
    const char* shape;
    const char* other;
  } kinds[] = {
      {R"({"mesh": {SHAPE "file": "meshes/heart.ply"}})", "file", "sphere"},
      {R"({"cloth": {"mesh": {SHAPE "file": "meshes/shield.obj"}}})", "file", "disc"},
      {R"({"reaction": {"preset": "heat", "mesh": {SHAPE "file": "meshes/heart.ply"}}})", "file", "sphere"},
      {R"({"water": {"floats": [{SHAPE "file": "meshes/boat.obj"}]}})", "file", "box"},
      {R"({"particles": {"groups": [{"count": 9}], "look": {SHAPE "mesh": "meshes/dart.obj"}}})", "mesh",
       "sphere"},
      {R"({"particles": {"groups": [{SHAPE "file": "meshes/heart.ply"}]}})", "file", "cube"},
      {R"({"fluid": {"obstacles": [{SHAPE "image": "textures/flag.png"}]}})", "image", "box"},
      {R"({"reaction": {"preset": "heat", "strokes": [{SHAPE "image": "textures/flag.png"}]}})", "image",
       "line"}};
  for (const auto& kind : kinds) {
    CAPTURE(kind.object);
    const auto named = [](const std::string& shape) { return fmt::format(R"("shape": "{}",)", shape); };
    const std::string without = understoodAs(kind.object, "");
    CHECK(without.front() == '{');
    CHECK(without == understoodAs(kind.object, named(kind.shape)));
    simreel::test::checkHas(without, fmt::format(R"("shape":"{}")", kind.shape));
    simreel::test::checkHas(
        understoodAs(kind.object, named(kind.other)),
        fmt::format(R"(needs "shape": "{}"; correct "shape" or leave it out)", kind.shape));
  }
}
