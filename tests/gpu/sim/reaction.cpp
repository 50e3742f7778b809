// Tests reaction rules on the GPU for all boundaries, methods and widths. They must equal their evaluator
// on the CPU bit for bit.
#include "sim/reaction/reaction.hpp"

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/reaction/kernels.hpp"
#include "sim/reaction/presets.hpp"
#include "sim/world/list.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double plateFrame = 1.0 / 30;

sim::ReactionParameters rule(const std::string& members) {
  const std::string text = "{\"version\": 1, \"objects\": {\"r\": {\"reaction\": {" + members + "}}}}";
  const auto scene = scene::parseScene(text, "s.json", {}, sim::kinds());
  return dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters);
}

std::unique_ptr<sim::Simulation> made(const sim::ReactionParameters& parameters) {
  testContext();
  scene::Object object;
  object.name = "r";
  object.kind = "reaction";
  object.parameters = std::make_unique<sim::ReactionParameters>(parameters);
  const std::vector<sim::ColliderShape> none;
  return sim::reactionKind().make(object, {false, 5, plateFrame, &none});
}

/// Returns the planes of a GPU state without the padding of rows, and checks that the padding is zero.
std::vector<float> planesOf(const sim::Simulation& simulation, glm::ivec2 size) {
  const auto elements = simulation.state()[0].buffer->readAll<glm::vec4>();
  const int columns = (size.x + 3) / 4;
  std::vector<float> cells;
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (int c = 0; c < 4; ++c) {
      const int x = static_cast<int>(i) % columns * 4 + c;
      if (x < size.x)
        cells.push_back(elements[i][c]);
      else
        CHECK(std::bit_cast<std::uint32_t>(elements[i][c]) == 0);
    }
  return cells;
}

void comparePlanes(const std::vector<float>& got, const std::vector<float>& want) {
  REQUIRE(got.size() == want.size());
  std::size_t different = 0, first = 0;
  float minimum = want[0], maximum = want[0];
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(got[i]) != std::bit_cast<std::uint32_t>(want[i]) && different++ == 0)
      first = i;
    minimum = std::min(minimum, want[i]);
    maximum = std::max(maximum, want[i]);
  }
  CHECK_MESSAGE(different == 0, different, " of ", got.size(), " cells differ, first ", first, ": ",
                got[first], " for ", want[first]);
  CHECK(std::isfinite(maximum - minimum));
  CHECK(maximum - minimum > 1e-3F);  // The state is not constant.
}

/// Steps the GPU simulation and the CPU evaluator and compares every bit of the state.
void compareWithTwin(const sim::ReactionParameters& p, int frames) {
  const auto gpu = made(p);
  const sim::ReactionPlan plan(p, "r", 5, plateFrame);
  sim::RuleField field = plan.firstField();
  const auto paint = [&](double time, int step) {
    if (p.space() == sim::RuleSpace::plane) return;
    for (const auto& painted : plan.strokesAt(time, step)) sim::evaluateBrush(painted, field);
  };
  paint(0, 0);
  for (int frame = 0; frame < frames; ++frame) {
    const double time = frame * plateFrame;
    gpu->step(time, {});
    for (int i = 0; i < p.steps; ++i) {
      const long step = plan.stepAt(time) + i;
      sim::evaluateStep(plan, plan.valuesAt(time), step, 0, field);
      paint(time, i + 1);
    }
  }
  std::vector<float> want;
  for (const auto& plane : field.stage) want.insert(want.end(), plane.begin(), plane.end());
  comparePlanes(planesOf(*gpu, plan.parameters().size), want);
}

