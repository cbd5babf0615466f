#include "config/formula.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mien {
namespace {

double value_of(const std::string& text, double time_s = 0, const Inputs& inputs = {}) {
  FormulaFault fault;
  const FormulaPointer formula = build_formula(text, inputs, 0, fault);
  EXPECT_NE(formula, nullptr) << text << ": " << fault.message;
  return formula ? evaluate(*formula, time_s) : NAN;
}

std::string fault_of(const std::string& text, const Inputs& inputs = {}) {
  FormulaFault fault;
  EXPECT_EQ(build_formula(text, inputs, 0, fault), nullptr) << text;
  return std::to_string(fault.byte) + ": " + fault.message;
}

TEST(formula, is_a_number_of_time) {
  EXPECT_DOUBLE_EQ(value_of("0.3*sin(2*pi*t/1.5)", 0.25), 0.3 * std::sin(2 * std::numbers::pi * 0.25 / 1.5));
  EXPECT_EQ(value_of("t > 1 ? 2 : 3", 2), 2);
  EXPECT_EQ(value_of("clamp(t, 0, 1) + mod(-1, 3) + min(4, 5) + max(1, 2)", 7), 1 + 2 + 4 + 2);
  EXPECT_EQ(value_of("2^3 - abs(-1)"), 7);
  EXPECT_EQ(value_of("t == 2 && t >= 1", 2), 1);
}

TEST(formula, counts_t_from_its_start) {
  FormulaFault fault;
  EXPECT_EQ(evaluate(*build_formula("t", {}, 2, fault), 5), 3);
}

TEST(formula, uses_inputs_and_what_they_use) {
  FormulaFault fault;
  const Inputs one{{"mood", 0.5, {}}};
  const Inputs two{one[0], {"beat", 0, build_formula("mood * t", one, 0, fault)}};
  EXPECT_EQ(value_of("beat + mood", 4, two), 2.5);
  // Each input is worked out once: forty that use the one before twice would take years otherwise.
  Inputs many{{"a0", 1, {}}};
  for (int i = 1; i <= 40; ++i) {
    const std::string before = "a" + std::to_string(i - 1);
    many.push_back({"a" + std::to_string(i), 0, build_formula(before + " + " + before, many, 0, fault)});
  }
  EXPECT_EQ(value_of("a40", 0, many), std::pow(2.0, 40));
}

TEST(formula, knows_the_clip_and_what_it_depends_on) {
  FormulaFault fault;
  FormulaWords words{.runtime_s = 4, .fps = 24};
  const FormulaPointer half = build_formula("runtime/2 + t", {}, 1, fault, words);
  ASSERT_NE(half, nullptr);
  EXPECT_EQ(evaluate(*half, 3), 4);
  EXPECT_EQ(evaluate(*shift_formula(*half, 1), 3), 5);
  EXPECT_EQ(evaluate(*build_formula("fps*mood", {{"mood", 0.5, {}}}, 0, fault, words), 0), 12);
  // An input keeps the words that it was read with.
  const Inputs inputs{
      {"half", 0, half}, {"mood", 0.5, {}}, {"rate", 0, build_formula("fps", {}, 0, fault, words)}};
  const FormulaPointer later =
      build_formula("half + runtime", inputs, 0, fault, {.runtime_s = 10, .fps = 24});
  EXPECT_EQ(evaluate(*later, 3), 14);
  EXPECT_TRUE(uses_word(*later, "runtime"));
  EXPECT_TRUE(uses_word(*later, "t"));
  EXPECT_FALSE(uses_word(*later, "fps"));
  EXPECT_EQ(find_changing_word(*later), "half");
  EXPECT_EQ(find_changing_word(*half), "t");
  const FormulaPointer rate = build_formula("rate*mood", inputs, 0, fault, words);
  EXPECT_EQ(find_changing_word(*rate), "");
  EXPECT_TRUE(uses_word(*rate, "fps"));
  EXPECT_FALSE(uses_word(*rate, "t"));
  // What is not known is told, and that it was asked for.
  RuntimeUse use;
  words.runtime_s = {};
  words.use = &use;
  EXPECT_EQ(build_formula("2 + runtime", {}, 0, fault, words), nullptr);
  EXPECT_EQ(fault.message, "'runtime' is not known here");
  EXPECT_EQ(fault.byte, 4u);
  EXPECT_TRUE(use.is_asked);
  EXPECT_EQ(find_word("runtimes + runtime", "runtime"), 11u);
  EXPECT_EQ(find_word("runtimes", "runtime"), 0u);
}

TEST(formula, is_greater_by_what_it_is_shifted) {
  FormulaFault fault;
  const FormulaPointer mood = build_formula("2*t", {}, 0, fault);
  const FormulaPointer formula = build_formula("mood + 1", {{"mood", 0, mood}}, 1, fault);
  const FormulaPointer shifted = shift_formula(*shift_formula(*formula, 10), -40);
  for (const double time_s : {0.0, 1.5, 7.0})
    EXPECT_EQ(evaluate(*shifted, time_s), evaluate(*formula, time_s) - 30);
  EXPECT_EQ(compute_start_s(*shifted), 1);
}

TEST(formula, has_no_value_where_it_has_none) {
  EXPECT_FALSE(std::isfinite(value_of("1/t", 0)));
  EXPECT_FALSE(std::isfinite(value_of("sqrt(t)", -1)));
  FormulaFault fault;
  EXPECT_EQ(evaluate_held(*build_formula("1/t", {}, 0, fault), 0), 0);
}

TEST(formula, tells_what_is_wrong_and_where) {
  EXPECT_EQ(fault_of("0.3*sni(t)"), "4: unknown word 'sni'; did you mean 'sin'?");
  EXPECT_EQ(fault_of("1 + moood", {{"mood", 1, {}}}), "4: unknown word 'moood'; did you mean 'mood'?");
  EXPECT_EQ(fault_of("t = 3"), "2: a single '='; expected '==' to compare");
  EXPECT_EQ(fault_of("1, 2"), "0: it comes to 2 numbers; expected one");
  EXPECT_EQ(fault_of("2*"), "2: it ends too early");
  EXPECT_EQ(fault_of("1 + "), "4: it ends too early");
  EXPECT_EQ(fault_of(""), "0: it ends too early");
  EXPECT_EQ(fault_of("2*(t + sin(t)"), "2: a '(' is not closed");
  EXPECT_EQ(fault_of("sin((t) + 1"), "3: a '(' is not closed");
  EXPECT_EQ(fault_of("t + 1)"), "5: ')' is not expected here");
  EXPECT_EQ(fault_of("t \x01"), "2: a letter that no formula has");
  EXPECT_EQ(fault_of(std::string(2000, '(')), "0: it is longer than 1000 bytes");
  for (const char* text :
       {"", "(t", "t)", "sin()", "sin(1, 2)", "1 +", "* 2", "t t", "1 ? 2", "a b", "\\", "#"})
    fault_of(text);
}

TEST(formula, survives_nonsense) {
  for (const std::string unit :
       {"(", "-", "!", "sin(", "t?", "1:", "t?t:", "1+", "max(1,", "^", "t^", "((t)"}) {
    std::string text;
    while (text.size() + unit.size() <= 1000) text += unit;
    FormulaFault fault;
    EXPECT_EQ(build_formula(text, {}, 0, fault), nullptr) << unit;
  }
}

TEST(formula, names_of_inputs_are_words_of_their_own) {
  for (const char* name : {"mood", "_x", "beat2"}) EXPECT_TRUE(is_input_name(name)) << name;
  for (const char* name : {"", "t", "pi", "sin", "clamp", "2x", "a-b", "_pi", "runtime", "fps"})
    EXPECT_FALSE(is_input_name(name)) << name;
}

}  // namespace
}  // namespace mien
