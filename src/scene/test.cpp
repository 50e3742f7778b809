// Declares and validates "test" and "checks" of a scene.
#include "scene/test.hpp"

#include "scene/json/words.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

constexpr Range channel{0.0, 255.0};
constexpr Range frameNumber{0.0, 1e7};

void checkAscending(Fields& fields, const std::vector<int>& frames) {
  for (std::size_t i = 1; i < frames.size(); ++i)
    if (frames[i] <= frames[i - 1])
      fields.error("frames", frames[i] == frames[i - 1] ? fmt::format("frame {} is listed twice", frames[i])
                                                        : fmt::format("frames must ascend; {} follows {}",
                                                                      frames[i], frames[i - 1]));
}

/// True if `of` is an array name, a dot and a component, such as "positions.y".
bool namesComponent(const std::string& of) {
  const std::size_t dot = of.rfind('.');
  if (dot == std::string::npos || dot == 0) return false;
  const std::string component = of.substr(dot + 1);
  return component == "length" || (component.size() == 1 && component.find_first_of("xyzw") == 0);
}

/// Checks that a check has the members that its kind needs, and no others.
void checkForm(Fields& fields, const Check& check) {
  if (check.what.empty()) {
    fields.error("what",
                 "\"what\" is missing: not-blank, no-nan, mean, min, max, sum, or a quantity such as "
                 "\"mass\"");
  } else if (check.isStatistic() && check.of.empty()) {
    fields.error("of", fmt::format("\"{}\" needs \"of\", a state array and component such as "
                                   "\"positions.y\"",
                                   check.what));
  } else if (check.isStatistic() && !namesComponent(check.of)) {
    fields.error("of", fmt::format("{} is not a state array and component; components are x, y, z, w and "
                                   "length, as in \"positions.y\"",
                                   inQuotes(check.of)));
  } else if (!check.isStatistic() && fields.given("of")) {
    fields.error("of",
                 fmt::format("\"of\" belongs to mean, min, max and sum, not to {}", inQuotes(check.what)));
  } else if (check.what == "not-blank" && fields.given("object")) {
    fields.error("object", "\"not-blank\" looks at the whole picture, not at an object");
  } else if (!check.isStatistic() && !check.isQuantity()) {
    for (const char* bound : {"min", "max", "drift"})
      if (fields.given(bound)) fields.error(bound, fmt::format("\"{}\" takes no bounds", check.what));
  } else if (!check.min && !check.max && !check.drift) {
    const std::string near = suggestion(check.what, std::array<std::string, 2>{"not-blank", "no-nan"});
    fields.error("what", fmt::format("{} needs a bound: \"min\", \"max\" or \"drift\"{}",
                                     inQuotes(check.what), near.starts_with("did") ? "; " + near : ""));
  }
}

}  // namespace

void Tolerance::describe(Fields& fields) {
  fields.integer("maxChannelDiff", maxChannelDiff, channel, "",
                 "A pixel counts as different when one of its channels differs by more than this.");
  fields.optionalNumber("maxDiffPixels", maxDiffPixels, notNegative, "pixels",
                        "Number of pixels that may differ.");
  fields.optionalNumber("maxDiffRatio", maxDiffRatio, fraction, "",
                        "Fraction of all pixels that may differ.");
  fields.leftOut("maxDiffRatio", "0.02, or any where maxDiffPixels is given");
  fields.integer("windowSize", windowSize, {1, 4096}, "pixels", "Side N of the densest N x N window.");
  fields.optionalNumber("maxWindowRatio", maxWindowRatio, fraction, "",
                        "Fraction of that window's pixels that may differ.");
  fields.optionalNumber("maxFlipMean", maxFlipMean, fraction, "", "Mean FLIP error allowed.");
  fields.optionalNumber("hardFail", hardFail, channel, "",
                        "No channel of any pixel may differ by more than this.");
  if (fields.given("windowSize") && !maxWindowRatio)
    fields.error("windowSize", "\"windowSize\" does nothing without \"maxWindowRatio\"");
}

