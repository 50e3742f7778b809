#include "golden/pictures/picture_test.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/processor.hpp"
#include "base/text.hpp"
#include "frame/image.hpp"
#include "frame/interrupt.hpp"
#include "golden/compare/compare.hpp"
#include "golden/compare/comparison.hpp"
#include "golden/files/picture.hpp"
#include "golden/pictures/picture_folder.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <sstream>
#include <utility>

#include <tbb/parallel_pipeline.h>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

/// A decoded picture and the bytes of its file.
struct ReadPicture {
  std::string bytes;
  Picture picture;
};

ReadPicture readWhole(const fs::path& file, const char* what) {
  ReadPicture read;
  readBytes(file, what, read.bytes);
  read.picture = decodePicture(read.bytes, what, file.string());
  return read;
}

class PictureTest {
 public:
  PictureTest(const PictureCase& one, const PictureOptions& options)
      : case_(one), options_(options), terms_(termsFor(one.name, options.rules)) {
    result_.name = one.name;
    result_.file = (one.actual.empty() ? one.expected : one.actual).generic_string();
    result_.baselines = (options.expected / one.name).generic_string();
    result_.tolerance = terms_.bounds;
    result_.xfail = terms_.xfail;
    result_.renamedFrom = one.renamedFrom;
    result_.repeats = 1;
  }

  SceneResult run() {
    try {
      read();
      if (expected_ && actual_) compareBoth();
      if (result_.status == Status::fail || result_.status == Status::missing) judge();
    } catch (const UserError& error) {
      stop(error);
    }
    for (std::string& message : result_.messages) message = oneLine(message);
    finishFrame();
    applyExpectation();
    return std::move(result_);
  }

 private:
  void stop(const UserError& error) {
    result_.status = Status::error;
    result_.messages.emplace_back(error.what());
  }

  void read() {
    // Reads both files before throwing, so that one error does not hide the other.
    std::optional<UserError> first;
    const auto readOne = [&](const fs::path& file, const char* what, std::optional<ReadPicture>& into) {
      if (file.empty()) return;
      try {
        into = readWhole(file, what);
        if (const auto& note = into->picture.note; !note.empty())
          result_.notes.push_back(fmt::format("{} {}: {}", what, file.string(), note));
      } catch (const UserError& error) {
        if (first) result_.messages.emplace_back(first->what());
        first = error;
      }
    };
    readOne(case_.expected, "baseline", expected_);
    readOne(case_.actual, "picture", actual_);
    if (first) throw UserError(*first);
    if (actual_) frame_.pixels = pictureHash(actual_->picture);
    if (expected_) frame_.expectedPixels = pictureHash(expected_->picture);
    if (case_.actual.empty()) {
      result_.status = Status::fail;
      result_.messages.push_back(
          fmt::format("there is no picture for the baseline {}; if the picture is no longer made, remove "
                      "the baseline, or all such baselines with --update=prune",
                      result_.baselines));
    } else if (case_.expected.empty()) {
      result_.status = Status::missing;
      result_.messages.push_back(fmt::format("there is no baseline {}", result_.baselines));
    } else if (!case_.renamedFrom.empty()) {
      result_.status = Status::missing;
      result_.messages.push_back(fmt::format(
          "there is no baseline {}; it has the pixels of {}, which has no picture any more: renamed? "
          "--update and accept move the baseline",
          result_.baselines, case_.renamedFrom));
    }
  }

  void compareBoth() {
    const frame::Image &a = expected_->picture.image, &b = actual_->picture.image;
    Allowance allowance = allowanceOf(terms_, a.width, a.height);
    if (!allowance.mask.empty() && (b.width > a.width || b.height > a.height)) {
      const int width = std::max(a.width, b.width), height = std::max(a.height, b.height);
      std::vector<std::uint8_t> wider(std::size_t(width) * std::size_t(height), 0);
      for (int y = 0; y < a.height; ++y)
        std::copy_n(allowance.mask.begin() + std::ptrdiff_t{y} * a.width, a.width,
                    wider.begin() + std::ptrdiff_t{y} * width);
      allowance.mask = std::move(wider);
    }
    made_ = compare(expected_->picture, actual_->picture, terms_.tolerance, allowance,
                    terms_.tolerance.maxFlipMean ? Measures::all : options_.measures);
    if (!made_->colours.empty()) result_.notes.push_back(made_->colours);
    if (!made_->layerNote.empty()) result_.notes.push_back(made_->layerNote);
    if (!case_.renamedFrom.empty()) return;
    const auto broken = brokenBounds(made_->metrics, terms_.tolerance, made_->a.width, made_->a.height);
    const bool excused =
        made_->metrics.maskedPixels + made_->metrics.antialiasedPixels + made_->metrics.movedPixels > 0;
    if (made_->metrics.differentPixels > 0 || excused) frame_.metrics = made_->metrics;
    if (made_->sizes.empty() && made_->layers.empty() && broken.empty()) return;
    result_.status = Status::fail;
    if (!made_->sizes.empty())
      result_.messages.push_back(
          fmt::format("{}; compared as {}x{}, padded", made_->sizes, made_->a.width, made_->a.height));
    if (!made_->layers.empty()) result_.messages.push_back(made_->layers);
    if (!broken.empty()) result_.messages.push_back(fmt::format("{}", fmt::join(broken, "; ")));
  }

