#include "golden/trace/lines.hpp"

#include "base/json_depth.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "dumps are copied as they lie in memory");

std::string text(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

struct NoWholeNumber {};

/// A number that Int holds. nlohmann would convert 1e300 without a word, which C++ leaves undefined.
template <class Int>
Int whole(const Json& json) {
  if (json.is_number_unsigned() && std::in_range<Int>(json.get<std::uint64_t>()))
    return static_cast<Int>(json.get<std::uint64_t>());
  if (json.is_number_integer() && !json.is_number_unsigned() &&
      std::in_range<Int>(json.get<std::int64_t>()))
    return static_cast<Int>(json.get<std::int64_t>());
  throw NoWholeNumber();
}

/// Calls `read` with the parsed line; what nlohmann says of a mistake is for its users, not for ours.
template <class Read>
auto reading(const std::string& line, const char* what, const Read& read) {
  refuseDeepJson(line);
  const auto refusal = [&] {
    std::string start = line.substr(0, 80);
    for (char& c : start)
      if (static_cast<unsigned char>(c) < 32) c = ' ';
    return std::runtime_error("\"" + start + "\" is no " + what);
  };
  try {
    return read(Json::parse(line));
  } catch (const Json::exception&) {
    throw refusal();
  } catch (const NoWholeNumber&) {
    throw refusal();
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
               {"firstFrame", header.firstFrame},
               {"arrays", Json::array()}};
  for (const TraceHeader::Array& a : header.arrays)
    json["arrays"].push_back(
        {{"object", a.object}, {"array", a.array}, {"elements", a.elements}, {"stepsPerFrame", a.steps}});
  return text(json);
}

TraceHeader readHeaderLine(const std::string& line) {
  return reading(line, "header of a trace", [](const Json& json) {
    TraceHeader header;
    const int format = whole<int>(json.at("trace"));
    if (format != 1) throw std::runtime_error("its trace has format " + std::to_string(format) + ", not 1");
    header.version = json.at("version");
    header.driver = json.at("driver");
    header.fingerprint = json.at("fingerprint");
    header.memoryPath = json.at("memoryPath");
    if (json.at("inexact").is_string()) header.inexact = json.at("inexact");
    header.firstFrame = whole<int>(json.at("firstFrame"));
    for (const Json& a : json.at("arrays"))
      header.arrays.push_back({a.at("object"), a.at("array"), whole<std::int64_t>(a.at("elements")),
                               whole<int>(a.at("stepsPerFrame"))});
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
  return text(json);
}

StateLine readStateLine(const std::string& line) {
  return reading(line, "line of a trace", [](const Json& json) {
    StateLine state;
    state.frame = whole<int>(json.at("frame"));
    if (json.contains("step")) {
      state.object = json.at("object");
      state.step = whole<int>(json.at("step"));
      state.steps = whole<int>(json.at("steps"));
    }
    for (const auto& [name, hash] : json.at("arrays").items()) state.arrays.emplace_back(name, hash);
    return state;
  });
}

std::vector<std::byte> encodeDump(const StateDump& dump) {
  Json json = {{"dump", 1}, {"frame", dump.frame}, {"step", dump.step}, {"arrays", Json::array()}};
  for (const StateDump::Array& a : dump.arrays)
    json["arrays"].push_back({{"object", a.object}, {"array", a.array}, {"elements", a.words.size() / 4}});
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
  return reading(head, "header of a dump", [&](const Json& json) {
    StateDump dump;
    dump.frame = whole<int>(json.at("frame"));
    dump.step = whole<int>(json.at("step"));
    for (const Json& a : json.at("arrays")) {
      const auto elements = whole<std::uint64_t>(a.at("elements"));
      if (elements > rest.size() / 16) throw std::runtime_error("the dump is cut off");
      StateDump::Array array{a.at("object"), a.at("array"), std::vector<std::uint32_t>(elements * 4)};
      if (elements > 0) std::memcpy(array.words.data(), rest.data(), elements * 16);
      rest = rest.subspan(elements * 16);
      dump.arrays.push_back(std::move(array));
    }
    if (!rest.empty()) throw std::runtime_error("the dump is longer than its header says");
    return dump;
  });
}

}  // namespace simreel::golden
