#include "golden/suite/judge.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "golden/baseline/tolerance.hpp"
#include "golden/compare/compare.hpp"
#include "golden/files/damage.hpp"
#include "golden/files/png_check.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

const PictureBaseline::Frame* find(const Reference& reference, int frame) {
  if (!reference.pictures) return nullptr;
  const auto found = reference.pictures->frames.find(frame);
  return found == reference.pictures->frames.end() ? nullptr : &found->second;
}

fs::path pictureFile(const Reference& reference, int frame, int alternate) {
  return reference.folder / reference.pictures->profile / pictureName(frame, alternate);
}

void addMessage(FrameResult& result, Status status, const std::string& message) {
  // A difference has precedence over a missing baseline.
  if (result.status != Status::fail) result.status = status;
  result.message += (result.message.empty() ? "" : "; ") + message;
}

void judgeState(const RunFrame& made, const Reference& reference, bool sameNumerics, FrameResult& result) {
  result.state = "equal";
  if (made.state.empty()) return;  // the scene has no simulated objects
  if (!reference.exact && !sameNumerics) {
    result.state = "not compared";
    return;
  }
  const StateHashes* stored = nullptr;
  if (reference.state)
    if (const auto found = reference.state->frames.find(made.frame); found != reference.state->frames.end())
      stored = &found->second;
  if (stored == nullptr) {
    result.state = "missing";
    addMessage(result, Status::missing, "no baseline of its state");
    return;
  }
  if (*stored == made.state) return;
  result.state = "different";
  std::string names;
  for (const auto& [array, hash] : made.state)
    if (const auto found = stored->find(array); found == stored->end() || found->second != hash)
      names += (names.empty() ? "" : ", ") + array;
  if (names.empty()) names = "an array that is gone";
  addMessage(result, Status::fail, "the state differs: " + names);
}

struct Nearest {
  int alternate = 0;
  Metrics metrics;
  std::vector<std::string> broken;
};

/// Returns the baseline or alternate that violates the fewest bounds. If several violate equally few,
/// returns the one with the fewest pixels beyond the tolerance, then the one with the fewest differing
/// pixels.
Nearest nearest(const RunFrame& made, const Reference& reference, const PictureBaseline::Frame& stored,
                Measures measures) {
  const bool near = requiredMatch(stored.origin, reference.here) == RequiredMatch::near;
  if (near || reference.tolerance.maxFlipMean) measures = Measures::all;
  std::optional<Nearest> best;
  for (int i = 0; i <= static_cast<int>(stored.alternates.size()); ++i) {
    const auto picture = referencePicture(reference, made.frame, i);
    const auto metrics = measure(made.image, picture, reference.tolerance, measures);
    auto broken = brokenBounds(metrics, reference.tolerance, picture.width, picture.height);
    if (near)
      for (std::string& clause : brokenNearness(metrics, picture.width, picture.height))
        broken.push_back(std::move(clause));
    const auto rank = [](const Metrics& m, const std::vector<std::string>& clauses) {
      return std::tuple(clauses.size(), m.pixelsBeyond, m.differentPixels);
    };
    if (!best || rank(metrics, broken) < rank(best->metrics, best->broken))
      best = {i, metrics, std::move(broken)};
  }
  return *best;
}

/// Returns the message for a picture whose pixels must all be equal but differ.
std::string unequal(const Metrics& metrics, const Origin& there, const Origin& here) {
  if (there.exact && !here.exact)
    return "the baseline was drawn by the exact rasterizer, this picture by the driver; update the "
           "baseline with --update=changed, or set \"rasterizer\": \"exact\"";
  if (here.exact && !there.exact)
    return "the baseline was drawn by a driver, this picture by the exact rasterizer; look at the picture "
           "and update the baseline with --update=changed, or set \"rasterizer\": \"driver\"";
  return fmt::format("{} pixels differ, by {:.4g} at most; {} no pixel may differ", metrics.differentPixels,
                     metrics.worst,
                     here.exact ? "in exact pictures" : "on the machine that drew the baseline");
}

