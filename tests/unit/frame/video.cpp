#include "frame/file/manifest.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/frame_rate.hpp"
#include "frame/sink/open_sink.hpp"
#include "frame/sink/stream_sink.hpp"
#include "help.hpp"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sched.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using namespace simreel;
using namespace simreel::frame;
using namespace simreel::frame::test;

namespace {

constexpr int frameCount = 12;
const std::vector<int> frames = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

void renderVideo(const std::string& output, Existing existing = Existing::error,
                 const RunInfo& run = runInfo()) {
  const auto sink = openSink(parseOutput(output, frames.size()), existing, run, frames, "rgba");
  for (const int frame : frames)
    if (sink->wants(frame)) sink->add(frameInfo(frame), picture(run.width, run.height, frame));
  sink->finish();
}

/// Sets the environment variable PATH during its lifetime.
class SearchPath {
 public:
  explicit SearchPath(const std::string& value) : old_(std::getenv("PATH")) {
    ::setenv("PATH", value.c_str(), 1);
  }
  ~SearchPath() { ::setenv("PATH", old_.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;
  SearchPath(SearchPath&&) = delete;
  SearchPath& operator=(SearchPath&&) = delete;

 private:
  std::string old_;
};

bool ffmpegInstalled() {
  return std::system("command -v ffmpeg ffprobe >/dev/null 2>&1") == 0;
}

/// Renders with a program named ffmpeg that runs the script. Returns the error.
std::pair<ExitCode, std::string> withFakeFfmpeg(const std::string& script) {
  const TemporaryFolder folder;
  writeFileAtomically(folder / "ffmpeg", std::string_view("#!/bin/sh\n" + script + "\n"));
  ::chmod((folder / "ffmpeg").c_str(), 0755);
  const SearchPath path(folder.string() + ":/usr/bin:/bin");
  const auto result =
      errorOf([&] { renderVideo((folder / "v.mp4").string(), Existing::error, runInfo(320, 200)); });
  CHECK_FALSE(std::filesystem::exists(folder / "v.mp4"));
  CHECK_FALSE(std::filesystem::exists(folder / "v.part.mp4"));
  CHECK(result.second.find('\n') == std::string::npos);
  return result;
}

/// Returns all bytes that `write` writes into a pipe.
template <class Write>
std::string throughPipe(const Write& write) {
  int ends[2];
  REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
  std::string bytes;
  std::thread reader([&] {
    char block[4096];
    for (ssize_t got; (got = ::read(ends[0], block, sizeof block)) > 0;)
      bytes.append(block, std::size_t(got));
  });
  write(ends[1]);
  ::close(ends[1]);
  reader.join();
  ::close(ends[0]);
  return bytes;
}

}  // namespace

TEST_CASE("video: bytes do not depend on the number of processors") {
  if (!ffmpegInstalled()) return;
  const TemporaryFolder folder;
  cpu_set_t all, one;
  REQUIRE(::sched_getaffinity(0, sizeof all, &all) == 0);
  CPU_ZERO(&one);
  for (int i = 0; i < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++i)
    if (CPU_ISSET(i, &all)) CPU_SET(i, &one);
  for (const char* name : {".mp4", ".webm", ".avi"}) {
    renderVideo((folder / (std::string("all") + name)).string(), Existing::error, runInfo(320, 180));
    REQUIRE(::sched_setaffinity(0, sizeof one, &one) ==
            0);  // Sets this thread's affinity to one processor, which ffmpeg inherits.
    renderVideo((folder / (std::string("one") + name)).string(), Existing::error, runInfo(320, 180));
    REQUIRE(::sched_setaffinity(0, sizeof all, &all) == 0);
    CHECK(readFile(folder / (std::string("all") + name), "video") ==
          readFile(folder / (std::string("one") + name), "video"));
  }
}

TEST_CASE("video: ffmpeg writes each format, with a manifest") {
  if (!ffmpegInstalled()) {
    MESSAGE("skipped: ffmpeg is not installed");
    return;
  }
  const TemporaryFolder folder;
  for (const char* name : {"v.mp4", "v.webm", "v.gif", "v.mkv", "v.avi", "v.apng", "-odd:name.mp4"}) {
    CAPTURE(name);
    const std::string file = (folder / name).string();
    renderVideo(file, Existing::error, runInfo(33, 17));  // The size is odd and needs padding for 4:2:0.
    CHECK(std::filesystem::file_size(file) > 100);
    const Manifest manifest = parseManifest(readFile(file + ".manifest.json", "manifest"), "m");
    CHECK(manifest.frames.size() == frameCount);
    CHECK(manifest.frames.at(5).pixels == pixelHash(picture(33, 17, 5)));
  }
  const std::string probe =
      "test \"$(ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width,height -of "
      "csv=p=0 " +
      (folder / "v.mp4").string() + ")\" = 34,18,12";
  CHECK(std::system(probe.c_str()) == 0);
  // Rendering twice must give equal bytes.
  renderVideo((folder / "w.mp4").string(), Existing::error, runInfo(33, 17));
  CHECK((readFile(folder / "w.mp4", "video") == readFile(folder / "v.mp4", "video")));
  for (const auto& entry : std::filesystem::directory_iterator(folder.string()))
    CHECK_FALSE(contains(entry.path().string(), ".part"));

  const std::string file = (folder / "v.mp4").string();
  CHECK(contains(errorOf([&] { renderVideo(file); }).second, "v.mp4 exists"));
  CHECK(errorOf([&] { renderVideo(file, Existing::resume); }).first == ExitCode::usage);
  const auto sink =
      openSink(parseOutput(file, frames.size()), Existing::skip, runInfo(33, 17), frames, "rgba");
  CHECK_FALSE(sink->wants(5));
  CHECK(sink->knownStateHash(5) == "state5");
  sink->finish();
}

TEST_CASE("video: an interrupted run keeps the frames written so far; an abandoned run leaves no file") {
  if (!ffmpegInstalled()) {
    MESSAGE("skipped: ffmpeg is not installed");
    return;
  }
  const TemporaryFolder folder;
  {
    const auto sink = openSink(parseOutput((folder / "v.mp4").string(), frames.size()), Existing::error,
                               runInfo(), frames, "rgba");
    sink->add(frameInfo(0), picture(32, 18));
    sink->finish();
    CHECK(std::filesystem::exists(folder / "v.mp4"));
  }
  {
    const auto sink = openSink(parseOutput((folder / "w.mp4").string(), frames.size()), Existing::error,
                               runInfo(), frames, "rgba");
    sink->add(frameInfo(0), picture(32, 18));
  }
  {
    const auto sink = openSink(parseOutput((folder / "x.mp4").string(), frames.size()), Existing::error,
                               runInfo(), frames, "rgba");
    sink->finish();
  }
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.string())) ++files;
  CHECK(files == 3);
}

