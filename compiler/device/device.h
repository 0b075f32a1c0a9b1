// SPDX-License-Identifier: Apache-2.0
// The requests of a host to a board, and a complete update: from sending the image to its first start.  Prints nothing; the results
// contain everything that the caller needs for its messages.
#ifndef SMC_DEVICE_H
#define SMC_DEVICE_H

#include "compiler/device/link_host.h"

#define DEVICE_BUILT_IN 0xffu   // the slot number of the built-in image

typedef struct DeviceInfo {
    uint8_t protocol, body, block, slots;
    uint32_t slot_size, ram, longest;
    SmResult may;             // whether an update may begin
    bool wants_signed;        // it only accepts images that are signed with its key and have a number above `newest`
    uint32_t newest;
    bool tells_mark;          // it reported the mark of its key (smvm_auth_mark)
    uint32_t mark;
    // Valid if the firmware reports its limits (`tells`):
    bool tells, windows;      // windows: it runs rolling windows
    uint8_t machines;         // the most machines in an image; 0: any number
    uint8_t ram_digital, ram_analog;      // bytes of `ram` for each pin
    uint16_t period;          // default number of milliseconds between steps
    uint16_t cycles;          // ATmega cycles that a step may take for each millisecond of the period; 0: no limit
} DeviceInfo;

enum { DEVICE_EMPTY, DEVICE_WHOLE, DEVICE_TRIAL, DEVICE_CONFIRMED };

typedef struct DeviceImage {
    uint8_t slot, state;
    uint32_t length, checksum;
    uint8_t identity[8];
    bool runs, chosen;
    bool before;              // the board falls back to it if the chosen image cannot run
    uint8_t starts;           // remaining starts of a trial
    uint16_t period;          // milliseconds between its steps; 0: the board's default
} DeviceImage;

// These return false if the board did not answer (h->answered is false) or refused (h->result is the reason).
bool device_hello(LinkHost *h, DeviceInfo *info);
// Whether its version of the link and the sizes that it reports are usable.  What follows assumes it.
bool device_is_usable(const DeviceInfo *info);
bool device_image(LinkHost *h, uint8_t slot, DeviceImage *image);
// The running image.
bool device_running(LinkHost *h, const DeviceInfo *info, DeviceImage *image);
bool device_request_about(LinkHost *h, LinkMessage message, uint32_t checksum);        // CONFIRM, ERASE
// The image on trial, whether it already runs or will run from the next start on.  False with SM_OK if no image is on trial.
bool device_trial(LinkHost *h, const DeviceInfo *info, DeviceImage *image);
// The pin of the board's chip for a pin of an image (SmvmPhysicalPin).  False with SM_E_UNSUPPORTED if the board does not report it.
bool device_pin_place(LinkHost *h, uint8_t kind, uint16_t number, uint8_t *place);
// Restarts the board.  The request is never repeated, because every start of a trial counts.  True if a usable board answers again.
bool device_restart(LinkHost *h, DeviceInfo *info);

// ---- an update ----

typedef enum DeviceStep {
    DEVICE_DONE, DEVICE_LOOK, DEVICE_BEGIN, DEVICE_DATA, DEVICE_END, DEVICE_READ, DEVICE_ACTIVATE, DEVICE_RESTART, DEVICE_RUN
} DeviceStep;

typedef struct Update {
    const uint8_t *bytes;
    uint32_t length, checksum;
    uint16_t session;         // not 0; different for each update
    uint16_t period;          // milliseconds between its steps; 0: the board's default
    void (*progress)(void *context, uint32_t done);
    void *context;
    bool was_there;           // result: the image was already running, and nothing was sent
    uint8_t rule;             // result if DEVICE_END was refused: the rule that the board's verifier reports and its offset; 0: none
    uint32_t at;
} Update;

// Sends the image, has the board verify it, reads it back, chooses it, restarts the board and checks that it runs.  Returns DEVICE_DONE if
// it runs, else the step that failed.  After a failure the previous image is still chosen, except if the step is DEVICE_RESTART or
// DEVICE_RUN, or if the answer to ACTIVATE was lost.
DeviceStep device_update(LinkHost *h, DeviceInfo *info, Update *u);

#endif
