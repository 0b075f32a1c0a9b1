// SPDX-License-Identifier: Apache-2.0
// The bytecode VM: runs the machines of an image (.smb; docs/bytecode.md) in place, from flash, EEPROM or RAM.  C99 without
// heap, recursion or stdio; to embed it, copy this folder and stdlib.
//
//     SmvmVerdict why;
//     SmvmMachine m;
//     if (smvm_verify(image, size, &why) != 0)           // once, when the image arrives: why.rule is the broken rule
//         refuse();
//     smvm_machine(image, 0, &m);                        // its first machine
//     SmvmVector v = {sv, sizeof sv, MY_LAYOUT};
//     if (smvm_init(memory, sizeof memory, &m, &v, 1) != SM_OK)
//         refuse();                                      // memory: smvm_ram_size(&m) bytes, aligned as an array of uint64_t
//     for (;;) {
//         …put inputs and G into sv…
//         smvm_step(memory, sv);                         // SM_OK, or SM_REFUSED when G did not advance
//         …use the stored outputs…
//     }
//
// The verifier makes every safety decision once.  When the interpreter runs an image that the verifier accepted, it cannot leave
// its memory, loop without bound or trap, whatever the state vector contains.  Pass no other image to any other function here.
#ifndef SMVM_H
#define SMVM_H

#include <stdbool.h>
#include <stdint.h>

#include "bytecode-vm/config.h"
#include "stdlib/result.h"
#include "stdlib/types.h"

// With -DSMVM_BINDINGS this header has declarations only, for tools that read it for another language (docs/embedding.md).
#ifdef SMVM_BINDINGS
typedef double SmF64;
#else
#include "stdlib/f64.h"
#include "stdlib/roll.h"
#endif

