#include "frame/file/world_state.hpp"

#include "base/error.hpp"

#include <cstdint>
#include <cstring>
#include <span>

namespace simreel::frame {

namespace {

/// Appends every visited array and number to a WorldState.
class StateSaver final : public sim::CarryOver {
 public:
  explicit StateSaver(WorldState& state) : state_(state) {}
  void begin(const std::string& object) { object_ = object; }
  void array(const char* name, gl::Buffer& buffer) override {
    const std::size_t at = state_.bytes.size();
    state_.bytes.resize(at + buffer.bytes());
    buffer.read(0, std::as_writable_bytes(std::span(state_.bytes).subspan(at)));
    state_.parts.push_back({object_, name, buffer.bytes()});
  }

 private:
  void word(const char* name, std::int64_t& bits) override {
    state_.bytes.append(reinterpret_cast<const char*>(&bits), sizeof bits);
    state_.parts.push_back({object_, name, sizeof bits});
  }

  WorldState& state_;
  std::string object_;
};

/// Writes stored parts back into the visited arrays and numbers, in the same order.
class StateRestorer final : public sim::CarryOver {
 public:
  StateRestorer(const std::vector<StatePart>& parts, std::string_view bytes, const std::string& from)
      : parts_(parts), bytes_(bytes), from_(from) {}
  void begin(const std::string& object) { object_ = object; }
  void array(const char* name, gl::Buffer& buffer) override {
    buffer.write(0, std::as_bytes(std::span(next(name, buffer.bytes()))));
  }
  [[nodiscard]] bool ended() const { return part_ == parts_.size(); }

 private:
  void word(const char* name, std::int64_t& bits) override {
    std::memcpy(&bits, next(name, sizeof bits).data(), sizeof bits);
  }
  std::string_view next(const char* name, std::size_t bytes) {
    if (ended() || parts_[part_].object != object_ || parts_[part_].name != name ||
        parts_[part_].bytes != bytes)
      fail(ExitCode::usage,
           "{} does not match the scene: its next part is not the {} of \"{}\" with {} bytes; remove it to "
           "simulate from the start",
           from_, name, object_, bytes);
    ++part_;
    at_ += bytes;
    return bytes_.substr(at_ - bytes, bytes);
  }

  const std::vector<StatePart>& parts_;
  std::string_view bytes_;
  const std::string& from_;
  std::string object_;
  std::size_t part_ = 0;
  std::size_t at_ = 0;
};

}  // namespace

WorldState stateOf(sim::World& world) {
  WorldState state;
  state.frame = world.frame();
  StateSaver saver(state);
  world.visitCheckpointData(saver, [&](const std::string& object) { saver.begin(object); });
  return state;
}

void putBack(sim::World& world, int frame, const std::vector<StatePart>& parts, std::string_view bytes,
             const std::string& from) {
  gl::beforeWrites();  // Waits because kernels that read the current state may still be running.
  StateRestorer restorer(parts, bytes, from);
  world.visitCheckpointData(restorer, [&](const std::string& object) { restorer.begin(object); });
  if (!restorer.ended())
    fail(ExitCode::usage,
         "{} does not match the scene: it has more data; remove it to simulate from the start", from);
  world.resumeAt(frame);
}

}  // namespace simreel::frame
