// SPDX-License-Identifier: Apache-2.0
// The checker: AST to typed program.  Reports every root cause once; gives NULL when there was an error.
#ifndef SMC_CHECK_H
#define SMC_CHECK_H

#include "compiler/diag/diag.h"
#include "compiler/sema/app.h"
#include "compiler/sema/iomap.h"
#include "compiler/sema/program.h"
#include "compiler/syntax/ast.h"

typedef struct CheckContext {
    Arena *arena;
    StrPool *strings;
    Diags *diags;
} CheckContext;

StateVec *check_state_vector(CheckContext *c, const AstFile *sv);

// `sv` may be NULL: the machine's own [state_vector] section is then the whole vector.
// `written_outside` names locals that somebody beside the machine writes (a state script): read-only ones among them are
// variables and not constants.  NULL when nobody does.
Program *check_machine(CheckContext *c, const AstFile *sm, StateVec *sv, const Map *written_outside);

Script *check_script(CheckContext *c, const AstFile *ss, const Program *program);

// The pins of elements of `sv`.
IoMap *check_io(CheckContext *c, const AstFile *io, const StateVec *sv);

// The files that an application names: whoever can opens them before it is checked.
void app_files(Arena *arena, const AstFile *app, AppFiles *out);
// `sv` and `pins` are NULL where they, and a machine's program where that, has errors, which were reported; then the rest is checked.
App *check_app(CheckContext *c, const AstFile *app, const StateVec *sv, const IoMap *pins, const AppFiles *files);

// Puts the names that the script assigns into `names` (name to itself): what check_machine wants as written_outside.
void script_written_names(const AstFile *ss, Map *names);
// How much G advances from step to step in the script; 0: it has no valid delta_t.
uint64_t script_delta_t(const AstFile *ss);

// Offsets, sizes and hash of a state vector whose elements and regions are in place (layout.c).
void layout_state_vector(StateVec *sv, Arena *arena);

#endif
