// SPDX-License-Identifier: Apache-2.0
// The role of a machine's elements, and the inputs that its values depend on: which sensors a guard depends on, directly,
// through rolling windows, and through locals computed from them.
#ifndef SMC_INPUT_DEPS_H
#define SMC_INPUT_DEPS_H

#include "compiler/analysis/analysis.h"

enum { INPUT_DEPS_MAX = 6 };      // sensors tracked per value; a value that reads more is treated as depending on no single one

typedef struct InputDeps {
    const Var *sensor[INPUT_DEPS_MAX]; // in order of Var.index
    uint32_t n;
    bool more;                    // on further sensors
    bool time;                    // on T or G
    bool input;                   // on an element that the machine only reads and that is not a sensor
    bool other;                   // on an element that the machine writes, on S, or on a local that a script writes
} InputDeps;

typedef struct InputDepsTable {
    Analysis *a;
    bool *command;                // by Var.index: marked @command; or an integer that is only ever compared with constants by == or !=
    InputDeps *deps;              // by Var.index, followed by Stmt.number of conditionals: its guard and the enclosing guards
    const Stmt **store;           // by Var.index: its first assignment in the file; or NULL
} InputDepsTable;

const InputDepsTable *input_deps_of(Analysis *a);

bool is_sensor(const InputDepsTable *s, const Var *v);       // a numeric element that the machine only reads; not a command, G, S or T

// The inputs that decide whether all these conditions are met; the inputs that a value depends on.
InputDeps input_deps_of_condition(const InputDepsTable *s, const Condition *when);
InputDeps input_deps_of_expr(const InputDepsTable *s, const Expr *e);
bool input_deps_include(const InputDeps *l, const Var *sensor);
// The innermost condition whose own guard depends on a sensor; NULL if there is none.
const Condition *input_deps_find_condition(const InputDepsTable *s, const Condition *when, const Var *sensor);
// For an expression that does not read the sensor itself: a store to a local that it reads and that depends on the sensor.
// NULL: there is none.
const Stmt *input_deps_find_store(const InputDepsTable *s, const Expr *e, const Var *sensor);

#endif
