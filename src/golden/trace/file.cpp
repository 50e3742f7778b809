// Reads and writes steps.bin. The file consists of magic, version, header, words, and the XXH3 hash of
// everything before it. Numbers are little endian.
#include "golden/trace/file.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "golden/files/damage.hpp"
#include "golden/trace/layout.hpp"
#include "golden/trace/trace.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace simreel::golden {

namespace {

static_assert(std::endian::native == std::endian::little, "steps.bin is copied as it lies in memory");

constexpr char magic[8] = {'S', 'R', 'S', 'T', 'E', 'P', 'S', '1'};
constexpr std::uint32_t maxArrays = 4096;
constexpr std::uint32_t maxNameBytes = 256;

void put(std::vector<std::byte>& out, const void* data, std::size_t size) {
  const auto* bytes = static_cast<const std::byte*>(data);
  out.insert(out.end(), bytes, bytes + size);
}

void put(std::vector<std::byte>& out, std::uint32_t value) {
  put(out, &value, sizeof value);
}

void put(std::vector<std::byte>& out, const std::string& text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  put(out, text.data(), text.size());
}

class Input {
 public:
  Input(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(&name) {}

  [[noreturn]] void wrong(const char* what) const {
    fail(ExitCode::inputOutput, "baseline {} cannot be used: {}; {}", *name_, what, restoreIt);
  }
  std::span<const std::byte> bytes(std::size_t size) {
    if (size > bytes_.size()) wrong("it is cut off");
    const auto taken = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return taken;
  }
  std::uint32_t number() {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes(sizeof value).data(), sizeof value);
    return value;
  }
  std::string text() {
    const std::uint32_t size = number();
    if (size > maxNameBytes) wrong("a name in it is too long");
    const auto taken = bytes(size);
    return {reinterpret_cast<const char*>(taken.data()), size};
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  const std::string* name_;
};

StepTrace::Array readArray(Input& in) {
  StepTrace::Array array;
  array.object = in.text();
  array.name = in.text();
  array.elements = in.number();
  array.perBlock = in.number();
  array.steps = in.number();
  constexpr std::uint32_t max = 1U << 30;
  // Objects that only compute a first state, such as kernels with "steps": 0, have no steps.
  if (array.elements < 1 || array.elements > max || array.perBlock < 1 || array.perBlock > max ||
      array.steps > max)
    in.wrong("its sizes make no sense");
  // Every invocation of the hash kernel must take the same number of elements of a block.
  if (array.perBlock % elementsPerInvocation(array.perBlock) != 0) in.wrong("its sizes make no sense");
  return array;
}

}  // namespace

std::vector<std::byte> encodeTrace(const StepTrace& trace) {
  std::vector<std::byte> out;
  put(out, magic, sizeof magic);
  put(out, static_cast<std::uint32_t>(trace.firstFrame));
  put(out, trace.frames);
  put(out, trace.detailed);
  put(out, static_cast<std::uint32_t>(trace.arrays.size()));
  for (const StepTrace::Array& array : trace.arrays) {
    put(out, array.object);
    put(out, array.name);
    put(out, array.elements);
    put(out, array.perBlock);
    put(out, array.steps);
  }
  put(out, trace.words.data(), trace.words.size() * sizeof(std::uint32_t));
  const std::string hash = hashHex(std::span<const std::byte>(out));
  put(out, hash.data(), hash.size());
  return out;
}

StepTrace decodeTrace(std::span<const std::byte> bytes, const std::string& name) {
  Input in(bytes, name);
  if (bytes.size() < sizeof magic + hashDigits || std::memcmp(bytes.data(), magic, sizeof magic) != 0)
    in.wrong("it is no step trace");
  const auto content = bytes.first(bytes.size() - hashDigits);
  if (std::memcmp(hashHex(content).data(), bytes.last(hashDigits).data(), hashDigits) != 0)
    in.wrong("it is damaged");
  in = Input(content.subspan(sizeof magic), name);
  StepTrace trace;
  trace.firstFrame = static_cast<std::int32_t>(in.number());
  trace.frames = in.number();
  trace.detailed = in.number();
  const std::uint32_t arrays = in.number();
  constexpr std::uint32_t maxFrames = 1U << 24;
  if (trace.frames > maxFrames || trace.detailed > trace.frames || arrays > maxArrays ||
      trace.firstFrame > 0 || trace.firstFrame < -static_cast<std::int32_t>(maxFrames))
    in.wrong("its sizes make no sense");
  for (std::uint32_t i = 0; i < arrays; ++i) trace.arrays.push_back(readArray(in));
  // Computed in double, because the product of invalid sizes could overflow an integer.
  double expected = 0;
  for (const StepTrace::Array& array : trace.arrays)
    expected += double(array.words()) *
                (double(trace.detailed) * array.steps + double(trace.frames - trace.detailed) + 1.0);
  if (expected * sizeof(std::uint32_t) != static_cast<double>(in.left()))
    in.wrong("its length does not match its header");
  trace.words.resize(in.left() / sizeof(std::uint32_t));
  const auto words = in.bytes(in.left());
  if (!words.empty()) std::memcpy(trace.words.data(), words.data(), words.size());
  return trace;
}

}  // namespace simreel::golden
