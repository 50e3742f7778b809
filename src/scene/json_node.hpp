#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::scene {

/// A stretch of the text a message points at. `source` 0 is the scene file; i > 0 the i-th override.
struct Place {
  std::size_t source = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A JSON value that remembers where it stands.
struct Node {
  enum class Kind { null, boolean, number, text, list, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;
  bool whole = false;  ///< the number was written without fraction or exponent
  std::string text;
  std::vector<Node> items;         ///< of a list, or the values of an object's members
  std::vector<std::string> keys;   ///< of an object, in file order
  std::vector<Place> keyPlaces;
  Place place;

  [[nodiscard]] const Node* find(std::string_view key) const;
  [[nodiscard]] Node* find(std::string_view key);
};

/// "a number", "a string", ... for messages.
[[nodiscard]] const char* kindName(Node::Kind kind);

/// A syntax mistake.
struct JsonError {
  Place place;
  std::string message;
};

/// Parses JSON with // and /* */ comments. Refuses duplicate keys, numbers beyond double, more than 64 levels and
/// more than a million values. False with `error` filled in when the text is no such JSON.
[[nodiscard]] bool parseJson(std::string_view text, std::size_t source, Node& root, JsonError& error);

}  // namespace simreel::scene