std::string Bound::formerName() const {
  return splitCamelCase(name, '_');
}

std::vector<Bound> Tolerance::bounds() {
  class Collector final : public Fields {
   public:
    std::vector<Bound> found;
    void field(const char* name, Member member, const Spec& spec) override {
      found.push_back({name, member, spec});
    }
    void section(const char* /*name*/, bool* /*present*/, const char* /*doc*/,
                 const std::function<void(Fields&)>& /*describe*/) override {}
    void listOf(const char* /*name*/, const char* /*doc*/, std::size_t /*maxItems*/, std::size_t /*items*/,
                const std::function<void(std::size_t)>& /*resize*/,
                const std::function<void(Fields&, std::size_t)>& /*describe*/) override {}
    void namedGroups(const char* /*name*/, const char* /*doc*/, const char* /*one*/,
                     std::size_t /*maxItems*/, const std::vector<std::string>& /*names*/,
                     const std::function<void(const std::vector<std::string>&)>& /*rename*/,
                     const std::function<void(Fields&, std::size_t)>& /*describe*/) override {}
  } collector;
  describe(collector);
  return std::move(collector.found);
}

void Test::describe(Fields& fields) {
  fields.integers("frames", frames, frameNumber, "",
                  "Frames that are compared, ascending; left out: the first, middle and last.");
  fields.pair("size", size, {1, 16384}, "pixels", "Width and height of the compared images.");
  fields.integerOr("samples", samples, "scene", {1, 16}, "",
                   "Samples per pixel; \"scene\" takes what the scene renders with.");
  fields.group(
      "tolerance",
      "Allowed difference of an image from a baseline of other numerics; every bound that is given must "
      "hold. On the machine that drew the baseline images have to be equal, on another one with the same "
      "numerics within 2 of 255 on 2% of the pixels, with a mean FLIP error of 0.002.",
      [&](Fields& inner) {
        for (const Bound& bound : tolerance.bounds())
          inner.formerly(bound.formerName().c_str(), bound.name);
        tolerance.describe(inner);
      });
  fields.text("xfail", xfail, "Why the scene is expected to fail for now; passing is a failure then.");
  checkAscending(fields, frames);
  if (fields.given("xfail") && xfail.find_first_not_of(" \t") == std::string::npos)
    fields.error("xfail", "\"xfail\" needs a reason; leave it out when the scene is to pass");
}

bool Check::isStatistic() const {
  return what == "mean" || what == "min" || what == "max" || what == "sum";
}

bool Check::isQuantity() const {
  return !what.empty() && what != "not-blank" && what != "no-nan" && !isStatistic();
}

void Check::describe(Fields& fields) {
  fields.text(
      "what", what,
      "not-blank (the picture is not one colour), no-nan (every number of the state is finite), mean, "
      "min, max or sum of a component, or a quantity that the simulation measures, such as mass (simreel "
      "list "
      "KIND names them).");
  fields.text("object", object, "Name of the object; left out: the only object that measures it.");
  fields.text("of", of,
              "State array and component, such as \"positions.y\"; x, y, z, w or length (of xyz).");
  fields.integers("frames", frames, frameNumber, "",
                  "Frames at which the condition must hold, ascending; left out: every tested frame.");
  fields.formerly("least", "min");
  fields.formerly("most", "max");
  fields.optionalNumber("min", min, {}, "", "Least value that is allowed.");
  fields.optionalNumber("max", max, {}, "", "Greatest value that is allowed.");
  fields.optionalNumber("drift", drift, notNegative, "",
                        "Greatest relative change from the value at the first of the frames.");
  checkForm(fields, *this);
  checkAscending(fields, frames);
  if (min && max && !(*min <= *max))
    fields.error("min", fmt::format("\"min\" ({}) must not be above \"max\" ({})", *min, *max));
  if (drift && frames.size() == 1)
    fields.error("drift", "\"drift\" compares frames with the first, and \"frames\" lists one only");
}

}  // namespace simreel::scene
