#include "frame/file/checkpoint.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "base/strict_json.hpp"
#include "base/version.hpp"
#include "frame/file/run_info.hpp"

#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <span>

#include <nlohmann/json.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* checkpointFormat = "simreel-checkpoint";

/// Takes the hash off its end. Throws JsonError where it is not of all before.
void checkHash(std::string& text) {
  const std::string_view all(text);
  if (all.size() < hashDigits ||
      hashHex(all.substr(0, all.size() - hashDigits)) != all.substr(all.size() - hashDigits))
    throw JsonError("it is damaged, or of another version of simreel");
  text.resize(text.size() - hashDigits);
}

/// Appends every part to a text.
class Saver final : public sim::CarryOver {
 public:
  Saver(std::string& text, Json& parts) : text_(text), parts_(parts) {}
  void begin(const std::string& object) { object_ = object; }
  void array(const char* name, gl::Buffer& buffer) override {
    const std::size_t at = text_.size();
    text_.resize(at + buffer.bytes());
    buffer.read(0, std::as_writable_bytes(std::span(text_).subspan(at)));
    parts_.push_back({object_, name, buffer.bytes()});
  }

 private:
  void word(const char* name, std::int64_t& bits) override {
    text_.append(reinterpret_cast<const char*>(&bits), sizeof bits);
    parts_.push_back({object_, name, sizeof bits});
  }

  std::string& text_;
  Json& parts_;
  std::string object_;
};

}  // namespace

void Checkpoint::write(const std::filesystem::path& file, const RunInfo& run, const std::string& stateHash,
                       const std::string& counts, sim::World& world) {
  std::string payload = counts;
  Json parts = Json::array();
  Saver saver(payload, parts);
  world.carryOver(saver, [&](const std::string& object) { saver.begin(object); });
  Json header = {{"format", checkpointFormat}, {"program", version()},     {"simulation", run.simulation},
                 {"numerics", run.numerics},   {"frame", world.frame()},   {"state", stateHash},
                 {"counts", counts.size()},    {"parts", std::move(parts)}};
  if (run.numerics != "exact") header["fingerprint"] = run.fingerprint;
  std::string text = header.dump() + "\n";
  text.reserve(text.size() + payload.size() + hashDigits);
  text += payload;
  text += hashHex(text);
  writeFileAtomically(file, text);
}

Checkpoint Checkpoint::load(const std::filesystem::path& file) {
  Checkpoint c;
  c.file_ = file;
  c.text_ = readFile(file, "checkpoint", std::numeric_limits<std::size_t>::max() / 2);
  try {
    c.readHeader();
  } catch (const JsonError& error) {
    fail(ExitCode::usage, "checkpoint {} cannot be used: {}", file.string(), error.what());
  }
  return c;
}

void Checkpoint::readHeader() {
  checkHash(text_);
  payload_ = text_.find('\n') + 1;
  const auto json = parseStrictJson(std::string_view(text_).substr(0, payload_));
  const JsonValue header(json);
  if (!header.at("format").is(checkpointFormat)) throw JsonError("it is no checkpoint");
  if (const std::string program = header.at("program").text(); program != version())
    throw JsonError(fmt::format("simreel {} wrote it", program));
  simulation_ = header.at("simulation").text();
  numerics_ = header.at("numerics").text();
  fingerprint_ = textIfThere(header, "fingerprint");
  frame_ = header.at("frame").integer(0);
  readParts(header);
}

std::optional<std::string> Checkpoint::mismatch(const RunInfo& run) const {
  if (simulation_ != run.simulation)
    return "it is of another simulation: seed, times, numerics, ground or an object differ";
  if (numerics_ != "exact" && fingerprint_ != run.fingerprint)
    return fmt::format(
        "its numerics are fast, and its driver's (fingerprint {}) are others than this one's ({})",
        fingerprint_, run.fingerprint);
  return std::nullopt;
}

std::optional<Checkpoint> Checkpoint::read(const std::filesystem::path& file, const RunInfo& run,
                                           int lastFrame) {
  if (!pathExists(file)) return std::nullopt;
  try {
    Checkpoint c;
    c.file_ = file;
    c.text_ = readFile(file, "checkpoint", std::numeric_limits<std::size_t>::max() / 2);
    c.readHeader();
    if (const auto difference = c.mismatch(run)) throw JsonError(*difference);
    if (c.frame_ > lastFrame)
      throw JsonError(fmt::format("it is of frame {}, and the run has 0 to {}", c.frame_, lastFrame));
    return c;
  } catch (const std::bad_alloc&) {
    warn("checkpoint {} is not used: there is not enough memory to read it", file.string());
  } catch (const std::exception& error) {
    warn("checkpoint {} is not used: {}", file.string(), error.what());
  }
  return std::nullopt;
}

/// Sizes are taken off what there is, so they can add up to nothing else.
void Checkpoint::readParts(const JsonValue& header) {
  std::size_t left = text_.size() - payload_;
  const auto take = [&](const JsonValue& size) {
    const auto bytes =
        static_cast<std::size_t>(size.integer<std::int64_t>(0, static_cast<std::int64_t>(left)));
    left -= bytes;
    return bytes;
  };
  stateHash_ = header.at("state").text();
  countBytes_ = take(header.at("counts"));
  header.at("parts").eachItem([&](const JsonValue& part) {
    parts_.push_back({part.at(0).text(), part.at(1).text(), take(part.at(2))});
  });
  if (left != 0) throw JsonError("it holds more than it says");
}

std::string_view Checkpoint::counts() const {
  return std::string_view(text_).substr(payload_, countBytes_);
}

void Checkpoint::restore(sim::World& world) const {
  /// Puts the parts back one after the other.
  class Restorer final : public sim::CarryOver {
   public:
    explicit Restorer(const Checkpoint& from) : from_(from), at_(from.payload_ + from.countBytes_) {}
    void begin(const std::string& object) { object_ = object; }
    void array(const char* name, gl::Buffer& buffer) override {
      buffer.write(0, std::as_bytes(std::span(next(name, buffer.bytes()))));
    }
    [[nodiscard]] bool ended() const { return part_ == from_.parts_.size(); }

   private:
    void word(const char* name, std::int64_t& bits) override {
      std::memcpy(&bits, next(name, sizeof bits).data(), sizeof bits);
    }
    std::string_view next(const char* name, std::size_t bytes) {
      if (ended() || from_.parts_[part_].object != object_ || from_.parts_[part_].name != name ||
          from_.parts_[part_].bytes != bytes)
        fail(ExitCode::usage,
             "checkpoint {} does not fit: it has no {} of \"{}\" with {} bytes next; remove it to simulate "
             "from the start",
             from_.file_.string(), name, object_, bytes);
      ++part_;
      at_ += bytes;
      return std::string_view(from_.text_).substr(at_ - bytes, bytes);
    }

    const Checkpoint& from_;
    std::string object_;
    std::size_t part_ = 0;
    std::size_t at_;
  };

  gl::beforeWrites();  // kernels of the first state may still be at it
  Restorer restorer(*this);
  world.carryOver(restorer, [&](const std::string& object) { restorer.begin(object); });
  if (!restorer.ended())
    fail(ExitCode::usage, "checkpoint {} does not fit: it holds more; remove it to simulate from the start",
         file_.string());
  world.resumeAt(frame_);
}

}  // namespace simreel::frame
