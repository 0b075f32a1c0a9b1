// SPDX-License-Identifier: Apache-2.0
// What a host can ask of a board, and an update from its first byte to its first start.  Prints nothing; all results say what to
// tell.
#ifndef SMC_DEVICE_H
#define SMC_DEVICE_H

#include "compiler/device/link_host.h"

#define DEVICE_BUILT_IN 0xffu   // stands for a slot

typedef struct DeviceInfo {
    uint8_t protocol, body, block, slots;
    uint32_t slot_size, ram, longest;
    SmResult may;             // whether an update may begin
    bool wants_signed;        // only images signed with its key, and with numbers above this
    uint32_t newest;
    bool tells_mark;          // of its key (smvm_auth_mark)
    uint32_t mark;
    // Of firmware that tells (`tells`):
    bool tells, windows;      // whether it runs rolling windows
    uint8_t machines;         // how many; 0: any number
    uint8_t ram_digital, ram_analog;      // what a pin takes of `ram`
    uint16_t period;          // milliseconds between steps where nobody says
    uint16_t cycles;          // of an ATmega that a step may take for each of them; 0: nobody minds
} DeviceInfo;

enum { DEVICE_EMPTY, DEVICE_WHOLE, DEVICE_TRIAL, DEVICE_CONFIRMED };

typedef struct DeviceImage {
    uint8_t slot, state;
    uint32_t length, checksum;
    uint8_t identity[8];
    bool runs, chosen;
    bool before;              // runs where the chosen one cannot
    uint8_t starts;           // left to a trial
    uint16_t period;          // milliseconds between its steps; 0: as the board has it
} DeviceImage;

// False: no answer (h->answered), or one that says no (h->result).
bool device_hello(LinkHost *h, DeviceInfo *info);
bool device_image(LinkHost *h, uint8_t slot, DeviceImage *image);
// What runs.
bool device_running(LinkHost *h, const DeviceInfo *info, DeviceImage *image);
bool device_ask_about(LinkHost *h, LinkMessage message, uint32_t checksum);        // CONFIRM, ERASE
// The image on trial, whether it runs already or from the next start on; false with SM_OK: none is.
bool device_trial(LinkHost *h, const DeviceInfo *info, DeviceImage *image);
// Which pin of its chip an image's is (SmvmPinPlace).  False with SM_E_UNSUPPORTED: the board does not say.
bool device_pin_place(LinkHost *h, uint8_t kind, uint16_t number, uint8_t *place);
// Whatever happens, it is asked once only: each restart counts.  True: the board answers again.
bool device_restart(LinkHost *h, DeviceInfo *info);

// ---- an update ----

typedef enum DeviceStep {
    DEVICE_DONE, DEVICE_LOOK, DEVICE_BEGIN, DEVICE_DATA, DEVICE_END, DEVICE_READ, DEVICE_ACTIVATE, DEVICE_RESTART, DEVICE_RUN
} DeviceStep;

typedef struct Update {
    const uint8_t *bytes;
    uint32_t length, checksum;
    uint16_t session;         // not 0; another one for each update
    uint16_t period;          // milliseconds between its steps; 0: as the board has it
    void (*progress)(void *context, uint32_t done);
    void *context;
    bool was_there;           // it runs already: nothing was sent
    uint8_t rule;             // DEVICE_END refused: what the board's verifier says, 0: nothing
    uint32_t at;
} Update;

// Sends it, has it verified, reads it back, chooses it, restarts the board and looks what runs.  DEVICE_DONE: it does; else the
// step that failed.  Unless that is DEVICE_RESTART or DEVICE_RUN, or the answer to ACTIVATE was lost, what ran before is still
// chosen.
DeviceStep device_update(LinkHost *h, DeviceInfo *info, Update *u);

#endif
