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
    const char *prefix;           // prefix of the application's names: `rocket` in rocket_app
    const char *sv;               // prefix of the state vector's names: `rocket` in rocket_vector
    const char *io;               // prefix of the pin file's names: `rocket` in rocket_inputs
    const char *net;              // prefix of the names of network messages: `rocket` in rocket_receive
    CUnit vector;                 // the names of the state vector's members
    CVectorNames names;           // the names of the elements' enumerators
    const Buf *const *image;      // by machine: its bytecode image; NULL if the machine is emitted as C
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
// Whether the executor has a gate, two tasks that swap machines at the beginning and end of a tick: it runs a machine that can be swapped.
bool app_has_gate(const AppExecutor *x);
// Returns the index of machine m in the list of machines that can be swapped.
unsigned app_swappable_index(const App *app, const AppMachine *m);
bool app_has_storage(const AppEmitter *e);       // whether the images of confirmed swaps are stored in non-volatile memory
// Whether hosts outside the application can connect to it and request swaps.
bool app_is_reached(const AppEmitter *e);
// Writes the tables of runtime-c/swap.h; nothing if no machine can be swapped.
void app_write_swaps(const AppEmitter *e);

#endif