TEST_CASE("video: a missing or dying ffmpeg is a one-line error and never a hang") {
  {
    const TemporaryFolder empty;
    const SearchPath path(empty.string());
    const auto [code, message] = errorOf([&] { renderVideo((empty / "v.mp4").string()); });
    CHECK(code == ExitCode::inputOutput);
    CHECK(contains(message, "ffmpeg is not installed"));
    CHECK(contains(message, "apt install ffmpeg"));
  }
  CHECK(contains(withFakeFfmpeg("echo first >&2; echo Unknown encoder >&2; exit 1").second,
                 "status 1 before the video was complete: Unknown encoder"));
  CHECK(contains(withFakeFfmpeg("head -c 600000 >/dev/null; echo No space left >&2; exit 3").second,
                 "No space left"));
  CHECK(contains(withFakeFfmpeg("cat >/dev/null; echo Conversion failed >&2; exit 1").second,
                 "Conversion failed"));
  // A full disk gets the program's own sentence, which names the video and not ffmpeg's temporary file.
  const std::string full =
      withFakeFfmpeg(
          "cat >/dev/null; echo trailer of file:v.part.mp4: No space left on device >&2; "
          "echo Conversion failed >&2; exit 1")
          .second;
  CHECK(full.starts_with("cannot write "));
  CHECK(contains(full, "/v.mp4: No space left on device; make room there"));
  CHECK(contains(withFakeFfmpeg("kill -SEGV $$").second, "signal 11 (SIGSEGV)"));
  CHECK(contains(withFakeFfmpeg("kill -KILL $$").second, "was ended by signal 9 (SIGKILL)"));
  CHECK(contains(withFakeFfmpeg("exit 0").second, "before the video was complete"));
  // The program writes more to standard error than a pipe can hold.
  CHECK(contains(
      withFakeFfmpeg("head -c 1000000 /dev/zero >&2; echo >&2; echo end >&2; cat >/dev/null; exit 1")
          .second,
      ": end"));
  // The program closes its input and keeps running.
  CHECK(contains(withFakeFfmpeg("exec <&-; exec sleep 60").second, "closed its input"));
}

