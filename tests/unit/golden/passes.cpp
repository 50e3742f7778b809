#include "golden/trace/passes.hpp"

#include "golden/trace/pass_difference.hpp"

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Returns a picture of 3x2 pixels with two samples each. It shows a cloth in front of the ground and the
/// sky, with spheres and copies behind it.
golden::PassDump smallPicture() {
  golden::PassDump dump;
  dump.frame = 7;
  draw::PassPicture& picture = dump.picture;
  picture.things = {{"flag", "triangle", 0, 1}, {"snow", "ball", 100, 1}, {"darts", "instance", 200, 6}};
  const auto add = [&](const char* pass, const char* part, int each, bool light,
                       std::vector<std::uint32_t> words) {
    draw::PassArray array;
    array.pass = pass;
    array.part = part;
    array.width = 3;
    array.height = 2;
    array.each = each;
    array.light = light;
    array.words = std::move(words);
    picture.arrays.push_back(array);
  };
  constexpr unsigned ground = 0xfffffffe;
  constexpr unsigned sky = 0xffffffff;
  add("visibility", "keys", 2, false, {9, 9, 8, 8, 7, 7, 6, 6, 5, 5, sky, sky});
  add("visibility", "numbers", 2, false, {5, 99, ground, 5, 103, 103, 213, 213, ground, ground, sky, sky});
  add("light", "", 4, true, std::vector<std::uint32_t>(24, 0x3f000000));
  add("picture", "finished", 1, false, {1, 2, 3, 4, 5, 6});
  return dump;
}

draw::PassArray& arrayOf(golden::PassDump& dump, const std::string& pass) {
  for (draw::PassArray& array : dump.picture.arrays)
    if (array.pass == pass) return array;
  throw std::logic_error("no such pass");
}

}  // namespace

TEST_CASE("passes: IDs in a pass are translated to object and primitive") {
  const auto dump = smallPicture();
  const auto& picture = dump.picture;
  CHECK(golden::thingOfNumber(picture, 99).name() == "triangle 99 of flag");
  CHECK(golden::thingOfNumber(picture, 103).name() == "ball 3 of snow");
  CHECK(golden::thingOfNumber(picture, 213).name() == "triangle 1 of instance 2 of darts");
  CHECK(golden::thingOfNumber(picture, 0xfffffffe).name() == "the ground");
  CHECK(golden::thingAt(picture, 1, 0).name() == "the ground");
  CHECK(golden::thingAt(picture, 2, 1).name() == "the sky");
  CHECK(golden::thingAt(picture, 3, 1).name() == "the sky");
  CHECK(golden::thingOfNumber({}, 3).name() == "the primitive 3");
  CHECK(golden::showsOneThing(picture, 0, 0));  // Two triangles of one object count as one thing.
  CHECK_FALSE(golden::showsOneThing(picture, 1, 0));
  CHECK(golden::showsOneThing(picture, 1, 1));
  CHECK_FALSE(golden::showsOneThing(picture, -1, 1));
}

TEST_CASE("passes: each pass hash covers all outputs of its pass") {
  auto dump = smallPicture();
  const auto before = golden::hashesOf(dump.picture);
  CHECK(before.size() == 3);
  CHECK(before.at("light").size() == 16);
  CHECK(golden::firstDifferentPass(before, before).empty());
  arrayOf(dump, "picture").words[5] ^= 1U;
  auto after = golden::hashesOf(dump.picture);
  CHECK(golden::firstDifferentPass(before, after) == "picture");
  dump.picture.arrays[1].words[11] ^= 1U;  // changes the number of a primitive
  after = golden::hashesOf(dump.picture);
  CHECK(golden::firstDifferentPass(before, after) == "visibility");
  CHECK(after.at("light") == before.at("light"));
  after.erase("visibility");
  CHECK(golden::firstDifferentPass(before, after) == "visibility");
  CHECK(golden::firstDifferentPass(after, before) == "visibility");
  // A picture of another shape is different even if its words are equal.
  auto turned = smallPicture();
  std::swap(arrayOf(turned, "light").width, arrayOf(turned, "light").height);
  CHECK(golden::firstDifferentPass(before, golden::hashesOf(turned.picture)) == "light");
}

TEST_CASE("passes: a dump is read back, and damage is detected") {
  const auto dump = smallPicture();
  const auto bytes = golden::encodePasses(dump);
  const auto back = golden::readPasses(bytes);
  CHECK(back.frame == 7);
  CHECK(golden::hashesOf(back.picture) == golden::hashesOf(dump.picture));
  CHECK(back.picture.things.size() == 3);
  CHECK(golden::thingOfNumber(back.picture, 213).name() == "triangle 1 of instance 2 of darts");
  CHECK_FALSE(golden::comparePasses(dump, back));
  for (std::size_t length = 0; length < bytes.size(); ++length)
    CHECK_THROWS_AS(static_cast<void>(golden::readPasses(std::span(bytes).first(length))),
                    std::runtime_error);
  auto longer = bytes;
  longer.push_back(std::byte{0});
  CHECK_THROWS_WITH(static_cast<void>(golden::readPasses(longer)),
                    "the dump is longer than its header says");
  std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  text.replace(text.find("\"width\":3"), 9, "\"width\":0");
  CHECK_THROWS_AS(static_cast<void>(golden::readPasses(std::as_bytes(std::span(text)))),
                  std::runtime_error);
}

TEST_CASE("passes: the first difference is located, preferably at a pixel with one object") {
  const auto here = smallPicture();
  auto there = smallPicture();
  auto& light = arrayOf(there, "light").words;
  light[4 * 1 + 2] = 0;  // This pixel shows both the flag and the ground.
  auto found = golden::comparePasses(here, there);
  REQUIRE(found);
  CHECK(found->pass == "light");
  CHECK(found->pixel == golden::PicturePlace{1, 0});
  CHECK(found->differing == 1);
  light[4 * 3] = 0;
  found = golden::comparePasses(here, there);
  CHECK(found->pixel == golden::PicturePlace{0, 1});
  CHECK(found->here.name() == "triangle 1 of instance 2 of darts");
  CHECK(found->differing == 2);
  CHECK(found->all == 6);
  CHECK(found->thereValues[0] == 0);
  there.picture.arrays[0].words[3] = 4;  // changes a depth key
  found = golden::comparePasses(here, there);
  CHECK(found->pass == "visibility");
  CHECK(found->pixel == golden::PicturePlace{1, 0});
  CHECK(found->sample == 1);
  CHECK(found->here.name() == "triangle 5 of flag");
  CHECK(found->hereValues[0] == 8);
  CHECK(found->thereValues[0] == 4);
  there.picture.arrays.erase(there.picture.arrays.begin() +
                             2);  // Removes an array that belongs to a later pass.
  CHECK(golden::comparePasses(here, there)->pass == "visibility");
  there = smallPicture();
  there.picture.arrays.erase(there.picture.arrays.begin() + 2);
  found = golden::comparePasses(here, there);
  CHECK(found->pass == "light");
  CHECK(found->values == 0);
  CHECK(golden::nearnessOf(0x7fffffff - 0x3f000000) == 0.5F);
  CHECK_FALSE(golden::nearnessOf(0xffffffff));
}
