// SPDX-License-Identifier: Apache-2.0
// The requests of a host to a board (docs/link.md), and a complete update: from sending the image to its first start.  Prints nothing; the results
// contain everything that the caller needs for its messages.
#ifndef SMC_DEVICE_H
#define SMC_DEVICE_H

#include "compiler/device/link_host.h"
#include "runtime-c/link/transition.h"

#define DEVICE_BUILT_IN 0xffu   // the slot number of the built-in image

typedef struct DeviceInfo {
    uint8_t protocol;         // version of the link protocol
    uint8_t body, block;      // maximum number of bytes in the body of a frame, and of data in one DATA request
    uint8_t slots;            // number of slots for images
    uint32_t slot_size, ram;  // bytes of a slot, and of memory for a machine
    uint32_t longest;         // maximum number of VM instructions in a step; 0: no limit
    SmResult may;             // SM_OK if an update may begin, otherwise the reason why not
    bool requires_signature;  // the board only accepts images that are signed with its key and have a number above `newest`
    uint32_t newest;          // the highest number of a signed image that the board has accepted
    bool reports_mark;        // the board has reported `mark`
    uint32_t mark;            // identifies the board's key (smvm_auth_mark)
    bool reports_limits;      // the firmware reports its limits; the following fields are valid only then
    bool windows;             // the firmware supports rolling windows
    bool parameters;          // the firmware supports parameters (language.md 5.77); older firmware does not
    uint32_t functions;       // the elementary functions of the firmware: bit n for number n (stdlib/elementary.def); 0: firmware that does not
                              // report them
    uint8_t machines;         // the most machines in an image; 0: any number
    uint8_t ram_digital, ram_analog;      // bytes of `ram` that each digital and each analog pin takes
    uint16_t period;          // default number of milliseconds between steps
    uint16_t cycles;          // ATmega cycles that a step may take for each millisecond of the period; 0: no limit
} DeviceInfo;

// DeviceImage.state: the slot has no image; a complete one, neither on trial nor confirmed; one on trial; one whose trial was confirmed.
enum { DEVICE_EMPTY, DEVICE_WHOLE, DEVICE_TRIAL, DEVICE_CONFIRMED };

typedef enum DeviceEnd { DEVICE_NOT_ENDED, DEVICE_STARTS_USED, DEVICE_NOT_RUNNABLE } DeviceEnd;

typedef struct DeviceImage {
    uint8_t slot;
    uint8_t state;            // DEVICE_EMPTY to DEVICE_CONFIRMED
    uint32_t length, checksum;
    uint8_t identity[8];
    bool runs;                // the board runs this image now
    bool chosen;              // the board runs this image after its next start
    bool before;              // the board falls back to this image if the chosen one cannot run
    uint8_t starts;           // remaining starts of a trial
    uint8_t end;              // why its trial ended without confirmation (DeviceEnd); only for the image whose trial ended last
    uint16_t period;          // milliseconds between its steps; 0: the board's default
} DeviceImage;

// The following functions return false if the board did not answer (h->answered is false) or refused (h->result is the reason).
bool device_query_info(LinkHost *h, DeviceInfo *info);
// Whether the host can use the board's protocol version and sizes.  The functions below require it.
bool device_is_usable(const DeviceInfo *info);
bool device_read_image_info(LinkHost *h, uint8_t slot, DeviceImage *image);
// Finds the running image: that of a slot, or else the built-in one.
bool device_find_running_image(LinkHost *h, const DeviceInfo *info, DeviceImage *image);
// Ends the trial of the running image, which has this checksum: the board keeps it (smvm_store_confirm).
bool device_confirm_image(LinkHost *h, uint32_t checksum);
// From the board's next start on, the image with this checksum does not run (smvm_store_erase).
bool device_erase_image(LinkHost *h, uint32_t checksum);
// Reads an image from its slot into `bytes`, which has room for image->length bytes.
bool device_read_image(LinkHost *h, const DeviceInfo *info, const DeviceImage *image, uint8_t *bytes);
// Finds the image on trial, whether it already runs or will run from the next start on.  False with SM_OK if no image is on trial.
bool device_find_trial_image(LinkHost *h, const DeviceInfo *info, DeviceImage *image);
// Finds the image whose trial has ended.  False with SM_OK if no trial of an image has ended.
bool device_find_ended_trial(LinkHost *h, const DeviceInfo *info, DeviceImage *image);
// Reads the transitions that the board has stored in the slot of this image, the oldest first; *n: their number.  Bytes that are no record
// of the image are skipped.
bool device_read_transitions(LinkHost *h, const DeviceInfo *info, const DeviceImage *image, LinkTransition *out, size_t *n);
// Finds the pin of the board's chip for a pin of an image (SmvmPhysicalPin).  False with SM_E_UNSUPPORTED if the board does not report it.
bool device_find_chip_pin(LinkHost *h, uint8_t kind, uint16_t number, uint8_t *chip_pin);
// Restarts the board.  The request is never repeated, because every start of a trial counts.  True if a usable board answers again.
bool device_restart(LinkHost *h, DeviceInfo *info);

// ---- an update ----

enum { DEVICE_PERMIT = 20 };

// The steps of an update.  device_update returns the one that failed.
typedef enum DeviceStep {
    DEVICE_DONE, DEVICE_FIND, DEVICE_BEGIN, DEVICE_DATA, DEVICE_END, DEVICE_READ, DEVICE_ACTIVATE, DEVICE_RESTART, DEVICE_RUN
} DeviceStep;

typedef struct Update {
    const uint8_t *bytes;
    uint32_t length, checksum;
    const uint8_t *permit;    // DEVICE_PERMIT bytes: the number of the image and its permit (smvm_permit_read); NULL: the image has no permit
    uint16_t session;         // a number other than 0 that is different for each update
    uint16_t period;          // milliseconds between its steps; 0: the board's default
    void (*progress)(void *context, uint32_t done);
    void *context;
    bool was_running;         // result: the image was already running, and nothing was sent
    uint8_t rule;             // result if DEVICE_END was refused: the rule that the board's verifier reports and its offset; 0: none
    uint32_t at;
} Update;

// Sends the image, has the board verify it, reads it back, chooses it, restarts the board and checks that it runs.  Returns DEVICE_DONE if
// it runs, else the step that failed.  After a failure the previous image is still chosen, except if the step is DEVICE_RESTART or
// DEVICE_RUN, or if the answer to ACTIVATE was lost.
DeviceStep device_update(LinkHost *h, DeviceInfo *info, Update *u);

#endif
