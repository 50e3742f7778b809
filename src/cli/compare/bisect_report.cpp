#include "cli/compare/bisect_report.hpp"

#include "base/text.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::cli {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* components[] = {"x", "y", "z", "w"};

std::string sideText(const char* name, const golden::TraceHeader& side, const std::string& command) {
  const std::string about =
      fmt::format("simreel {}, {}, {} path, {}{}", side.version, side.driver, side.memoryPath, command,
                  side.inexact.empty() ? "" : " (computes inexactly: " + side.inexact + ")");
  return fmt::format("{:<10} {}\n", name, oneLine(about));
}

std::string framesText(const golden::BisectResult& result) {
  const int first = result.here.run.firstFrame;
  const int count = result.lastFrame - first + 1;
  return fmt::format("{} frame{} ({} to {})", count, count == 1 ? "" : "s", first, result.lastFrame);
}

std::string componentText(const golden::ArrayDifference& d, std::size_t i) {
  const auto value = [](std::uint32_t bits) {
    return fmt::format("{:.9g} (0x{:08x})", std::bit_cast<float>(bits), bits);
  };
  std::string distance = "equal";
  if (d.here[i] != d.there[i]) {
    const auto ulps = golden::ulpsBetween(d.here[i], d.there[i]);
    distance = ulps ? fmt::format("{} ulp", *ulps) : std::string("not a number");
  }
  return fmt::format("  {} {:<32} {:<32} {}\n", components[i], value(d.here[i]), value(d.there[i]),
                     distance);
}

std::string arrayText(const golden::DifferentArray& array) {
  const golden::ArrayDifference& d = array.difference;
  return fmt::format("{}.{}: {} of {} elements differ, at most {} ulp{}\n", array.object, array.array,
                     d.differing, d.elements, d.maxUlps,
                     d.withNan > 0 ? fmt::format("; {} with a NaN", d.withNan) : "");
}

std::string differenceText(const BisectReport& report) {
  const golden::StateDifference& found = *report.result.difference;
  std::string text = fmt::format("First difference: frame {}", found.frame);
  text += found.step > 0           ? fmt::format(", step {} of {}", found.step, found.steps)
          : found.unstable.empty() ? ", the first state, before any step"
                                   : "";
  if (found.arrays.empty()) return text + "\n" + found.unstable + "\n";
  const golden::DifferentArray& first = found.arrays.front();
  text += fmt::format(": {}.{}, {}\n", first.object, first.array, report.element);
  text += fmt::format("    {:<32} {}\n", "this side", "other side");
  for (std::size_t i = 0; i < 4; ++i) text += componentText(first.difference, i);
  for (const golden::DifferentArray& array : found.arrays) text += arrayText(array);
  return text;
}

/// Returns the name of the differing pass, such as "pass shadow (sun)".
std::string passName(const golden::PassDifference& found) {
  return found.pass + (found.part.empty() ? "" : fmt::format(" ({})", found.part));
}

/// Formats one word of a pass as a depth key, as a channel of light, or as red, green and blue from the
/// lowest bytes of the word.
std::string wordText(const golden::PassDifference& found, std::uint32_t word) {
  if (found.pass == "picture")
    return fmt::format("{} {} {}", word & 255U, word >> 8U & 255U, word >> 16U & 255U);
  const std::optional<float> value = found.light ? std::bit_cast<float>(word) : golden::nearnessOf(word);
  return value ? fmt::format("{:.9g} (0x{:08x})", *value, word) : std::string("nothing");
}

/// Returns the names of the words of a pass, in order.
std::array<const char*, 4> wordNames(const golden::PassDifference& found) {
  if (found.light) return {"red", "green", "blue", "coverage"};
  return {found.pass == "picture" ? "bytes" : "nearness", "", "", ""};
}

std::string passText(const golden::PassDifference& found) {
  std::string text = fmt::format("First difference: frame {}", found.frame);
  if (!found.unstable.empty()) return text + "\n" + found.unstable + "\n";
  text += ", pass " + passName(found);
  if (found.values == 0) return text + ": only one side has it\n";
  if (found.texel) text += fmt::format(", texel ({}, {})", found.texel->x, found.texel->y);
  if (found.sample) text += fmt::format(", sample {}", *found.sample);
  if (found.pixel) {
    text += fmt::format("{} pixel ({}, {})",
                        found.sample  ? " of"
                        : found.texel ? ", shown first at"
                                      : ",",
                        found.pixel->x, found.pixel->y);
    if (found.here == found.there) text += ", " + oneLine(found.here.name());
  } else {
    text += ", which no pixel's light shows";
  }
  const auto row = [&](const char* name, const std::string& here, const std::string& there) {
    text += fmt::format("  {:<8} {:<32} {}\n", name, here, there);
  };
  text += "\n";
  row("", "this side", "other side");
  if (found.here != found.there) row("shows", oneLine(found.here.name()), oneLine(found.there.name()));
  const auto names = wordNames(found);
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.values); ++i)
    row(names[i], wordText(found, found.hereValues[i]), wordText(found, found.thereValues[i]));
  return text + fmt::format("{}: {} of {} {} differ\n", passName(found), found.differing, found.all,
                            found.sample  ? "samples"
                            : found.texel ? "texels"
                                          : "pixels");
}