/// Judges the pixels of a frame. Returns true if the picture fails.
bool judgePixels(const RunFrame& made, const Reference& reference, Measures measures, FrameResult& result) {
  const PictureBaseline::Frame* stored = find(reference, made.frame);
  if (stored == nullptr) {
    addMessage(result, Status::missing, "no baseline picture");
    return false;
  }
  result.expectedPixels = stored->pixels;
  const PictureBaseline& all = *reference.pictures;
  if (all.width != made.image.width || all.height != made.image.height) {
    addMessage(result, Status::fail,
               fmt::format("the picture is {}x{}, its baseline {}x{}", made.image.width, made.image.height,
                           all.width, all.height));
    return true;
  }
  for (int i = 0; i <= static_cast<int>(stored->alternates.size()); ++i)
    if (const auto file = pictureFile(reference, made.frame, i); !pathExists(file))
      fail(ExitCode::inputOutput, "baseline picture {} is missing, though baseline.json lists it; {}",
           file.string(), restoreIt);
  const auto known = std::find(stored->alternates.begin(), stored->alternates.end(), made.pixels);
  if (known != stored->alternates.end())
    result.alternate = static_cast<int>(known - stored->alternates.begin()) + 1;
  if (stored->pixels == made.pixels || known != stored->alternates.end()) {
    for (int i = 0; i <= static_cast<int>(stored->alternates.size()); ++i)
      static_cast<void>(referencePicture(reference, made.frame, i));
    return false;
  }
  Nearest found = nearest(made, reference, *stored, measures);
  result.alternate = found.alternate;
  result.metrics = found.metrics;
  if (requiredMatch(stored->origin, reference.here) <= RequiredMatch::equal) {
    addMessage(result, Status::fail, unequal(found.metrics, stored->origin, reference.here));
    return true;
  }
  if (!found.broken.empty())
    addMessage(result, Status::fail, fmt::format("{}", fmt::join(found.broken, "; ")));
  return !found.broken.empty();
}

}  // namespace

Reference findReference(const fs::path& folder, const std::string& ownProfile, bool exact,
                        const Origin& here) {
  Reference reference;
  reference.folder = folder;
  reference.exact = exact;
  reference.here = here;
  reference.pictures = choosePictures(folder, ownProfile);
  const std::string profile = reference.pictures ? reference.pictures->profile : ownProfile;
  reference.state = readState(stateFolder(folder, profile, exact));
  return reference;
}

Judgement judgeFrame(const RunFrame& made, const Reference& reference, Measures measures) {
  Judgement judged;
  FrameResult& result = judged.frame;
  result.frame = made.frame;
  result.time = made.time;
  result.pixels = made.pixels;
  const PictureBaseline::Frame* stored = find(reference, made.frame);
  if (stored != nullptr) result.asked = requiredMatchName(requiredMatch(stored->origin, reference.here));
  const bool sameNumerics = stored == nullptr || stored->origin.numerics == reference.here.numerics;
  judgeState(made, reference, sameNumerics, result);
  try {
    judged.pictureFails = judgePixels(made, reference, measures, result);
  } catch (const UserError& error) {
    judged.pictureFails = judged.damaged = true;
    addMessage(result, Status::fail, error.what());
  }
  return judged;
}

frame::Image referencePicture(const Reference& reference, int frame, int alternate) {
  const fs::path file = pictureFile(reference, frame, alternate);
  frame::Image picture = readPng(file, "baseline picture");
  const PictureBaseline& all = *reference.pictures;
  if (picture.width != all.width || picture.height != all.height)
    fail(ExitCode::inputOutput, "baseline picture {} is {}x{}, though baseline.json says {}x{}",
         file.string(), picture.width, picture.height, all.width, all.height);
  const PictureBaseline::Frame& stored = all.frames.at(frame);
  const std::string& listed =
      alternate == 0 ? stored.pixels : stored.alternates.at(static_cast<std::size_t>(alternate) - 1);
  if (frame::pixelHash(picture) != listed)
    fail(ExitCode::inputOutput, "baseline picture {} does not have the pixels that baseline.json lists; {}",
         file.string(), restoreIt);
  return picture;
}

