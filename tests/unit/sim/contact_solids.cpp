#include "base/error.hpp"
#include "reference/contact_pile.hpp"
#include "reference/crossings.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/contact/crossings.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/world/list.hpp"
#include "sim/world/port_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Returns a box of twelve faces whose position over time is `at`.
PileSolid solidBox(glm::vec3 half, std::function<glm::dvec3(double)> at) {
  PileSolid box;
  box.at = [half, at = std::move(at)](double time) {
    const glm::dvec3 place = at(time);
    std::vector<glm::vec4> corners;
    for (int i = 0; i < 8; ++i)
      corners.emplace_back(
          glm::vec3(place + glm::dvec3(half) * glm::dvec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                                          (i & 4) != 0 ? 1 : -1)),
          0.0F);
    return corners;
  };
  for (const glm::uvec4& side : {glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6), glm::uvec4(0, 1, 5, 4),
                                 glm::uvec4(2, 6, 7, 3), glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5)}) {
    box.faces.emplace_back(side.x, side.y, side.z);
    box.faces.emplace_back(side.x, side.z, side.w);
  }
  return box;
}

PileSolid solidBall(float radius, glm::ivec2 resolution, glm::vec3 place) {
  const sim::Mesh mesh = sim::sphereMesh(radius, resolution);
  PileSolid ball;
  std::vector<glm::vec4> positions;
  for (const glm::vec3& p : mesh.positions) positions.emplace_back(p + place, 0.0F);
  ball.at = [positions](double) { return positions; };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    ball.faces.emplace_back(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
  return ball;
}

double fastestOf(const ClothTwin& cloth) {
  double fastest = 0;
  for (const glm::vec4& v : cloth.velocities) fastest = std::max(fastest, glm::length(glm::dvec3(v)));
  return fastest;
}

glm::dvec3 meanOf(const std::vector<glm::vec4>& items) {
  glm::dvec3 sum(0);
  for (const glm::vec4& item : items) sum += glm::dvec3(item);
  return sum / static_cast<double>(items.size());
}

}  // namespace

TEST_CASE("a box at 10 m/s pushes a hanging sheet and does not pass through") {
  auto sheet = silk({17, 15}, 0.03F, {0, 0, 0}, {90, 0, 0});
  sheet.pins.resize(1);
  sheet.pins[0].rows = {0};
  Pile pile(
      {sheet}, {}, 0.008F, 0.3F,
      {solidBox({0.08F, 0.06F, 0.05F}, [](double t) { return glm::dvec3(0.02, -0.05, -0.15 + 10 * t); })});
  double far = 0;
  std::size_t touching = 0;
  for (int f = 0; f < 10; ++f) {
    pile.step();
    touching += pile.contact->touching;
    CHECK(crossings(pile.points(), pile.faces, pile.firstSolid) == 0);
    for (const glm::vec4& p : pile.cloths[0]->positions) far = std::max(far, static_cast<double>(p.z));
  }
  CHECK(touching > 15);
  CHECK(far > 0.2);  // The box has passed through the position where the sheet hung.
}

TEST_CASE("a 2 cm rod at 10 m/s carries a loose sheet along") {
  auto sheet = silk({13, 15}, 0.03F, {0, 0, 0}, {90, 20, 0});
  sheet.gravity = glm::vec3(0);
  Pile pile({sheet}, {}, 0.006F, 0.3F,
            {solidBox({0.3F, 0.01F, 0.01F}, [](double t) { return glm::dvec3(0, 0.01, -0.15 + 10 * t); })});
  for (int f = 0; f < 8; ++f) {
    pile.step();
    CHECK(crossings(pile.points(), pile.faces, pile.firstSolid) == 0);
  }
  CHECK(meanOf(pile.cloths[0]->positions).z > 0.5);  // The rod has reached z = 1.18.
  CHECK(meanOf(pile.cloths[0]->velocities).z > 5);
}

