#pragma once
#include <span>
#include <string_view>

namespace simreel::cli {

/// Facts of the reference about a kind of object, beside its parameters.
struct KindNotes {
  std::string_view kind;
  std::string_view states;   ///< state arrays, as `simreel trace` and `bake` name them: "name: meaning|..."
  std::string_view sources;  ///< papers and books: "one|another"; empty: none
};

/// Notes of every kind, in the order of `simreel list`.
[[nodiscard]] std::span<const KindNotes> kindNotes();
/// Empty notes for other names.
[[nodiscard]] KindNotes notesOf(std::string_view kind);

}  // namespace simreel::cli
