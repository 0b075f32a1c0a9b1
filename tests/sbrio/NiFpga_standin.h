// SPDX-License-Identifier: Apache-2.0
// The stand-in for NI's library and FPGA: NiFpga.c checks what the API documents of its calls, and injects statuses.  A call that breaks the
// contract ends the program with exit code 3, unless the test expects it.  What it checks:
//
//   1. NiFpga_Initialize comes first, once; NiFpga_Finalize last.  At the end of the program nothing is open.
//   2. NiFpga_Initialize and NiFpga_Finalize overlap with no other call.
//   3. The session is open, and no call has reported that it is invalid.
//   4. The address is that of a control or indicator, and has the type of the function.  Only controls are written.
//   5. The bitfile is an absolute path, the signature is that of the VI, attributes are documented ones, pointers are not null.
//   6. With all_at_start: when the VI starts, the program has written every control that it ever writes.
#ifndef NIFPGA_STANDIN_H
#define NIFPGA_STANDIN_H

#include <stdbool.h>

#include "NiFpga.h"

// A control or indicator of the VI.  Types are numbered in the order of NiFpga.h: STANDIN_Bool …
typedef enum StandinType { STANDIN_Bool, STANDIN_I8, STANDIN_U8, STANDIN_I16, STANDIN_U16, STANDIN_I32, STANDIN_U32, STANDIN_I64, STANDIN_U64, STANDIN_Sgl, STANDIN_Dbl } StandinType;

typedef struct StandinRegister {
    uint32_t address;
    uint8_t type;             // StandinType
    bool control;
    uint32_t follows;         // an indicator that the VI sets to the value of this control; 0: none
    double value;
    bool written;
} StandinRegister;

// The VI: its signature, its controls and indicators.  The test program defines it; without a definition, any address can be accessed.
typedef struct StandinVi {
    const char *signature;
    StandinRegister *at;
    unsigned count;
    bool all_at_start;
} StandinVi;
extern const StandinVi standin_vi;

typedef enum StandinCall { STANDIN_Initialize, STANDIN_Finalize, STANDIN_Open, STANDIN_Close, STANDIN_Run, STANDIN_Read, STANDIN_Write } StandinCall;

// Called before each call, with the register that it accesses or NULL.  The program can define it.  It may change registers.  It returns the
// status of the call; a negative one prevents it.
NiFpga_Status standin_before(StandinCall call, StandinRegister *r);

// Closes the session and resets the registers of the VI.  Session numbers continue.
void standin_reset(void);

// Call number `n` from now on, counted from 0, returns this status.  A negative one prevents the call.
void standin_inject(unsigned n, NiFpga_Status status);

// Returns the number of calls since standin_reset, and the kind of call i, which is below the number and 255.
unsigned standin_calls(void);
StandinCall standin_call(unsigned i);

// From now on a call in the library lets other threads call meanwhile.
void standin_slow(void);

// Whether the VI runs, and the register of an address; NULL if no register has it.
bool standin_runs(void);
StandinRegister *standin_find(uint32_t address);

// The next call that breaks the contract does not end the program.  standin_broken returns whether there was one, and forgets it.
void standin_expect_broken(void);
bool standin_broken(void);

#endif