  /// Updates the baseline of a missing or failed picture, or stores its files for the report.
  void judge() {
    if (result_.xfail.empty() && update()) return;
    if (options_.artifacts.empty()) return;
    keep();
  }

  bool update() {
    const Update mode = options_.update;
    const fs::path baseline = options_.expected / case_.name;
    if (case_.actual.empty()) {
      if (mode != Update::prune) return false;
      removeFile(case_.expected);
      result_.notes.push_back("removed the baseline " + result_.baselines);
    } else {
      const bool changed = result_.status == Status::fail;
      if (mode != Update::all && mode != (changed ? Update::changed : Update::missing)) return false;
      makeFolders(baseline.parent_path());
      writeFileAtomically(baseline, actual_->bytes);
      if (!case_.renamedFrom.empty()) removeFile(case_.expected);
      result_.notes.push_back(
          "wrote " + result_.baselines +
          (case_.renamedFrom.empty() ? "" : " and removed " + case_.expected.generic_string()));
      frame_.expectedPixels = frame_.pixels;
      frame_.metrics.reset();
    }
    result_.status = Status::updated;
    result_.messages.clear();
    return true;
  }

  std::string write(const std::string& name, std::span<const std::byte> bytes) const {
    const fs::path file = options_.artifacts / case_.name / name;
    makeFolders(file.parent_path());
    markReport(options_.artifacts);
    writeFileAtomically(file, bytes);
    return file.lexically_relative(options_.reportFolder).generic_string();
  }
  std::string write(const std::string& name, const frame::Image& image) const {
    return write(name, frame::encodePng(image, {}));
  }

  /// Copies the file, which preserves alpha, if browsers can display it. Otherwise, writes a PNG.
  std::string copyOf(const char* role, const ReadPicture& read, const fs::path& file) const {
    const std::string ending = lowerExtension(file);
    if (read.picture.depth != Depth::linear && (ending == ".png" || ending == ".jpg" || ending == ".jpeg"))
      return write(role + ending, std::as_bytes(std::span(read.bytes)));
    return write(std::string(role) + ".png", read.picture.image);
  }

  void keep() {
    if (expected_) frame_.expectedImage = copyOf("expected", *expected_, case_.expected);
    if (actual_) frame_.actualImage = copyOf("actual", *actual_, case_.actual);
    if (made_ && (frame_.metrics || !made_->sizes.empty())) {
      frame_.differenceImage = write("difference.png", differenceImage(*made_));
      if (made_->metrics.flipMean.value_or(0) > 0) frame_.flipImage = write("flip.png", flipImage(*made_));
    }
    if (!actual_ || !result_.xfail.empty()) return;
    const std::string kept = "candidate/" + fs::path(case_.name).filename().string();
    result_.candidate =
        fs::path(write(kept, std::as_bytes(std::span(actual_->bytes)))).parent_path().generic_string();
  }

  void finishFrame() {
    frame_.status = result_.status;
    if (!result_.messages.empty()) frame_.message = result_.messages.front();
    if (actual_ || expected_) result_.frames.push_back(frame_);
  }

  void applyExpectation() {
    if (result_.xfail.empty()) return;
    if (result_.status == Status::fail) {
      result_.status = Status::xfail;
    } else if (result_.status == Status::pass) {
      result_.status = Status::xpass;
      result_.messages.push_back(fmt::format(
          "passes, though the rules expect it to fail ({}); remove its \"xfail\"", result_.xfail));
    }
  }

  const PictureCase& case_;
  const PictureOptions& options_;
  Terms terms_;
  std::optional<ReadPicture> expected_, actual_;
  std::optional<Comparison> made_;
  FrameResult frame_;
  SceneResult result_;
};

}  // namespace

SceneResult testPicture(const PictureCase& one, const PictureOptions& options) {
  const auto begin = Clock::now();
  SceneResult result = PictureTest(one, options).run();
  result.seconds = secondsSince(begin);
  return result;
}

void testPictures(const std::vector<PictureCase>& cases, const PictureOptions& options,
                  const std::function<void(SceneResult&&)>& done) {
  std::size_t at = 0;
  const auto next = [&](tbb::flow_control& control) -> std::size_t {
    if (at == cases.size()) control.stop();
    return at == cases.size() ? 0 : at++;
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      2 * processorCount(),  // max number of pictures in memory at a time
      tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, next) &
          tbb::make_filter<std::size_t, SceneResult>(filter_mode::parallel,
                                                     [&](std::size_t index) {
                                                       frame::throwIfInterrupted();
                                                       return testPicture(cases[index], options);
                                                     }) &
          tbb::make_filter<SceneResult, void>(filter_mode::serial_in_order,
                                              [&](SceneResult result) { done(std::move(result)); }));
}

std::vector<std::string> unusedRules(const std::vector<Rule>& rules,
                                     const std::vector<PictureCase>& cases) {
  std::vector<std::string> unused;
  for (const Rule& rule : rules)
    if (!rule.match.empty() && std::none_of(cases.begin(), cases.end(), [&](const PictureCase& one) {
          return nameMatches(rule.match, one.name);
        }))
      unused.push_back(rule.origin + " matches no picture");
  return unused;
}

}  // namespace simreel::golden
