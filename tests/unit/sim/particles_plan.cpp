#include "base/error.hpp"
#include "reference/particles_twin.hpp"
#include "scene/load.hpp"
#include "sim/particles/file.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;
using simreel::test::TemporaryFile;
namespace fs = std::filesystem;

namespace {

std::string problemOf(const std::string& text, int max = 100) {
  const TemporaryFile file("bad", text);
  try {
    (void)sim::readParticles(file.path(), 1, max);
  } catch (const UserError& error) {
    const std::string line = error.what();
    const bool many = line.find("the most that fit here") != std::string::npos;
    CHECK(error.code() == (many ? ExitCode::usage : ExitCode::inputOutput));
    CHECK(line.find('\n') == std::string::npos);
    CHECK(line.find(file.path().string()) == 0);
    return line.substr(file.path().string().size() + 2);
  }
  return "";
}

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

sim::ParticleParameters fountain() {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  auto& emitter = p.emitters.emplace_back();
  emitter.rate = 777;
  emitter.lifetime = 0.5F;
  emitter.lifetimeVariation = 0.4F;
  return p;
}

scene::Scene parsed(const std::string& object) {
  return scene::parseScene("{\"version\": 1, \"objects\": {\"cloud\": {\"particles\": " + object + "}}}",
                           "test.json", {}, sim::kinds());
}

std::string sceneProblem(const std::string& object) {
  try {
    (void)parsed(object);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("particle CSV files are read by column name") {
  const TemporaryFile file(
      "good.csv", "# made by hand\nmass, z, y,x,name,vy\r\n2,3,2,1,alpha,-1\r\n\n4,6,5,+4,b,1e-1\n");
  const auto cloud = sim::readParticles(file.path(), 1, 10);
  REQUIRE(cloud.positions.size() == 2);
  CHECK(cloud.positions[0] == glm::vec4(1, 2, 3, 2));
  CHECK(cloud.positions[1] == glm::vec4(4, 5, 6, 4));
  CHECK(cloud.velocities[1] == glm::vec4(0, 0.1F, 0, 0));
}

TEST_CASE("particles of a file without masses share the group's mass") {
  // The file is in the form in which spreadsheets write: with a byte order mark, capitals, quotes, and
  // commas inside quotes.
  const TemporaryFile sheet(
      "sheet.csv", "\xEF\xBB\xBF\"X\",\"Y\", \"Z\",\"Name, first\",Mass\r\n1,2,\"3\",\"a, b\",4\r\n");
  CHECK(sim::readParticles(sheet.path(), 1, 10).positions.at(0) == glm::vec4(1, 2, 3, 4));
  const TemporaryFile file("shared.csv", "x,y,z\n1,2,3\n4,5,6");
  CHECK(sim::readParticles(file.path(), 3, 10).positions[1].w == 1.5F);
}

TEST_CASE("particle PLY files are read, ascii and binary") {
  const std::string rest =
      "element vertex 2\nproperty float x\nproperty double y\nproperty float z\nproperty uchar red\n"
      "property float vx\nproperty short mass\nelement face 0\nproperty list uchar int vertex_indices\n"
      "end_header\n";
  const TemporaryFile ascii(
      "a.ply", "ply\nformat ascii 1.0\ncomment hello\n" + rest + "1 2 3 255 0.5 7\n4 5 6 0 -1 8\n");
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + rest;
  const double rows[2][6] = {{1, 2, 3, 255, 0.5, 7}, {4, 5, 6, 0, -1, 8}};
  for (const auto& row : rows) {
    append(bytes, static_cast<float>(row[0]));
    append(bytes, row[1]);
    append(bytes, static_cast<float>(row[2]));
    append(bytes, static_cast<unsigned char>(row[3]));
    append(bytes, static_cast<float>(row[4]));
    append(bytes, static_cast<short>(row[5]));
  }
  const TemporaryFile binary("b.ply", bytes);
  const TemporaryFile lists(
      "c.ply",
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int i\nelement vertex 2\n"
      "property list uchar float w\nproperty float X\nproperty float Y\nproperty float Z\n"
      "property float vx\nproperty int mass\nend_header\n"
      "3 0 1 1\n2 9 9 1 2 3 0.5 7\n0 4 5 6 -1 8\n");
  for (const fs::path& path : {ascii.path(), binary.path(), lists.path()}) {
    const auto cloud = sim::readParticles(path, 1, 10);
    REQUIRE(cloud.positions.size() == 2);
    CHECK(cloud.positions[0] == glm::vec4(1, 2, 3, 7));
    CHECK(cloud.positions[1] == glm::vec4(4, 5, 6, 8));
    CHECK(cloud.velocities[1] == glm::vec4(-1, 0, 0, 0));
  }
}

TEST_CASE("particle files may be separated by semicolons or tabs") {
  for (const char separator : {',', ';', '\t'}) {
    std::string text = "x,y,z,mass\n1,2,3,7\n";
    for (char& c : text)
      if (c == ',') c = separator;
    const TemporaryFile file("separated.csv", text);
    CHECK(sim::readParticles(file.path(), 1, 10).positions.at(0) == glm::vec4(1, 2, 3, 7));
  }
  CHECK(problemOf("x;y;z\n1,5;2;3\n") == "line 2: \"1,5\" is not a number");
}

TEST_CASE("unusable particle files are refused in one line") {
  CHECK(problemOf("") == "no particles in it");
  CHECK(problemOf("x,y,z\n") == "no particles in it");
  CHECK(problemOf("x,z\n1,2\n").find("no column \"y\"") == 0);
  CHECK(problemOf("x,y,z,x\n").find("line 1: column \"x\" twice") == 0);
  CHECK(problemOf("x,y,z\n1,2\n").find("line 2: 2 values") == 0);
  CHECK(problemOf("x,y,z\n1,2,3\n1,two,3\n") == "line 3: \"two\" is not a number");
  CHECK(problemOf("x,y,z\n1,,3\n") == "line 2: \"\" is not a number");
  CHECK(problemOf("x,y,z\n1,nan,3\n") == "line 2: y is not a finite number");
  CHECK(problemOf("x,y,z\n1,2,inf\n") == "line 2: z is not a finite number");
  CHECK(problemOf("x,y,z\n1,2,1e30\n").find("line 2: z = 1e+30 is beyond 1e7") == 0);
  CHECK(problemOf("x,y,z,mass\n1,2,3,0\n").find("line 2: the mass is 0") == 0);
  CHECK(problemOf("x,y,z,mass\n1,2,3,-4\n").find("line 2: the mass is -4") == 0);
  CHECK(problemOf("x,y,z\n1,2,3\n1,2,3\n1,2,3\n", 2).find("more than 2 particles") == 0);
  CHECK(problemOf("ply\nformat ascii 1.0\n") == "has no \"end_header\"");
  CHECK(problemOf("ply\nend_header\n").find("has no format in its header") == 0);
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n";
  CHECK(problemOf(head + "end_header\n").find("no column \"z\"") == 0);
  CHECK(problemOf(head + "property float z\nend_header\n1 2 3\n") == "is cut off at vertex 1 of 3");
  CHECK(problemOf(head + "property float z\nend_header\n1 2\n") == "is cut off at vertex 0 of 3");
  CHECK(problemOf(head + "property list uchar int z\nend_header\n").find("no column \"z\"") == 0);
  CHECK(problemOf(
            "ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\nproperty float y\n"
            "property float z\nend_header\nabc") == "is cut off at vertex 0 of 9");
  CHECK(problemOf("ply\nformat ascii 1.0\nelement face 0\nend_header\n") == "has no vertices");
}

TEST_CASE("emitters emit at their rate and never overwrite living particles") {
  const auto p = fountain();
  ParticlesTwin twin(sim::ParticlePlan(p, 1, 1.0 / 60));
  std::vector<float> before(twin.velocities.size(), -1.0F);
  int early = 0;
  for (int frame = 0; frame < 240; ++frame) {
    twin.step(frame / 60.0);
    int alive = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      const float age = twin.velocities[i].w;
      alive += age >= 0 ? 1 : 0;
      // `early` counts slots that are reborn although the last particle had more than a substep to live.
      if (age >= 0 && age < before[i] && before[i] < 0.9F) ++early;
      CHECK((age < 0) == (twin.positions[i].w == 0));
      before[i] = age;
    }
    if (frame >= 60) CHECK(alive == doctest::Approx(777 * 0.5).epsilon(0.1));
  }
  CHECK(early == 0);
}

TEST_CASE("emitters start and stop at their times, including the pre-roll") {
  auto p = fountain();
  sim::ParticlePlan plan(p, 1, 1.0 / 60);
  int born = 0;
  for (int frame = -60; frame < 0; ++frame) born += plan.frame(frame / 60.0)[0].emitters[0].newborns;
  CHECK(born == 777);
  p.emitters[0].from = 1;
  p.emitters[0].until = 3;
  sim::ParticlePlan timed(p, 1, 1.0 / 60);
  born = 0;
  for (int frame = 0; frame < 60; ++frame) born += timed.frame(frame / 60.0)[0].emitters[0].newborns;
  CHECK(born == 0);
  for (int frame = 60; frame < 600; ++frame) born += timed.frame(frame / 60.0)[0].emitters[0].newborns;
  CHECK(born == 2 * 777);
}

TEST_CASE("newborn particles lie in the given cone and ball") {
  auto p = fountain();
  p.emitters[0].velocity = glm::vec3(0, 0, -4);
  p.emitters[0].spread = 30;
  p.emitters[0].radius = 0.5F;
  p.emitters[0].position = glm::vec3(1, 2, 3);
  ParticlesTwin twin(sim::ParticlePlan(p, 1, 1.0 / 60));
  float widest = 0;
  float farthest = 0;
  for (int frame = 0; frame < 20; ++frame) twin.step(frame / 60.0);
  for (std::size_t i = 0; i < twin.positions.size(); ++i) {
    if (twin.velocities[i].w < 0) continue;
    const glm::vec3 v(twin.velocities[i]);
    const float speed = glm::length(v);
    CHECK(speed == doctest::Approx(4).epsilon(0.301));
    widest = std::max(widest, std::acos(glm::dot(v / speed, glm::vec3(0, 0, -1))));
    // The flight is traced back over the particle's age, which is a fraction of the slot's lifetime of 0.3
    // to 0.7 s.
    const glm::vec3 fromMiddle = glm::vec3(twin.positions[i]) - glm::vec3(1, 2, 3);
    const glm::vec3 across = fromMiddle - glm::dot(fromMiddle, v) / glm::dot(v, v) * v;
    farthest = std::max(farthest, glm::length(across));
  }
  CHECK(widest < 30.01F * 3.14159265F / 180);
  CHECK(widest > 26.0F * 3.14159265F / 180);
  CHECK(farthest < 0.501F);
  CHECK(farthest > 0.35F);
}

TEST_CASE("groups have the given shape, mass and motion") {
  sim::ParticleParameters p;
  auto& g = p.groups.emplace_back();
  g.count = 5001;
  g.radius = 2;
  g.totalMass = 10;
  g.position = glm::vec3(5, 0, 0);
  g.velocity = glm::vec3(0, 3, 0);
  const auto middleOf = [](const std::vector<glm::vec4>& items) {
    glm::dvec3 sum(0);
    for (const auto& item : items) sum += glm::dvec3(item);
    return sum / static_cast<double>(items.size());
  };
  const auto ball = sim::ParticlePlan(p, 1, 1).firstCloud();
  int inner = 0;
  for (const auto& position : ball.positions) {
    const float r = glm::length(glm::vec3(position) - g.position);
    CHECK(r < 2.0001F);
    inner += r < 1 ? 1 : 0;
  }
  CHECK(inner / 5001.0 == doctest::Approx(0.125).epsilon(0.1).scale(0));
  CHECK(glm::length(middleOf(ball.positions) - glm::dvec3(5, 0, 0)) < 0.05);
  CHECK(middleOf(ball.velocities).y == doctest::Approx(3));
  CHECK(ball.positions[7].w * 5001 == doctest::Approx(10));
  CHECK(sim::ParticlePlan(p, 1, 1).firstCloud().positions == ball.positions);
  CHECK(sim::ParticlePlan(p, 2, 1).firstCloud().positions != ball.positions);

  g.shape = sim::ParticleGroup::Shape::plummer;
  g.position = glm::vec3(0);
  auto half = sim::ParticlePlan(p, 1, 1).firstCloud().positions;
  inner = 0;
  for (const auto& position : half) inner += glm::length(glm::vec3(position)) < 2 * 1.3048F ? 1 : 0;
  // The half-mass radius of a Plummer sphere with scale a is 1.305 a.
  CHECK(inner / 5001.0 == doctest::Approx(0.5).epsilon(0.05).scale(0));
  CHECK(glm::length(middleOf(half)) < 1e-5);

  g.shape = sim::ParticleGroup::Shape::disk;
  g.velocity = glm::vec3(0);
  g.centralMass = 3;
  const auto disk = sim::ParticlePlan(p, 1, 1).firstCloud();
  REQUIRE(disk.positions.size() == 5002);
  CHECK(disk.positions.back() == glm::vec4(0, 0, 0, 3));
  double height = 0;
  double spin = 0;
  double radius = 0;
  for (std::size_t i = 0; i < 5001; ++i) {
    height += std::abs(disk.positions[i].y);
    radius += std::hypot(disk.positions[i].x, disk.positions[i].z);
    spin += glm::cross(glm::vec3(disk.positions[i]), glm::vec3(disk.velocities[i])).y;
  }
  // The mean radius of an exponential disc with scale Rd, whose density is proportional to R e^(-R / Rd),
  // is 2 Rd.
  CHECK(radius / 5001 == doctest::Approx(2 * 2).epsilon(0.05).scale(0));
  // The mean height for a sech^2 profile with scale z0 is z0 ln 2.
  CHECK(height / 5001 == doctest::Approx(0.1 * 0.693).epsilon(0.1).scale(0));
  CHECK(spin > 0);
}

TEST_CASE("a disk turns steadily: its size is constant over two rotations") {
  sim::ParticleParameters p;
  auto& g = p.groups.emplace_back();
  g.shape = sim::ParticleGroup::Shape::disk;
  g.count = 801;
  g.centralMass = 2;
  g.thickness = 0.1F;
  p.gravity = 1;
  p.softening = 0.15F;
  ParticlesTwin twin(sim::ParticlePlan(p, 3, 0.04));
  const auto meanRadius = [&] {
    double sum = 0;
    for (const auto& x : twin.positions) sum += std::hypot(x.x, x.z);
    return sum / static_cast<double>(twin.positions.size());
  };
  const double first = meanRadius();
  for (int i = 0; i < 500; ++i) {  // The loop simulates 20 s. An orbit at R = 2 takes about 9 s.
    twin.step(i * 0.04, 0);
    if (i % 100 == 99) CHECK(meanRadius() == doctest::Approx(first).epsilon(0.08));
  }
}

TEST_CASE("too many particle slots are refused in one line") {
  auto p = fountain();
  p.emitters[0].rate = 1e8F;
  p.emitters[0].lifetime = 1e5F;
  try {
    const sim::ParticlePlan plan(p, 1, 1, 1000000);
    FAIL("accepted");
  } catch (const UserError& error) {
    CHECK(std::string(error.what()).find("more than the 1000000 that fit") != std::string::npos);
  }
}

TEST_CASE("particle scenes are read and their errors reported") {
  const auto scene = parsed(R"({
    "groups": [{"shape": "plummer", "count": 300, "totalMass": 5}],
    "emitters": [{"rate": 10, "velocity": {"keys": [[0, [0, 1, 0]], [1, [1, 1, 0]]]}}],
    "method": "none", "attractor": {"position": [1, 2, 3]}, "turbulence": {"strength": 2},
    "look": {"colorBy": "age", "colors": "magma", "colorTo": 0.5}})");
  const auto& p = dynamic_cast<const sim::ParticleParameters&>(*scene.objects[0].parameters);
  CHECK(p.groups[0].shape == sim::ParticleGroup::Shape::plummer);
  CHECK(p.emitters[0].velocity.moves());
  CHECK(p.method == sim::GravityMethod::none);
  CHECK(p.attractor.has_value());
  CHECK(p.attractor->mass.at(0) == 100.0F);
  CHECK(p.turbulence.strength == 2.0F);
  CHECK(p.colorBy == sim::Instances::ColorBy::age);
  CHECK(p.colorRange == glm::vec2(0, 0.5F));
  CHECK(p.colors.size() >= 2);
  const auto own =
      parsed(R"({"groups": [{}], "look": {"colorStops": [{"color": [1, 0, 0]}, {"color": [0, 0, 1]}]}})");
  CHECK(dynamic_cast<const sim::ParticleParameters&>(*own.objects[0].parameters).colors ==
        std::vector<glm::vec3>{glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)});

