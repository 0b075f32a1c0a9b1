// SPDX-License-Identifier: Apache-2.0
// Runs many programs at once outside this process.  Either several compilers compile them as emitted C in one translation unit, or another
// program runs their images.  Each program receives the whole conversation (talk.h), and must give the same answers as the reference, byte for
// byte.
#ifndef SM_DIFF_BATCH_H
#define SM_DIFF_BATCH_H

#include "tests/diff/talk.h"

enum { BATCH_MAX = 100, BATCH_TOO_LARGE = 77 };  // BATCH_TOO_LARGE: the exit code of a compiler if all programs together do not fit its chip

// The command of a C compiler, or of a program that runs images, such as tests/targets/vm.c.
typedef struct Via {
    const char *command;
    bool images;
    bool soft;                // the C computes its numbers in software
} Via;

// Parses --vm=COMMAND, --cc=COMMAND, or --cc-soft=COMMAND, which is C with numbers in software.  Returns false if `arg` is none of these.
bool batch_via(const char *arg, Via *out);

// Runs n programs (at most BATCH_MAX) by each command in `via`; all commands are of one kind.  Bits 1u << Form of forms[i] select the forms of
// program i, whose result is r[i].  Files are created in `folder`.
void run_batch(Gen *const *g, const unsigned *forms, uint32_t n, const Via *via, uint32_t vias, const char *folder, Arena *arena,
               RunResult *r);

// Prepares the part of a conversation for one machine.  Returns NULL and sets *result if no image can be built.
TalkPart *batch_part(Talk *t, Session *s, const Program *p, const Program *known, Form form, IrMachine *ir, RunResult *result);
// Runs the conversation with every command.
void batch_talk(Talk *t, const Via *via, uint32_t vias, const char *folder);
// Removes the files that batch_talk created, and the folder.
void batch_clean(const char *folder);

#endif
