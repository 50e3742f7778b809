#include "draw/exact/scene/picture_layers.hpp"
#include "frame/file/manifest.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/file/run_log.hpp"
#include "frame/sink/frame_sink.hpp"
#include "frame/sink/open_sink.hpp"
#include "help.hpp"

#include <map>
#include <memory>
#include <numeric>
#include <sys/mount.h>
#include <unistd.h>

using namespace simreel;
using namespace simreel::frame;
using namespace simreel::frame::test;

namespace {

std::vector<int> upTo(int count) {
  std::vector<int> frames(static_cast<std::size_t>(count));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

/// Renders the frames that the sink requests, and returns their numbers.
std::vector<int> renderInto(const std::string& output, Existing existing, int count,
                            const RunInfo& run = runInfo()) {
  const auto frames = upTo(count);
  const auto sink = openSink(parseOutput(output, frames.size()), existing, run, frames, "rgba");
  std::vector<int> drawn;
  for (const int frame : frames) {
    if (!sink->wants(frame)) continue;
    drawn.push_back(frame);
    sink->add(frameInfo(frame), picture(run.width, run.height, frame));
  }
  sink->finish();
  return drawn;
}

std::string text(const std::filesystem::path& path) {
  return readFile(path, "test file");
}

}  // namespace

TEST_CASE("sequence: two runs write the same bytes") {
  const TemporaryFolder folder;
  CHECK(renderInto((folder / "a").string(), Existing::error, 40).size() == 40);
  renderInto((folder / "b/deep/").string(), Existing::error, 40);
  const std::string manifest = text(folder / "a/manifest.json");
  CHECK(manifest == text(folder / "b/deep/manifest.json"));
  CHECK(text(folder / "a/000039.png") == text(folder / "b/deep/000039.png"));
  CHECK(contains(manifest, "\"format\": \"simreel-manifest\""));
  const Manifest read = parseManifest(manifest, "manifest");
  CHECK(manifestText(read) == manifest);
  CHECK(read.frames.size() == 40);
  CHECK(read.frames.at(3).pixels == pixelHash(picture(32, 18, 3)));
  CHECK(read.frames.at(3).state == "state3");
  CHECK(contains(text(folder / "a/000003.png"), std::string("simreel:state\0state3", 20)));
}

TEST_CASE(
    "sequence: exact pictures and their manifest are equal on every machine; run.json names the machine") {
  const TemporaryFolder folder;
  RunInfo here = runInfo();
  here.rasterizer = "exact";
  here.processor = "Testium 3";
  RunInfo there = here;
  there.driver = "another";
  there.processor = "Testium 4";
  there.fingerprint = "else";
  const auto bytes = [&](const char* name, const RunInfo& run) {
    renderInto((folder / name).string(), Existing::overwrite, 3, run);
    return text(folder / name / "manifest.json") + text(folder / name / "000002.png");
  };
  CHECK(bytes("a", here) == bytes("b", there));
  CHECK(readRunLog(folder / "b/run.json").machineOf(2) == "Testium 4; another");
  // Pictures of the driver depend on the numerics fingerprint.
  here.rasterizer = there.rasterizer = "driver";
  CHECK(bytes("c", here) != bytes("d", there));
  CHECK(contains(text(folder / "c/manifest.json"), "\"fingerprint\": \"fingerprint\""));
}

TEST_CASE("run.json: each frame is listed under the run that drew it last") {
  RunRecord first;
  first.host = "a";
  first.processor = "p";
  first.driver = "d";
  first.frames = {0, 1, 2, 3, 7};
  RunRecord second = first;
  second.host = "b \"quoted\"";
  second.seconds = 1.5;
  second.folders = {"/x"};
  second.frames = {1, 2};
  RunLog log;
  log.put(first);
  log.put(second);
  const std::string written = runLogText(log);
  CHECK(runLogText(parseRunLog(written, "run.json")) == written);
  CHECK(contains(written, "\"frames\":\"0,3,7\""));
  CHECK(contains(written, "\"frames\":\"1-2\""));
  second.frames = {0, 1, 2, 3, 7};
  log.put(second);
  CHECK(log.runs.size() == 1);
  CHECK(log.runs.front().host == second.host);
  for (const char* broken : {"", "[]", "{\"format\":\"simreel-run\",\"version\":9,\"runs\":[]}",
                             "{\"format\":\"simreel-run\",\"version\":1,\"runs\":[{}]}"})
    CHECK(errorOf([&] { static_cast<void>(parseRunLog(broken, "run.json")); }).first == ExitCode::usage);
}

TEST_CASE("sequence: existing frames are refused before drawing starts") {
  const TemporaryFolder folder;
  const std::string output = (folder / "f_##.png").string();
  renderInto(output, Existing::error, 3);
  CHECK(std::filesystem::exists(folder / "f_02.png"));
  CHECK(std::filesystem::exists(folder / "f.manifest.json"));
  const auto [code, message] = errorOf([&] { renderInto(output, Existing::error, 5); });
  CHECK(code == ExitCode::inputOutput);
  CHECK(contains(message, "f_00.png and 2 more exist; use --overwrite, --skip-existing or --resume"));
  CHECK(renderInto(output, Existing::overwrite, 5).size() == 5);
}

TEST_CASE("sequence: resume redraws missing, truncated and changed frames") {
  const TemporaryFolder folder;
  const std::string output = folder.string();
  renderInto(output, Existing::error, 8);
  const std::string manifest = text(folder / "manifest.json");
  std::map<int, std::string> files;
  for (int frame = 0; frame < 8; ++frame) files[frame] = text(folder / fmt::format("{:06}.png", frame));

  std::filesystem::remove(folder / "000001.png");
  std::filesystem::resize_file(folder / "000003.png", files[3].size() / 2);
  std::filesystem::copy_file(folder / "000004.png", folder / "000005.png",
                             std::filesystem::copy_options::overwrite_existing);
  writeFileAtomically(folder / "000006.png", std::string_view());
  writeFileAtomically(folder / "000007.png.part", std::string_view("left behind"));
  CHECK(renderInto(output, Existing::resume, 8) == std::vector{1, 3, 5, 6});
  CHECK(text(folder / "manifest.json") == manifest);
  for (int frame = 0; frame < 8; ++frame)
    CHECK(text(folder / fmt::format("{:06}.png", frame)) == files[frame]);

  const auto frames = upTo(8);
  const auto sink =
      openSink(parseOutput(output, frames.size()), Existing::resume, runInfo(), frames, "rgba");
  CHECK(sink->knownStateHash(5) == "state5");
  CHECK(sink->summary() == (folder / "000000.png").string() + " ... " + (folder / "000007.png").string());
  sink->finish();

  // A frame missing from the manifest is drawn. Without a manifest, all frames are drawn.
  Manifest partial = parseManifest(manifest, "manifest");
  partial.frames.erase(2);
  writeFileAtomically(folder / "manifest.json", manifestText(partial));
  CHECK(renderInto(output, Existing::resume, 8) == std::vector{2});
  std::filesystem::remove(folder / "manifest.json");
  CHECK(renderInto(output, Existing::resume, 8).size() == 8);
}

TEST_CASE("sequence: resume refuses frames of a different run, and starts over if the manifest is broken") {
  const TemporaryFolder folder;
  renderInto(folder.string(), Existing::error, 2);
  const auto refusal = [&](const RunInfo& run) {
    const auto [code, message] = errorOf([&] { renderInto(folder.string(), Existing::resume, 2, run); });
    CHECK(code == ExitCode::usage);
    CHECK(contains(message, "--overwrite"));
    return message;
  };
  RunInfo other = runInfo();
  other.seed = 8;
  CHECK(contains(refusal(other), "seed is 8 in this run and 7 in the earlier one"));
  CHECK(contains(refusal(runInfo(64, 18)), "size is 64x18 in this run and 32x18"));
  for (const char* broken : {"", "{", "[]", "{\"format\":\"simreel-manifest\",\"version\":9}",
                             "{\"format\":\"simreel-manifest\",\"version\":2,\"title\":3}"}) {
    writeFileAtomically(folder / "manifest.json", std::string_view(broken));
    CHECK(renderInto(folder.string(), Existing::resume, 2).size() == 2);
  }
}

TEST_CASE("sequence: companion files of a frame are kept if manifest and hash match") {
  const TemporaryFolder folder;
  const std::vector<int> frames = {0};
  const auto store = [&](Existing existing) {
    const auto sink =
        openSink(parseOutput(folder.string(), frames.size()), existing, runInfo(), frames, "rgba");
    FrameInfo info = frameInfo(0);
    for (const char* name : {"000000.a.npy", "000000.b.npy"})
      if (!sink->holds(0, name)) info.files.push_back({name, std::vector<std::byte>(9)});
    const std::size_t stored = info.files.size();
    if (sink->wants(0))
      sink->add(std::move(info), picture(32, 18));
    else
      sink->add(std::move(info), std::nullopt);
    sink->addCounts("step,time\n0,0\n");
    sink->finish();
    return stored;
  };
  CHECK(store(Existing::error) == 2);
  const std::string manifest = text(folder / "manifest.json");
  CHECK(store(Existing::resume) == 0);
  writeFileAtomically(folder / "000000.b.npy", std::string_view("damaged"));
  writeFileAtomically(folder / "counts.csv", std::string_view("step,time\n0,0\n1,damaged"));
  CHECK(store(Existing::resume) == 1);
  CHECK(text(folder / "000000.b.npy") == std::string(9, '\0'));
  CHECK(text(folder / "counts.csv") == "step,time\n0,0\n");
  CHECK(text(folder / "manifest.json") == manifest);
}

TEST_CASE("sequence: skipping lists existing frames that declare this run") {
  const TemporaryFolder folder;
  renderInto(folder.string(), Existing::error, 3);
  const std::string manifest = text(folder / "manifest.json");
  std::filesystem::remove(folder / "manifest.json");
  CHECK(renderInto(folder.string(), Existing::skip, 3).empty());
  CHECK(text(folder / "manifest.json") == manifest);
  // Existing::skip keeps a picture that lacks the metadata of a run (frame 0), but does not list it in the
  // manifest. A later Existing::resume refuses to replace it. Existing::skip draws damaged and empty
  // pictures again (frames 1 and 2).
  std::filesystem::remove(folder / "manifest.json");
  writeFileAtomically(folder / "000000.png", encodePng(picture(32, 18), {}));
  std::filesystem::resize_file(folder / "000001.png", 100);
  std::filesystem::resize_file(folder / "000002.png", 0);
  const std::string foreign = text(folder / "000000.png");
  CHECK(renderInto(folder.string(), Existing::skip, 5) == std::vector{1, 2, 3, 4});
  CHECK(text(folder / "000000.png") == foreign);
  const Manifest after = parseManifest(text(folder / "manifest.json"), "manifest");
  CHECK(after.frames.size() == 4);
  CHECK(after.frames.at(4).state == "state4");
  const auto [refusal, reason] = errorOf([&] { renderInto(folder.string(), Existing::resume, 5); });
  CHECK(refusal == ExitCode::usage);
  CHECK(contains(reason, "000000.png is no picture of simreel"));
  CHECK(text(folder / "000000.png") == foreign);
  std::filesystem::remove(folder / "000000.png");
  CHECK(renderInto(folder.string(), Existing::resume, 5) == std::vector{0});
  std::filesystem::remove(folder / "000002.png");
  std::filesystem::create_directory(folder / "000002.png");
  const auto [code, message] = errorOf([&] { renderInto(folder.string(), Existing::skip, 5); });
  CHECK(code == ExitCode::inputOutput);
  CHECK(contains(message, "000002.png: a folder has this name"));
}

TEST_CASE("sequence: skipping refuses frames of a different run, by manifest or by their own metadata") {
  RunInfo seed = runInfo(), scene = runInfo(), changed = runInfo();
  seed.seed = 8;
  scene.sceneHash = "other";
  changed.overrides = {"a=1"};
  const std::vector<std::pair<RunInfo, std::string>> others = {
      {seed, "seed is 8 in this run and 7 in "},
      {scene, "scene hash is other in this run and scenehash in "},
      {changed, "what is changed in the scene is -D a=1 in this run and nothing in "},
      {runInfo(64, 18), "size is 64x18 in this run and 32x18 in "}};
  for (const char* name : {"", "f_##.png", "f_##.exr"}) {
    const TemporaryFolder folder;
    const std::string output = (folder / name).string();
    const bool light = output.ends_with(".exr");
    if (light) {
      const auto sink = openSink(parseOutput(output, 2), Existing::error, runInfo(), upTo(2), "rgba");
      for (const int frame : upTo(2)) {
        FrameInfo info = frameInfo(frame);
        auto layers = std::make_shared<draw::PictureLayers>();
        layers->size = {32, 18};
        layers->light.resize(std::size_t{4} * 32 * 18);
        info.layers = layers;
        sink->add(info, picture(32, 18));
      }
      sink->finish();
    } else {
      renderInto(output, Existing::error, 2);
    }
    const auto manifest = parseOutput(output, 2).manifestFile();
    const std::string before = text(manifest);
    for (const bool listed : {true, false}) {
      if (!listed) std::filesystem::remove(manifest);
      for (const auto& other : others) {  // Clang 14 cannot capture structured bindings.
        const auto& words = other.second;
        const auto [code, message] = errorOf([&] { renderInto(output, Existing::skip, 5, other.first); });
        CHECK(code == ExitCode::usage);
        CHECK(contains(message, "cannot skip existing frames: " + words));
        CHECK(pathExists(manifest) == listed);
        if (listed) CHECK(text(manifest) == before);
      }
    }
    // For a picture of another program, the size is checked.
    if (light) continue;
    const auto first = parseOutput(output, 2).file(0);
    writeFileAtomically(first, encodePng(picture(30, 18), {}));
    CHECK(contains(errorOf([&] { renderInto(output, Existing::skip, 2); }).second,
                   "size is 32x18 in this run and 30x18 in " + first.string()));
  }
}

TEST_CASE("sequence: a manifest with any changed digit starts over") {
  const TemporaryFolder folder;
  renderInto(folder.string(), Existing::error, 2);
  const std::string manifest = text(folder / "manifest.json");
  for (const std::string word :
       {"\"pixels\":\"", "\"state\":\"state", "\"seed\": ", "\"title\": \"Te", "\"hash\": \""}) {
    std::string changed = manifest;
    char& digit = changed[changed.find(word) + word.size()];
    REQUIRE(&digit < changed.data() + changed.size());
    digit = digit == '7' ? '8' : '7';
    CHECK(contains(errorOf([&] { static_cast<void>(parseManifest(changed, "m.json")); }).second,
                   "manifest m.json cannot be read: it was changed after it was written"));
    writeFileAtomically(folder / "manifest.json", std::string_view(changed));
    CHECK(renderInto(folder.string(), Existing::resume, 2).size() == 2);
    CHECK(text(folder / "manifest.json") == manifest);
  }
  // Manifests of earlier versions have no hash.
  const std::string old = manifest.substr(0, manifest.rfind(",\n  \"hash\"")) + "\n}\n";
  CHECK_THROWS_AS(static_cast<void>(parseManifest(old, "m.json")), UserError);
  std::string three = old;
  three.replace(three.find("\"version\": 4"), 12, "\"version\": 3");
  CHECK(manifestText(parseManifest(three, "m.json")) == manifest);
}

TEST_CASE("sequence: a later run with other frames keeps earlier frames in the manifest") {
  const TemporaryFolder folder;
  renderInto(folder.string(), Existing::error, 3);
  const std::vector<int> frames = {1};
  const auto sink =
      openSink(parseOutput(folder.string(), frames.size()), Existing::overwrite, runInfo(), frames, "rgba");
  sink->add(frameInfo(1), picture(32, 18, 1));
  sink->finish();
  CHECK(parseManifest(text(folder / "manifest.json"), "manifest").frames.size() == 3);
}

TEST_CASE("sequence: frames finished before an unrelated error can be resumed") {
  const TemporaryFolder folder;
  const auto frames = upTo(4);
  {
    const auto sink =
        openSink(parseOutput(folder.string(), frames.size()), Existing::error, runInfo(), frames, "rgba");
    sink->add(frameInfo(0), picture(32, 18, 0));
  }
  CHECK(renderInto(folder.string(), Existing::resume, 4) == std::vector{1, 2, 3});
}

TEST_CASE("sequence: an unwritable output is one user error") {
  const TemporaryFolder folder;
  writeFileAtomically(folder / "file", std::string_view("x"));
  const auto [code, message] =
      errorOf([&] { renderInto((folder / "file/out/").string(), Existing::error, 2); });
  CHECK(code == ExitCode::inputOutput);
  CHECK(contains(message, "cannot create folder"));
  // A folder has the name of the frame's file.
  std::filesystem::create_directories(folder / "g/000030.png/x");
  const auto blocked = errorOf([&] { renderInto((folder / "g").string(), Existing::overwrite, 40); });
  CHECK(blocked.first == ExitCode::inputOutput);
  CHECK(contains(blocked.second, "000030.png"));
  CHECK(parseManifest(text(folder / "g/manifest.json"), "manifest").frames.contains(0));
}

TEST_CASE("sequence: a full disk is one user error, and the run can be resumed") {
  const TemporaryFolder folder;
  if (::mount("tmpfs", folder.string().c_str(), "tmpfs", 0, "size=256k") != 0) {
    MESSAGE("skipped: mounting a small tmpfs needs root");
    return;
  }
  const RunInfo run = runInfo(200, 200);
  const auto [code, message] =
      errorOf([&] { renderInto((folder / "o").string(), Existing::error, 400, run); });
  CHECK(code == ExitCode::inputOutput);
  CHECK(contains(message, "No space left on device"));
  CHECK(message.find('\n') == std::string::npos);
  for (const auto& entry : std::filesystem::directory_iterator(folder / "o"))
    CHECK(entry.path().extension() != ".part");
  CHECK(::umount(folder.string().c_str()) == 0);
}

TEST_CASE("sequence: a single picture is written under its plain name") {
  const TemporaryFolder folder;
  const std::vector<int> frames = {150};
  const auto sink = openSink(parseOutput((folder / "poster.png").string(), frames.size()), Existing::error,
                             runInfo(), frames, "rgba");
  sink->add(frameInfo(150), picture(32, 18));
  sink->finish();
  CHECK(sink->summary() == (folder / "poster.png").string());
  CHECK(sink->encodeSeconds() >= 0);
  CHECK(parseManifest(text(folder / "poster.manifest.json"), "m").frames.at(150).file == "poster.png");
}
