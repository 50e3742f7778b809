#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>

namespace simreel::draw {

struct ExactFrame;

/// One step of the drawing of an exact picture.
class Pass {
 public:
  virtual ~Pass() = default;
  /// True if the current picture, moment or band needs the pass.
  [[nodiscard]] virtual bool on() const { return true; }
  virtual void run() = 0;
  /// Runs the pass again to restore the contents of a band. May write only resources of the band (ofBands).
  virtual void restoreBand() { run(); }
  /// Prepares the pass to store the light and layers that the caller has requested (ExactFrame::wanted).
  virtual void asked() {}
};
using PassMaker = std::unique_ptr<Pass>(ExactFrame& frame);

/// A list of names with a fixed capacity of `maximum`.
class Names {
 public:
  static constexpr std::size_t maximum = 10;
  constexpr Names(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) names_.at(count_++) = name;
  }
  [[nodiscard]] constexpr auto begin() const { return names_.begin(); }
  [[nodiscard]] constexpr auto end() const { return names_.begin() + static_cast<std::ptrdiff_t>(count_); }
  [[nodiscard]] constexpr bool has(std::string_view name) const {
    return std::find(begin(), end(), name) != end();
  }

 private:
  std::array<std::string_view, maximum> names_{};
  std::size_t count_ = 0;
};

/// How often a pass runs: once per picture, once per moment of the shutter, once per view (moment and lens
/// point), or once per band of a view.
enum class Each { picture, moment, view, band };

/// One entry of the pass list.
struct PassEntry {
  std::string_view name;
  Each each;
  const char* stage;  ///< stage name in `simreel bench`; if null, the time counts towards the next stage
  Names reads, writes;
  Names kept;  ///< names under which `simreel bisect --passes` compares the pass's output
  PassMaker* make;
};

/// A list of passes with its inputs and outputs.
struct PassList {
  std::span<const PassEntry> entries;
  Names given;    ///< resources that exist before the first pass
  Names results;  ///< resources that are read after the last pass
  Names ofBands;  ///< resources that hold one band of a view
};

/// A mistake in a pass list. An empty `what` means no mistake.
struct PassFault {
  std::string_view what, pass, resource;
};
[[nodiscard]] constexpr PassFault faultOf(const PassList& list) {
  const auto writes = [](std::string_view name) {
    return [name](const PassEntry& entry) { return entry.writes.has(name); };
  };
  const auto reads = [](std::string_view name) {
    return [name](const PassEntry& entry) { return entry.reads.has(name); };
  };
  int before = 0;  // loop level of the previous entry: 0 for the picture before the loops, 1 for moments, 2
                   // for views and bands, 3 for the picture after the loops
  for (auto entry = list.entries.begin(); entry != list.entries.end(); ++entry) {
    const bool ofPicture = entry->each == Each::picture;
    const int part = ofPicture ? (before == 0 ? 0 : 3) : entry->each == Each::moment ? 1 : 2;
    if (part < before) return {"runs inside a loop that has ended", entry->name, {}};
    before = part;
    for (const std::string_view name : list.ofBands)
      if (entry->each != Each::band && (entry->reads.has(name) || entry->writes.has(name)))
        return {"uses what one band has, but does not run once a band", entry->name, name};
    for (const std::string_view name : entry->reads)
      if (!list.given.has(name) && std::none_of(list.entries.begin(), entry, writes(name)))
        return {"reads what no earlier pass writes", entry->name, name};
    for (const std::string_view name : entry->writes)
      if (!list.results.has(name) && std::none_of(entry + 1, list.entries.end(), reads(name)))
        return {"writes what no later pass reads", entry->name, name};
  }
  return {};
}

}  // namespace simreel::draw
