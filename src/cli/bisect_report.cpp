#include "cli/bisect_report.hpp"

#include "base/text.hpp"

#include <bit>
#include <cstddef>

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
  std::string apart = "equal";
  if (d.here[i] != d.there[i]) {
    const auto ulps = golden::ulpsBetween(d.here[i], d.there[i]);
    apart = ulps ? fmt::format("{} ulp", *ulps) : std::string("not a number");
  }
  return fmt::format("  {} {:<32} {:<32} {}\n", components[i], value(d.here[i]), value(d.there[i]), apart);
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
    values.push_back(std::bit_cast<float>(word));  // NaN and infinity become null
    bits.push_back(fmt::format("0x{:08x}", word));
  }
  return {{"values", values}, {"bits", bits}};
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
                            : fmt::format("The same state, bit for bit, over {}.\n", framesText(result)));
}

std::string bisectJson(const BisectReport& report) {
  const golden::BisectResult& result = report.result;
  const Json json = {{"different", result.difference.has_value()},
                     {"firstFrame", result.here.run.firstFrame},
                     {"lastFrame", result.lastFrame},
                     {"here", sideJson(result.here, report.commandHere)},
                     {"there", sideJson(result.there, report.commandThere)},
                     {"difference", result.difference ? differenceJson(report) : Json()}};
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace simreel::cli
