// SPDX-License-Identifier: Apache-2.0
// An application at the other end of a link (docs/swapping.md 12.35 to 12.54): lists its machines and sends a swap.  Prints nothing.
#ifndef SMC_APP_HOST_H
#define SMC_APP_HOST_H

#include "bytecode-vm/auth.h"
#include "compiler/base/arena.h"
#include "compiler/base/buf.h"
#include "compiler/device/link_host.h"
#include "runtime-c/swap_phases.h"

enum { APPLICATION_NAME = 128 };      // bytes of a name with its zero byte; a longer one is cut off

typedef struct ApplicationInfo {
    uint8_t protocol, body, block;    // `block`: payload bytes of DATA
    uint16_t machines;
    uint32_t room;            // most bytes of a swap
    bool requires_signature;
    uint32_t mark;            // number that identifies the application's key (smvm_auth_mark)
    uint32_t newest;          // the highest number of a signed swap so far; the application refuses this number and lower ones
    char name[APPLICATION_NAME];
} ApplicationInfo;

typedef struct ApplicationMachine {
    bool can_swap, is_on_trial;
    bool is_built_in;         // the machine runs the image with which the application was built
    bool is_stored;           // its image is stored, and runs again after a restart of the application
    uint32_t checksum;        // checksum of the image that the machine runs
    uint8_t identity[8];
    uint32_t state;
    char name[APPLICATION_NAME], state_name[APPLICATION_NAME];
} ApplicationMachine;

typedef struct ApplicationSwap {
    uint32_t checksum;        // checksum of the last swap; 0: it was begun by the application itself, not by a host
    uint8_t phase, reason, end;       // SmSwapPhase, SmSwapReason, SmSwapEnd
    uint16_t machine;         // index of the machine that was refused; 0xffff: the refusal concerns no single machine
    uint32_t number;          // number of the swap, if it was signed
} ApplicationSwap;

typedef struct ApplicationItem {
    uint8_t kind, fate;       // SmvmSwapKind, SmvmSwapFate of bytecode-vm/swap.h
    char name[LINK_BODY_MAX];
} ApplicationItem;

// The following functions return false if the application did not answer (h->answered is false) or refused (h->result is the reason).
bool application_query(LinkHost *h, ApplicationInfo *info);
bool application_read_machine(LinkHost *h, uint16_t machine, ApplicationMachine *out);
bool application_read_swap(LinkHost *h, ApplicationSwap *out);
// Reads item `item`, from 0, of what the last swap did with the states, locals and windows of a machine.  False with SM_E_MISSING after the last one.
bool application_read_item(LinkHost *h, uint16_t machine, uint32_t item, ApplicationItem *out);
// Confirms the swap on trial.  key: signs the confirmation; NULL if the application accepts unsigned swaps.
bool application_confirm(LinkHost *h, const ApplicationSwap *swap, const uint8_t *key);

// ---- a swap ----

typedef struct ApplicationChange {
    const char *machine;
    uint8_t mode;             // SmSwapMode
    const char *state;        // name of the state in which the machine restarts; NULL: its first
    const uint8_t *image;
    uint32_t size;            // bytes of `image`; 0: the image with which the application was built
} ApplicationChange;

// Returns the sentence of a reason for a refusal (runtime-c/swaps.def).
const char *application_reason_text(uint8_t reason);

// Returns the checksum of a swap, by which the application identifies it.
uint32_t application_swap_checksum(const Buf *swap);

// Appends the bytes of a swap (bytecode-vm/target/swap_link.h), signed if `key` is not NULL.  At most 255 changes with names of at most
// 63 characters.
void application_write_swap(const ApplicationChange *change, size_t n, const uint8_t *key, uint32_t number, Buf *out);

typedef enum ApplicationStep { APPLICATION_DONE, APPLICATION_BEGIN, APPLICATION_DATA, APPLICATION_END } ApplicationStep;

// Sends a swap and lets the application begin it.  `session`: not 0, and different for each swap.  Returns the step that failed; then the
// swap has not begun, except if the step is APPLICATION_END and there was no answer.
ApplicationStep application_send_swap(LinkHost *h, const ApplicationInfo *info, const Buf *swap, const uint8_t *key, uint32_t number,
                                      uint16_t session);

#endif
