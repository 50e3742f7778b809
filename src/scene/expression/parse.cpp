// Recursive-descent parser with one function per precedence level. A limit on the nesting depth ends the
// recursion before the stack overflows.
#include "base/text.hpp"
#include "scene/expression/tree.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

using ExpressionNode = ExpressionTree::Node;

class Parser {
 public:
  Parser(std::string_view text, std::span<const char* const> lookups) : text_(text), lookups_(lookups) {
    if (text.size() > maxExpressionBytes)
      throw ExpressionMistake{
          0, 1,
          fmt::format("an expression has at most {} bytes, this one {}; split it by \"lets\"",
                      maxExpressionBytes, text.size())};
  }

  ExpressionTree whole() {
    skipSpace();
    if (at_ == text_.size()) fail(at_, at_ + 1, "the expression is empty");
    either();
    if (at_ < text_.size()) {
      if (text_[at_] == ')') fail(at_, at_ + 1, "there is no ( for this )");
      if (text_[at_] == '=') fail(at_, at_ + 1, "expected an operator; equality is ==");
      fail(at_, at_ + 1, fmt::format("expected an operator, found {}", found()));
    }
    return std::move(tree_);
  }

 private:
  [[noreturn]] static void fail(std::size_t begin, std::size_t end, std::string message) {
    throw ExpressionMistake{begin, end, std::move(message)};
  }

