// SPDX-License-Identifier: Apache-2.0
// The bytecode VM: runs the machines of an image (.smb; docs/bytecode.md) in place, from flash, EEPROM or RAM.  C99 without
// heap, recursion or stdio; to embed it, copy this folder and stdlib.
//
//     SmvmVerdict why;
//     SmvmMachine m;
//     if (smvm_verify(image, size, &why) != 0)           // once, when the image arrives: why.rule says what is wrong
//         refuse();
//     smvm_machine(image, 0, &m);                        // its first machine
//     SmvmVector v = {sv, sizeof sv, MY_LAYOUT};
//     if (smvm_init(memory, sizeof memory, &m, &v, 1) != SM_OK)
//         refuse();                                      // memory: smvm_ram_size(&m) bytes, aligned as an array of uint64_t
//     for (;;) {
//         …put inputs and G into sv…
//         smvm_step(memory, sv);                         // SM_OK, or SM_REFUSED when G did not advance
//         …use what it stored…
//     }
//
// The verifier decides everything once.  Of an image that it accepted the interpreter cannot leave its memory, loop without
// bound or trap, whatever the state vector holds.  An image that it did not accept must not be given to any other function here.
#ifndef SMVM_H
#define SMVM_H

#include <stdbool.h>
#include <stdint.h>

#include "bytecode-vm/config.h"
#include "stdlib/f64.h"
#include "stdlib/result.h"
#include "stdlib/roll.h"
#include "stdlib/types.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- images ----

typedef struct SmvmVerdict {
    uint8_t rule;             // 0: accepted; else the number of the rule that is broken (rules.def)
    SmvmAt at;                // where: offset in the image
    SmvmAt machine;           // in which machine, counted from 0
    uint32_t longest;         // accepted: instructions in the longest step, of the machine where that is largest; as smvm_longest_step
} SmvmVerdict;

// Checks `size` bytes; an image may be shorter than that.  Gives v->rule.  Linear in size, no memory but ~600 bytes of stack.
uint8_t smvm_verify(SmvmBytes image, uint32_t size, SmvmVerdict *v);

// A part of an image, read one thing behind the other.
typedef struct SmvmReader {
    SmvmBytes image;
    SmvmAt at, end;
    SmvmAt n;                 // the number that was read last
} SmvmReader;

// What a machine is and where its parts lie in the image (all offsets count from the image's start).
typedef struct SmvmMachine {
    SmvmAt sv_size;           // bytes of that state vector in memory
    SmvmAt from, to;          // it reads and writes only these of them, from a multiple of 8 up to before one
    SmvmAt windows, f32s, f64s;       // how many of each
    SmvmAt states;            // numbered from 1
    // (From here to width as SmvmTables has them, which has others in the place of these two: bytes of locals, and of what is computed on the
    // way; and how many elements it may store, beside S.)
    SmvmAt windows_at, outputs_at, functions_at, f32s_at, f64s_at;
    SmvmAt locals, outputs;
    SmvmAt g, s;              // where in the state vector G and S are, in bytes
    SmvmAt width;             // bytes of an entry in the table of functions
    SmvmAt machine_at, machine_size;
    SmvmAt code_at, code_size, init_at, init_size, debug_at, debug_size;       // size 0: there is none
    SmvmAt safe_at, safe_size;        // which states are marked @safe: a bit each; safe_at 0: it marks none
    SmvmBytes image;
    uint32_t layout;          // hash of the layout of the state vector it was made for
} SmvmMachine;

// Reads machine `number`, counted from 0.  False if the image has no such machine.
bool smvm_machine(SmvmBytes image, uint32_t number, SmvmMachine *m);

// The instructions of its longest step, not counting the time that statistics take to walk over their windows; 0 where the VM is made
// without (SMVM_LONGEST).
uint32_t smvm_longest_step(const SmvmMachine *m);

// Whether a state of it (1 to m->states) is marked @safe.  Of a machine that marks none, each is.
bool smvm_state_is_safe(const SmvmMachine *m, uint32_t state);

// Where an element lies in the state vector, or a local among the locals.
typedef struct SmvmPlace {
    SmType type;
    SmvmAt offset;            // in bytes
} SmvmPlace;
SmvmPlace smvm_output(const SmvmMachine *m, uint32_t output);         // from 0

// ---- pins ----

// A pin that an image carries, as config.md 9 says; numbers of kinds and flags are those of runtime-c/io.h.
typedef struct SmvmPin {
    uint8_t kind;             // bit 0: an output; bit 1: digital
    uint8_t type;             // of the element
    uint8_t flags;            // 1 inverted, 2 pulled up, 4 pulled down
    uint8_t hold;             // inputs: steps that the last measurement is kept
    uint32_t pin;             // 0 to 65535
    SmvmAt offset;            // the element's place in the state vector
    SmF64 scale, zero;        // analog: element = volts * scale + zero
    SmF64 safe;               // outputs
} SmvmPin;

// Two pins with the same place are one pin of the chip.  SMVM_NO_PIN: none that an image may have.  `kind` as above, and from bit 2 on flags.
typedef uint8_t SmvmPinPlace(uint16_t number, uint8_t kind);
static inline uint8_t smvm_pin_kind(const SmvmPin *p) { return (uint8_t)(p->kind | p->flags << 2); }
#define SMVM_NO_PIN 0xffu

