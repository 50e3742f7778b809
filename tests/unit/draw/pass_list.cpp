// Tests the list of passes of an exact picture: invalid lists, and properties of the actual list.
#include "draw/exact/pass_list.hpp"

#include <set>
#include <span>

#include <doctest/doctest.h>

namespace simreel::test::draw_pass_list {

using draw::Each;
using draw::PassEntry;
using draw::PassFault;

PassFault faultOf(std::span<const PassEntry> entries) {
  return draw::faultOf({entries, {"drawables"}, {"picture"}, {"keys"}});
}

constexpr PassEntry depth{"depth", Each::band, "visibility", {"drawables"}, {"keys"}, {}, nullptr};
constexpr PassEntry shade{"shade", Each::band, "surfaces", {"keys"}, {"light"}, {}, nullptr};
constexpr PassEntry film{"film", Each::picture, "tone map", {"light"}, {"picture"}, {}, nullptr};

TEST_CASE("pass list: a pass that reads what no earlier pass writes is refused") {
  CHECK(faultOf(std::array{depth, shade, film}).what.empty());
  for (const auto& list : {std::array{shade, depth, film}, std::array{shade, shade, film}}) {
    const PassFault fault = faultOf(list);
    CHECK(fault.what == "reads what no earlier pass writes");
    CHECK(fault.pass == "shade");
    CHECK(fault.resource == "keys");
  }
  PassEntry own = shade;
  own.reads = {"keys", "own"};
  own.writes = {"light", "own"};
  CHECK(faultOf(std::array{depth, own, film}).resource == "own");
}

TEST_CASE("pass list: a pass that writes what no later pass reads is refused") {
  const PassFault fault = faultOf(std::array{depth, film});
  CHECK(fault.pass == "depth");
  CHECK(fault.what == "writes what no later pass reads");
}

TEST_CASE("pass list: a per-band pass among whole-picture passes is refused") {
  PassEntry early = film;
  early.writes = {"light", "picture"};
  early.reads = {"drawables"};
  CHECK(faultOf(std::array{depth, early, shade, film}).what == "runs inside a loop that has ended");
}

TEST_CASE("pass list: a once-per-view pass that reads per-band data is refused") {
  PassEntry whole = shade;
  whole.each = Each::view;
  const PassFault fault = faultOf(std::array{depth, whole, film});
  CHECK(fault.what == "uses what one band has, but does not run once a band");
  CHECK(fault.resource == "keys");
}

TEST_CASE("pass list: bisect compares the outputs that passes keep, in pass order") {
  CHECK(draw::passNames() ==
        std::vector<std::string>{"visibility", "shadow", "light", "glow", "bloom", "picture"});
}

TEST_CASE("pass list: pass names are unique") {
  std::set<std::string_view> names;
  for (const PassEntry& entry : draw::exactPasses) CHECK(names.insert(entry.name).second);
}

}  // namespace simreel::test::draw_pass_list