  CHECK(sceneProblem("{}").find("no particles") != std::string::npos);
  CHECK(sceneProblem(R"({"groups": [{"shape": "file"}]})").find("needs \"file\"") != std::string::npos);
  CHECK(sceneProblem(R"({"groups": [{"count": 0}]})").find("count") != std::string::npos);
  CHECK(sceneProblem(R"({"groups": [{}], "look": {"shape": "mesh"}})").find("needs \"mesh\"") !=
        std::string::npos);
  CHECK(sceneProblem(R"({"groups": [{}], "look": {"colors": "viridi"}})").find("viridis") !=
        std::string::npos);
  CHECK(sceneProblem(R"({"groups": [{}], "atractor": {}})").find("attractor") != std::string::npos);
  CHECK(sceneProblem(R"({"emitters": [{"from": 2, "until": 1}]})").find("stops before") !=
        std::string::npos);
}

TEST_CASE("particles attract each other by default, except for streams from emitters alone") {
  const auto methodOf = [](const std::string& object) {
    return dynamic_cast<const sim::ParticleParameters&>(*parsed(object).objects[0].parameters).method;
  };
  CHECK(methodOf(R"({"groups": [{}]})") == sim::GravityMethod::allPairs);
  CHECK(methodOf(R"({"groups": [{}], "emitters": [{}]})") == sim::GravityMethod::allPairs);
  CHECK(methodOf(R"({"emitters": [{}]})") == sim::GravityMethod::none);
  CHECK(methodOf(R"({"emitters": [{}], "method": "all-pairs"})") == sim::GravityMethod::allPairs);
}