/// Text of a rule with every function and operator, numbers of all magnitudes, and nested lets.
const std::string everything = R"X("dt": 0.01, "steps": 3,
  "parameters": {"p": 0.3, "q": {"keys": [[0, 1.5], [1, -2]]}, "m": {"value": 0.2, "across": 0.9}, "k": {"value": 1, "down": 2}},
  "lets": {"mu": "u^3 - u - 0.5*laplacian(u) + m", "nu": "laplacian(mu) + ddx(mu)*p", "tiny": "u*1e-20*v*1e-15"},
  "species": {
    "u": {"diffusion": 0.4, "start": "random(1) + sin(x*0.3)*0.5",
          "rate": "nu*0.01 + min(u, v, w) - max(p, u*v) + clamp(u, -0.5, 0.5) + step(p, u) + if(u < v and not w >= 1 or u == 3, 0.2, q*0.1) + tiny*1e30"},
    "v": {"diffusion": {"keys": [[0, 0.1], [1, 0.6]]}, "start": "0.5 + 0.2*random(2)", "edge": 0.25,
          "rate": "abs(u) + floor(3*v) - sqrt(abs(w)) + exp(-u*u) - log(v*v + 0.1) + sin(4*u) - cos(v) + tanh(3*u) + tanh(0.1*v) - 5*v"},
    "w": {"start": "0.3*cos(y) + x*0.01", "rate": "abs(v)^1.3 - w^3 + w^5/(1 + u^2) + v^-2*0.001 + u^q*0.01 + 0.2*noise(3) + 0.1*random(1) + t*0.1 + x*0.001 - y*0.002 + neighbours(w)*0.1 - corners(v)*0.1 - 0.2*ddy(u*v) + diffuse(k, w)*0.1 + diffuse(m, u) + pi*0.01 + width*0.001 - 2*w"}},
  )X";

/// Text of a rule with every stencil, applied to a species and to a let.
const std::string small = R"X("dt": 0.01, "steps": 3, "lets": {"w": "u*u - laplacian(u)"},
  "species": {
    "u": {"diffusion": 0.4, "start": "random(1)", "rate": "laplacian(w) + corners(w) - neighbours(u) + ddx(u)*ddy(w)"},
    "v": {"start": "random(2)", "edge": 0.25, "rate": "ddx(w) - ddy(u) + neighbours(v) - 4*v"}}, )X";

}  // namespace

// Pointwise functions use the same code for all boundaries and methods, so they are tested once with each
// boundary and once with each method. Stencils depend on both, so every pair is tested. A kernel with all
// functions takes ten times as long to compile as a kernel with stencils.
TEST_CASE(
    "reaction: every function and every stencil equal the evaluator, on every boundary, by every method") {
  const std::array<const char*, 3> boundaries = {"torus", "no-flux", "fixed"},
                                   methods = {"rk4", "euler", "heun"};
  for (std::size_t b = 0; b < 3; ++b)
    for (std::size_t m = 0; m < 3; ++m) {
      CAPTURE(boundaries[b]);
      CAPTURE(methods[m]);
      auto p = rule((b == m ? everything : small) +
                    fmt::format("\"boundary\": \"{}\", \"method\": \"{}\"", boundaries[b], methods[m]));
      p.size = {67, 45};
      p.show = b == m ? "mu*laplacian(nu)" : "w*laplacian(v)";
      compareWithTwin(p, 4);
    }
}

TEST_CASE("reaction equals its evaluator on widths down to four") {
  for (const glm::ivec2 size :
       {glm::ivec2(4, 5), glm::ivec2(5, 4), glm::ivec2(6, 9), glm::ivec2(7, 6), glm::ivec2(131, 13)})
    for (const char* boundary : {"torus", "no-flux", "fixed"}) {
      CAPTURE(size.x);
      CAPTURE(size.y);
      auto p = rule(small + fmt::format("\"boundary\": \"{}\"", boundary));
      p.size = size;
      compareWithTwin(p, 3);
    }
}

TEST_CASE("reaction: every preset equals the evaluator") {
  for (const sim::ReactionPreset& preset : sim::reactionPresets()) {
    CAPTURE(preset.name);
    auto p = rule(fmt::format("\"preset\": \"{}\"", preset.name));
    p.size = {43, 37};
    compareWithTwin(p, 4);
  }
}

