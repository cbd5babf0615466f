// POV-Ray's scene description language, read as far as templates/povray uses it: macros, locals, conditions,
// loops, expressions, and blocks of words and values. A picture that we trace ourselves reads the very text
// that POV-Ray reads; what a block means is its reader's affair.
//
// Source: POV-Ray 3.7 reference manual, 3.3 (language directives) and 3.3.1.6 (expressions).
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sketch/sdl_tokens.hpp"

namespace mien {

// A number (all of `v` are it), a vector, or a colour: red, green, blue, filter, transmit; linear.
struct SdlValue {
  std::array<double, 5> v{};
  int size = 1;  // 1, 2, 3 or 5

  double number() const { return v[0]; }
  glm::dvec3 vector() const { return {v[0], v[1], v[2]}; }
};

// An expression of x, y and z, as in function { }.
struct SdlFunction {
  enum class Node { number, x, y, z, add, subtract, multiply, divide, call };
  Node node = Node::number;
  double number = 0;
  double (*call)(double, double) = nullptr;
  std::vector<SdlFunction> parts;
};
double evaluate(const SdlFunction& function, const glm::dvec3& at);

struct SdlBlock;

// One thing in a block: a word, a value, a block with its name ("finish { }"), or an entry of a map
// ("[.5 color Red]", a block without a name).
struct SdlItem {
  std::string word;
  SdlValue value;
  std::shared_ptr<const SdlBlock> block;
  bool is_value = false;
  std::vector<double> matrix;  // of the word "matrix": its twelve numbers
};

struct SdlBlock {
  std::string name;
  std::vector<SdlItem> items;
  SdlFunction function;  // of a block "function"
};

// The value behind a word of the block ("diffuse .75"); null if there is none.
const SdlValue* find_value(const SdlBlock& block, std::string_view word);
bool has_word(const SdlBlock& block, std::string_view word);
// The first block of a name; null if there is none.
const SdlBlock* find_block(const SdlBlock& block, std::string_view name);

struct SdlMacro {
  std::vector<std::string> parameters;
  std::shared_ptr<const std::vector<SdlToken>> tokens;  // of the text it stands in
  std::size_t first = 0, last = 0;                      // its body
};

// What has been declared.
struct SdlNames {
  std::map<std::string, SdlMacro, std::less<>> macros;
  std::map<std::string, SdlValue, std::less<>> values;
};

// Reads a text: declarations go into `names`, the blocks and words that stand outside of all are returned.
// Throws RunError "NAME:line: ..." on what is beyond the language's part that is known here.
SdlBlock read_sdl(std::string_view text, std::string_view name, SdlNames& names);

}  // namespace mien
