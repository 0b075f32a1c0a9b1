// SPDX-License-Identifier: Apache-2.0
// The role of a machine's elements, and the inputs that its values depend on: which sensors a guard depends on, directly,
// through rolling windows, and through locals computed from them.
#ifndef SMC_INPUT_DEPS_H
#define SMC_INPUT_DEPS_H

#include "compiler/analysis/analysis.h"

enum { LOOKS_MAX = 6 };           // sensors tracked per value; a value that reads more is treated as depending on no single one

typedef struct Looks {
    const Var *sensor[LOOKS_MAX]; // in order of Var.index
    uint32_t n;
    bool more;                    // on further sensors
    bool time;                    // on T or G
    bool input;                   // on an element that the machine only reads and that is not a sensor
    bool other;                   // on an element that the machine writes, on S, or on a local that a script writes
} Looks;

typedef VEC(StmtPlace) Stores;
typedef VEC(uint32_t) Numbers;

typedef struct Sensors {
    Analysis *a;
    bool *command;                // by Var.index: marked @command; or an integer that is only ever compared with constants by == or !=
    Looks *looks;                 // by Var.index, followed by Stmt.number of conditionals: its guard and the enclosing guards
    Stores *stores;               // by Var.index
} Sensors;

const Sensors *sensors_of(Analysis *a);

bool is_sensor(const Sensors *s, const Var *v);       // a numeric element that the machine only reads; not a command, G, S or T

// The inputs that decide whether all these conditions are met; the inputs that a value depends on.
Looks looks_of_condition(const Sensors *s, const Condition *when);
Looks looks_of_value(const Sensors *s, const Expr *e);
bool looks_at(const Looks *l, const Var *sensor);
// The innermost condition whose own guard depends on a sensor; NULL if there is none.
const Condition *condition_on(const Sensors *s, const Condition *when, const Var *sensor);
// For an expression that does not read the sensor itself: a store to a local that it reads and that depends on the sensor.
// NULL: there is none.
const Stmt *looks_through(const Sensors *s, const Expr *e, const Var *sensor);

#endif
