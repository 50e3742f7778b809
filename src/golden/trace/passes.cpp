#include "golden/trace/passes.hpp"

#include "base/hash.hpp"
#include "base/strict_json.hpp"
#include "base/text.hpp"
#include "draw/exact/pass_list.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "dumps are copied as they lie in memory");

// The values must match glsl/draw/exact/tiles/tile_lists.glsl.
constexpr unsigned groundNumber = 0xfffffffeU;
constexpr unsigned noNumber = 0xffffffffU;
constexpr std::size_t passDigits = 16;

/// Returns the primitive numbers of a pixel's samples, or an empty span if the picture has no samples.
std::span<const std::uint32_t> numbersAt(const draw::PassPicture& picture, int x, int y) {
  for (const draw::PassArray& array : picture.arrays) {
    if (array.pass != "visibility" || array.part != "numbers") continue;
    if (x < 0 || y < 0 || x >= array.width || y >= array.height) continue;
    const auto each = static_cast<std::size_t>(array.each);
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(array.width) + static_cast<std::size_t>(x);
    return std::span(array.words).subspan(pixel * each, each);
  }
  return {};
}

const draw::DrawnThing* thingWith(const draw::PassPicture& picture, unsigned number) {
  const draw::DrawnThing* thing = nullptr;
  for (const draw::DrawnThing& one : picture.things)
    if (one.firstId <= number) thing = &one;
  return thing;
}

std::string hashOf(const draw::PassArray& array) {
  const std::string about =
      fmt::format("{} {} {}x{}x{} ", array.pass, array.part, array.width, array.height, array.each);
  return about + hashHex(std::as_bytes(std::span(array.words)));
}

}  // namespace

PassHashes hashesOf(const draw::PassPicture& picture) {
  PassHashes texts;
  for (const draw::PassArray& array : picture.arrays) texts[array.pass] += hashOf(array);
  for (auto& [pass, text] : texts) text = hashHex(text).substr(0, passDigits);
  return texts;
}

std::string firstDifferentPass(const PassHashes& here, const PassHashes& there) {
  for (const std::string& pass : draw::passNames()) {
    const auto a = here.find(pass);
    const auto b = there.find(pass);
    if ((a == here.end()) != (b == there.end()) || (a != here.end() && a->second != b->second)) return pass;
  }
  return {};
}

std::string SeenThing::name() const {
  return object.empty() ? "the " + primitive : primitive + " of " + object;
}

SeenThing thingOfNumber(const draw::PassPicture& picture, unsigned number) {
  if (number == groundNumber) return {"", "ground"};
  if (number == noNumber) return {"", "sky"};
  const draw::DrawnThing* thing = thingWith(picture, number);
  if (thing == nullptr) return {"", fmt::format("primitive {}", number)};
  const unsigned own = number - thing->firstId;
  if (thing->kind == "instance")
    return {thing->object, fmt::format("triangle {} of instance {}", own % thing->each, own / thing->each)};
  return {thing->object, fmt::format("{} {}", thing->kind, own)};
}

SeenThing thingAt(const draw::PassPicture& picture, int x, int y) {
  const auto numbers = numbersAt(picture, x, y);
  const auto shown = std::find_if(numbers.begin(), numbers.end(), [](unsigned n) { return n != noNumber; });
  return thingOfNumber(picture, shown == numbers.end() ? noNumber : *shown);
}

bool showsOneThing(const draw::PassPicture& picture, int x, int y) {
  const auto numbers = numbersAt(picture, x, y);
  if (numbers.empty()) return false;
  const auto same = [&](unsigned a, unsigned b) {
    const bool things = a < groundNumber && b < groundNumber;
    return a == b || (things && thingWith(picture, a) == thingWith(picture, b));
  };
  return std::all_of(numbers.begin(), numbers.end(), [&](unsigned n) { return same(n, numbers.front()); });
}

std::vector<std::byte> encodePasses(const PassDump& dump) {
  Json json = {{"passes", 1}, {"frame", dump.frame}, {"arrays", Json::array()}, {"things", Json::array()}};
  for (const draw::PassArray& a : dump.picture.arrays)
    json["arrays"].push_back({{"pass", a.pass},
                              {"part", a.part},
                              {"width", a.width},
                              {"height", a.height},
                              {"each", a.each},
                              {"light", a.light}});
  for (const draw::DrawnThing& thing : dump.picture.things)
    json["things"].push_back(
        {{"object", thing.object}, {"kind", thing.kind}, {"first", thing.firstId}, {"each", thing.each}});
  const std::string head = json.dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
  std::vector<std::byte> bytes(head.size());
  std::memcpy(bytes.data(), head.data(), head.size());
  for (const draw::PassArray& a : dump.picture.arrays) {
    const auto words = std::as_bytes(std::span(a.words));
    bytes.insert(bytes.end(), words.begin(), words.end());
  }
  return bytes;
}

PassDump readPasses(std::span<const std::byte> bytes) {
  const auto end = std::find(bytes.begin(), bytes.end(), std::byte{'\n'});
  if (end == bytes.end()) throw std::runtime_error("the dump has no header line");
  const auto size = static_cast<std::size_t>(end - bytes.begin());
  auto rest = bytes.subspan(size + 1);
  const auto json = parseStrictJson(std::string(reinterpret_cast<const char*>(bytes.data()), size));
  const JsonValue head(json);
  PassDump dump;
  if (head.at("passes").integer() != 1) throw std::runtime_error("the dump has another format");
  dump.frame = head.at("frame").integer();
  head.at("things").eachItem([&](const JsonValue& thing) {
    dump.picture.things.push_back({thing.at("object").text(), thing.at("kind").text(),
                                   thing.at("first").integer<unsigned>(0),
                                   std::max(thing.at("each").integer<unsigned>(0), 1U)});
  });
  head.at("arrays").eachItem([&](const JsonValue& a) {
    draw::PassArray array;
    array.pass = a.at("pass").text();
    array.part = a.at("part").text();
    array.width = a.at("width").integer();
    array.height = a.at("height").integer();
    array.each = a.at("each").integer();
    array.light = a.at("light").boolean();
    constexpr int largestSide = 1 << 15;
    if (std::min({array.width, array.height, array.each}) < 1 ||
        std::max({array.width, array.height, 1024 * array.each}) > largestSide)
      throw std::runtime_error("the dump has an array of no size");
    const std::size_t words = static_cast<std::size_t>(array.width) *
                              static_cast<std::size_t>(array.height) * static_cast<std::size_t>(array.each);
    if (words > rest.size() / 4) throw std::runtime_error("the dump is cut off");
    array.words.resize(words);
    std::memcpy(array.words.data(), rest.data(), words * 4);
    rest = rest.subspan(words * 4);
    dump.picture.arrays.push_back(std::move(array));
  });
  if (!rest.empty()) throw std::runtime_error("the dump is longer than its header says");
  return dump;
}

}  // namespace simreel::golden