TEST_CASE("a rotating bar winds up a sheet without crossing it") {
  auto sheet = silk({15, 13}, 0.03F, {0, 0.03F, 0}, {0, 0, 0});
  PileSolid bar = solidBox({0.2F, 0.01F, 0.02F}, [](double) { return glm::dvec3(0); });
  bar.at = [rest = bar.at(0)](double time) {
    std::vector<glm::vec4> turned;
    const double s = std::sin(15 * time), c = std::cos(15 * time);  // The bar's tips move at 3 m/s.
    for (const glm::vec4& p : rest) turned.emplace_back(c * p.x - s * p.y, s * p.x + c * p.y, p.z, 0);
    return turned;
  };
  Pile pile({sheet}, {}, 0.006F, 0.3F, {bar});
  for (int f = 0; f < 20; ++f) {
    pile.step();
    CHECK(crossings(pile.points(), pile.faces, pile.firstSolid) == 0);
  }
}

TEST_CASE("a cloth rests on a box of twelve faces at its thickness") {
  auto sheet = silk({9, 8}, 0.05F, {0, 0.006F, 0}, {0, 20, 0});
  sheet.damping = 1;
  Pile pile({sheet}, {}, 0.005F, 0.3F,
            {solidBox({0.4F, 0.05F, 0.4F}, [](double) { return glm::dvec3(0, -0.05, 0); })});
  for (int f = 0; f < 60; ++f) pile.step();
  CHECK(fastestOf(*pile.cloths[0]) < 0.01);
  for (const glm::vec4& p : pile.cloths[0]->positions) CHECK(p.y == doctest::Approx(0.005).epsilon(0.1));
  CHECK(crossings(pile.points(), pile.faces, pile.firstSolid) == 0);
}

TEST_CASE("a cloth hangs over a ball of faces at a distance of its thickness") {
  auto sheet = silk({15, 15}, 0.03F, {0, 0.165F, 0}, {0, 10, 0});
  sheet.damping = 3;
  Pile pile({sheet}, {}, 0.006F, 0.6F, {solidBall(0.15F, {33, 17}, glm::vec3(0))});
  double nearest = 1;
  for (int f = 0; f < 45; ++f) {
    pile.step();
    CHECK(crossings(pile.points(), pile.faces, pile.firstSolid) == 0);
  }
  for (const glm::vec4& p : pile.cloths[0]->positions)
    nearest = std::min(nearest, glm::length(glm::dvec3(p)) - 0.15);
  CHECK(nearest > 0.0035);  // The ball's faces are up to 0.7 mm inside the sphere.
  CHECK(nearest < 0.0065);
  double low = 0;
  for (const glm::vec4& p : pile.cloths[0]->positions) low = std::min<double>(low, p.y);
  CHECK(low < -0.02);
}

TEST_CASE("a moving floor of faces accelerates a cloth by friction at mu g up to the floor's speed") {
  const double mu = 0.3, speed = 1;
  for (const float own : {-1.0F, 0.1F}) {  // friction coefficient of the solid; if it is -1, the cloth's
                                           // coefficient 0.3 applies, and otherwise the mean of both
    const double expected = own < 0 ? mu : 0.5 * (mu + 0.1);
    auto sheet = silk({7, 6}, 0.04F, {0, 0.0051F, 0}, {0, 10, 0});
    sheet.damping = 0;
    sheet.jitter = 0;
    PileSolid floor = solidBox({2, 0.05F, 1}, [&](double t) { return glm::dvec3(speed * t, -0.05, 0); });
    floor.friction = own;
    Pile pile({sheet}, {}, 0.005F, static_cast<float>(mu), {floor});
    const auto run = [&](int frames) {
      for (int f = 0; f < frames; ++f) pile.step();
      return meanOf(pile.cloths[0]->velocities).x;
    };
    CHECK(run(12) == doctest::Approx(expected * 9.8 * 0.2).epsilon(0.05));
    CHECK(run(own < 0 ? 18 : 28) == doctest::Approx(speed).epsilon(0.01));
    CHECK(std::abs(meanOf(pile.cloths[0]->velocities).z) < 0.02);
  }
}

TEST_CASE("initial intersections between solids are not counted, those with a cloth are") {
  std::vector<sim::ContactPart> parts;
  sim::ContactPart sheet;
  for (const glm::vec3& p : {glm::vec3(2, -1, -1), glm::vec3(2, 1, -1), glm::vec3(2, 0, 1)})
    sheet.positions.emplace_back(p, 1.0F);
  sheet.faces.emplace_back(0, 1, 2);
  parts.push_back(sheet);
  for (const double x : {0.0, 0.3}) {
    const PileSolid box = solidBox({0.5F, 0.4F, 0.3F}, [x](double) { return glm::dvec3(x, 0.1 * x, x); });
    parts.push_back({box.at(0), box.faces, 0, -1, {}, true});
  }
  const auto count = [&] {
    std::vector<glm::vec4> positions;
    for (const sim::ContactPart& part : parts)
      positions.insert(positions.end(), part.positions.begin(), part.positions.end());
    return sim::crossingsOf(sim::ContactPlan(parts, 0.001), positions);
  };
  CHECK(count() == 0);
  for (glm::vec4& p : parts[0].positions) p.x = 0.1F;
  CHECK(count() > 0);
}

