// SPDX-License-Identifier: Apache-2.0
// Emits an application as C on top of runtime-c: NAME_app.h and NAME_app.c (docs/config.md 10).
#ifndef SMC_EMIT_C_APP_H
#define SMC_EMIT_C_APP_H

#include "compiler/base/buf.h"
#include "compiler/diag/diag.h"
#include "compiler/sema/application.h"

// Checks that each of its C names denotes only one thing; reports those that do not.
bool emit_c_app_names(Arena *arena, Diags *diags, const App *app);

// `image`: by machine, the image of each machine with @bytecode.
void emit_c_app(Arena *arena, const App *app, const Buf *const *image, Buf *header, Buf *code);

#endif
