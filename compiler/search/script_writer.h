// SPDX-License-Identifier: Apache-2.0
// Writes a scenario as a state script that a person reads: inputs at times, and asserts of what the machine does then.
//
//     Buf out;
//     buf_init(&out, arena);
//     script_write(arena, &(ScriptPage){.p = p, .scenario = s, .engine = engine, .comment = comment, .comments = n}, &out);
//
// Run by the script engine, the text stores exactly the scenario's values, bit for bit, in each step.  Its asserts are those of the run on `engine`,
// so it passes.  They are a time line: each line is true in all of its steps, and the lines together cover the run.
#ifndef SMC_SCRIPT_WRITER_H
#define SMC_SCRIPT_WRITER_H

#include "compiler/base/buf.h"
#include "compiler/script/engine.h"
#include "compiler/script/scenario.h"

typedef struct ScriptPage {
    const Program *p;         // the machine as its scripts run it; can be an application
    const Scenario *scenario;
    Engine *engine;           // runs p
    const char *const *comment;       // sentences, each a comment; a long one is wrapped, an empty one separates paragraphs
    size_t comments;
    bool is_skeleton;         // no asserts: a comment shows where a person writes them
    const State *not_entered; // the last line asserts that the machine is not in this state; NULL: no such line
} ScriptPage;

// Appends the script.  Returns false if a scenario cannot be written: variables are copied to each other in a circle, a copy reads G, S or T, a
// parameter changes after the first step, or the engine refuses a step.  Then *out is undefined.
bool script_write(Arena *arena, const ScriptPage *page, Buf *out);

// Appends a value as an assignment to a variable of this type stores it: the fewest digits that store the same cell.
void script_write_value(Buf *out, SmType type, double x);
// Appends a time, in units of the machine's G: "0", "300 ms", "1.5 s".
void script_write_time(Buf *out, TimeUnit unit, uint64_t g);

#endif
