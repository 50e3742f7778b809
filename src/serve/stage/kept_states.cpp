#include "serve/stage/kept_states.hpp"

#include <iterator>
#include <utility>

namespace simreel::serve {

void KeptStates::keep(frame::WorldState state) {
  const int frame = state.frame;
  if (const auto known = states_.find(frame); known != states_.end()) bytes_ -= known->second.bytes.size();
  bytes_ += state.bytes.size();
  states_.insert_or_assign(frame, std::move(state));
  thin();
}

void KeptStates::allow(std::size_t byteLimit) {
  byteLimit_ = byteLimit;
  thin();
}

void KeptStates::thin() {
  constexpr int farthest = 1 << 20;
  while (bytes_ > byteLimit_ && states_.size() > 1 && interval_ < farthest) {
    interval_ *= 2;
    // The state of frame 0 is never removed, because all later states can be computed from it.
    std::erase_if(states_, [&](const auto& kept) {
      if (kept.first % interval_ == 0) return false;
      bytes_ -= kept.second.bytes.size();
      return true;
    });
  }
}

const frame::WorldState* KeptStates::before(int frame) const {
  auto after = states_.upper_bound(frame);
  return after == states_.begin() ? nullptr : &std::prev(after)->second;
}

void KeptStates::forgetFrom(int frame) {
  const auto first = states_.lower_bound(frame);
  for (auto one = first; one != states_.end(); ++one) bytes_ -= one->second.bytes.size();
  states_.erase(first, states_.end());
}

void KeptStates::clear() {
  states_.clear();
  bytes_ = 0;
  interval_ = 1;
}

std::vector<int> KeptStates::frames() const {
  std::vector<int> frames;
  frames.reserve(states_.size());
  for (const auto& [frame, state] : states_) frames.push_back(frame);
  return frames;
}

}  // namespace simreel::serve
