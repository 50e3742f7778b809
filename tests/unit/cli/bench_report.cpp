#include "base/error.hpp"
#include "base/file.hpp"
#include "cli/bench/chart.hpp"
#include "cli/bench/report.hpp"
#include "cli/bench/rows.hpp"
#include "scene/load.hpp"
#include "scene/value/choices.hpp"
#include "unit/frame/help.hpp"

#include <cstdlib>
#include <pugixml.hpp>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::cli;
using frame::test::contains;

namespace {

/// Returns a row of five frames that take 10 ms each, except frame 33 with 50 ms.
BenchRow row(const std::string& name, bool waited) {
  BenchRow made{{name, {{"objects.sea.mesh.technique", name}}}, {640, 360}, "abc", {}};
  made.times.frames = {31, 32, 33, 34, 35};
  made.times.wall = {10, 10, 50, 10, 10};
  made.times.waited = {1, 1, 1, 1, 1};
  made.times.processor = {30, 30, 90, 30, 45};
  const std::vector<double> none = waited ? std::vector<double>() : std::vector<double>(5, 0.5);
  made.times.stages = {{"step sea", std::vector<double>(5, 6), none, {}},
                       {"shadow", std::vector<double>(5, 0.01), none, {}},
                       {"surfaces", std::vector<double>(5, 2), none, {}}};
  made.times.stages[0].parts = {{"deform", std::vector<double>(5, 4)},
                                {"normals", std::vector<double>(5, 1)}};
  return made;
}

BenchReport report(bool waited) {
  return {.scene = "here/a<b>&\"c\".json",
          .device = "a device",
          .driver = "4.5",
          .memoryPath = "texel",
          .software = true,
          .processors = 4,
          .timing = waited ? frame::Timing::wait : frame::Timing::query,
          .frames = 5,
          .warmUp = 2,
          .rounds = 1,
          .rows = {row("jobs", waited), row("<compute> & more", waited)}};
}

std::string lint(const std::string& text) {
  const frame::test::TemporaryFolder folder;
  writeFileAtomically(folder / "chart.svg", text);
  const std::string command = fmt::format("xmllint --noout '{}' > '{}' 2>&1",
                                          (folder / "chart.svg").string(), (folder / "said").string());
  return std::system(command.c_str()) == 0 ? "" : "refused: " + readFile(folder / "said", "output");
}

std::string message(const std::string& technique, const scene::Scene& scene) {
  try {
    static_cast<void>(parseTechniques(technique, scene, {}));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("bench: the figures of a row are computed from its samples") {
  const RowFigures f = figuresOf(row("jobs", true).times, frame::Timing::wait);
  CHECK(f.frame.median == 10);
  CHECK(f.outliers.count == 1);
  CHECK(f.perSecond == doctest::Approx(5e3 / 90));
  CHECK(f.processors == doctest::Approx(2.5));  // 225 ms of processor time in 90 ms of wall-clock time are
                                                // 2.5 processors.
  CHECK(f.cpu == doctest::Approx(8.01));
  CHECK(f.bound == "step sea (deform), 60%");
  const auto gpu = row("jobs", false).times;
  CHECK(figuresOf(gpu, frame::Timing::query).bound == "CPU: step sea (deform), 60%");
  auto drawn = gpu;
  drawn.stages[2].gpu.assign(5, 9.0);
  CHECK(figuresOf(drawn, frame::Timing::query).bound == "GPU: surfaces, 90%");
  auto idle = gpu;
  idle.stages[0].cpu.assign(5, 0.5);
  CHECK(figuresOf(idle, frame::Timing::query).bound == "waiting");
  CHECK(figuresOf({}, frame::Timing::query).bound.empty());
}

TEST_CASE("bench: tables have the expected columns and leave out minor stages") {
  const std::string text = benchText(report(true));
  CHECK(contains(text, "1, worst 50.0 ms in frame 33"));
  CHECK(contains(text, "of it deform"));
  CHECK(contains(text, "640x360"));
  CHECK(contains(text, "processors busy"));
  CHECK(contains(text, "62%"));           // 2.5 of 4 processors are 62%.
  CHECK_FALSE(contains(text, "shadow"));  // The stage "shadow" takes only 0.1% of the frame.
  CHECK_FALSE(contains(text, "GPU"));
  const std::string both = benchText(report(false));
  CHECK(contains(both, "jobs, GPU"));
  CHECK(contains(both, "jobs, CPU"));
  BenchReport empty = report(true);
  empty.rows[1].times = {};
  CHECK(contains(benchText(empty), "<compute> & more"));
}

TEST_CASE("bench: the JSON report has all figures") {
  const auto json = benchJson(report(false));
  const auto& first = json["rows"][0];
  CHECK(json["bench"] == 1);
  CHECK(first["set"]["objects.sea.mesh.technique"] == "jobs");
  CHECK(first["outliers"]["worst"]["frame"] == 33);
  CHECK(json["processors"] == 4);
  CHECK(first["processorsBusy"] == 0.625);
  CHECK(first["processor"]["median"] == 30);
  CHECK(first["stages"][0]["parts"]["deform"]["median"] == 4);
  CHECK(first["stages"][0]["gpu"]["p95"] == 0.5);
  CHECK(first["samples"]["ms"].size() == 5);
  CHECK(benchJson(report(true))["rows"][0]["stages"][0]["gpu"].is_null());
}

TEST_CASE("bench: the chart is well-formed and to scale") {
  for (const bool waited : {true, false}) {
    const std::string svg = benchChart(report(waited));
    CHECK(lint(svg) == "");
    pugi::xml_document document;
    REQUIRE(document.load_string(svg.c_str()));
    CHECK(contains(svg, "&lt;compute&gt; &amp; more"));
    double deform = 0;
    double rest = 0;
    for (const auto& found : document.select_nodes("//rect")) {
      const std::string hint = found.node().child("title").text().get();
      const double wide = found.node().attribute("width").as_double();
      if (hint == "step sea: deform: 4.000 ms") deform = wide;
      if (hint == "rest: 1.990 ms" || hint == "rest: 2.000 ms") rest = wide;
    }
    CHECK(deform > 0);
    CHECK(deform == doctest::Approx(2 * rest).epsilon(0.01));
  }
  BenchReport empty = report(true);
  for (BenchRow& one : empty.rows) one.times = {};
  CHECK(lint(benchChart(empty)) == "");
}

TEST_CASE("bench: values of --vary are parsed") {
  const auto sizes = simreel::cli::parseVary("objects.a.cloth.size=[9,7],[11,7]");
  REQUIRE(sizes.size() == 2);
  CHECK(sizes[1].name == "size=[11,7]");
  CHECK(sizes[1].changes[0].path == "objects.a.cloth.size");
  CHECK(sizes[1].changes[0].value == "[11,7]");
  CHECK(simreel::cli::parseVary(R"(title="a,b","\",",c)").size() == 3);
  for (const char* bad : {"", "a", "=1", "a=", "a=1,,2", "a=1,"})
    CHECK_THROWS_AS(static_cast<void>(simreel::cli::parseVary(bad)), UserError);
  const auto cases = combine(std::vector{sizes, simreel::cli::parseVary("seed=1,2,3")}, "plain");
  REQUIRE(cases.size() == 6);
  CHECK(cases[1].name == "size=[9,7], seed=2");
  CHECK(cases[5].changes.size() == 2);
  CHECK(combine({}, "plain")[0].name == "plain");
  const std::vector<std::vector<BenchChoice>> many(7, simreel::cli::parseVary("seed=1,2"));
  CHECK_THROWS_AS(static_cast<void>(combine(many, "plain")), UserError);
}

TEST_CASE("bench: --technique offers the choices of the parameter \"technique\"") {
  struct Mesh final : scene::Parameters {
    int technique = 0;
    float deep = 1;
    void describe(scene::Fields& fields) override {
      fields.number("deep", deep, scene::positive, "m", "Deep.");
      fields.oneOf("technique", technique, {"jobs", "compute"}, "Technique.");
    }
  };
  const scene::Kind kind{"mesh", "A mesh.", [] { return std::make_unique<Mesh>(); }};
  CHECK(scene::choicesOf(kind, "technique") == std::vector<std::string>{"jobs", "compute"});
  CHECK(scene::choicesOf(kind, "deep").empty());
  const std::vector<scene::Kind> kinds = {kind};
  const scene::Scene scene = scene::parseScene(
      R"({"version": 1, "objects": {"a": {"mesh": {}}, "b": {"mesh": {}}}})", "test.json", {}, {kinds});
  const auto all = parseTechniques("all", scene, kinds);
  REQUIRE(all.size() == 2);
  CHECK(all[1].name == "compute");
  REQUIRE(all[1].changes.size() == 2);
  CHECK(all[1].changes[1].path == "objects.b.mesh.technique");
  CHECK(parseTechniques("compute", scene, kinds).size() == 1);
  CHECK_THROWS_WITH_AS(
      static_cast<void>(parseTechniques("jobs,magic", scene, kinds)),
      "--technique magic: no object of this scene has this technique; use all, jobs, compute", UserError);
  CHECK(contains(message("all", scene), "no object of this scene has techniques"));
}