TEST_CASE("reaction in a volume equals the evaluator: every function, boundary and method, odd sizes") {
  // The rule for planes gets derivatives along z and terms that differ between layers.
  std::string deep = everything;
  deep.replace(deep.find("ddy(u*v)"), 8, "ddz(u*v)");
  deep.replace(deep.find("x*0.001"), 7, "z*0.003 + depth*0.001 + ddz(nu)*0.001");
  for (const bool rk4 : {false, true})
    for (const char* boundary : {"torus", "no-flux", "fixed"}) {
      CAPTURE(boundary);
      CAPTURE(rk4);
      // Each boundary and each method is tested once with all functions.
      const bool all = rk4 == (std::string(boundary) == "torus");
      auto p =
          rule((all ? deep : small) + fmt::format("\"depth\": 9, \"boundary\": \"{}\", \"method\": \"{}\"",
                                                  boundary, rk4 ? "rk4" : "euler"));
      p.size = {19, 7};
      p.show = all ? "mu*laplacian(nu)" : "w*laplacian(v)";
      p.surface.color = all ? "w + ddz(u)" : "w + ddz(v)";
      compareWithTwin(p, 3);
    }
  for (const glm::ivec3 size :
       {glm::ivec3(4, 5, 2), glm::ivec3(5, 4, 3), glm::ivec3(6, 9, 5), glm::ivec3(131, 5, 4)})
    for (const char* boundary : {"torus", "no-flux", "fixed"}) {
      CAPTURE(size.x);
      CAPTURE(size.z);
      auto p = rule(small + fmt::format("\"boundary\": \"{}\"", boundary));
      p.size = {size.x, size.y};
      p.depth = size.z;
      compareWithTwin(p, 3);
    }
}

TEST_CASE("reaction in a volume: a diverging state is reported with its three coordinates") {
  auto p = rule(R"X("dt": 1, "steps": 10, "depth": 5, "species": {"quiet": {},
                    "loud": {"rate": "if(x > 10 and x < 11 and y > 7 and y < 8 and z > 2 and z < 3, 3/max(6 - t, 0), 0)"}})X");
  p.size = {17, 11};
  const auto gpu = made(p);
  gpu->step(0, {});
  const auto status = gpu->status()->readAll<unsigned>();
  REQUIRE(status[0] != 0xffffffffU);
  CHECK(gpu->explainLoss(status[0], status[1]).find("\"loud\" of cell (10, 7, 2)") != std::string::npos);
}

TEST_CASE("reaction on a mesh equals the evaluator, by every method") {
  const std::string skin = R"X("dt": 0.01, "steps": 3, "lets": {"w": "u*u - laplacian(u)"},
    "parameters": {"k": {"value": 1, "down": 2}, "m": {"value": 0, "across": 0.3}},
    "species": {
      "u": {"diffusion": 0.4, "start": "random(1) + 0.01*x", "rate": "0.02*laplacian(w) - 0.1*u + m*sin(z)"},
      "v": {"diffusion": 0.1, "start": "sin(y) + 0.1*z", "rate": "0.1*diffuse(k, u) + noise(1) - y*0.01 + depth*0.01"}}, )X";
  for (const char* mesh : {R"X({"shape": "sphere", "resolution": [19, 10]})X",
                           R"X({"shape": "torus", "resolution": [14, 9], "refine": 1})X",
                           R"X({"shape": "plane", "resolution": [4, 4]})X"})
    for (const char* method : {"euler", "heun", "rk4"}) {
      CAPTURE(std::string(mesh));
      CAPTURE(method);
      auto p = rule(skin + fmt::format("\"mesh\": {}, \"method\": \"{}\"", mesh, method));
      p.show = "w*u";
      compareWithTwin(p, 3);
    }
}

TEST_CASE("reaction: automata equal the evaluator, in volumes, planes and on meshes") {
  const std::string life = R"X("lets": {"alive": "u == 1", "n": "around(alive)"}, "steps": 2, "species": {
    "u": {"start": "if(random(1) > 0.3, 1, 0)", "next": "if(u == 0, n >= 5 and n <= 6, if(u == 1, if(n >= 4 and n <= 5, 1, 2), if(u == 4, 0, u + 1)))"},
    "seen": {"rate": "around(u)*0.01 - seen"}})X";
  for (const char* boundary : {"torus", "no-flux", "fixed"})
    for (const int depth : {1, 6}) {
      CAPTURE(boundary);
      auto p = rule(life + fmt::format(", \"boundary\": \"{}\"", boundary));
      p.size = {22, 13};
      p.depth = depth;
      compareWithTwin(p, 4);
    }
  compareWithTwin(rule(life + R"X(, "mesh": {"shape": "torus", "resolution": [18, 9]})X"), 4);
}

