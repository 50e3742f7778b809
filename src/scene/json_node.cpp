#include "scene/json_node.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::scene {

namespace {

constexpr std::size_t mostLevels = 64;
constexpr std::size_t mostValues = 1'000'000;
constexpr std::size_t mostKeys = 5'000;

/// Hands the text to the parser one character at a time and counts: when the parser reports a token, the count
/// tells where that token ends.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*count_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator old = *this;
    ++*this;
    return old;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* count_;
};

bool isNumberCharacter(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}

/// Builds the tree from the parser's events.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, std::size_t source, const std::size_t& consumed, Node& root, JsonError& error)
      : text_(text), source_(source), consumed_(consumed), root_(root), error_(error) {}

  bool null() override { return add(Node::Kind::null, word(4)) != nullptr; }
  bool boolean(bool value) override {
    Node* node = add(Node::Kind::boolean, word(value ? 4 : 5));
    if (node != nullptr) node->boolean = value;
    return node != nullptr;
  }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value), true); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value), true); }
  bool number_float(number_float_t value, const string_t& /*raw*/) override { return number(value, false); }
  bool string(string_t& value) override {
    Node* node = add(Node::Kind::text, quoted());
    if (node != nullptr) node->text = value;
    return node != nullptr;
  }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*count*/) override { return open(Node::Kind::object); }
  bool start_array(std::size_t /*count*/) override { return open(Node::Kind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    Node& object = *open_.back();
    const Place place = quoted();
    if (object.find(value) != nullptr) return refuse(place, fmt::format("the key \"{}\" is given twice", value));
    if (object.keys.size() >= mostKeys) return refuse(place, fmt::format("more than {} keys in one object", mostKeys));
    object.keys.push_back(value);
    object.keyPlaces.push_back(place);
    return true;
  }
  bool parse_error(std::size_t /*position*/, const std::string& last,
                   const nlohmann::json::exception& exception) override {
    const std::size_t end = std::min(consumed_, text_.size());
    // out_of_range 406: a number like 1e999.
    if (exception.id == 406) return refuse(numberPlace(), "this number is too large");
    std::size_t shown = last.size() > end || last.find('<') != std::string::npos ? std::min<std::size_t>(1, end) : last.size();
    if (shown == 0) shown = std::min<std::size_t>(1, end);
    return refuse({source_, end - shown, end}, reason(exception.what(), end >= text_.size()));
  }

 private:
  /// What the library says after its own prefixes: "unexpected ...; expected ...".
  static std::string reason(const std::string& what, bool atEnd) {
    const auto dash = what.find(" - ");
    std::string tail = dash == std::string::npos ? "" : what.substr(dash + 3);
    if (const auto last = tail.find("; last read:"); last != std::string::npos) {
      const auto next = tail.find("'; expected ", last);
      tail = tail.substr(0, last) + (next == std::string::npos ? "" : tail.substr(next + 1));
    }
    if (what.find("ill-formed UTF-8") != std::string::npos) return "not valid UTF-8 text";
    if (atEnd && tail.find("end of input") != std::string::npos) return "the file ends too early: a bracket or quote is not closed";
    return "not valid JSON: " + (tail.empty() ? "unexpected text" : tail);
  }

  bool refuse(Place place, std::string message) {
    if (error_.message.empty()) error_ = {place, std::move(message)};
    return false;
  }
  [[nodiscard]] Place word(std::size_t length) const { return {source_, consumed_ - std::min(length, consumed_), consumed_}; }
  /// The quoted string that ends here: back to the quote that no odd run of backslashes precedes.
  [[nodiscard]] Place quoted() const {
    std::size_t begin = consumed_ - 1;
    while (begin > 0) {
      --begin;
      if (text_[begin] != '"') continue;
      std::size_t slashes = 0;
      while (slashes < begin && text_[begin - 1 - slashes] == '\\') ++slashes;
      if (slashes % 2 == 0) break;
    }
    return {source_, begin, consumed_};
  }
  /// A number ends where the parser has looked one character ahead.
  [[nodiscard]] Place numberPlace() const {
    std::size_t end = std::min(consumed_, text_.size());
    if (end > 0 && !isNumberCharacter(text_[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && isNumberCharacter(text_[begin - 1])) --begin;
    return {source_, begin, end};
  }
  bool number(double value, bool whole) {
    Node* node = add(Node::Kind::number, numberPlace());
    if (node == nullptr) return false;
    node->number = value;
    node->whole = whole;
    return true;
  }
  Node* add(Node::Kind kind, Place place) {
    if (++values_ > mostValues) {
      refuse(place, fmt::format("more than {} values", mostValues));
      return nullptr;
    }
    Node* node = &root_;
    if (!open_.empty()) node = &open_.back()->items.emplace_back();
    node->kind = kind;
    node->place = place;
    return node;
  }
  bool open(Node::Kind kind) {
    Node* node = add(kind, word(1));
    if (node == nullptr) return false;
    if (open_.size() >= mostLevels) return refuse(word(1), fmt::format("nested deeper than {} levels", mostLevels));
    // Pointers stay good: a list grows only while its last item is closed.
    open_.push_back(node);
    return true;
  }
  bool close() {
    open_.back()->place.end = consumed_;
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  std::size_t source_;
  const std::size_t& consumed_;
  Node& root_;
  JsonError& error_;
  std::vector<Node*> open_;
  std::size_t values_ = 0;
};

}  // namespace

const Node* Node::find(std::string_view key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

Node* Node::find(std::string_view key) {
  return const_cast<Node*>(std::as_const(*this).find(key));
}

const char* kindName(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::null: return "null";
    case Node::Kind::boolean: return "true or false";
    case Node::Kind::number: return "a number";
    case Node::Kind::text: return "a string";
    case Node::Kind::list: return "a list";
    case Node::Kind::object: return "an object";
  }
  return "";
}

bool parseJson(std::string_view text, std::size_t source, Node& root, JsonError& error) {
  root = {};
  error = {};
  if (text.empty()) {
    error = {{source, 0, 0}, "the file is empty"};
    return false;
  }
  std::size_t consumed = 0;
  Builder builder(text, source, consumed, root, error);
  const bool good = nlohmann::json::sax_parse(CountingIterator(text.data(), &consumed),
                                              CountingIterator(text.data() + text.size(), &consumed), &builder,
                                              nlohmann::json::input_format_t::json, true, true);
  if (!good && error.message.empty()) error = {{source, 0, 0}, "not valid JSON"};
  return good;
}

}  // namespace simreel::scene
