// SPDX-License-Identifier: Apache-2.0
// The contract suite: what the headers of runtime-c/pal promise, one file a header, run on each platform (PSL).  What a header
// cannot say for all platforms (which pins are wired together, what the memory is called) is the platform's bench: bench_NAME.c.
#ifndef PSL_SUITE_H
#define PSL_SUITE_H

#include <string.h>

#include "runtime-c/pal/pal.h"
#include "tests/test.h"

#define MS ((uint64_t)PAL_MILLISECOND)
#define COUNT(array) (sizeof(array) / sizeof *(array))

typedef struct Tally {
    int passed, failed;
} Tally;

// Each contract_X ends with this: the counters of test.h are the file's own.
#define TALLY() ((Tally){test_passed, test_failed})

Tally contract_clock(void);
Tally contract_console(void);
Tally contract_lock(void);
Tally contract_nvm(void);
Tally contract_thread(void);

// The platforms' own tests.
Tally own_linux(void);

// The platform under test, and what it is said to have: what it has must work, what it has not must say so.
typedef struct Bench {
    const char *name;
    bool clock, console, threads, locks;
    const char *nvm;          // the name of a memory of nvm_size bytes that may be overwritten; NULL: it has none
    uint32_t nvm_size;
    const char *nvm_missing;  // a name that stands for none
    Tally (*own)(void);       // the platform's own tests, or NULL
} Bench;

extern const Bench bench;

// Called before and after everything.
void bench_begin(void);
Tally bench_end(void);

#endif
