// SPDX-License-Identifier: Apache-2.0
// Writes ordinary scripts that reproduce the outcome of a fault (docs/faults.md).  There are two forms.  The edited form is the original script,
// changed so that it writes a variable of the script instead of the faulty input, followed by a section that writes the sensor's reading to the
// input.  The recorded form lists the inputs of each step, without the original script.
#ifndef SMC_FAULT_SCRIPT_H
#define SMC_FAULT_SCRIPT_H

#include "compiler/whatif/faults.h"

// Where the new script is, relative to the original.
typedef struct FaultScriptPlace {
    const char *to_original;          // path from the folder of the script to that of the original, "" or with a separator at its end; NULL: there is
                                      // no original
    const char *command;              // the command line that runs the script
} FaultScriptPlace;

// Append a script.  Return NULL, or the reason why no script of this form is possible.
const char *fault_script_write_edited(Arena *arena, const Faults *f, const FaultResult *r, const FaultScriptPlace *place, Buf *out);
const char *fault_script_write_recorded(Arena *arena, Faults *f, const FaultResult *r, const FaultScriptPlace *place, Buf *out);
// Runs a script that one of these two functions has written.  Returns whether it has the same outcome as the fault, at the same step.
bool fault_script_reproduces(Arena *arena, const Faults *f, const FaultResult *r, const Script *s);

// Appends a fault in words: "altitude dead", "altitude dead and armed stuck".
void fault_write_name(const Faults *f, const FaultResult *r, Buf *out);
// Appends where the fault begins: "at Boost -> Coast (G = 1200)".
void fault_write_trigger(const Faults *f, const FaultResult *r, Buf *out);
// Appends where the range of an input comes from, unless it is declared: "'p' has no @range; …".  Returns whether it has appended anything.
bool fault_write_range(const FaultInput *in, Buf *out);
// Appends the most dangerous outcome of an input's faults of one kind in a few words, for a cell of a table; nothing if none has an effect.  Of all
// effects with this outcome the first: "R3", "-> Abort", "valve", "no @stop", "assert"; "+2" after it: two others.
void fault_write_worst(const Faults *f, uint32_t input, FaultKind kind, Buf *out);
// Appends what happened, in words, without a full stop.
void fault_write_effect(const Faults *f, const FaultResult *r, Buf *out);

#endif