// Stands before the next of them.
typedef struct SmvmPins {
    SmvmReader in;
    uint32_t layout;          // hash of the layout of the state vector they are for
    SmvmAt sv_size;           // of that, in units of 8 bytes; the largest that there is where it is beyond what this target allows
    SmvmAt left;              // how many are still to come
} SmvmPins;

// Before the first pin of an image; false if it carries none.
bool smvm_pins(SmvmBytes image, SmvmPins *p);

// Reads the next one, in the order of the .io; false at the end.
bool smvm_next_pin(SmvmPins *p, SmvmPin *pin);

// ---- running ----

// Where in its image, its memory and the state vector a machine that runs has what.
typedef struct SmvmTables {
    SmvmAt windows, outputs, functions, f32s, f64s;       // in the image
    SmvmAt more, more_bytes;                              // behind the SmVm: bits of the outputs from 64 on
    SmvmAt g, s;                                          // in the state vector
    uint8_t width;            // bytes of an entry in the table of functions
} SmvmTables;

// A machine that runs; lies at the start of the memory given to smvm_init.  Read it through the functions below.
typedef struct SmVm {
    SmvmBytes image;
    uint64_t start, next;     // 1 more than G at the first step of `state`, and at the last step that ran; 0: there was none
    uint8_t stored[8];        // one bit for each of the first 64 outputs; behind the locals are more where there are more
    SmvmAt machine, code;     // where in the image its MACHINE and CODE are; what they say is read again at each step
    SmvmAt local;             // how far behind this the locals are
    SmvmAt state;             // the one that the next step runs
#if SMVM_KEEP_TABLES
    SmvmTables tables;
#endif
    // first: the next step is the first of `state`; entered: the last step was the first of its state: it stored S
#if SMVM_FETCH_AVR            // and what the assembly keeps (interp_avr.h): there are samples to take; there are more than eight outputs
    bool first : 1, entered : 1, samples : 1, many : 1;
    uint16_t body;            // address of the state's .step
    uint8_t y[8];             // register Y
#else
    bool first, entered;
#endif
} SmVm;

// Bytes of memory that smvm_init needs for m.
SmvmAt smvm_ram_size(const SmvmMachine *m);

// The state vector that there is, or a snapshot of it.
typedef struct SmvmVector {
    void *at;                 // aligned as a uint64_t
    uint32_t size;            // in bytes
    uint32_t layout;          // its hash, as the machine's
} SmvmVector;

// Puts a machine at state `state` (1 is the initial one) in memory that is the caller's, aligned as an array of uint64_t and of at
// least smvm_ram_size(m) bytes: locals at their initial values, windows empty.  Writes the state's number to S.
// SM_E_LAYOUT: m was made for a state vector of another layout or size.  SM_E_ARGUMENT: there is no such state.
// SM_E_MEMORY: `size` is too small.  SM_E_ALIGNMENT: memory or state vector is not aligned.
SmResult smvm_init(void *memory, uint32_t size, const SmvmMachine *m, const SmvmVector *sv, uint32_t state);

// One step (language.md 6) on the state vector or another snapshot of it.  SM_REFUSED: G did not advance; nothing changed.
SmResult smvm_step(SmVm *vm, void *sv);

uint32_t smvm_state(const SmVm *vm);                  // the state that the next step runs
uint64_t smvm_time(const SmVm *vm);                   // T
bool smvm_stored(const SmVm *vm, uint32_t output);    // whether the last step that ran stored output 0 … m.outputs - 1
bool smvm_stored_state(const SmVm *vm);               // whether it stored S
void *smvm_locals(SmVm *vm);                          // the locals, as the code and the debug section place them

// ---- running faster, where there is RAM to spare ----

// The code of a machine with its operands looked up, for one state vector; several times as fast as reading the image.
typedef struct SmvmDecoded SmvmDecoded;

// Bytes of memory that smvm_decode needs for m.
uint32_t smvm_decoded_size(const SmvmMachine *m);

// Decodes the code of the machine that smvm_init has put at vm, for steps on the state vector at sv, into memory that is the caller's,
// aligned as an array of uint64_t; *decoded is then that memory.  The locals, windows and everything else stay at vm, where all functions
// above find them; a new smvm_init of the same machine at the same place leaves the decoded code as it is.
// SM_E_MEMORY: `size` is too small.  SM_E_ALIGNMENT: the memory is not aligned.
SmResult smvm_decode(SmvmDecoded **decoded, void *memory, uint32_t size, const SmvmMachine *m, SmVm *vm, void *sv);

// As smvm_step, with the same results.  On another state vector than that given to smvm_decode it is smvm_step.
SmResult smvm_step_decoded(SmvmDecoded *decoded, void *sv);

// ---- for people; on hosts ----

typedef void (*SmvmWrite)(void *context, const char *text, size_t length);

// Any image that the verifier accepts, as text.
void smvm_disasm(SmvmBytes image, SmvmWrite write, void *context);

const char *smvm_rule_text(uint8_t rule);             // the sentence of a rule; "" for a number that has none

#ifdef __cplusplus
}
#endif
#endif
