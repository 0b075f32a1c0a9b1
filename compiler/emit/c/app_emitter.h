// SPDX-License-Identifier: Apache-2.0
// What the files that emit an application share.
#ifndef SMC_EMIT_C_APP_EMITTER_H
#define SMC_EMIT_C_APP_EMITTER_H

#include "compiler/emit/c/emit_app.h"
#include "compiler/emit/c/unit.h"

// The application and the C names of its parts.
typedef struct AppEmitter {
    Arena *arena;
    const App *app;
    const char *prefix;           // begins names of the application: `rocket` in rocket_app
    const char *sv;               // begins names of the state vector: `rocket` in rocket_vector
    const char *io;               // begins names of the pin file: `rocket` in rocket_inputs
    const char *net;              // begins names of the messages: `rocket` in rocket_receive
    CUnit vector;                 // the names of the state vector's members
    CVectorNames names;           // the names of the elements' enumerators
    const Buf *const *image;      // by machine; NULL if the machine is emitted as C
    Buf *out;
} AppEmitter;

// ---- emit_app.c ----

// Returns the address of an element's SmElement.
const char *app_element_address(const AppEmitter *e, const Element *x);
// Returns the text escaped for a C string literal.
const char *app_escape_string(const AppEmitter *e, Str text);
bool app_has_task(const AppEmitter *e, AstAppTaskKind kind);

// ---- app_swaps.c ----

bool app_has_swaps(const App *app);
// Whether the executor runs a machine that can be swapped.
bool app_has_gate(const AppExecutor *x);
// Returns the index of a machine among those that can be swapped.
unsigned app_swappable_index(const App *app, const AppMachine *m);
bool app_has_storage(const AppEmitter *e);
// Whether the application answers requests from outside.
bool app_is_reached(const AppEmitter *e);
// Writes the tables of runtime-c/swap.h, if there are any.
void app_write_swaps(const AppEmitter *e);

#endif
