// Tests the worked example of src/sim/ports/README.md, which is built from its listings. The example is a
// fan, a kind of object that blows wind on particles and cloth. It is defined only in its own folder. Its
// relations to other objects must be checked, ordered and connected like those of all other kinds.
#include "sim/fan/fan.hpp"

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "sim/core/kind.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/world/list.hpp"
#include "sim/world/object_links.hpp"
#include "sim/world/port_check.hpp"

#include <memory>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// A kind that takes the wind of another object and passes it on.
struct RelayParameters : sim::ObjectParameters {
  std::string from;
  void describe(scene::Fields& f) override {
    f.text("from", from, "Name of the object whose wind it takes.");
  }
  void ports(sim::Ports& ports) const override {
    ports.provide<sim::FluidWind>();
    ports.want<sim::FluidWind>(from, {"from"});
  }
};

scene::Scene read(const std::string& objects) {
  static const sim::SimulationKind fan = sim::fanKind();
  static const std::vector<scene::Kind> list = [] {
    std::vector<scene::Kind> all(sim::kinds().list.begin(), sim::kinds().list.end());
    all.push_back(fan.kind);
    all.push_back({"relay", "Relay of wind.", [] { return std::make_unique<RelayParameters>(); }});
    return all;
  }();
  return scene::parseScene(R"({"version": 1, "objects": {)" + objects + "}}", "fan.json", {},
                           {list, sim::checkPorts});
}

std::string mistakeOf(const std::string& objects) {
  try {
    static_cast<void>(read(objects));
    return "none";
  } catch (const UserError& error) {
    return error.what();
  }
}

const std::string fanText = R"("fan": {"fan": {"position": [0, 0, 0], "speed": 6}})";

/// Two particles at rest, one near the fan and one far from it.
const std::string grains = R"("grains": {"particles": {"method": "none", "wind": {"fluid": "fan"},
    "groups": [{"shape": "ball", "count": 1, "position": [0.5, 0, 0], "radius": 1e-4},
               {"shape": "ball", "count": 1, "position": [4, 0, 0], "radius": 1e-4}]}})";

}  // namespace

TEST_CASE("example: the fan of the README blows on particles, harder on the near one") {
  testContext();
  const scene::Scene scene = read(grains + ", " + fanText);
  sim::ObjectLinks links(scene.objects, [] { return 0.0; });
  const std::vector<sim::ColliderShape> none;
  sim::Setting setting;
  setting.colliders = &none;
  setting.links = &links;
  REQUIRE(links.order().size() == 2);
  CHECK(links.order()[0].objects[0] == 1);  // The fan comes first, although it is last in the scene.
  for (const sim::StepNode& node : links.order()) {
    const scene::Object& object = scene.objects[node.objects[0]];
    const sim::SimulationKind kind =
        object.kind == "fan" ? sim::fanKind() : sim::simulationNamed(object.kind);
    links.made(node.objects[0], kind.make(object, setting));
  }
  for (int frame = 0; frame < 6; ++frame)
    for (const sim::StepNode& node : links.order())
      links.simulations()[node.objects[0]]->step(frame * setting.frameSeconds, {});
  const sim::PointTable table = links.simulations()[0]->points();
  const std::size_t columns = table.columns.size();
  REQUIRE(table.values.size() == 2 * columns);
  const float near = table.values[0] - 0.5F, far = table.values[columns] - 4;
  CHECK(far > 1e-4F);
  CHECK(near > 4 * far);
}

TEST_CASE("example: an unknown fan name is reported with the known name") {
  CHECK(mistakeOf(grains + ", " + fanText) == "none");
  const auto says = [](const std::string& message, const char* what) {
    CHECK_MESSAGE(message.find(what) != std::string::npos, message);
  };
  const std::string renamed = R"("fann": {"fan": {}}, )" + grains;
  says(mistakeOf(renamed), "no object is named \"fan\"; did you mean \"fann\"?");
  says(mistakeOf(R"("fan": {"sphere": {}}, )" + grains), "object \"fan\" is a sphere, which does not blow");
}

TEST_CASE("example: objects step after the objects whose wind they use, and a cycle is refused by name") {
  const std::string chain =
      R"("a": {"relay": {"from": "b"}}, "b": {"relay": {"from": "c"}}, "c": {"relay": {}})";
  CHECK(mistakeOf(chain) == "none");
  std::vector<std::size_t> order;
  for (const sim::StepNode& node : sim::stepOrder(read(chain).objects)) order.push_back(node.objects[0]);
  CHECK(order == std::vector<std::size_t>{2, 1, 0});
  const std::string circle =
      mistakeOf(R"("x": {"relay": {}}, "a": {"relay": {"from": "b"}}, "b": {"relay": {"from": "a"}})");
  CHECK_MESSAGE(circle.find("objects \"a\", \"b\" depend on each other in a circle") != std::string::npos,
                circle);
  const std::string self = mistakeOf(R"("a": {"relay": {"from": "a"}})");
  CHECK_MESSAGE(self.find("object \"a\" needs its own state") != std::string::npos, self);
}