Json sideJson(const golden::TraceHeader& side, const std::string& command) {
  return {{"command", command},
          {"version", side.version},
          {"driver", side.driver},
          {"fingerprint", side.fingerprint},
          {"memoryPath", side.memoryPath}};
}

Json valuesJson(const std::array<std::uint32_t, 4>& words) {
  Json values = Json::array();
  Json bits = Json::array();
  for (const std::uint32_t word : words) {
    values.push_back(std::bit_cast<float>(word));  // JSON writes NaN and infinity as null.
    bits.push_back(fmt::format("0x{:08x}", word));
  }
  return {{"values", values}, {"bits", bits}};
}

Json placeJson(const std::optional<golden::PicturePlace>& place) {
  return place ? Json{place->x, place->y} : Json();
}

Json passSideJson(const golden::PassDifference& found, const golden::SeenThing& seen,
                  const std::array<std::uint32_t, 4>& words) {
  Json values = Json::array();
  Json bits = Json::array();
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.values); ++i) {
    bits.push_back(fmt::format("0x{:08x}", words[i]));
    if (found.pass == "picture") {
      for (const unsigned shift : {0U, 8U, 16U}) values.push_back(words[i] >> shift & 255U);
    } else {
      const auto value = found.light ? std::bit_cast<float>(words[i]) : golden::nearnessOf(words[i]);
      values.push_back(value ? Json(*value) : Json());  // JSON writes NaN and infinity as null.
    }
  }
  return {{"object", seen.object}, {"primitive", seen.primitive}, {"values", values}, {"bits", bits}};
}

Json passJson(const golden::PassDifference& found) {
  Json json = {{"frame", found.frame}};
  if (!found.unstable.empty()) {
    json["unstable"] = found.unstable;
    return json;
  }
  json["pass"] = found.pass;
  json["part"] = found.part;
  json["pixel"] = placeJson(found.pixel);
  json["texel"] = placeJson(found.texel);
  json["sample"] = found.sample ? Json(*found.sample) : Json();
  json["here"] = passSideJson(found, found.here, found.hereValues);
  json["there"] = passSideJson(found, found.there, found.thereValues);
  json["differing"] = found.differing;
  json["of"] = found.all;
  return json;
}

Json differenceJson(const BisectReport& report) {
  const golden::StateDifference& found = *report.result.difference;
  Json json = {{"frame", found.frame}, {"step", found.step}, {"steps", found.steps}};
  if (!found.unstable.empty()) json["unstable"] = found.unstable;
  if (found.arrays.empty()) return json;
  const golden::DifferentArray& first = found.arrays.front();
  json["object"] = first.object;
  json["array"] = first.array;
  json["element"] = first.difference.first;
  json["elementName"] = report.element;
  json["here"] = valuesJson(first.difference.here);
  json["there"] = valuesJson(first.difference.there);
  json["arrays"] = Json::array();
  for (const golden::DifferentArray& array : found.arrays)
    json["arrays"].push_back({{"object", array.object},
                              {"array", array.array},
                              {"elements", array.difference.elements},
                              {"differing", array.difference.differing},
                              {"mostUlps", array.difference.maxUlps},
                              {"withNan", array.difference.withNan}});
  return json;
}

}  // namespace

std::string bisectText(const BisectReport& report) {
  const golden::BisectResult& result = report.result;
  return sideText("This side", result.here, report.commandHere) +
         sideText("Other side", result.there, report.commandThere) +
         (result.difference ? differenceText(report)
          : result.pass     ? passText(*result.pass)
                            : fmt::format("The same state{}, bit for bit, over {}.\n",
                                      result.passes ? " and the same passes" : "", framesText(result)));
}

std::string bisectJson(const BisectReport& report) {
  const golden::BisectResult& result = report.result;
  const Json json = {{"different", result.difference.has_value() || result.pass.has_value()},
                     {"firstFrame", result.here.run.firstFrame},
                     {"lastFrame", result.lastFrame},
                     {"here", sideJson(result.here, report.commandHere)},
                     {"there", sideJson(result.there, report.commandThere)},
                     {"difference", result.difference ? differenceJson(report)
                                    : result.pass     ? passJson(*result.pass)
                                                      : Json()}};
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace simreel::cli
