#pragma once
#include <span>
#include <string_view>

namespace simreel::cli {

/// Facts about a kind of object that the reference prints beside the kind's parameters.
struct KindNotes {
  std::string_view kind;
  std::string_view states;   ///< state arrays, as `simreel trace` and `bake` name them: "name: meaning|..."
  std::string_view sources;  ///< papers and books: "one|another"; may be empty
};

/// Returns the notes of every kind, in the order of `simreel list`.
[[nodiscard]] std::span<const KindNotes> kindNotes();
/// Returns the notes of a kind; empty notes for an unknown name.
[[nodiscard]] KindNotes notesOf(std::string_view kind);

}  // namespace simreel::cli
