// SPDX-License-Identifier: Apache-2.0
// Emits an application as C on top of runtime-c: NAME_app.h and NAME_app.c (docs/config.md 10).
#ifndef SMC_EMIT_APP_H
#define SMC_EMIT_APP_H

#include "compiler/base/buf.h"
#include "compiler/diag/diag.h"
#include "compiler/sema/application.h"

// Checks that no two things in the emitted C of an application have the same name.  Reports each clash; returns false if there is one.
bool emit_c_check_app_names(Arena *arena, Diags *diags, const App *app);

// Emits the application.  `image`: by machine, the bytecode image of a machine with @bytecode, otherwise NULL.
void emit_c_app(Arena *arena, const App *app, const Buf *const *image, Buf *header, Buf *code);

#endif
