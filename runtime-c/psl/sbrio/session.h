// SPDX-License-Identifier: Apache-2.0
// Internal to this platform: the session with the FPGA, which all pins and channels share.  The functions of NI's library are called in session.c
// only.
//
// 1. The first pin that is opened loads NI's library and opens the session, without running the VI.  The bitfile is downloaded if the FPGA does
//    not contain it, which can take seconds.  The last pin that is closed, or exit(), closes the session and unloads the library.
// 2. The VI is started by the first read, or the first write of an output that already has a value.  So outputs have their first level before
//    the VI drives them.
// 3. NI documents that loading and unloading are not thread-safe.  Here the mutex of the tables is locked during both, and no pin is open.
// 4. A session whose status says that it is invalid is lost: no function of NI's library uses it again, and every access returns SM_E_CLOSED.  It
//    is not opened again while the program uses pins, because that would download the bitfile and restart the VI.  All pins have to be closed first.
#ifndef PSL_SBRIO_SESSION_H
#define PSL_SBRIO_SESSION_H

#include "runtime-c/psl/sbrio/fpga.h"

// Finds the row of a digital pin or an analog channel.  SM_E_MISSING: there is none.  SM_E_ARGUMENT: there are several, or its numbers are invalid.
SmResult sbrio_find(bool digital, uint16_t number, const SbrioPin **row);

// Called for each pin that is opened and closed, with the mutex of the tables locked.
SmResult sbrio_open(void);
void sbrio_close(void);

// Starts the VI if it has not been started.
SmResult sbrio_start(void);

// Reads a control or an indicator; starts the VI before.  The value can be NaN.
SmResult sbrio_read(const SbrioPin *row, double *value);

// Writes a control: the nearest value of its type.  Does not start the VI.
SmResult sbrio_write(const SbrioPin *row, double value);

// The lowest and highest value of a type, and whether it has whole numbers only.
typedef struct SbrioRange {
    double lowest, highest;
    bool whole;
} SbrioRange;
extern const SbrioRange sbrio_ranges[SBRIO_TYPES];

#endif
