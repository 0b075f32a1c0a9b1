// SPDX-License-Identifier: Apache-2.0
// Many programs at once, run by something outside of this process: as emitted C in one translation unit, compiled by several
// compilers; or as images, fed to a program that runs them.  Each receives the whole conversation (talk.h); its answers must be those that
// the reference answered, byte for byte.
#ifndef SM_DIFF_BATCH_H
#define SM_DIFF_BATCH_H

#include "tests/diff/talk.h"

enum { BATCH_MAX = 100, BATCH_TOO_LARGE = 77 };       // the exit code of a compiler if all programs together do not fit its chip

// What runs them: a C compiler's command, or that of a program as tests/targets/vm.c.
typedef struct Via {
    const char *command;
    bool images;
    bool soft;                // the C has its numbers in software
} Via;

// Whether it is --vm=COMMAND, --cc=COMMAND, or --cc-soft=COMMAND, which is C with numbers in software.
bool batch_via(const char *arg, Via *out);

// Runs n programs (at most BATCH_MAX), each in some forms (1u << Form …), by each of these, all of one kind; r[i] is the result of the i-th.
// Files are made in `folder`.
void run_batch(Gen *const *g, const unsigned *forms, uint32_t n, const Via *via, uint32_t vias, const char *folder, Arena *arena,
               RunResult *r);

// The part of a machine, ready to be recorded; NULL if no image can be built, with the reason in `result`.
TalkPart *batch_part(Talk *t, Session *s, const Program *p, const Program *known, Form form, IrMachine *ir, RunResult *result);
// Holds the conversation.
void batch_talk(Talk *t, const Via *via, uint32_t vias, const char *folder);
// Removes what batch_talk made, and the folder.
void batch_clean(const char *folder);

#endif