#ifdef __cplusplus
extern "C" {
#endif
#ifdef SMVM_LIBRARY           // defined while the library is built, which exports these functions
#pragma GCC visibility push(default)
#endif

// ---- images ----

typedef struct SmvmVerdict {
    uint8_t rule;             // 0: accepted; else the number of the rule that is broken (rules.def)
    SmvmAt at;                // offset of the error in the image
    SmvmAt machine;           // number of the faulty machine, counted from 0
    uint32_t longest;         // accepted: the largest smvm_longest_step of all machines
} SmvmVerdict;

// Checks an image within the first `size` bytes; it may be shorter than that.  Returns v->rule.  Takes time linear in the size and
// no memory but about 600 bytes of stack.
uint8_t smvm_verify(SmvmBytes image, uint32_t size, SmvmVerdict *v);

// Reads a part of an image sequentially.
typedef struct SmvmReader {
    SmvmBytes image;
    SmvmAt at, end;              // offsets in the image: the next byte; the end of the part
    SmvmAt n;                 // the varint read last
} SmvmReader;

// The properties of a machine, and the offsets of its parts from the start of the image (fields with _at).
typedef struct SmvmMachine {
    SmvmAt sv_size;           // bytes of the machine's state vector in memory
    SmvmAt from, to;          // the machine accesses only bytes from … to - 1 of the state vector; both are multiples of 8
    SmvmAt windows, f32s, f64s;       // numbers of windows, F32 constants and F64 constants
    SmvmAt states;            // number of states; they are numbered from 1
    // The fields from here to width are also those of SmvmTables, at the same distances, so that the VM copies them as a block.  In place of
    // locals and outputs, SmvmTables has more and more_bytes.  locals: bytes of locals and of intermediate results.  outputs: the number of
    // elements that the machine can store, besides S.
    SmvmAt windows_at, outputs_at, functions_at, f32s_at, f64s_at;
    SmvmAt locals, outputs;
    SmvmAt g, s;              // byte offsets of G and S in the state vector
    SmvmAt width;             // bytes of an entry in the table of functions
    SmvmAt machine_at, machine_size;    // the MACHINE section
    SmvmAt code_at, code_size, init_at, init_size, debug_at, debug_size;       // size 0: the section is absent
    SmvmAt safe_at, safe_size;        // a bit for each state: whether it is marked @safe; safe_at 0: the machine marks no state
#if SMVM_PARAMETERS
    SmvmAt parameters_at, parameters_size;    // the section PARAMETERS (smvm_parameter); size 0: the machine has no parameters
#endif
    SmvmBytes image;
    uint32_t layout;          // layout hash of the state vector that the machine was compiled for
} SmvmMachine;

// Reads machine `number`, counted from 0.  Returns false if the image has no such machine.
bool smvm_machine(SmvmBytes image, uint32_t number, SmvmMachine *m);

// Returns the number of instructions in the longest step; 0 if the VM is compiled without this count (SMVM_LONGEST).  The time that statistics
// need to traverse their windows is additional.
uint32_t smvm_longest_step(const SmvmMachine *m);

// Whether state `state` (1 to m->states) is marked @safe.  True for every state of a machine that marks none.
bool smvm_state_is_safe(const SmvmMachine *m, uint32_t state);

// The type and offset of an element in the state vector, or of a local among the locals.
typedef struct SmvmLocation {
    SmType type;
    SmvmAt offset;            // in bytes
} SmvmLocation;
SmvmLocation smvm_output(const SmvmMachine *m, uint32_t output);      // returns where output number `output`, counted from 0, is stored

// ---- pins ----

// A pin that an image describes (config.md 9).  The values of kind and flags are those of runtime-c/io.h.
typedef struct SmvmPin {
    uint8_t kind;             // bit 0: an output; bit 1: digital
    uint8_t type;             // type of the pin's element (SmType)
    uint8_t flags;            // 1 inverted, 2 pulled up, 4 pulled down
    uint8_t hold;             // inputs: for how many steps the last measurement remains valid
    uint32_t pin;             // number of the pin, 0 to 65535
    SmvmAt offset;            // offset of the element in the state vector, in bytes
    SmF64 scale, zero;        // analog: element = volts * scale + zero
    SmF64 safe;               // outputs: the value in the safe state, in the element's unit
} SmvmPin;

// A function of the board: returns the number of the chip's pin that pin `number` of an image uses, so two pins with the same result are the
// same pin of the chip.  SMVM_NO_PIN: an image may not use this pin.  `kind` is SmvmPin.kind, with the flags from bit 2 on (smvm_pin_kind).
typedef uint8_t SmvmPhysicalPin(uint16_t number, uint8_t kind);
#ifndef SMVM_BINDINGS
static inline uint8_t smvm_pin_kind(const SmvmPin *p) { return (uint8_t)(p->kind | p->flags << 2); }
#endif
#define SMVM_NO_PIN 0xffu

// An iterator over the pins of an image.
typedef struct SmvmPins {
    SmvmReader in;               // reads the section IO
    uint32_t layout;          // layout hash of the state vector that the pins belong to
    SmvmAt sv_size;           // size of that state vector, in units of 8 bytes; at most the largest SmvmAt / 8
    SmvmAt left;              // the number of pins not read yet
} SmvmPins;

// Initialises p, so that smvm_next_pin reads the first pin of the image.  Returns false if the image has no pins.
bool smvm_pins(SmvmBytes image, SmvmPins *p);

// Reads the next pin, in the order of the .io file.  Returns false at the end.
bool smvm_next_pin(SmvmPins *p, SmvmPin *pin);

// ---- running ----

// Where the tables and elements of a running machine are, as offsets.
typedef struct SmvmTables {
    SmvmAt windows, outputs, functions, f32s, f64s;       // offsets in the image
    SmvmAt more, more_bytes;                              // in the memory of SmVm: offset and size of the stored bits of outputs from the 64th on
    SmvmAt g, s;                                          // offsets in the state vector
    uint8_t width;            // bytes of an entry in the table of functions
} SmvmTables;

// A running machine.  It is at the start of the memory passed to smvm_init.  Read it through the functions below.
typedef struct SmVm {
    SmvmBytes image;
    uint64_t start, next;     // start: G + 1 at the first step of `state`.  next: G + 1 at the last step that ran; 0: no step has run
    uint8_t stored[8];        // one bit for each of the first 64 outputs; the bits of further outputs follow the locals
    SmvmAt machine, code;     // offsets in the image of MACHINE and CODE, which are read again at each step
    SmvmAt local;             // offset of the locals from this structure
    SmvmAt state;             // the state that the next step runs
#if SMVM_KEEP_TABLES
    SmvmTables tables;
#endif
    // first: the next step is the first one of `state`; entered: the last step was the first one of its state, so it stored S.
    // Only for the assembly (interp_avr.h): samples: the sample function is not empty; many: the machine has more than 8 outputs.
#if SMVM_FETCH_AVR
    bool first : 1, entered : 1, samples : 1, many : 1;
    uint16_t body;            // address of the state's .step block
    uint8_t y[8];             // register Y
#else
    bool first, entered;
#endif
} SmVm;

// Bytes of memory that smvm_init needs for m.
SmvmAt smvm_ram_size(const SmvmMachine *m);

// The state vector, or a snapshot of it.
typedef struct SmvmVector {
    void *at;                 // aligned as a uint64_t
    uint32_t size;            // in bytes
    uint32_t layout;          // hash of the layout of the state vector, to compare with the machine's
} SmvmVector;

// Starts a machine in state `state` (1 is the initial state), in memory that the caller owns.  The memory must be aligned as an array
// of uint64_t and have at least smvm_ram_size(m) bytes.  Sets locals to their initial values, empties windows, and writes the state's
// number to S. 
// SM_E_LAYOUT: m was compiled for a state vector of another layout or size.  SM_E_ARGUMENT: there is no such state.
// SM_E_MEMORY: `size` is too small.  SM_E_ALIGNMENT: the memory or the state vector is not aligned.
SmResult smvm_init(void *memory, uint32_t size, const SmvmMachine *m, const SmvmVector *sv, uint32_t state);

// Runs one step (language.md 6) on the state vector or on another snapshot of it.  SM_REFUSED: G did not advance; nothing changed.
SmResult smvm_step(SmVm *vm, void *sv);

uint32_t smvm_state(const SmVm *vm);                  // the state that the next step runs
uint64_t smvm_time(const SmVm *vm);                   // T after the last step: the time since the first step of the state that it ran (language.md 6)
bool smvm_stored(const SmVm *vm, uint32_t output);    // whether the last step stored this output, 0 to m.outputs - 1
bool smvm_stored_state(const SmVm *vm);               // whether the last step stored S
void *smvm_locals(SmVm *vm);                          // the locals, at the offsets that the code and the debug section use

// ---- faster execution, where there is RAM to spare ----

// The code of a machine with its operands resolved for one state vector.  It runs several times as fast as the image.
typedef struct SmvmDecoded SmvmDecoded;

// Bytes of memory that smvm_decode needs for m.
uint32_t smvm_decoded_size(const SmvmMachine *m);

// Decodes the code of the machine that smvm_init started at vm, for steps on the state vector at sv.  The caller owns the memory, which
// must be aligned as an array of uint64_t; *decoded is set to it.  Locals, windows and everything else stay at vm, so all functions above
// work as before.  The decoded code remains valid after another smvm_init of the same machine at the same address.
// SM_E_MEMORY: `size` is too small.  SM_E_ALIGNMENT: the memory is not aligned.
SmResult smvm_decode(SmvmDecoded **decoded, void *memory, uint32_t size, const SmvmMachine *m, SmVm *vm, void *sv);

// Like smvm_step, with the same results.  On any state vector other than the one passed to smvm_decode it calls smvm_step.
SmResult smvm_step_decoded(SmvmDecoded *decoded, void *sv);

// ---- text for people; on hosts ----

typedef void (*SmvmWrite)(void *context, const char *text, size_t length);

// Disassembles an image that the verifier accepts.
void smvm_disasm(SmvmBytes image, SmvmWrite write, void *context);

const char *smvm_rule_text(uint8_t rule);             // the sentence of a rule; "" if there is no such rule

// Copies the name of a state (1 to m->states) to `to`, at most size - 1 characters and a 0.  Returns the length of the name; 0 if the image
// has no names (smc build -g).
uint32_t smvm_copy_state_name(const SmvmMachine *m, uint32_t state, char *to, uint32_t size);

// ---- marks of states; on hosts ----

// Whether a machine may be replaced while it is in a state (1 to m->states): the state is marked @swap or @safe (swapping.md 12.4).  False for
// every state of a machine that marks none.
bool smvm_state_allows_swap(const SmvmMachine *m, uint32_t state);

// Whether a state is marked @abort.  False if the image has no names (smc build -g).
bool smvm_state_is_abort(const SmvmMachine *m, uint32_t state);

// ---- parameters (language.md 5.77); on hosts ----

typedef struct SmvmParameter {
    uint8_t type;             // SmType
    SmvmAt offset;            // offset of the parameter among the locals, in bytes
    SmvmAt name_at, name_size, unit_at, unit_size;        // offsets in the image and lengths of the name and the unit; unit_size 0: no unit
    SmF64 lowest, highest;    // the range of the parameter
    SmF64 standard, value;    // the default value, and the value with which the machine starts
} SmvmParameter;

// Reads parameter `number` of a machine, counted from 0.  Returns false if the machine has no such parameter.
bool smvm_parameter(const SmvmMachine *m, uint32_t number, SmvmParameter *p);
// Finds a parameter by its name, of `size` bytes.  Returns false if no parameter has that name.
bool smvm_find_parameter(const SmvmMachine *m, const char *name, uint32_t size, uint32_t *number);

// Returns 0 if the parameter can have the value x; else why not, as a number for smvm_refusal_text.
uint8_t smvm_judge_parameter(const SmvmMachine *m, uint32_t number, SmF64 x);
// Stores x as the value of a parameter in an image that can be written, and the image's new CRC.  m is a machine of this image.  Returns 0, or
// why the value is refused; then nothing changed.  The image must not be signed: the code would no longer be that of the image.
uint8_t smvm_set_parameter(uint8_t *image, const SmvmMachine *m, uint32_t number, SmF64 x);
// Returns the sentence, without its period, that every program shows for a refusal.
const char *smvm_refusal_text(uint8_t refusal);

// What identifies the logic of an image: code, layout, constants, and the parameters except for their values.  Independent of names (-g).
uint64_t smvm_logic_identity(SmvmBytes image);
// What identifies the values of its parameters.
uint64_t smvm_settings_identity(SmvmBytes image);

// ---- for other languages ----

// Sizes of structures that the caller provides: SmvmVerdict and SmvmMachine.
uint32_t smvm_verdict_size(void);
uint32_t smvm_machine_size(void);

#ifdef SMVM_LIBRARY
#pragma GCC visibility pop
#endif

#ifdef __cplusplus
}
#endif
#endif
