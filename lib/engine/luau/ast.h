// The parsed form of a script. Types are not kept.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace obby::luau {

struct Expr;
struct Stat;
using ExprPtr = std::unique_ptr<Expr>;
using StatPtr = std::unique_ptr<Stat>;
using Block = std::vector<StatPtr>;

struct Function {
  std::vector<std::string> parameters;
  Block body;
  int line = 0;
  int endLine = 0;      // line of its `end`
  bool vararg = false;  // the parameters end with `...`
};

enum class ExprKind {
  nil,
  truth,
  falsehood,
  number,
  string,
  name,
  vararg,
  field,     // kids[0].text
  index,     // kids[0][kids[1]]
  call,      // kids[0](kids[1..])
  method,    // kids[0]:text(kids[1..])
  function,  // body
  table,     // keys[i] (may be null) = kids[i]
  unary,     // operator `text`, operand kids[0]
  binary,    // kids[0] text kids[1]
  choice,    // if kids[0] then kids[1] else kids[2]
  unknown
};

struct Expr {
  ExprKind kind = ExprKind::unknown;
  int line = 0;
  std::string text;
  double number = 0;
  // True if `text` holds the value of a string. Otherwise the string is interpolated: keys[0]
  // kids[0] keys[1] ... kids[n-1] keys[n], where the keys are strings.
  bool known = true;
  bool parenthesised = false;  // (e) or e :: T: exactly one value, and no target of an assignment
  std::vector<ExprPtr> kids;
  std::vector<ExprPtr> keys;
  std::unique_ptr<Function> body;
  int height = 1;  // height of the tree below; bounded, so that walking it may recurse
};

enum class StatKind {
  local,       // names = values; text is "const" if they may not be assigned again
  assign,      // targets = values
  compound,    // targets[0] text= values[0]
  call,        // values[0]
  block,       // blocks[0]; none for a type's declaration
  whileLoop,   // while values[0] do blocks[0]
  repeatLoop,  // repeat blocks[0] until values[0]
  branch,      // if values[i] then blocks[i] ... else blocks[values.size()]
  numericFor,  // for names[0] = values[0..2] do blocks[0]
  genericFor,  // for names in values do blocks[0]
  function,    // function targets[0] values[0]; a local one has names[0] instead of a target
  returns,     // return values
  leaves       // break, continue: text says which
};

struct Stat {
  StatKind kind = StatKind::block;
  int line = 0;
  int endLine = 0;  // line of the `end` or `until` of a statement with blocks
  std::string text;
  std::vector<std::string> names;
  std::vector<ExprPtr> targets, values;
  std::vector<Block> blocks;
};

struct Chunk {
  Block body;
  bool broken = false;  // a statement could not be parsed and was skipped
  std::string error;    // the first error of a broken chunk, in plain words
  int errorLine = 0;
};

}  // namespace obby::luau
