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
Tally contract_aio(void);
Tally contract_dio(void);
Tally contract_io(void);
Tally contract_lock(void);
Tally contract_log(void);
Tally contract_nvm(void);
Tally contract_serial(void);
Tally contract_socket(void);
Tally contract_thread(void);
Tally contract_watchdog(void);

// The platforms' own tests.
Tally own_files_linux(void);
Tally own_threads_linux(void);
Tally own_devices_linux(void);
Tally own_sim(void);
Tally own_sbrio(void);

// Whether a platform has a feature: it works; it returns SM_E_UNSUPPORTED; it would work, but nothing is connected (SM_E_MISSING).
typedef enum Has { HAS_NONE, HAS, HAS_NOTHING_THERE } Has;

// The platform under test and what it claims to have.
typedef struct Bench {
    const char *name;
    Has clock, console, threads, locks, sockets;

    Has nvm;
    const char *nvm_name;     // a memory of nvm_size bytes that may be overwritten
    uint32_t nvm_size;
    const char *nvm_missing;  // the name of no memory

    Has log;
    const char *log_name;     // a file that may be made
    const char *log_missing;  // a name in a folder that is not there
    size_t (*log_read)(void *bytes, size_t room);         // the content of the file of log_name

    Has serial;
    const char *serial_name;
    void (*far_send)(const void *bytes, size_t n);        // the other end of that line
    size_t (*far_receive)(void *bytes, size_t room);      // the bytes that have arrived, without waiting
    void (*far_unplug)(void);                             // the line is closed until the suite ends

    Has dio;
    uint16_t pins[2];         // two that may be used
    bool wired;               // the second follows the first
    uint16_t pin_missing;

    Has aio;
    uint16_t channel_in, channel_out, channel_missing;
    bool analog_wired;        // channel_in measures the output of channel_out

    Has watchdog;

    Tally (*own[3])(void);    // the platform's own tests; NULL: none
} Bench;

extern Bench bench;

// Called before and after everything.
void bench_begin(void);
Tally bench_end(void);

#endif
