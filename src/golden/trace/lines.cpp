#include "golden/trace/lines.hpp"

#include "base/strict_json.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "dumps are copied as they lie in memory");

std::string text(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

/// Parses a line as JSON and calls `read` with it. Adds the line and `what` to error messages.
template <class Read>
auto reading(const std::string& line, const char* what, const Read& read) {
  try {
    const auto json = parseStrictJson(line);
    return read(JsonValue(json));
  } catch (const JsonError& error) {
    constexpr std::size_t maxShown = 80;
    throw std::runtime_error(
        fmt::format("\"{}\" is no {}: {}", oneLine(line.substr(0, maxShown)), what, error.what()));
  }
}

}  // namespace

std::string headerLine(const TraceHeader& header) {
  Json json = {{"trace", 1},
               {"version", header.version},
               {"driver", header.driver},
               {"fingerprint", header.fingerprint},
               {"memoryPath", header.memoryPath},
               {"inexact", header.inexact.empty() ? Json() : Json(header.inexact)},
               {"firstFrame", header.run.firstFrame},
               {"arrays", Json::array()}};
  for (const TracedArray& a : header.run.arrays)
    json["arrays"].push_back(
        {{"object", a.object}, {"array", a.array}, {"elements", a.elements}, {"stepsPerFrame", a.steps}});
  return text(json);
}

TraceHeader readHeaderLine(const std::string& line) {
  return reading(line, "header of a trace", [](const JsonValue& json) {
    TraceHeader header;
    const int format = json.at("trace").integer();
    if (format != 1) throw std::runtime_error("its trace has format " + std::to_string(format) + ", not 1");
    header.version = json.at("version").text();
    header.driver = json.at("driver").text();
    header.fingerprint = json.at("fingerprint").text();
    header.memoryPath = json.at("memoryPath").text();
    if (const JsonValue inexact = json.at("inexact"); !inexact.isNull()) header.inexact = inexact.text();
    header.run.firstFrame = json.at("firstFrame").integer();
    json.at("arrays").eachItem([&](const JsonValue& a) {
      header.run.arrays.push_back({a.at("object").text(), a.at("array").text(),
                                   a.at("elements").integer<std::int64_t>(),
                                   a.at("stepsPerFrame").integer()});
    });
    return header;
  });
}

std::string stateLine(const StateLine& state) {
  Json json = {{"frame", state.frame}};
  if (state.step > 0) {
    json["object"] = state.object;
    json["step"] = state.step;
    json["steps"] = state.steps;
  }
  json["arrays"] = Json::object();
  for (const auto& [name, hash] : state.arrays) json["arrays"][name] = hash;
  if (!state.passes.empty()) json["passes"] = Json::object();
  for (const auto& [pass, hash] : state.passes) json["passes"][pass] = hash;
  return text(json);
}

StateLine readStateLine(const std::string& line) {
  return reading(line, "line of a trace", [](const JsonValue& json) {
    StateLine state;
    state.frame = json.at("frame").integer();
    if (const auto step = json.find("step")) {
      state.object = json.at("object").text();
      state.step = step->integer();
      state.steps = json.at("steps").integer();
    }
    json.at("arrays").eachMember([&](const std::string& name, const JsonValue& hash) {
      state.arrays.emplace_back(name, hash.text());
    });
    if (const auto passes = json.find("passes"))
      passes->eachMember([&](const std::string& pass, const JsonValue& hash) {
        state.passes.emplace_back(pass, hash.text());
      });
    return state;
  });
}

std::vector<std::byte> encodeDump(const StateDump& dump) {
  Json json = {{"dump", 1}, {"frame", dump.frame}, {"step", dump.step}, {"arrays", Json::array()}};
  for (const StateDump::Array& a : dump.arrays)
    json["arrays"].push_back(
        {{"object", a.object}, {"array", a.array}, {"elements", a.words.size() / wordsPerElement}});
  const std::string head = text(json) + "\n";
  std::vector<std::byte> bytes(head.size());
  std::memcpy(bytes.data(), head.data(), head.size());
  for (const StateDump::Array& a : dump.arrays) {
    const auto words = std::as_bytes(std::span(a.words));
    bytes.insert(bytes.end(), words.begin(), words.end());
  }
  return bytes;
}

StateDump readDump(std::span<const std::byte> bytes) {
  const auto end = std::find(bytes.begin(), bytes.end(), std::byte{'\n'});
  if (end == bytes.end()) throw std::runtime_error("the dump has no header line");
  const auto size = static_cast<std::size_t>(end - bytes.begin());
  const std::string head(reinterpret_cast<const char*>(bytes.data()), size);
  auto rest = bytes.subspan(size + 1);
  return reading(head, "header of a dump", [&](const JsonValue& json) {
    StateDump dump;
    dump.frame = json.at("frame").integer();
    dump.step = json.at("step").integer();
    json.at("arrays").eachItem([&](const JsonValue& a) {
      const auto elements = static_cast<std::size_t>(a.at("elements").integer<std::int64_t>(0));
      if (elements > rest.size() / bytesPerElement) throw std::runtime_error("the dump is cut off");
      StateDump::Array array{a.at("object").text(), a.at("array").text(),
                             std::vector<std::uint32_t>(elements * wordsPerElement)};
      if (elements > 0) std::memcpy(array.words.data(), rest.data(), elements * bytesPerElement);
      rest = rest.subspan(elements * bytesPerElement);
      dump.arrays.push_back(std::move(array));
    });
    if (!rest.empty()) throw std::runtime_error("the dump is longer than its header says");
    return dump;
  });
}

}  // namespace simreel::golden
