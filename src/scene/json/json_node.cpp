#include "scene/json/json_node.hpp"

#include "scene/json/json_error.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::scene {

namespace {

/// Iterator that counts the bytes that the JSON parser has consumed. The parser does not report positions,
/// so the builder computes the place of a value from this count.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* consumed) : at_(at), consumed_(consumed) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*consumed_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  std::size_t* consumed_;
};

/// Receives the parser's events and builds the tree.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, int source, std::size_t base, const std::size_t& consumed,
          Diagnostics& diagnostics)
      : text_(text), source_(source), base_(base), consumed_(consumed), diagnostics_(diagnostics) {}

  [[nodiscard]] Node takeRoot() { return std::move(root_); }

  bool null() override { return add(Node::Kind::null, consumed_ - 4, consumed_) != nullptr; }
  bool boolean(bool value) override {
    Node* node = add(Node::Kind::boolean, consumed_ - (value ? 4 : 5), consumed_);
    if (node != nullptr) node->boolean = value;
    return node != nullptr;
  }
  bool number_integer(number_integer_t value) override { return addNumber(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return addNumber(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t& /*written*/) override { return addNumber(value); }
  bool string(string_t& value) override {
    Node* node = add(Node::Kind::text, openingQuote(text_, consumed_ - 1), consumed_);
    if (node != nullptr) node->text = std::move(value);
    return node != nullptr;
  }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON text has no binary values.
  bool start_object(std::size_t /*count*/) override { return open(Node::Kind::object); }
  bool start_array(std::size_t /*count*/) override { return open(Node::Kind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    keyBegin_ = openingQuote(text_, consumed_ - 1);
    keyEnd_ = consumed_;
    if (!open_.back().keys.insert(value).second)
      report(keyBegin_, keyEnd_, fmt::format("key {} is given twice in this object", inQuotes(value)));
    key_ = std::move(value);
    return true;
  }
  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const nlohmann::json::exception& error) override {
    const std::size_t openedAt = open_.empty() ? std::string_view::npos : open_.back().node->begin - base_;
    const SyntaxError found = explainSyntaxError(text_, consumed_, error.what(), openedAt);
    report(found.begin, found.end, found.message);
    return false;
  }

 private:
  struct Open {
    Node* node;  ///< The pointer stays valid, because the parent adds no children until this node is
                 ///< closed.
    std::unordered_set<std::string> keys;
  };

  void report(std::size_t begin, std::size_t end, std::string message) {
    diagnostics_.add({source_, base_ + begin, base_ + end}, std::move(message));
  }

  bool addNumber(double value) {
    std::size_t end = consumed_;
    // The parser has read one character past the number.
    if (end > 0 && !isPartOfNumber(text_[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && isPartOfNumber(text_[begin - 1])) --begin;
    Node* node = add(Node::Kind::number, begin, end);
    if (node != nullptr) node->number = value;
    return node != nullptr;
  }

  Node* add(Node::Kind kind, std::size_t begin, std::size_t end) {
    if (++values_ > maxValues) {
      report(begin, end, fmt::format("more than {} values", maxValues));
      return nullptr;
    }
    Node* node = open_.empty() ? &root_ : &open_.back().node->children.emplace_back();
    node->kind = kind;
    node->source = source_;
    node->begin = static_cast<std::uint32_t>(base_ + begin);
    node->end = static_cast<std::uint32_t>(base_ + end);
    if (!open_.empty() && open_.back().node->kind == Node::Kind::object) {
      node->key = std::move(key_);
      node->keyBegin = static_cast<std::uint32_t>(base_ + keyBegin_);
      node->keyEnd = static_cast<std::uint32_t>(base_ + keyEnd_);
    }
    return node;
  }

  bool open(Node::Kind kind) {
    if (open_.size() >= maxDepth) {
      report(consumed_ - 1, consumed_, fmt::format("nested deeper than {} levels", maxDepth));
      return false;
    }
    Node* node = add(kind, consumed_ - 1, consumed_);
    if (node == nullptr) return false;
    open_.push_back({node, {}});
    return true;
  }

  bool close() {
    open_.back().node->end = static_cast<std::uint32_t>(base_ + consumed_);
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  int source_;
  std::size_t base_;
  const std::size_t& consumed_;
  Diagnostics& diagnostics_;
  Node root_;
  std::vector<Open> open_;
  std::string key_;
  std::size_t keyBegin_ = 0, keyEnd_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

const Node* Node::find(std::string_view name) const {
  const auto found =
      std::find_if(children.begin(), children.end(), [&](const Node& child) { return child.key == name; });
  return found == children.end() ? nullptr : &*found;
}

Node* Node::find(std::string_view name) {
  return const_cast<Node*>(std::as_const(*this).find(name));
}

Place Node::headPlace() const {
  if (keyEnd > keyBegin) return {source, keyBegin, keyEnd};
  return {source, begin, begin + 1};
}

const char* Node::kindText() const {
  switch (kind) {
    case Kind::null:
      return "null";
    case Kind::boolean:
      return "a boolean";
    case Kind::number:
      return "a number";
    case Kind::text:
      return "a string";
    case Kind::list:
      return "a list";
    case Kind::object:
      return "an object";
  }
  return "nothing";
}

std::optional<Node> parseJson(std::string_view text, int source, std::size_t base,
                              Diagnostics& diagnostics) {
  if (text.size() > maxSceneBytes) {
    diagnostics.add({source, base, base}, fmt::format("larger than the limit of {} bytes", maxSceneBytes));
    return std::nullopt;
  }
  // The parser takes a zero byte for the end of the text and ignores everything after it.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    diagnostics.add({source, base + zero, base + zero + 1}, "zero byte; is this a text file?");
    return std::nullopt;
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    diagnostics.add({source, base, base}, "the text is empty; a scene begins with {");
    return std::nullopt;
  }
  std::size_t consumed = 0;
  Builder builder(text, source, base, consumed, diagnostics);
  const CountingIterator first(text.data(), &consumed);
  const CountingIterator last(text.data() + text.size(), &consumed);
  const bool complete =
      nlohmann::json::sax_parse(first, last, &builder, nlohmann::json::input_format_t::json,
                                /*strict=*/true, /*ignore_comments=*/true);
  if (!complete) return std::nullopt;
  return builder.takeRoot();
}

}  // namespace simreel::scene
