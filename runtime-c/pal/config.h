// SPDX-License-Identifier: Apache-2.0
// The sizes of the runtime's static tables.  To change some of them, either define SM_CONFIG as the name of a header
// ("my_config.h") that defines them, or put a header "smc_config.h" on the include path.  The others keep the values below.
// Nothing in the runtime grows while it runs: a table that is too small makes the start fail.
#ifndef SM_CONFIG_H
#define SM_CONFIG_H

#if !defined(SM_CONFIG) && defined(__has_include)
#if __has_include("smc_config.h")
#define SM_CONFIG "smc_config.h"
#endif
#endif
#ifdef SM_CONFIG
#include SM_CONFIG
#endif

// How many locks, threads, sockets, pins, analog channels, serial lines, memories and logs can be open at once: 1 to 254 of each.
#ifndef PAL_LOCKS
#define PAL_LOCKS 8
#endif
#ifndef PAL_THREADS
#define PAL_THREADS 8
#endif
#ifndef PAL_SOCKETS
#define PAL_SOCKETS 16
#endif
#ifndef PAL_DIOS
#define PAL_DIOS 64
#endif
#ifndef PAL_AIOS
#define PAL_AIOS 32
#endif
#ifndef PAL_SERIALS
#define PAL_SERIALS 4
#endif
#ifndef PAL_NVMS
#define PAL_NVMS 4
#endif
#ifndef PAL_LOGS
#define PAL_LOGS 2
#endif

// Stack size in bytes of a thread whose creator does not specify one.
#ifndef PAL_THREAD_STACK
#define PAL_THREAD_STACK 65536u
#endif

// How often a thread retries a held lock before it sleeps.  Critical sections are a few memory accesses, shorter than two context
// switches.  On a single core spinning never helps, so a small number costs least.
#ifndef PAL_LOCK_SPINS
#define PAL_LOCK_SPINS 100
#endif

// How long the state vector and the events wait for their lock, in nanoseconds.  The lock is held for a few memory accesses only.
// A wait that lasts this long means that the holding thread has died.
#ifndef SM_LOCK_WAIT
#define SM_LOCK_WAIT 1000000000u
#endif

// The maximum size of a name or path, including the terminating zero.
#ifndef PAL_NAME
#define PAL_NAME 128
#endif

// The log (log.h).  SM_LOG_PIECE: bytes written to the medium at once.  SM_LOG_AGAIN: bytes after which the description is
// repeated.  SM_LOG_SYNC: nanoseconds after which the log waits for the medium; a power cut can lose the records of this time.
#ifndef SM_LOG_PIECE
#define SM_LOG_PIECE 4096u
#endif
#ifndef SM_LOG_AGAIN
#define SM_LOG_AGAIN 1048576u
#endif
#ifndef SM_LOG_SYNC
#define SM_LOG_SYNC 1000000000u
#endif

// The saved state vector (keep.h) is written in pieces of a multiple of this many bytes.  Some memories require such alignment
// (pal/nvm.h, write).  1 is enough for an EEPROM.
#ifndef SM_KEEP_UNIT
#define SM_KEEP_UNIT 32u
#endif

typedef char pal_tables_hold_1_to_254[PAL_LOCKS >= 1 && PAL_LOCKS <= 254 && PAL_THREADS >= 1 && PAL_THREADS <= 254 &&
    PAL_SOCKETS >= 1 && PAL_SOCKETS <= 254 && PAL_DIOS >= 1 && PAL_DIOS <= 254 && PAL_AIOS >= 1 && PAL_AIOS <= 254 &&
    PAL_SERIALS >= 1 && PAL_SERIALS <= 254 && PAL_NVMS >= 1 && PAL_NVMS <= 254 && PAL_LOGS >= 1 && PAL_LOGS <= 254 ? 1 : -1];

#endif
