// SPDX-License-Identifier: Apache-2.0
// An engine that interprets the IR.  It computes narrowed operations in their own types and again in F64, and compares every value with the
// facts about it.  A wrong fact or a wrong narrowing is then found even if no result depends on it.
#ifndef TESTS_DIFF_ENGINE_IR_H
#define TESTS_DIFF_ENGINE_IR_H

#include "compiler/ir/ir.h"
#include "compiler/script/engine.h"

Engine *engine_ir_open(Arena *arena, const Program *p, const IrMachine *m);

#endif
