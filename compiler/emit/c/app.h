// SPDX-License-Identifier: Apache-2.0
// An application to C on top of runtime-c: NAME_app.h and NAME_app.c (docs/config.md 10).
#ifndef SMC_EMIT_C_APP_H
#define SMC_EMIT_C_APP_H

#include "compiler/base/buf.h"
#include "compiler/diag/diag.h"
#include "compiler/sema/app.h"

// Whether each of its names in C stands for one thing; reports those that do not.
bool emit_c_app_names(Arena *arena, Diags *diags, const App *app);

// `image`: by machine, the image of each with @bytecode.
void emit_c_app(Arena *arena, const App *app, const Buf *const *image, Buf *header, Buf *code);

#endif
