// SPDX-License-Identifier: Apache-2.0
// An application to C on top of runtime-c: NAME_app.h and NAME_app.c (docs/config.md 10).
#ifndef SMC_EMIT_C_APP_H
#define SMC_EMIT_C_APP_H

#include "compiler/base/buf.h"
#include "compiler/sema/app.h"

void emit_c_app(Arena *arena, const App *app, Buf *header, Buf *code);

#endif