TEST_CASE("reaction: strokes in volumes and on meshes equal the evaluator") {
  const auto strokes = [](const char* unit) {
    return fmt::format(
        R"X("steps": 3, "dt": 0.05, "species": {{"u": {{"diffusion": 0.5}}, "v": {{"diffusion": 1, "start": "random(1)"}}}},
      "strokes": [{{"until": 1, "from": [{0}1, {0}2, {0}1], "to": [{0}9, {0}8, {0}7], "radius": {0}2, "fraction": 0.7}},
                  {{"at": 0.05, "shape": "line", "species": "v", "from": [-{0}4, {0}2, {0}5], "to": [{0}4, {0}9, {0}5], "radius": {0}2, "value": 2}}], )X",
        unit);
  };
  for (const char* boundary : {"torus", "no-flux", "fixed"}) {
    auto p = rule(strokes("") + fmt::format("\"boundary\": \"{}\"", boundary));
    p.size = {22, 13};
    p.depth = 6;
    compareWithTwin(p, 4);
  }
  compareWithTwin(
      rule(strokes("0.") + R"X("mesh": {"shape": "torus", "resolution": [22, 13], "rotation": [0, 20, 10],
    "position": {"keys": [[0, [0, 0, 0]], [1, [1, 0, 0]]]}})X"),
      4);
}

TEST_CASE("reaction: a diverging state is reported with species, cell and step") {
  auto p = rule(R"X("dt": 1, "steps": 10, "species": {"quiet": {},
                    "loud": {"rate": "if(x > 20 and x < 21 and y > 7 and y < 8, 3/max(6 - t, 0), 0)"}})X");
  p.size = {37, 21};
  const auto gpu = made(p);
  gpu->step(0, {});
  const auto status = gpu->status()->readAll<unsigned>();
  REQUIRE(status[0] != 0xffffffffU);
  CHECK(gpu->explainLoss(status[0], status[1]).find("\"loud\" of cell (20, 7)") != std::string::npos);
  CHECK(gpu->explainLoss(status[0], status[1]).find("after step 7;") != std::string::npos);
}

TEST_CASE(
    "reaction: several steps per pass give the same bits and the same report of divergence as single "
    "steps") {
  testContext();
  // Kernels that compute several steps per pass support ddy only on a torus, because ddy changes sign under
  // reflection.
  const std::string three = R"X("dt": 0.1, "steps": 11, "lets": {"all": "u + v + w"}, "species": {
    "u": {"diffusion": 0.3, "start": "abs(random(1))", "rate": "u*(1 - all - v) + 0.01*corners(w)"},
    "v": {"diffusion": 0.2, "start": "abs(random(2))", "rate": "v*(1 - all - w) - 0.01*neighbours(u)"},
    "w": {"start": "abs(random(3))", "rate": "w*(1 - all - u) + 0.1*laplacian(u)^2"}})X";
  const std::string grown = R"X("dt": 1, "steps": 11, "species": {
    "u": {"diffusion": 0.063, "start": "1 - 0.4*abs(random(1))", "rate": "0.04*(1 - u) - u*v^2 + 0.01*corners(v) - 0.01*neighbours(v)"},
    "v": {"diffusion": 0.0315, "start": "0.4*abs(random(2))", "rate": "u*v^2 - 0.1*v + 0.001*tanh(ddy(u))"}})X";
  for (const glm::ivec2 size : {glm::ivec2(4, 5), glm::ivec2(64, 37), glm::ivec2(260, 9)}) {
    CAPTURE(size.x);
    for (const bool isClosed : {false, true}) {
      CAPTURE(isClosed);
      if (isClosed && size.x > 64) continue;
      auto p = rule((isClosed ? three : grown) +
                    fmt::format(", \"boundary\": \"{}\"", isClosed ? "no-flux" : "torus"));
      p.size = size;
      const sim::ReactionPlan plan(p, "r", 5, plateFrame);
      REQUIRE(sim::stripsCan(plan.rule(), plan.program(), p.space(), p.boundary, size.x));
      std::vector<glm::vec4> first;
      std::vector<sim::WorkSplit> cuts = {{}, {1, 32, 4, 2, 3, 7}};
      if (isClosed)
        cuts.push_back({1, 32, 4, 4, 3, 0});
      else
        cuts.insert(cuts.end(), {{1, 32, 4, 4, 6, 0}, {1, 32, 4, 8, 5, 16}});
      for (const sim::WorkSplit& cut : cuts) {
        sim::ReactionKernels kernels("r", plan, false, cut);
        kernels.setValues(plan.valuesAt(0));
        kernels.advance(0, 11, 0);
        gl::barrier();
        const auto cells = kernels.cells().buffer().readAll<glm::vec4>();
        if (first.empty()) first = cells;
        CHECK(std::equal(first.begin(), first.end(), cells.begin(), cells.end()));
      }
    }
  }
  auto odd = rule(grown);
  odd.boundary = sim::RuleBoundary::noFlux;
  const sim::ReactionPlan single(odd, "r", 5, plateFrame);
  CHECK(!sim::stripsCan(single.rule(), single.program(), odd.space(), odd.boundary, 64));
  // At some cell and step, the state diverges.
  auto p = rule(
      R"X("dt": 1, "species": {"u": {"start": "1 + 0.3*random(1)", "rate": "u^3"}, "v": {"diffusion": 0.1, "rate": "u"}})X");
  p.size = {64, 48};
  const sim::ReactionPlan plan(p, "r", 5, plateFrame);
  std::vector<unsigned> expected;
  for (const sim::WorkSplit& cut :
       {sim::WorkSplit{}, sim::WorkSplit{1, 32, 4, 4, 6, 0}, sim::WorkSplit{1, 32, 4, 3, 4, 9}}) {
    sim::ReactionKernels kernels("r", plan, false, cut);
    kernels.setValues(plan.valuesAt(0));
    kernels.advance(0, 12, 0);
    gl::barrier();
    const auto status = kernels.status().readAll<unsigned>();
    CHECK(status[0] < 12);
    if (expected.empty()) expected = status;
    CHECK(status[0] == expected[0]);
    CHECK(status[1] == expected[1]);
  }
}

