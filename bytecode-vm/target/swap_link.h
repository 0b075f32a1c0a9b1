// SPDX-License-Identifier: Apache-2.0
// Reaches an application from outside while it runs: serves the frames of the link (runtime-c/link/link.def) on a socket of this computer, a
// TCP port or a serial line, so that `smc swap` can replace machines and `smc device` can list them (docs/swapping.md 12.35 to 12.54).
//
//     static uint8_t buffer[SM_SWAP_ROOM(2, 16384)];
//     static SmSwapChange changes[2];
//     static SmSwapLink link = {.service = SM_SWAP_LINK_SERVICE, .swaps = &stand_swaps, .place = SM_SWAP_AT_PATH, .name = "stand.sock",
//                               .machine = machines, .machines = 3, .change = changes, .buffer = buffer, .room = sizeof buffer};
//     SmSwaps stand_swaps = {…, .service = &link.service};
//
// The thread that writes the log does all of this, and no call of this module waits longer than the budget of its call.  The memory is
// constant: SM_SWAP_CLIENTS connections with a frame each, and one buffer for the swap that a host sends.  Further hosts wait in the queue of
// the system.  A connection without an intact frame for SM_SWAP_SILENT is closed.
//
// A swap is one byte string, in which the names end with a zero byte, and numbers have the least significant byte first:
//
//     u8 1: the version; u8 number of changes; for each of them:
//         u8 mode (SmSwapMode), u8 n, n bytes: the machine's name; u8 n, n bytes: to restart, the name of the state, or n = 0 for the first;
//         u24 length of the image, the image; length 0: the image with which the application was built
//     with a key also: u32 number, 16 bytes of code (bytecode-vm/auth.h) over all bytes before it
//
// It is sent with BEGIN, DATA and END, and begins when END has checked all of it.
#ifndef SMVM_TARGET_SWAP_LINK_H
#define SMVM_TARGET_SWAP_LINK_H

#include "bytecode-vm/auth.h"
#include "bytecode-vm/target/slot.h"
#include "runtime-c/link/link.h"
#include "runtime-c/pal/nvm.h"
#include "runtime-c/pal/serial.h"
#include "runtime-c/pal/socket.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SM_SWAP_SIGNATURE (4u + SMVM_CODE)                 // bytes at the end of a signed swap
// Bytes of the buffer for a swap of n machines, with images of up to `image` bytes each.
#define SM_SWAP_ROOM(n, image) (2u + (n) * ((image) + 6u + 2u * SM_SWAP_NAME) + SM_SWAP_SIGNATURE)

enum { SM_SWAP_CLIENTS = 4 };       // the most connections at once
#define SM_SWAP_SILENT (10 * (uint64_t)PAL_SECOND)

typedef enum SmSwapPlace { SM_SWAP_AT_PATH = 1, SM_SWAP_AT_ADDRESS, SM_SWAP_AT_LINE } SmSwapPlace;

// A connection to a host.
typedef struct SmSwapClient {
    bool is_open;
    PalSocket stream;         // the connection; unused at SM_SWAP_AT_LINE, where SmSwapLink.line is used
    uint64_t heard;           // PAL clock time of the last intact frame; before the first one, of the start of the connection
    LinkReceiver in;            // assembles received bytes to frames
    uint8_t received[LINK_ROOM(LINK_BODY_MAX)];
    uint8_t answer[LINK_ROOM(LINK_BODY_MAX)];
    uint16_t sent, length;    // number of bytes of `answer`: sent so far; in total
} SmSwapClient;

// How far the transfer of a swap from a host is: none, bytes are arriving, or END has come.
typedef enum SmSwapTransfer { SM_SWAP_NO_TRANSFER, SM_SWAP_RECEIVING, SM_SWAP_SENT } SmSwapTransfer;

typedef struct SmSwapLink {
    SmSwapService service;    // the first field: SM_SWAP_LINK_SERVICE
    SmSwaps *swaps;           // all its slots are SmvmSlots
    SmSwapPlace place;
    const char *name;         // path of the socket, or name of the serial line
    PalAddress address;       // the address and port at SM_SWAP_AT_ADDRESS
    uint32_t speed;           // bits per second at SM_SWAP_AT_LINE
    const char *key_file;     // 32 hexadecimal digits, read at the start; NULL: swaps need no signature
    const char *number_memory;// with a key: the name of the non-volatile memory that stores `newest`
    const SmMachine *machine; // all machines of the application
    uint16_t machines;
    SmSwapChange *change;     // one for each machine that can be swapped
    uint8_t *buffer;          // memory for the bytes of one swap
    uint32_t room;            // size of `buffer` in bytes
    // The fields below belong to the module; initially all zero.
    const char *app_name;
    const SmApp *app;
    SmEvents *events;
    uint32_t refused;         // bit r: a refusal with result -r has been logged as an event since `refused_since`
    uint64_t refused_since;   // PAL clock time
    PalSocket listening;
    PalSerial line;
    uint64_t retry;           // PAL clock time at which a line that has failed is opened again
    uint8_t key[SMVM_KEY];
    PalNvm memory;            // opened from `number_memory`
    uint32_t newest;          // with a key: the highest number of a signed swap so far; a swap with this number or a lower one is refused
    uint8_t record;           // the record in `memory` that the next number goes to
    SmSwapClient client[SM_SWAP_CLIENTS];
    uint8_t next;             // index of the client that is served first in the next call
    SmSwapTransfer transfer;
    uint16_t session;               // the host's number of the current transfer
    uint32_t length, checksum, received;  // of the current transfer; `received`: bytes so far
    uint64_t heard;           // PAL clock time of the last request of the current transfer
    uint32_t number;          // SmSwapStatus.number of the last swap that came over the link; 0: none
    uint32_t swap_checksum;   // the checksum of the received swap
    uint32_t swap_number;     // with a key: the number with which the swap was signed
    bool is_number_used;      // the number of the current transfer is checked and stored
} SmSwapLink;

SmResult sm_swap_link_open(SmSwapService *link, SmApp *app);
void sm_swap_link_serve(SmSwapService *link, uint64_t budget);
void sm_swap_link_close(SmSwapService *link);
#define SM_SWAP_LINK_SERVICE {sm_swap_link_open, sm_swap_link_serve, sm_swap_link_close}

// Handles one request, without a connection: reads sequence, message and n bytes of body from `request`, writes the frame of the answer to
// `answer`, which has LINK_ROOM(LINK_BODY_MAX) bytes, and returns the number of bytes to send; 0: none.
uint16_t sm_swap_link_answer(SmSwapLink *link, const uint8_t *request, uint16_t n, uint8_t *answer);

#ifdef __cplusplus
}
#endif
#endif
