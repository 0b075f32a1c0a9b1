// SPDX-License-Identifier: Apache-2.0
// A whole conversation with machines that run elsewhere, written before it takes place: commands, and the answers of the reference.  The
// protocol is that of emit_c_driver (emit_c.h), for emitted C.  tests/targets/vm.c uses it too, with one more command, for images.
#ifndef SM_DIFF_TALK_H
#define SM_DIFF_TALK_H

#include "tests/diff/run.h"

// The part of a conversation that concerns one machine.  Parts follow each other.
typedef struct TalkPart {
    const Program *program;
    Form form;
    const IrMachine *ir;
    bool tracks;                      // its answers contain the flags of stored elements
    Engine *inner;                    // the reference
    Engine recorder;
    struct Talk *talk;
    size_t first, answer;             // offset of its first answer; size of each answer
    VEC(uint32_t) step;               // by answer: the value of `now` when the answer was computed
    uint32_t now;                     // a number that the caller sets, for messages
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

// Adds a part for a machine in some form.  For images, `vm` is an engine of the VM that has this image open.
TalkPart *talk_add(Talk *t, Session *s, const Program *p, Form form, const IrMachine *ir, RunResult *result);
void talk_load(TalkPart *p, Engine *vm, const Buf *image);

// Compares the answers with the expected ones, and reports the first difference of each machine, with the name of the target.  A machine that
// had no room on the target is marked `no_room`.
void talk_compare(Talk *t, char *got, size_t n, const char *who);

#endif
