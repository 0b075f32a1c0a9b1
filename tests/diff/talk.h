// SPDX-License-Identifier: Apache-2.0
// A whole conversation with machines that run elsewhere, written down before it is held: commands, and the answers that the reference
// gives.  It is that of emit_c_driver (emit_c.h), for emitted C; tests/targets/vm.c speaks it too, with one more command, for images.
#ifndef SM_DIFF_TALK_H
#define SM_DIFF_TALK_H

#include "tests/diff/run.h"

// What one machine has of it.  Parts follow each other.
typedef struct TalkPart {
    const Program *program;
    Form form;
    const IrMachine *ir;
    bool tracks;                      // its answers tell what was stored
    Engine *inner;                    // the reference
    Engine recorder;
    struct Talk *talk;
    size_t first, answer;             // where its answers begin, and the size of one
    VEC(uint32_t) step;               // by answer: `now` when it was given
    uint32_t now;                     // a number of the caller's, for messages
    RunResult *result;
} TalkPart;

typedef struct Talk {
    Arena *arena;
    bool images;
    TalkPart *part;
    uint32_t n;
    Buf commands, answers;
} Talk;

void talk_init(Talk *t, Arena *arena, bool images, uint32_t parts_max);

// One more part, about a machine in some form.  For images: `vm` is an engine of the VM that has this image open.
TalkPart *talk_add(Talk *t, Session *s, const Program *p, Form form, const IrMachine *ir, RunResult *result);
void talk_load(TalkPart *p, Engine *vm, const Buf *image);

// Compares the answers with the expected ones, and reports the first difference of each machine, with the name of the target.  A machine
// that did not fit there gets `no_room`.
void talk_compare(Talk *t, char *got, size_t n, const char *who);

#endif