TEST_CASE("reaction: every cut of the work into workgroups gives the same bits") {
  testContext();
  auto p = rule(everything + "\"boundary\": \"torus\"");
  p.size = {147, 83};
  const sim::ReactionPlan plan(p, "r", 5, plateFrame);
  std::vector<glm::vec4> first;
  for (const sim::WorkSplit& cut : {sim::WorkSplit{}, sim::WorkSplit{1, 8, 8}, sim::WorkSplit{7, 32, 1}}) {
    sim::ReactionKernels kernels("r", plan, false, cut);
    kernels.setValues(plan.valuesAt(0));
    kernels.advance(0, 9, 0);
    gl::barrier();
    const auto cells = kernels.cells().buffer().readAll<glm::vec4>();
    if (first.empty()) first = cells;
    CHECK(std::equal(first.begin(), first.end(), cells.begin(), cells.end()));
  }
}

TEST_CASE(
    "reaction: every cut of a volume into workgroups gives the same bits and finds the same diverging "
    "cell") {
  testContext();
  auto p = rule(R"X("depth": 6, "dt": 0.1, "boundary": "fixed", "lets": {"q": "u*laplacian(v) + ddz(u)"},
      "species": {"u": {"start": "random(1)", "diffusion": 0.2, "rate": "v - u^3 + 0.01*x + noise(2)"},
                  "v": {"start": "random(2)", "diffusion": 0.1, "rate": "u*ddx(v) + ddy(u) - 0.1*q*z"}})X");
  p.size = {39, 13};
  auto failing = rule(
      R"X("depth": 6, "dt": 1, "species": {"u": {"diffusion": 0.001, "start": "1 + 0.3*random(1)", "rate": "u^3"}})X");
  failing.size = p.size;
  for (const sim::ReactionPlan& plan :
       {sim::ReactionPlan(p, "r", 5, plateFrame), sim::ReactionPlan(failing, "r", 5, plateFrame)}) {
    std::vector<glm::vec4> first;
    std::vector<unsigned> expected;
    for (const int rows : {2, 5, 16}) {
      sim::WorkSplit cut;
      cut.volumeRows = rows;
      sim::ReactionKernels kernels("r", plan, false, cut);
      kernels.setValues(plan.valuesAt(0));
      kernels.advance(0, 9, 0);
      gl::barrier();
      const auto cells = kernels.cells().buffer().readAll<glm::vec4>();
      const auto status = kernels.status().readAll<unsigned>();
      if (first.empty()) {
        first = cells;
        expected = status;
      }
      CHECK(status == expected);
      if (status[0] > 9) CHECK(std::equal(first.begin(), first.end(), cells.begin(), cells.end()));
    }
  }
}
