#include "frame/file/output_name.hpp"
#include "frame/frames_spec.hpp"
#include "frame/sink/progress.hpp"
#include "help.hpp"

using namespace simreel;
using namespace simreel::frame;
using namespace simreel::frame::test;

TEST_CASE("output: every form of output name is parsed") {
  const TemporaryFolder folder;
  const std::string base = folder.string();
  CHECK(parseOutput(base, 9).file(7) == folder / "000007.png");
  CHECK(parseOutput(base + "/new/", 9).file(7) == folder / "new/000007.png");
  CHECK(parseOutput("out", 9).file(1234567).string() == "out/1234567.png");
  CHECK(parseOutput("out", 9).manifestFile() == "out/manifest.json");
  CHECK(parseOutput("out/flag_####.png", 9).file(12).string() == "out/flag_0012.png");
  CHECK(parseOutput("out/flag_####.png", 9).manifestFile() == "out/flag.manifest.json");
  CHECK(parseOutput("####.png", 9).manifestFile() == "manifest.json");
  CHECK(parseOutput("out/%04d.png", 9).file(12).string() == "out/0012.png");
  CHECK(parseOutput("a%db.PNG", 9).file(12).string() == "a12b.PNG");
  CHECK(parseOutput("{}_{0}_#.png", 9).file(3).string() == "{}_{0}_3.png");
  CHECK(parseOutput("x/poster.png", 1).file(40).string() == "x/poster.png");
  CHECK(parseOutput("x/poster.png", 1).manifestFile() == "x/poster.manifest.json");
  CHECK(parseOutput("x.mp4", 9).kind == OutputName::Kind::video);
  CHECK(parseOutput("x.WebM", 9).kind == OutputName::Kind::video);
  CHECK(parseOutput("x.mp4", 9).manifestFile() == "x.mp4.manifest.json");
  CHECK(parseOutput("-", 9).kind == OutputName::Kind::stream);
}

TEST_CASE("output: invalid output names are usage errors") {
  for (const char* output :
       {"",        "poster.png", "a.jpg",     "a.exr",           "a_####.jpg",
        "a_####",  "a_####.mp4", "##_##.png", "%d_%d.png",       "%d_#.png",
        "%s.png",  "%n.png",     "%04x.png",  "%99999d.png",     "%4d.png",
        "%0d.png", "%",          "50%.png",   "frames_##/x.png", "#####################.png"}) {
    CAPTURE(output);
    const auto [code, text] = errorOf([&] { (void)parseOutput(output, 2); });
    CHECK(code == ExitCode::usage);
    CHECK(contains(text, "--output"));
  }
  CHECK(contains(errorOf([] { (void)parseOutput("a.jpg", 1); }).second, ".webm"));
  CHECK(contains(errorOf([] { (void)parseOutput("d/p.png", 2); }).second, "d/p_####.png"));
}

TEST_CASE("frames: lists, ranges and steps of frames are parsed") {
  CHECK(parseFrames("7") == std::vector{7});
  CHECK(parseFrames("0-4") == std::vector{0, 1, 2, 3, 4});
  CHECK(parseFrames("0-9x4,150") == std::vector{0, 4, 8, 150});
  CHECK(parseFrames("5,1-3, 2-6x2") == std::vector{1, 2, 3, 4, 5, 6});
  CHECK(parseFrames("0-999999").size() == 1000000);
  for (const auto& [typed, position] : {std::pair{"", 1},
                                        {"a", 1},
                                        {"1,", 3},
                                        {"1-", 3},
                                        {"5-1", 1},
                                        {"1-5x0", 5},
                                        {"1-5x", 5},
                                        {"1;2", 2},
                                        {"-3", 1},
                                        {"99999999999999999999", 1},
                                        {"0-1000000", 1},
                                        {"1x2", 2}}) {
    const std::string text = typed;  // This is a copy, because Clang 14 cannot capture structured bindings.
    CAPTURE(text);
    const auto [code, message] = errorOf([&] { (void)parseFrames(text); });
    CHECK(code == ExitCode::usage);
    CHECK(contains(message, fmt::format("at character {};", position)));
  }
}

TEST_CASE("frames: the word last is the scene's last frame") {
  CHECK(parseFrames("last", "--frames", 29) == std::vector{29});
  CHECK(parseFrames("0,last", "--frames", 29) == std::vector{0, 29});
  CHECK(parseFrames("0-lastx10", "--frames", 29) == std::vector{0, 10, 20});
  for (const char* wrong : {"lastly", "las", "40-last"})
    CHECK(errorOf([&] { (void)parseFrames(wrong, "--frames", 29); }).first == ExitCode::usage);
  CHECK(errorOf([&] { (void)parseFrames("last"); }).first == ExitCode::usage);
}

TEST_CASE("progress: progress texts show frames and time left") {
  CHECK(formatDuration(9.84) == "9.8 s");
  CHECK(formatDuration(185.2) == "3 min 05 s");
  CHECK(formatDuration(7460) == "2 h 04 min");
  CHECK(closingLine(120, 9.8, {2.1, 5.9, 0.3, 1.6, 0.8, 0.7}, "out/000000.png ... out/000119.png") ==
        "120 frames in 9.8 s (12.2 frames/s): start 0.8 s, simulate 2.1 s, draw 5.9 s, read back 0.3 s, "
        "encode "
        "1.6 s, wait 0.7 s -> out/000000.png ... out/000119.png");
  CHECK(contains(closingLine(1, 1, {}, ""), "1 frame in 1.0 s (1.0 frames/s): "));
  const std::string line = progressLine(30, 120, 10, 79);
  CHECK(contains(line, "30/120  3.0 frames/s  30.0 s left"));
  CHECK(line.front() == '[');
  for (const int width : {0, 1, 10, 24, 40, 79, 200}) {
    CHECK(progressLine(30, 120, 10, width).size() <= static_cast<std::size_t>(width));
    CHECK(progressLine(0, 0, 0, width).size() <= static_cast<std::size_t>(width));
  }
}

TEST_CASE(
    "progress: ndjson mode prints one JSON object per line, and automatic mode prints nothing if piped") {
  const TemporaryFolder folder;
  const auto record = [&](Progress::Mode mode) {
    const std::string path = (folder / "progress").string();
    std::FILE* file = std::fopen(path.c_str(), "w");
    REQUIRE(file != nullptr);
    Progress progress(mode, ::fileno(file));
    progress.start(2);
    progress.frame(10, {0.5, 0.25, 0, 0});
    progress.frame(11, {});
    progress.finish("ok", {});
    std::fclose(file);
    return readFile(path, "progress");
  };
  CHECK(record(Progress::Mode::automatic).empty());
  CHECK(record(Progress::Mode::none).empty());
  const std::string events = record(Progress::Mode::ndjson);
  CHECK(contains(events, "{\"event\":\"start\",\"frames\":2}\n"));
  CHECK(contains(events, "{\"event\":\"frame\",\"frame\":10,\"done\":1,\"total\":2,"));
  CHECK(contains(events, "\"simulate\":0.500000,\"draw\":0.250000"));
  CHECK(contains(events, "{\"event\":\"end\",\"status\":\"ok\",\"done\":2"));
  CHECK(contains(record(Progress::Mode::terminal), "2/2"));
  CHECK(errorOf([] { (void)parseProgressMode("loud"); }).first == ExitCode::usage);
}