TEST_CASE("colliding faces need a cloth with contact, and unsupported options are reported") {
  const auto mistake = [](const std::string& objects) -> std::string {
    try {
      const std::string text = R"({"version": 1, "objects": {)" + objects + "}}";
      static_cast<void>(scene::parseScene(text, "s.json", {}, sim::kinds()));
      return "none";
    } catch (const simreel::UserError& error) {
      return error.what();
    }
  };
  const std::string sheet = R"("c": {"cloth": {"contact": true}}, )";
  const std::string ball = R"("b": {"mesh": {"shape": "sphere", "collides": "faces")";
  const auto says = [](const std::string& message, const char* what) {
    CHECK_MESSAGE(message.find(what) != std::string::npos, message);
  };
  CHECK(mistake(sheet + ball + "}}") == "none");
  CHECK(mistake(sheet + ball + R"(, "friction": 0.2, "rotation": [0, 0, 5], "scale": 2}})") == "none");
  says(mistake(ball + "}}"), "nothing touches these faces; give a \"cloth\" of this scene \"contact\": {}");
  says(mistake(R"("c": {"cloth": {"contact": false}}, )" + ball + "}}"), "nothing touches these faces");
  says(mistake(sheet + ball + R"(, "grip": 2}})"), R"("grip" is for a mesh with "collides": true)");
  says(mistake(sheet + R"("b": {"mesh": {"shape": "sphere", "friction": 2}})"),
       R"("friction" is for a mesh with "collides": true or "faces")");
  says(mistake(sheet + ball + R"(, "technique": "vertex-shader", "deform": [{"ripple": {}}]}})"),
       "keeps no positions to collide with");
  says(mistake(sheet + R"("b": {"body": {"file": "meshes/walker.gltf", "collides": "faces", "grip": 2}})"),
       R"(faces have "friction" instead)");
}

TEST_CASE(
    "particles must name an existing cloth in contact, and a cloth that they pass through is reported") {
  const auto sceneOf = [](const std::string& objects) {
    return scene::parseScene(R"({"version": 1, "objects": {)" + objects + "}}", "s.json", {}, sim::kinds());
  };
  const auto mistake = [&](const std::string& objects) -> std::string {
    try {
      const auto mistakes = sim::portMistakes(sceneOf(objects));
      return mistakes.empty() ? "none" : mistakes.front();
    } catch (const simreel::UserError& error) {
      return error.what();
    }
  };
  const auto balls = [](const std::string& more) {
    return R"("b": {"particles": {"groups": [{"shape": "ball"}])" + more + "}}";
  };
  const std::string sheet = R"("c": {"cloth": {"contact": true}}, "d": {"cloth": {}}, )";
  CHECK(mistake(sheet + balls(R"(, "collides": true)")) == "none");
  CHECK(mistake(sheet + balls(R"(, "collides": true, "cloths": "c")")) == "none");
  const auto says = [](const std::string& message, const char* what) {
    CHECK_MESSAGE(message.find(what) != std::string::npos, message);
  };
  says(mistake(sheet + balls(R"(, "collides": true, "cloths": "e")")), "no object is named \"e\"");
  says(mistake(sheet + balls(R"(, "collides": true, "cloths": "d")")),
       "\"d\" is a cloth without \"contact\"");
  says(mistake(sheet + balls(R"(, "cloths": "c")")), "\"cloths\" is for particles with \"collides\": true");
  says(mistake(R"("d": {"cloth": {}}, )" + balls(R"(, "collides": true)")), "there is nothing to touch");
  const auto remarks = sim::portRemarks(sceneOf(sheet + balls(R"(, "collides": true)")));
  REQUIRE(remarks.size() == 1);
  says(remarks.front(), "pass through cloth \"d\"");
  CHECK(sim::portRemarks(sceneOf(sheet + balls(R"(, "collides": true, "cloths": "none")"))).empty());
}
