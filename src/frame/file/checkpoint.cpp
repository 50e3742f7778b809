#include "frame/file/checkpoint.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "base/strict_json.hpp"
#include "base/version.hpp"
#include "frame/file/run_info.hpp"

#include <cstdint>
#include <limits>
#include <new>

#include <nlohmann/json.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* checkpointFormat = "simreel-checkpoint";

/// Error about a file that is a checkpoint, but whose bytes are not those that were written.
class Damaged : public JsonError {
 public:
  using JsonError::JsonError;
};

/// Removes the hash from the end of the text. Throws JsonError if the text is no checkpoint, and Damaged if
/// the hash does not match the text before it.
void checkHash(std::string& text) {
  const std::string_view all(text);
  if (!all.starts_with(fmt::format("{{\"format\":\"{}\"", checkpointFormat)))
    throw JsonError("it is not a checkpoint");
  if (all.size() < hashDigits ||
      hashHex(all.substr(0, all.size() - hashDigits)) != all.substr(all.size() - hashDigits))
    throw Damaged("it is damaged");
  text.resize(text.size() - hashDigits);
}

}  // namespace

void Checkpoint::write(const std::filesystem::path& file, const RunInfo& run, const std::string& stateHash,
                       const std::string& counts, sim::World& world) {
  const WorldState state = stateOf(world);
  Json parts = Json::array();
  for (const StatePart& part : state.parts) parts.push_back({part.object, part.name, part.bytes});
  Json header = {{"format", checkpointFormat}, {"program", version()},     {"simulation", run.simulation},
                 {"numerics", run.numerics},   {"frame", world.frame()},   {"state", stateHash},
                 {"counts", counts.size()},    {"parts", std::move(parts)}};
  if (run.numerics != "exact") header["fingerprint"] = run.fingerprint;
  std::string text = header.dump() + "\n";
  text.reserve(text.size() + counts.size() + state.bytes.size() + hashDigits);
  text += counts;
  text += state.bytes;
  text += hashHex(text);
  writeFileAtomically(file, text);
}

Checkpoint Checkpoint::load(const std::filesystem::path& file) {
  Checkpoint c;
  c.file_ = file;
  c.text_ = readFile(file, "checkpoint", std::numeric_limits<std::size_t>::max() / 2);
  try {
    c.readHeader();
  } catch (const Damaged& error) {
    fail(ExitCode::inputOutput, "checkpoint {} cannot be used: {}", file.string(), error.what());
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
    return "it belongs to another simulation: seed, times, numerics, ground, an object or a file that the "
           "scene names differ";
  if (numerics_ != "exact" && fingerprint_ != run.fingerprint)
    return fmt::format(
        "it was computed with fast numerics by a driver (fingerprint {}) that computes differently from "
        "this one ({})",
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
      throw JsonError(
          fmt::format("it is of frame {}, but the run has the frames 0 to {}", c.frame_, lastFrame));
    return c;
  } catch (const std::bad_alloc&) {
    warn("checkpoint {} is not used: there is not enough memory to read it", file.string());
  } catch (const std::exception& error) {
    warn("checkpoint {} is not used: {}", file.string(), error.what());
  }
  return std::nullopt;
}

/// Each size is compared with the number of remaining bytes, so the sum cannot exceed the file size.
void Checkpoint::readParts(const JsonValue& header) {
  std::size_t left = text_.size() - payload_;
  const auto countBytes = [&](const JsonValue& size) {
    const auto bytes =
        static_cast<std::size_t>(size.integer<std::int64_t>(0, static_cast<std::int64_t>(left)));
    left -= bytes;
    return bytes;
  };
  stateHash_ = header.at("state").text();
  countBytes_ = countBytes(header.at("counts"));
  header.at("parts").eachItem([&](const JsonValue& part) {
    parts_.push_back({part.at(0).text(), part.at(1).text(), countBytes(part.at(2))});
  });
  if (left != 0) throw JsonError("it is longer than its header says");
}

std::string_view Checkpoint::counts() const {
  return std::string_view(text_).substr(payload_, countBytes_);
}

void Checkpoint::restore(sim::World& world) const {
  putBack(world, frame_, parts_, std::string_view(text_).substr(payload_ + countBytes_),
          "checkpoint " + file_.string());
}

WorldState Checkpoint::state() const {
  return {frame_, parts_, text_.substr(payload_ + countBytes_)};
}

}  // namespace simreel::frame
