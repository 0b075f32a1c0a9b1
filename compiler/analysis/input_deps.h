// SPDX-License-Identifier: Apache-2.0
// The inputs that a machine's values depend on: for example, which sensors a guard reads directly, through rolling windows, or
// through locals computed from them.  Also the role of each element: sensor, command or other.
#ifndef SMC_INPUT_DEPS_H
#define SMC_INPUT_DEPS_H

#include "compiler/analysis/analysis.h"

enum { INPUT_DEPS_MAX = 6 };      // sensors tracked per value; a value that reads more is treated as depending on no single one

typedef struct InputDeps {
    const Var *sensor[INPUT_DEPS_MAX]; // in order of Var.index
    uint32_t n;
    bool more;                    // the value depends on more than INPUT_DEPS_MAX sensors; the others are not listed
    bool time;                    // the value depends on T or G
    bool input;                   // the value depends on an element that the machine only reads and that is not a sensor
    bool command;                 // the value depends on such an element that a person operates: one marked @command, or any if no element is marked
    bool other;                   // the value depends on an element that the machine writes, on S, or on a local that a script writes
} InputDeps;

typedef struct InputDepsTable {
    Analysis *a;
    bool marks_commands;          // some element is marked @command, so those without the mark are no commands
    bool *command;                // by Var.index: marked @command; without marks_commands, an integer that is only ever compared with constants
                                  // by == or !=
    InputDeps *deps;              // first by Var.index, then by Stmt.number of conditionals (the guard with its enclosing guards)
    const Stmt **store;           // by Var.index: the variable's first assignment in the file; or NULL
} InputDepsTable;

// Computes the inputs of all variables and guards of the machine.
const InputDepsTable *input_deps_of(Analysis *a);

// Whether v is a numeric element that the machine only reads, and not a command, G or S.
bool is_sensor(const InputDepsTable *s, const Var *v);

// Return the inputs on which `when` and its outer conditions depend, and the inputs on which the value of e depends.
InputDeps input_deps_of_condition(const InputDepsTable *s, const Condition *when);
InputDeps input_deps_of_expr(const InputDepsTable *s, const Expr *e);
bool input_deps_include(const InputDeps *l, const Var *sensor);
// Returns the innermost of `when` and its outer conditions whose own guard depends on the sensor; NULL if no guard depends on it.
const Condition *input_deps_find_condition(const InputDepsTable *s, const Condition *when, const Var *sensor);
// If e depends on the sensor only through locals, returns an assignment to such a local.  Returns NULL if e reads the sensor directly, or
// does not depend on the sensor.
const Stmt *input_deps_find_indirect_store(const InputDepsTable *s, const Expr *e, const Var *sensor);

#endif
