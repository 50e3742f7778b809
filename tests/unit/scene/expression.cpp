// Tests expressions: the accepted syntax, precedence, and error messages.
#include "scene/expression/tree.hpp"

#include <string>

#include <doctest/doctest.h>

using namespace simreel::scene;

namespace {

std::string asC(const std::string& text) {
  return parseExpression(text).text();
}

/// Returns the error in an expression as "begin-end: message".
std::string mistakeIn(const std::string& text) {
  try {
    return "none: " + asC(text);
  } catch (const ExpressionMistake& mistake) {
    return std::to_string(mistake.begin) + "-" + std::to_string(mistake.end) + ": " + mistake.message;
  }
}

std::string repeated(const std::string& part, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += part;
  return all;
}

}  // namespace

TEST_CASE("operators in expressions have mathematical precedence") {
  CHECK(asC("a + b*c") == "a + b * c");
  CHECK(asC("(a + b)*c") == "(a + b) * c");
  CHECK(asC("a - b - c") == "a - b - c");
  CHECK(asC("a - (b - c)") == "a - (b - c)");
  CHECK(asC("a/b/c") == "a / b / c");
  CHECK(asC("-a^2") == "-pow(a, 2.0)");
  CHECK(asC("2^3^2") == "pow(2.0, pow(3.0, 2.0))");
  CHECK(asC("a^-b") == "pow(a, -b)");
  CHECK(asC("--a") == "-(-a)");
  CHECK(asC("a*-b") == "a * -b");
  CHECK(asC("1.5e-3*.5") == "0.0015 * 0.5");
  CHECK(asC("a < b and c >= d or not e == 1") == "a < b && d <= c || !(e == 1.0)");
  CHECK(asC("if(a > 0, b, c)") == "(0.0 < a ? b : c)");
  CHECK(asC("min(a, b, c)") == "min(min(a, b), c)");
  CHECK(asC("\tclamp( a ,0,1 )\n") == "clamp(a, 0.0, 1.0)");
  CHECK(asC("order + android") == "order + android");
}

TEST_CASE("an error in an expression has a position and advice") {
  CHECK(mistakeIn("") == "0-1: the expression is empty");
  CHECK(mistakeIn("a +") == "2-3: the expression ends where a value is missing");
  CHECK(mistakeIn("a + * b") == "4-5: expected a number, a name or (, found \"*\"");
  CHECK(mistakeIn("(a + b") == "0-1: this ( is not closed before the end");
  CHECK(mistakeIn("a + b)") == "5-6: there is no ( for this )");
  CHECK(mistakeIn("2a") == "0-2: a number ends here without an operator; a product is a * b");
  CHECK(mistakeIn("a b") == "2-3: expected an operator, found \"b\"");
  CHECK(mistakeIn("a ** 2") == "2-4: a power is a ^ b");
  CHECK(mistakeIn("pow(a, 2)") == "0-3: a power is a ^ b");
  CHECK(mistakeIn("a = b") == "2-3: expected an operator; equality is ==");
  CHECK(mistakeIn("a < b < c") == "2-7: comparisons cannot follow each other; join two by \"and\"");
  CHECK(mistakeIn("laplacain(u)") == "0-9: unknown function \"laplacain\"; did you mean \"laplacian\"?");
  CHECK(mistakeIn("sin") == "0-3: \"sin\" is a function: sin(...)");
  CHECK(mistakeIn("sin(a, b)") == "0-3: \"sin\" takes 1 argument, found 2");
  CHECK(mistakeIn("min(a)") == "0-3: \"min\" takes 2 to 8 arguments, found 1");
  CHECK(mistakeIn("clamp()") == "0-5: \"clamp\" takes 3 arguments, found 0");
  CHECK(mistakeIn("sin(a") == "0-3: the ( of \"sin\" is not closed before the end");
  CHECK(mistakeIn("noise(u)") ==
        "6-7: \"noise\" takes a whole number, 0 or more; different numbers give different random values");
  CHECK(mistakeIn("1e40") == "0-4: numbers are between 1e-30 and 1e30, or 0");
  CHECK(mistakeIn("1.2.3") == "0-4: a number ends here without an operator; a product is a * b");
  CHECK(mistakeIn("u; discard") == "1-2: expected an operator, found \";\"");
  CHECK(mistakeIn("\xc3\xa9 + 1") == "0-2: expected a number, a name or (, found \"\xc3\xa9\"");
}

TEST_CASE("an expression that is too long, deep or large is refused early") {
  const std::string deep = "nested deeper than 64 levels; split it by \"lets\"";
  CHECK(mistakeIn(repeated("(", 1000)).ends_with(deep));
  CHECK(mistakeIn(repeated("-", 1000) + "a").ends_with(deep));
  CHECK(mistakeIn(repeated("2^", 1000) + "a").ends_with(deep));
  CHECK(mistakeIn(repeated("not ", 1000) + "a").ends_with(deep));
  CHECK(mistakeIn(repeated("sin(", 1000)).ends_with(deep));
  CHECK(mistakeIn("a" + repeated("+a", 3000)).find("an expression has at most 2000 operations") !=
        std::string::npos);
  for (const char* part : {"(", "-", "a+", "sin("})
    CHECK(mistakeIn(repeated(part, 1'000'000)).find("an expression has at most 16384 bytes") !=
          std::string::npos);
  CHECK(asC("a" + repeated("+a", 900)).size() > 900);
}
