#include "serve/stage/kept_states.hpp"

#include <string>
#include <vector>

#include <doctest/doctest.h>

using simreel::frame::WorldState;
using simreel::serve::KeptStates;

namespace {

constexpr std::size_t each = 100;  ///< size of one state in bytes

WorldState stateOfFrame(int frame) {
  WorldState state;
  state.frame = frame;
  state.bytes = std::string(each, static_cast<char>(frame));
  return state;
}

/// Stores those states that KeptStates requests, frame by frame, as the stage does.
void advanceUndrawn(KeptStates& kept, int last) {
  for (int frame = 0; frame <= last; ++frame)
    if (kept.wants(frame)) kept.keep(stateOfFrame(frame));
}

int before(const KeptStates& kept, int frame) {
  const WorldState* found = kept.before(frame);
  return found == nullptr ? -1 : found->frame;
}

}  // namespace

TEST_CASE("serve: all states are kept while memory suffices") {
  KeptStates kept(5 * each);
  advanceUndrawn(kept, 4);
  CHECK_EQ(kept.frames(), std::vector{0, 1, 2, 3, 4});
  CHECK_EQ(kept.interval(), 1);
  CHECK_EQ(kept.bytes(), 5 * each);
  CHECK_FALSE(kept.wants(3));
  CHECK_FALSE(kept.wants(-1));
  CHECK(kept.wants(5));
}

TEST_CASE("serve: without room, the spacing of kept states doubles") {
  KeptStates kept(5 * each);
  advanceUndrawn(kept, 5);
  CHECK_EQ(kept.frames(), std::vector{0, 2, 4});
  CHECK_EQ(kept.interval(), 2);
  CHECK_EQ(kept.bytes(), 3 * each);
  CHECK_FALSE(kept.wants(7));
  advanceUndrawn(kept, 100);
  CHECK_EQ(kept.frames(), std::vector{0, 32, 64, 96});
  CHECK_LE(kept.bytes(), 5 * each);
}

TEST_CASE("serve: the first state is kept even with little room") {
  KeptStates kept(1);
  advanceUndrawn(kept, 9);
  CHECK_EQ(kept.frames(), std::vector{0});
  CHECK_EQ(before(kept, 9), 0);
}

TEST_CASE("serve: the nearest kept state at or before a frame is found") {
  KeptStates kept(5 * each);
  CHECK_EQ(before(kept, 3), -1);
  advanceUndrawn(kept, 5);
  CHECK_EQ(before(kept, 0), 0);
  CHECK_EQ(before(kept, 1), 0);
  CHECK_EQ(before(kept, 2), 2);
  CHECK_EQ(before(kept, 3), 2);
  CHECK_EQ(before(kept, 99), 4);
  CHECK_EQ(before(kept, -1), -1);
  CHECK_EQ(kept.before(3)->bytes, std::string(each, '\2'));
}

TEST_CASE("serve: states are discarded from a given frame on, or all") {
  KeptStates kept(5 * each);
  advanceUndrawn(kept, 4);
  kept.keep(stateOfFrame(4));  // The second call stores the same state again.
  CHECK_EQ(kept.bytes(), 5 * each);
  kept.forgetFrom(3);
  CHECK_EQ(kept.frames(), std::vector{0, 1, 2});
  CHECK_EQ(kept.bytes(), 3 * each);
  CHECK(kept.wants(3));
  advanceUndrawn(kept, 9);
  kept.clear();
  CHECK(kept.frames().empty());
  CHECK_EQ(kept.bytes(), 0);
  CHECK_EQ(kept.interval(), 1);
}