std::optional<PassPlace> placeOfDifference(const Reference& reference, const RunFrame& made, int alternate,
                                           const PassDump& drawn) {
  frame::Image expected;
  try {
    expected = referencePicture(reference, made.frame, alternate);
  } catch (const UserError&) {
    return std::nullopt;  // judgeFrame() has already reported the error.
  }
  if (expected.bytes.size() != made.image.bytes.size()) return std::nullopt;
  constexpr std::size_t channels = 4;  // number of channels (RGBA); alpha is not compared, because the
                                       // files have none
  const std::size_t pixels = expected.bytes.size() / channels;
  const auto color = [](const frame::Image& image, std::size_t pixel) {
    const auto* bytes = &image.bytes[channels * pixel];
    return std::array<int, 3>{bytes[0], bytes[1], bytes[2]};
  };
  const auto width = static_cast<std::size_t>(expected.width);
  const auto alone = [&](std::size_t i) {
    return showsOneThing(drawn.picture, static_cast<int>(i % width), static_cast<int>(i / width));
  };
  std::size_t pixel = pixels;
  for (std::size_t i = 0; i < pixels && (pixel == pixels || !alone(pixel)); ++i)
    if (color(made.image, i) != color(expected, i) && (pixel == pixels || alone(i))) pixel = i;
  if (pixel == pixels) return std::nullopt;
  PassPlace place;
  place.x = static_cast<int>(pixel % width);
  place.y = static_cast<int>(pixel / width);
  place.shows = thingAt(drawn.picture, place.x, place.y).name();
  const auto& known = reference.pictures->frames.at(made.frame).passes;
  if (alternate == 0 && !known.empty()) place.pass = firstDifferentPass(hashesOf(drawn.picture), known);
  place.message = fmt::format("frame {}: {}; at pixel ({}, {}), {}: {}, in the baseline {}", made.frame,
                              place.pass.empty() ? "the baseline does not record which pass differs"
                                                 : "the first pass that differs is " + place.pass,
                              place.x, place.y, place.shows, fmt::join(color(made.image, pixel), " "),
                              fmt::join(color(expected, pixel), " "));
  return place;
}

std::vector<std::string> looseBounds(const std::vector<FrameResult>& frames,
                                     const scene::Tolerance& tolerance) {
  std::map<std::string, double> observed;
  for (const FrameResult& frame : frames) {
    // Only frames drawn with other numerics use the tolerance.
    if (!frame.metrics || frame.asked != requiredMatchName(RequiredMatch::tolerance)) continue;
    const Metrics& m = *frame.metrics;
    const auto raise = [&](const char* field, double value) {
      observed[field] = std::max(observed[field], value);
    };
    raise("maxChannelDiff", m.worst);
    raise("maxDiffPixels", static_cast<double>(m.pixelsBeyond));
    raise("maxDiffRatio", m.ratioBeyond);
    raise("maxWindowRatio", m.windowRatio);
    raise("maxFlipMean", m.flipMean.value_or(0));
    raise("hardFail", m.worst);
  }
  constexpr double muchLooser = 10;
  std::vector<std::string> loose;
  if (observed.empty()) return loose;
  for (const auto& [field, bound] : boundsInForce(tolerance)) {
    if (!observed.contains(field) || bound <= muchLooser * observed[field]) continue;
    loose.push_back(observed[field] == 0
                        ? fmt::format("{} is {:g}, though nothing was observed", field, bound)
                        : fmt::format("{} is {:g}, {:.0f} times the {:.3g} observed", field, bound,
                                      bound / observed[field], observed[field]));
  }
  return loose;
}

}  // namespace simreel::golden
