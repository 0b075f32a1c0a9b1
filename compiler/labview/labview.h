// SPDX-License-Identifier: Apache-2.0
// The face of smc.dll for LabVIEW, and for other programs that call a DLL without C headers.  docs/labview.md shows how a Call Library
// Function Node is set for each function.
//
// **Types.**  Every function is a C function (__cdecl, without decoration) that returns int32_t.  Parameters are int32_t, uint64_t, double,
// pointers to one of these for a single result, and arrays with their length.  There are no callbacks, structs or pointers that the caller
// would have to keep.
//
// **Result.**  SMC_OK (0), or a negative SmcResultCode of smc.h.  `message` receives the sentence about it, "" for SMC_OK: at most
// `message_size` bytes with the NUL that always ends it.  It can be NULL with size 0.
//
// **Handles** are positive numbers.  0 and numbers of closed sessions and machines are refused with SMC_E_HANDLE.  Up to 64 sessions and
// 1,024 machines can be open.
//
// **Byte arrays** that receive a text or bytes: `size` is the room of the array, *length becomes the length of the whole text.  If the array
// is too short, it receives the beginning, and the result is SMC_E_SIZE unless the function failed for another reason.
//
// **Threads.**  Any thread can call any function.  Of two calls of one session at the same time, the second returns SMC_E_BUSY.
#ifndef SMC_LABVIEW_H
#define SMC_LABVIEW_H

#include <stdint.h>

// Opens a session, which compiles.
int32_t smclv_open(int32_t *session, char *message, int32_t message_size);
// Closes a session and its machines.
int32_t smclv_close(int32_t session, char *message, int32_t message_size);

// Adds a source, or replaces the text of the source of that name.  kind: 0 .sv, 1 .sm, 2 .ss, 3 .io, 4 .app, 5 .net, 6 .rq.  `name` ends with a NUL.
int32_t smclv_source(int32_t session, int32_t kind, const char *name, const uint8_t *text, int32_t text_length, int32_t *source,
                     char *message, int32_t message_size);
// Removes all sources.
int32_t smclv_clear(int32_t session, char *message, int32_t message_size);
// Sets an option: SMC_OPTION_… of smc.h.
int32_t smclv_option(int32_t session, int32_t option, uint64_t value, char *message, int32_t message_size);

// Compiles all sources.  `diagnostics` receives errors and warnings as text, also if the sources have neither (length 0).
int32_t smclv_compile(int32_t session, uint8_t *diagnostics, int32_t size, int32_t *length, char *message, int32_t message_size);
// Stores the image of what was compiled (.smb), with names.
int32_t smclv_image(int32_t session, uint8_t *image, int32_t size, int32_t *length, char *message, int32_t message_size);
// Runs a script; `report` receives what smc test prints.  steps 0: at most 1,000,000.
int32_t smclv_run(int32_t session, int32_t script, uint64_t steps, uint8_t *report, int32_t size, int32_t *length, char *message,
                  int32_t message_size);
// Draws the state diagram of a machine.  form: 0 SVG, 1 DOT, 2 Mermaid.
int32_t smclv_diagram(int32_t session, int32_t source, int32_t form, uint8_t *text, int32_t size, int32_t *length, char *message,
                      int32_t message_size);

// Starts a machine in its first state: one that was compiled, or number `number` of an image.
int32_t smclv_machine_open(int32_t session, int32_t source, int32_t *machine, char *message, int32_t message_size);
int32_t smclv_machine_open_image(int32_t session, const uint8_t *image, int32_t image_length, int32_t number, int32_t *machine, char *message,
                                 int32_t message_size);
int32_t smclv_machine_close(int32_t machine, char *message, int32_t message_size);
// Starts it again in a state, from 1.
int32_t smclv_machine_start(int32_t machine, int32_t state, char *message, int32_t message_size);
// Sets G and runs a step.  *state becomes the number of the state that the next step runs.
int32_t smclv_machine_step(int32_t machine, uint64_t g, int32_t *state, char *message, int32_t message_size);
// Swaps: `to` continues where `from` is (docs/swapping.md).  Both belong to one session.
int32_t smclv_machine_continue(int32_t from, int32_t to, char *message, int32_t message_size);

// The state that the next step runs, how many there are, and the time T in the state.
int32_t smclv_machine_state(int32_t machine, int32_t *state, int32_t *states, uint64_t *time, char *message, int32_t message_size);
int32_t smclv_machine_state_name(int32_t machine, int32_t state, uint8_t *name, int32_t size, int32_t *length, char *message,
                                 int32_t message_size);

// Elements and locals by number.  type: SMC_TYPE_… of smc.h, 8 F32, 9 F64, 10 bool; kind: 0 element, 1 local.
int32_t smclv_variables(int32_t machine, int32_t *count, char *message, int32_t message_size);
int32_t smclv_variable(int32_t machine, int32_t variable, uint8_t *name, int32_t size, int32_t *length, int32_t *type, int32_t *kind,
                       char *message, int32_t message_size);
int32_t smclv_find(int32_t machine, const char *name, int32_t *variable, char *message, int32_t message_size);

// Values as doubles.  smclv_get_cells and smclv_set_cells pass them exactly, as U64: an integer as its two's complement, a bool as 0 or 1,
// a float as the bits of its binary64.  Both have `count` variables and values.  A failed set has set the variables before the one at fault.
int32_t smclv_get(int32_t machine, const int32_t *variables, double *values, int32_t count, char *message, int32_t message_size);
int32_t smclv_set(int32_t machine, const int32_t *variables, const double *values, int32_t count, char *message, int32_t message_size);
int32_t smclv_get_cells(int32_t machine, const int32_t *variables, uint64_t *cells, int32_t count, char *message, int32_t message_size);
int32_t smclv_set_cells(int32_t machine, const int32_t *variables, const uint64_t *cells, int32_t count, char *message, int32_t message_size);

#endif
