// SPDX-License-Identifier: Apache-2.0
// Decides whether a board can be sent an image: compares what the image needs with what the board has, and with what it accepts now.  Prints
// nothing and sends no part of the image; the results contain everything that the caller needs for its messages.
#ifndef SMC_FLASH_H
#define SMC_FLASH_H

#include "bytecode-vm/auth.h"
#include "bytecode-vm/image.h"
#include "compiler/base/arena.h"
#include "compiler/device/device.h"

typedef struct FlashImage {
    const uint8_t *bytes;     // an image that the verifier accepts
    uint32_t length;
    uint32_t longest;         // instructions of its longest step, from the verdict
    uint16_t period;          // milliseconds between its steps; 0: the board's default
} FlashImage;

// What an image requires on any computer.  `ram`: bytes for the state vector, its machines and pins, without the VM's own structures, whose
// size differs between computers.  `cycles`: of its longest steps, estimated for an ATmega.
// `functions`: those of stdlib/elementary.def that it calls, bit n for number n.
typedef struct ImageNeeds { uint32_t ram, longest, machines, windows, parameters, cycles, functions; } ImageNeeds;

typedef enum FlashRefusal {
    FLASH_ACCEPTED,
    FLASH_LINK_FAILED,        // the request for FlashCheck.asking failed; the reason is in the LinkHost
    // The board has too little for the image:
    FLASH_TOO_LARGE, FLASH_RAM_TOO_SMALL, FLASH_STEP_TOO_LONG, FLASH_HAS_WINDOWS, FLASH_HAS_PARAMETERS, FLASH_CALLS_FUNCTION, FLASH_TOO_MANY_MACHINES,
    FLASH_STEP_TOO_SLOW,
    // A board of this kind would refuse or ignore a pin:
    FLASH_PIN_ABSENT, FLASH_PINS_CLASH,
    // The board accepts this image, or any image, only later or never:
    FLASH_NO_UPDATE_NOW,      // DeviceInfo.may is the reason
    FLASH_OTHER_ON_TRIAL, FLASH_NOT_SIGNED, FLASH_OTHER_KEY, FLASH_OLD_NUMBER
} FlashRefusal;

typedef struct FlashCheck {
    ImageNeeds needs;
    uint32_t period;          // milliseconds between steps: the image's, or the board's default if it has none
    const char *asking;       // FLASH_LINK_FAILED: what the failed request was for, as "asking what runs"
    DeviceImage running;      // the image that runs on the board
    bool runs_already;        // the running image is the one to send, with the same period
    DeviceImage trial;        // FLASH_OTHER_ON_TRIAL: the image on trial
    const char *function;     // FLASH_CALLS_FUNCTION: the name of the first elementary function that the board lacks
    SmvmAuth code;            // FLASH_OTHER_KEY, FLASH_OLD_NUMBER: the mark and number of the image
    SmvmPin pin, other;       // FLASH_PIN_ABSENT: the pin; FLASH_PINS_CLASH: two that are one pin of the board
} FlashCheck;

// Decides whether `image` can be sent.  The signature of an image that already runs or is on trial is not checked, because it is not sent.
FlashRefusal flash_check(Arena *arena, LinkHost *h, const DeviceInfo *info, const FlashImage *image, FlashCheck *out);

// What became of the previously running image after an update that failed before the new one was chosen.
typedef enum FlashPrevious {
    PREVIOUS_RUNS,
    PREVIOUS_RUNS_AFTER_RESTART,      // until then the built-in image runs
    PREVIOUS_OVERWRITTEN,
    PREVIOUS_UNKNOWN                  // the board does not answer
} FlashPrevious;
FlashPrevious flash_find_previous(LinkHost *h, const DeviceInfo *info, const DeviceImage *previous);

#endif
