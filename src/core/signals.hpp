// Ctrl-C and its kin: noted when they come, thrown where work can stop.
#pragma once

namespace mien {

// From now on SIGINT (Ctrl-C), SIGTERM and SIGHUP are noted, so that waiting functions end their children and
// throw Interrupted; one more signal ends us at once. What comes within a second of the first is its echo
// (timeout(1), make and shells send one to the process and one to its group) and counts as the same. A pipe
// that nobody reads any more is an error of whoever writes to it and no signal (SIGPIPE). Forgets a signal
// that came before. For main.cpp, once.
void install_signal_handlers();

// Throws Interrupted if a signal came. For long loops that wait for no process.
void throw_if_interrupted();

}  // namespace mien