TEST_CASE("stream: raw frames have the right bytes") {
  const std::string bytes = throughPipe([](int descriptor) {
    const auto sink = openStreamSink("rgba", runInfo(3, 2), {}, descriptor);
    for (int frame = 0; frame < 3; ++frame) sink->add(frameInfo(frame), picture(3, 2, frame));
    sink->finish();
    CHECK(sink->summary() == "standard output");
  });
  REQUIRE(bytes.size() == 3 * 24);
  const Image last = picture(3, 2, 2);
  CHECK(std::equal(last.bytes.begin(), last.bytes.end(), bytes.begin() + 48,
                   [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }));
}

TEST_CASE("stream: y4m has the right header, frames and values") {
  RunInfo run = runInfo(2, 1);
  run.fps = 59.94;
  const Image image{2, 1, {255, 255, 255, 255, 255, 0, 0, 255}};
  const std::string bytes = throughPipe([&](int descriptor) {
    const auto sink = openStreamSink("y4m", run, {}, descriptor);
    for (int frame = 0; frame < 2; ++frame) sink->add(frameInfo(frame), image);
    sink->finish();
  });
  const std::string header = "YUV4MPEG2 W2 H1 F60000:1001 Ip A1:1 C444 XCOLORRANGE=FULL\n";
  // The first pixel is white. The second is red: Y 76, Cb 85, Cr 255 by the JFIF formula.
  const std::string frame = "FRAME\n\xff\x4c\x80\x55\x80\xff";
  CHECK((bytes == header + frame + frame));
  for (int grey = 0; grey < 256; ++grey) {
    const auto value = static_cast<std::uint8_t>(grey);
    CHECK(toFullRangeYuv444({1, 1, {value, value, value, 0}}) ==
          std::vector<std::uint8_t>{value, 128, 128});
  }
}

TEST_CASE("a video of every fifth frame plays at the scene's speed") {
  const auto rate = [](double fps, std::initializer_list<int> frames) {
    return playedRate(fps, std::vector<int>(frames)).text('/');
  };
  CHECK(rate(30, {}) == "30/1");
  CHECK(rate(30, {7}) == "30/1");
  CHECK(rate(30, {0, 1, 2}) == "30/1");
  CHECK(rate(30, {0, 5, 10}) == "6/1");
  CHECK(rate(30, {3, 10}) == "30/7");
  CHECK(rate(29.97, {0, 1}) == "30000/1001");
  CHECK(rate(59.94, {0, 2, 4}) == "30000/1001");
  CHECK(rate(12.5, {0, 1}) == "12500/1000");
  CHECK(rate(30, {0, 1, 3}) ==
        "30/1");  // The frames are not evenly spaced, so the scene's rate is used, with a warning.
}

TEST_CASE("stream: a closed pipe and an unknown format are user errors") {
  int ends[2];
  REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
  ::close(ends[0]);
  const auto [code, message] = errorOf([&] {
    const auto sink = openStreamSink("rgba", runInfo(), {}, ends[1]);
    for (const int frame : frames) sink->add(frameInfo(frame), picture(32, 18));
    sink->finish();
  });
  ::close(ends[1]);
  CHECK(code == ExitCode::inputOutput);
  CHECK(contains(message, "standard output was closed"));
  CHECK(errorOf([] { (void)openStreamSink("bmp", runInfo(), {}, 1); }).first == ExitCode::usage);
}

TEST_CASE("interrupt: the first signal requests a stop") {
  CHECK(interruptSignal() == 0);
  catchInterrupts();
  ::raise(SIGTERM);
  CHECK(interruptSignal() == SIGTERM);
  ::alarm(0);
  ::signal(SIGTERM, SIG_DFL);
  ::signal(SIGINT, SIG_DFL);
}
