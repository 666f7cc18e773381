// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Makes Ctrl-C (SIGINT) and SIGTERM a request that interrupted() returns; a second one ends the program at
// once. So does the first, with this sentence on the error output and this exit status, where interrupted()
// is not called within a second. sentence: ends with a new line, and must stay valid.
void catch_interrupts(const char* sentence, int exit_status);

// From now on the first interrupt waits for interrupted(), however long that takes; or no longer.
void let_interrupts_wait(bool wait);

// Ignores interrupts from now on: of several processes, one handles them.
void ignore_interrupts();

// Returns whether an interrupt has come. Cheap.
bool interrupted();

// Call after interrupted() has returned true. The program ends a second after the interrupt, with the
// sentence and the exit status of catch_interrupts, whatever it does then. Returns true, and ends nothing,
// where that second is over.
bool end_in_its_second();

}  // namespace luxel
