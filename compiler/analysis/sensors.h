// SPDX-License-Identifier: Apache-2.0
// What the elements of a machine are to it, and what its values look at: which sensors a guard hangs on, directly, through rolling
// windows, and through locals that hold something made of them.
#ifndef SMC_SENSORS_H
#define SMC_SENSORS_H

#include "compiler/analysis/analysis.h"

enum { LOOKS_MAX = 6 };           // sensors that are told apart; who looks at more hangs on none of them

typedef struct Looks {
    const Var *sensor[LOOKS_MAX]; // in order of Var.index
    uint32_t n;
    bool more;                    // at further sensors
    bool time;                    // at T or G
    bool input;                   // at an element that the machine only reads and that is no sensor
    bool other;                   // at what the machine writes, at S, or at a local that a script writes
} Looks;

typedef VEC(StmtPlace) Stores;
typedef VEC(uint32_t) Numbers;

typedef struct Sensors {
    Analysis *a;
    bool *command;                // by Var.index: marked @command; or an integer that is only ever compared with constants by == or !=
    Looks *looks;                 // by Var.index, and behind these by Stmt.number, of a conditional: its guard and those around it
    Stores *stores;               // by Var.index
} Sensors;

const Sensors *sensors_of(Analysis *a);

bool is_sensor(const Sensors *s, const Var *v);       // a numeric element that the machine only reads; no command, no G, S, T

// What decides whether all these conditions hold; what decides on a value.
Looks looks_of_condition(const Sensors *s, const Condition *when);
Looks looks_of_value(const Sensors *s, const Expr *e);
bool looks_at(const Looks *l, const Var *sensor);
// The innermost condition whose own guard looks at a sensor; NULL if none does.
const Condition *condition_on(const Sensors *s, const Condition *when, const Var *sensor);
// Where an expression that does not read the sensor itself reads a local that looks at it: what is stored in that.  NULL: nowhere.
const Stmt *looks_through(const Sensors *s, const Expr *e, const Var *sensor);

#endif
