# --emit=c writes two files.
args build --emit=c a.sm && ls

-- a.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- file a.h --
// The state machine a.  Made by smc from a.sm: change that, not this file.
#ifndef A_H_INCLUDED
#define A_H_INCLUDED

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// The state vector: what the machine reads and writes.
// The layout is the same on every target: nothing is hidden between the members.  A bool is a byte: 0 is false,
// anything else true.
#if !defined(A_SV_LAYOUT)
#define A_SV_LAYOUT 0xb1dc9237u
typedef struct ASv {
    uint64_t G;
    uint32_t S;
    uint8_t  open;                    // bool
    uint8_t  pad_at_13_[3];
} ASv;

// Does not compile where the compiler puts gaps between members or has other sizes.
typedef char ASv_layout_check[sizeof(ASv) == 16 ? 1 : -1];
#elif A_SV_LAYOUT != 0xb1dc9237u
#error "ASv: this header and one included before it were made from different state vectors"
#endif

typedef enum AStatus {
    A_OK,
    A_REFUSED,     // step: time did not advance; nothing changed
    A_NO_STATE,    // init: there is no state of that number; step: init has not succeeded
    A_UNFIT        // init: built or run in a way that changes what arithmetic means
} AStatus;

// States by number.  The first is where the machine starts if you have no reason to choose another.
enum {
    A_STATE_Idle = 1,
    A_INITIAL_STATE = 1,
    A_STATES = 1      // how many there are
};

// Which elements the last step that was not refused has stored.
typedef struct AStored {
    bool S;
    bool open;
} AStored;

// The machine.  Copying it copies the machine; its members are for reading, and those that end in an underscore are
// its own business.
typedef struct A {
    uint32_t state_;                  // what the next step runs; 0 before init
    bool     first_;                  // the next step is the state's first
    bool     ran_;                    // a step has run since init
    uint64_t start_;                  // time of the state's first step
    uint64_t last_;                   // time of the last step that ran
    uint64_t T;                       // time in the state, as of the last step
    AStored  stored;                  // what that step stored
} A;

// Puts the machine at a state, writes its number to the state vector and the locals' initial values.  On any other
// status than A_OK the machine will not step.
AStatus a_init(A *m, ASv *sv, uint32_t state);

// Runs one step.  Time, sv->G, must have advanced since the last step that ran.
AStatus a_step(A *m, ASv *sv);

// The number of the state that the next step runs.
uint32_t a_state(const A *m);

// A state's name as in the source; "" for a number that is no state's.
const char *a_state_name(uint32_t state);

#ifdef __cplusplus
}
#endif

#endif
-- stdout --
a.c
a.h
a.sm
