// SPDX-License-Identifier: Apache-2.0
// The contract suite: tests the guarantees of the headers of runtime-c/pal, one file for each header, on each platform (PSL).  The bench of a
// platform, bench_NAME.c, describes what differs: which pins are connected, or the name of the memory.
#ifndef PSL_SUITE_H
#define PSL_SUITE_H

#include <string.h>

#include "runtime-c/pal/pal.h"
#define TEST_TALLY
#include "tests/test.h"

#define MS ((uint64_t)PAL_MILLISECOND)
#define COUNT(array) (sizeof(array) / sizeof *(array))

typedef struct Tally {
    int passed, failed;
} Tally;

// Each contract_X ends with this, since the counters of test.h are static in each file.
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

// The state of a feature: it works; it returns SM_E_UNSUPPORTED; or it would work, but no device is connected (SM_E_MISSING).
typedef enum Has { HAS_NONE, HAS, HAS_NOTHING_THERE } Has;

// The platform under test, and the features that it claims.
typedef struct Bench {
    const char *name;
    Has clock, console, threads, locks, sockets;

    Has nvm;
    const char *nvm_name;     // a memory of nvm_size bytes that the test can overwrite
    uint32_t nvm_size;
    const char *nvm_missing;  // a name that no memory has

    Has log;
    const char *log_name;     // a file that the test can create
    const char *log_missing;  // a name in a folder that does not exist
    size_t (*log_read)(void *bytes, size_t room);         // copies the content of the file log_name

    Has serial;
    const char *serial_name;
    void (*far_send)(const void *bytes, size_t n);        // sends from the other end of the serial line
    size_t (*far_receive)(void *bytes, size_t room);      // returns the bytes that have arrived there, without waiting
    void (*far_unplug)(void);                             // closes the line until the suite ends

    Has dio;
    uint16_t pins[2];         // two pins that the test can use
    bool wired;               // the second pin is connected to the first
    uint16_t pin_missing;

    Has aio;
    uint16_t channel_in, channel_out, channel_missing;
    bool analog_wired;        // channel_in measures the output of channel_out

    Has watchdog;

    Tally (*own[3])(void);    // the platform's own tests; NULL: none
} Bench;

extern Bench bench;

// Called before and after all tests.
void bench_begin(void);
Tally bench_end(void);

#endif