  void skipSpace() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n')) ++at_;
  }
  [[nodiscard]] std::string found() const {
    if (at_ >= text_.size()) return "the end";
    return inQuotes(text_.substr(at_, std::max<std::size_t>(1, codePointLength(text_, at_))));
  }
  /// Consumes `sign` (an operator or keyword) and the white space after it. Returns false if the text does
  /// not continue with `sign`.
  bool accept(std::string_view sign) {
    if (text_.substr(at_, sign.size()) != sign) return false;
    const std::size_t end = at_ + sign.size();
    if (isWord(sign[0]) && end < text_.size() && isWord(text_[end])) return false;
    at_ = end;
    skipSpace();
    return true;
  }
  static bool isWord(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || isDigit(c);
  }

  int add(ExpressionNode node) {
    if (tree_.nodes.size() >= maxExpressionNodes)
      fail(node.begin, node.end,
           fmt::format("an expression has at most {} operations, names and numbers; split it by \"lets\"",
                       maxExpressionNodes));
    tree_.nodes.push_back(std::move(node));
    return tree_.root();
  }
  [[noreturn]] static void tooDeep(std::size_t at) {
    fail(at, at + 1, fmt::format("nested deeper than {} levels; split it by \"lets\"", maxExpressionDepth));
  }
  int combine(Operation operation, int a, int b) {
    ExpressionNode node;
    node.operation = operation;
    node.arguments[0] = a;
    node.arguments[1] = b;
    node.begin = tree_.at(a).begin;
    node.end = tree_.at(b).end;
    return add(std::move(node));
  }

  int either() {
    const Level level(*this);
    int left = both();
    while (accept("or") || accept("||")) left = combine(Operation::either, left, both());
    return left;
  }
  int both() {
    int left = opposite();
    while (accept("and") || accept("&&")) left = combine(Operation::both, left, opposite());
    return left;
  }
  int opposite() {
    const std::size_t begin = at_;
    if (!accept("not")) return comparison();
    const Level level(*this);
    return prefixed(Operation::opposite, begin, opposite());
  }
  int comparison() {
    const int left = sum();
    const std::size_t begin = at_;
    int result = left;
    if (accept("<="))
      result = combine(Operation::lessEqual, left, sum());
    else if (accept(">="))
      result = swapped(Operation::lessEqual, left, sum());
    else if (accept("=="))
      result = combine(Operation::equal, left, sum());
    else if (accept("!="))
      result = combine(Operation::notEqual, left, sum());
    else if (accept("<"))
      result = combine(Operation::less, left, sum());
    else if (accept(">"))
      result = swapped(Operation::less, left, sum());
    else
      return left;
    for (const char* sign : {"<", ">", "==", "!="})
      if (text_.substr(at_).starts_with(sign))
        fail(begin, at_ + 1, "comparisons cannot follow each other; join two by \"and\"");
    return result;
  }
  /// Builds `a > b` as `b < a`.
  int swapped(Operation operation, int a, int b) {
    const int node = combine(operation, a, b);
    std::swap(tree_.nodes.back().arguments[0], tree_.nodes.back().arguments[1]);
    return node;
  }
  int sum() {
    int left = product();
    for (;;) {
      if (accept("+"))
        left = combine(Operation::add, left, product());
      else if (accept("-"))
        left = combine(Operation::subtract, left, product());
      else
        return left;
    }
  }
  int product() {
    int left = sign();
    for (;;) {
      if (text_.substr(at_).starts_with("**")) fail(at_, at_ + 2, "a power is a ^ b");
      if (accept("*"))
        left = combine(Operation::multiply, left, sign());
      else if (accept("/"))
        left = combine(Operation::divide, left, sign());
      else
        return left;
    }
  }
  int sign() {
    const std::size_t begin = at_;
    if (accept("-")) {
      const Level level(*this);
      return prefixed(Operation::negate, begin, sign());
    }
    if (accept("+")) {
      const Level level(*this);
      return sign();
    }
    const int base = value();
    if (!accept("^")) return base;
    const Level level(*this);
    return combine(Operation::power, base, sign());
  }
  int prefixed(Operation operation, std::size_t begin, int argument) {
    ExpressionNode node;
    node.operation = operation;
    node.arguments[0] = argument;
    node.begin = begin;
    node.end = tree_.at(argument).end;
    return add(std::move(node));
  }

  int value() {
    if (at_ >= text_.size())
      fail(at_ > 0 ? at_ - 1 : 0, at_, "the expression ends where a value is missing");
    const char c = text_[at_];
    const std::size_t begin = at_;
    if (accept("(")) {
      const int inside = either();
      if (!accept(")")) fail(begin, begin + 1, fmt::format("this ( is not closed before {}", found()));
      return inside;
    }
    if (isDigit(c) || c == '.') return number();
    if (isWord(c)) return word();
    fail(at_, at_ + std::max<std::size_t>(1, codePointLength(text_, at_)),
         fmt::format("expected a number, a name or (, found {}", found()));
  }

  int number() {
    ExpressionNode node;
    node.begin = at_;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), node.number);
    node.end =
        error == std::errc::invalid_argument ? at_ + 1 : static_cast<std::size_t>(end - text_.data());
    if (error == std::errc::invalid_argument)
      fail(at_, at_ + 1, "expected a number, a name or (, found \".\"");
    if (error != std::errc() || node.number > 1e30)
      fail(node.begin, node.end, "numbers are between 1e-30 and 1e30, or 0");
    if (node.end < text_.size() && (isWord(text_[node.end]) || text_[node.end] == '.'))
      fail(node.begin, node.end + 1, "a number ends here without an operator; a product is a * b");
    at_ = node.end;
    skipSpace();
    return add(std::move(node));
  }

  int word() {
    const std::size_t begin = at_;
    std::size_t end = at_;
    while (end < text_.size() && isWord(text_[end])) ++end;
    const std::string name(text_.substr(begin, end - begin));
    at_ = end;
    skipSpace();
    const auto functions = expressionFunctions();
    const auto function = std::find_if(functions.begin(), functions.end(),
                                       [&](const ExpressionFunction& f) { return name == f.name; });
    if (accept("(")) {
      if (std::find(lookups_.begin(), lookups_.end(), name) != lookups_.end()) return lookup(name, begin);
      if (function == functions.end()) unknownFunction(name, begin, end);
      return call(*function, begin, end);
    }
    if (function != functions.end()) fail(begin, end, fmt::format("\"{0}\" is a function: {0}(...)", name));
    for (const char* other : {"and", "or", "not"})
      if (name == other) fail(begin, end, fmt::format("a value is missing before \"{}\"", name));
    ExpressionNode node;
    node.operation = Operation::name;
    node.name = name;
    node.begin = begin;
    node.end = end;
    return add(std::move(node));
  }

  /// Parses the argument of a lookup function such as count(NAME), after its opening parenthesis.
  int lookup(const std::string& function, std::size_t begin) {
    std::size_t end = at_;
    while (end < text_.size() && (isWord(text_[end]) || text_[end] == '.' || text_[end] == '-')) ++end;
    ExpressionNode node;
    node.operation = Operation::name;
    node.name = fmt::format("{}({})", function, text_.substr(at_, end - at_));
    at_ = end;
    skipSpace();
    if (!accept(")")) fail(begin, at_ + 1, fmt::format("\"{0}\" takes one name: {0}(NAME)", function));
    node.begin = begin;
    node.end = at_;
    return add(std::move(node));
  }

  [[noreturn]] static void unknownFunction(const std::string& name, std::size_t begin, std::size_t end) {
    if (name == "pow") fail(begin, end, "a power is a ^ b");
    std::vector<std::string> known;
    for (const ExpressionFunction& function : expressionFunctions()) known.emplace_back(function.name);
    fail(begin, end, fmt::format("unknown function {}; {}", inQuotes(name), suggestion(name, known)));
  }

  int call(const ExpressionFunction& function, std::size_t begin, std::size_t nameEnd) {
    std::vector<int> arguments;
    std::size_t end = at_;
    if (!accept(")")) {
      do {
        arguments.push_back(either());
        if (arguments.size() > 64) break;
      } while (accept(","));
      end = at_;
      if (arguments.size() <= 64 && !accept(")"))
        fail(begin, nameEnd,
             fmt::format("the ( of \"{}\" is not closed before {}", function.name, found()));
    }
    const auto count = static_cast<int>(arguments.size());
    if (count < function.minimum || count > function.maximum)
      fail(begin, nameEnd,
           fmt::format("\"{}\" takes {}{} argument{}, found {}", function.name, function.minimum,
                       function.maximum > function.minimum ? fmt::format(" to {}", function.maximum) : "",
                       function.maximum == 1 ? "" : "s", count));
    if (function.operation == Operation::noise || function.operation == Operation::random)
      checkSalt(function, arguments[0]);
    ExpressionNode node;
    node.operation = function.operation;
    node.begin = begin;
    node.end = end + 1;
    if (function.maximum <= 3) {
      std::copy(arguments.begin(), arguments.end(), node.arguments);
      return add(std::move(node));
    }
    // `min` and `max` take more than two arguments as a chain of two-argument nodes, from left to right.
    int left = arguments[0];
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      node.arguments[0] = left;
      node.arguments[1] = arguments[i];
      left = add(node);
    }
    return left;
  }

  void checkSalt(const ExpressionFunction& function, int argument) const {
    const ExpressionNode& salt = tree_.at(argument);
    const bool whole = salt.operation == Operation::number && salt.number <= 1e6 &&
                       salt.number == static_cast<double>(static_cast<int>(salt.number));
    if (!whole)
      fail(salt.begin, salt.end,
           fmt::format(
               "\"{}\" takes a whole number, 0 or more; different numbers give different random values",
               function.name));
  }

  /// Guard that counts the recursion depth. Throws ExpressionMistake if the expression is nested too
  /// deeply.
  struct Level {
    explicit Level(Parser& parser) : depth(parser.depth_) {
      if (++depth > maxExpressionDepth) tooDeep(parser.at_ > 0 ? parser.at_ - 1 : 0);
    }
    ~Level() { --depth; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    int& depth;
  };

  std::string_view text_;
  std::span<const char* const> lookups_;
  std::size_t at_ = 0;
  int depth_ = 0;
  ExpressionTree tree_;
};

}  // namespace

ExpressionTree parseExpression(std::string_view text, std::span<const char* const> lookups) {
  return Parser(text, lookups).whole();
}

}  // namespace simreel::scene
