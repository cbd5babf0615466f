// The table of commands: help, completion and parsing come from it. A new command is one line here and a file
// of its own that defines command_NAME.
#pragma once

#include <array>

#include "commands/command.hpp"

// In the order that a user meets them.
#define MIEN_COMMANDS(X) \
  X(render)              \
  X(watch)               \
  X(live)                \
  X(frames)              \
  X(clean)               \
  X(still)               \
  X(sheet)               \
  X(mesh)                \
  X(bust)                \
  X(export)              \
  X(new)                 \
  X(import)              \
  X(check)               \
  X(explain)             \
  X(list)                \
  X(schema)

namespace mien {

#define MIEN_DECLARE(name) extern const CommandInfo command_##name;
MIEN_COMMANDS(MIEN_DECLARE)
#undef MIEN_DECLARE

#define MIEN_ADDRESS(name) &command_##name,
inline constexpr std::array kCommands{std::to_array<const CommandInfo*>({MIEN_COMMANDS(MIEN_ADDRESS)})};
#undef MIEN_ADDRESS

}  // namespace mien
