// SPDX-License-Identifier: Apache-2.0
#include "compiler/device/device.h"

#include <string.h>

enum {
    // Lengths of the answer to HELLO: the least, and with each of the parts that newer firmware appends (docs/link.md).
    HELLO_BYTES = 15, HELLO_SIGNED = HELLO_BYTES + 5, HELLO_LIMITS = HELLO_SIGNED + 7, HELLO_MARK = HELLO_LIMITS + 4,
    HELLO_FUNCTIONS = HELLO_MARK + 4,
    IMAGE_BYTES = 18,         // least length of the answer to IMAGE
    BEGIN_HEAD = 9,           // bytes before the permit in BEGIN
    DATA_HEAD = 5,            // bytes before the data in DATA: session, offset
    RESTARTS_MAX = 3          // attempts at an update or a restart
};

// Sends a request; returns true if the answer is SM_OK.  An answer with less than `least` bytes does not follow the protocol and sets h->result
// to SM_E_UNSUPPORTED.
static bool send_request(LinkHost *h, LinkMessage message, const uint8_t *body, size_t n, size_t least)
{
    if (!link_request(h, message, body, n))
        return false;
    if (h->result == SM_OK && h->n < least)
        h->result = SM_E_UNSUPPORTED;
    return h->result == SM_OK;
}

// All functions here that send requests return false if the board did not answer or refused, as those of device.h.

// ---- the board and its images ----

// Decodes the limits of the firmware in the answer to HELLO.
static void read_limits(const uint8_t *b, DeviceInfo *info)
{
    info->windows = (b[0] & LINK_WINDOWS) != 0;
    info->parameters = (b[0] & LINK_PARAMETERS) != 0;
    info->machines = (uint8_t)(b[0] & ~(LINK_WINDOWS | LINK_PARAMETERS));
    info->ram_digital = b[1];
    info->ram_analog = b[2];
    info->period = (uint16_t)sm_link_load(b + 3, 2);
    info->cycles = (uint16_t)sm_link_load(b + 5, 2);
}

bool device_query_info(LinkHost *h, DeviceInfo *info)
{
    const uint8_t *b;

    if (!send_request(h, LINK_HELLO, NULL, 0, HELLO_BYTES))
        return false;
    b = h->body;
    memset(info, 0, sizeof *info);
    info->protocol = b[0];
    info->body = b[1];
    info->block = b[2];
    info->slots = b[3];
    info->slot_size = sm_link_load(b + 4, 3);
    info->ram = sm_link_load(b + 7, 3);
    info->longest = sm_link_load(b + 10, 4);
    info->may = (SmResult)(int8_t)b[14];
    info->requires_signature = h->n >= HELLO_SIGNED && b[15] != 0;
    info->newest = h->n >= HELLO_SIGNED ? sm_link_load(b + 16, 4) : 0;
    info->reports_limits = h->n >= HELLO_LIMITS;
    if (info->reports_limits)
        read_limits(b + HELLO_SIGNED, info);
    info->reports_mark = h->n >= HELLO_MARK;
    info->functions = h->n >= HELLO_FUNCTIONS ? sm_link_load(b + HELLO_MARK, 4) : 0;
    info->mark = info->reports_mark ? sm_link_load(b + HELLO_LIMITS, 4) : 0;
    return true;
}

bool device_read_image_info(LinkHost *h, uint8_t slot, DeviceImage *image)
{
    const uint8_t *b;

    if (!send_request(h, LINK_IMAGE, &slot, 1, IMAGE_BYTES))
        return false;
    b = h->body;
    image->slot = slot;
    image->state = b[0];
    image->length = sm_link_load(b + 1, 3);
    image->checksum = sm_link_load(b + 4, 4);
    memcpy(image->identity, b + 8, 8);
    image->runs = (b[16] & 1) != 0;
    image->chosen = (b[16] & 2) != 0;
    image->before = (b[16] & 4) != 0;
    image->starts = b[17];
    image->end = b[16] / LINK_TRIAL_END % 4;
    image->period = h->n < IMAGE_BYTES + 2 ? 0 : (uint16_t)sm_link_load(b + IMAGE_BYTES, 2);
    return true;
}

// Finds the image that runs: the one in a slot that the board reports as running, or else the built-in one.
bool device_find_running_image(LinkHost *h, const DeviceInfo *info, DeviceImage *image)
{
    for (uint8_t slot = 0; slot < info->slots; slot++) {
        if (!device_read_image_info(h, slot, image))
            return false;
        if (image->runs)
            return true;
    }
    return device_read_image_info(h, DEVICE_BUILT_IN, image);
}

static bool is_on_trial(const DeviceImage *image) { return image->state == DEVICE_TRIAL; }
static bool has_ended_trial(const DeviceImage *image) { return image->state != DEVICE_EMPTY && image->end != DEVICE_NOT_ENDED; }

// Finds the first slot with an image that fulfils the condition `is`.
static bool find_image(LinkHost *h, const DeviceInfo *info, bool (*is)(const DeviceImage *image), DeviceImage *image)
{
    for (uint8_t slot = 0; slot < info->slots; slot++) {
        if (!device_read_image_info(h, slot, image))
            return false;
        if (is(image))
            return true;
    }
    return false;
}

// Finds the image on trial, whether it already runs or will run from the next start on.  False with SM_OK if no image is on trial.
bool device_find_trial_image(LinkHost *h, const DeviceInfo *info, DeviceImage *image) { return find_image(h, info, is_on_trial, image); }

// Finds the image whose trial has ended.  False with SM_OK if no trial of an image has ended.
bool device_find_ended_trial(LinkHost *h, const DeviceInfo *info, DeviceImage *image) { return find_image(h, info, has_ended_trial, image); }

// Sends a request whose body is the checksum of an image: CONFIRM or ERASE.  Returns whether the board answered SM_OK.
static bool send_request_for_checksum(LinkHost *h, LinkMessage message, uint32_t checksum)
{
    uint8_t body[4];

    sm_link_store(body, checksum, 4);
    return send_request(h, message, body, sizeof body, 0);
}

bool device_confirm_image(LinkHost *h, uint32_t checksum) { return send_request_for_checksum(h, LINK_CONFIRM, checksum); }
bool device_erase_image(LinkHost *h, uint32_t checksum) { return send_request_for_checksum(h, LINK_ERASE, checksum); }

// Asks the board which pin of its chip a pin of an image uses.  kind, number: see SmvmPhysicalPin.
bool device_find_chip_pin(LinkHost *h, uint8_t kind, uint16_t number, uint8_t *chip_pin)
{
    uint8_t body[3] = {kind, 0, 0};

    sm_link_store(body + 1, number, 2);
    if (!send_request(h, LINK_PIN, body, sizeof body, 1))
        return false;
    *chip_pin = h->body[0];
    return true;
}

// Whether the host can use the board's protocol version and sizes.
bool device_is_usable(const DeviceInfo *i)
{
    return i->protocol == LINK_PROTOCOL && i->block > 0 && i->body <= LINK_BODY_MAX && i->block + 5u <= i->body && i->slots >= 1 && i->slots <= 2;
}

// A board can restart before its answer is sent.  So a missing answer to RESTART is no failure if the board then answers HELLO.
bool device_restart(LinkHost *h, DeviceInfo *info)
{
    const unsigned tries = h->tries;
    bool refused;

    h->tries = 1;
    refused = link_request(h, LINK_RESTART, NULL, 0) && h->result != SM_OK;
    h->tries = tries;
    return !refused && device_query_info(h, info) && device_is_usable(info);
}

// ---- an update ----

// Sends a request whose body is the session number.
static bool request_in_session(LinkHost *h, const Update *u, LinkMessage message)
{
    uint8_t body[2];

    sm_link_store(body, u->session, 2);
    return send_request(h, message, body, sizeof body, 0);
}

// Asks the board to prepare a slot for the image.
static bool send_begin(LinkHost *h, const Update *u)
{
    uint8_t body[BEGIN_HEAD + DEVICE_PERMIT];

    sm_link_store(body, u->session, 2);
    sm_link_store(body + 2, u->length, 3);
    sm_link_store(body + 5, u->checksum, 4);
    if (u->permit)
        memcpy(body + BEGIN_HEAD, u->permit, DEVICE_PERMIT);
    return send_request(h, LINK_BEGIN, body, u->permit ? sizeof body : BEGIN_HEAD, 0);
}

// Sends the image in blocks.
static bool send_data(LinkHost *h, const DeviceInfo *info, Update *u)
{
    uint8_t body[LINK_BODY_MAX];

    for (uint32_t at = 0; at < u->length;) {
        const uint32_t n = u->length - at < info->block ? u->length - at : info->block;
        sm_link_store(body, u->session, 2);
        sm_link_store(body + 2, at, 3);
        memcpy(body + DATA_HEAD, u->bytes + at, n);
        if (!send_request(h, LINK_DATA, body, DATA_HEAD + n, 0))
            return false;
        at += n;
        if (u->progress)
            u->progress(u->context, at);
    }
    return true;
}

// Asks the board to verify the image.  Stores the rule that its verifier reports as broken.
static bool send_end(LinkHost *h, Update *u)
{
    const bool ok = request_in_session(h, u, LINK_END);

    u->rule = h->answered && h->n >= 4 ? h->body[0] : 0;
    u->at = h->answered && h->n >= 4 ? sm_link_load(h->body + 1, 3) : 0;
    return ok;
}

// Whether the slot contains the image, byte by byte.  Sets h->result to SM_E_DEVICE if not.
static bool slot_has_same_bytes(LinkHost *h, const DeviceInfo *info, const Update *u, uint8_t slot)
{
    for (uint32_t at = 0; at < u->length;) {
        const uint32_t most = info->body - 1u, n = u->length - at < most ? u->length - at : most;
        uint8_t body[5] = {slot, 0, 0, 0, (uint8_t)n};
        sm_link_store(body + 1, at, 3);
        if (!send_request(h, LINK_READ, body, sizeof body, n))
            return false;
        if (h->n != n || memcmp(h->body, u->bytes + at, n) != 0) {
            h->result = SM_E_DEVICE;
            return false;
        }
        at += n;
    }
    return true;
}

// Reads n bytes of a slot, from offset `at`.
static bool read_slot(LinkHost *h, const DeviceInfo *info, uint8_t slot, uint32_t at, uint8_t *bytes, uint32_t n)
{
    const uint32_t most = info->body - 1u;

    for (uint32_t done = 0; done < n;) {
        const uint32_t part = n - done < most ? n - done : most;
        uint8_t body[5] = {slot, 0, 0, 0, (uint8_t)part};
        sm_link_store(body + 1, at + done, 3);
        if (!send_request(h, LINK_READ, body, sizeof body, part))
            return false;
        memcpy(bytes + done, h->body, part);
        done += part;
    }
    return true;
}

bool device_read_image(LinkHost *h, const DeviceInfo *info, const DeviceImage *image, uint8_t *bytes)
{
    return read_slot(h, info, image->slot, 0, bytes, image->length);
}

// Sorts records from the oldest to the newest.  No two have the same number.
static void sort_transitions(LinkTransition *t, size_t n)
{
    for (size_t i = 1; i < n; i++)
        for (size_t k = i; k > 0 && sm_link_is_later(t[k - 1].number, t[k].number); k--) {
            const LinkTransition swap = t[k];
            t[k] = t[k - 1];
            t[k - 1] = swap;
        }
}

// Reads the transitions that the board has stored in the slot of this image, the oldest first; *n: their number.
bool device_read_transitions(LinkHost *h, const DeviceInfo *info, const DeviceImage *image, LinkTransition *out, size_t *n)
{
    uint8_t bytes[LINK_TRANSITIONS * LINK_TRANSITION];
    const uint32_t room = image->state == DEVICE_EMPTY || image->length > info->slot_size ? 0 : (info->slot_size - image->length) / LINK_TRANSITION;
    const uint32_t records = room < LINK_TRANSITIONS ? room : LINK_TRANSITIONS;

    *n = 0;
    if (!read_slot(h, info, image->slot, image->length, bytes, records * LINK_TRANSITION))
        return false;
    for (uint32_t i = 0; i < records; i++)
        *n += sm_link_load_transition(bytes + i * LINK_TRANSITION, image->checksum, &out[*n]);
    sort_transitions(out, *n);
    return true;
}

// Finds the slot with the image that was sent, and compares its contents.  Skips the slot of the running image, which an update never overwrites.
static bool verify_slot(LinkHost *h, const DeviceInfo *info, const Update *u)
{
    DeviceImage image;

    for (uint8_t slot = 0; slot < info->slots; slot++) {
        if (!device_read_image_info(h, slot, &image))
            return false;
        if (!image.runs && image.state != DEVICE_EMPTY && image.length == u->length && image.checksum == u->checksum)
            return slot_has_same_bytes(h, info, u, slot);
    }
    h->result = SM_E_DEVICE;
    return false;
}

// Asks the board to run the image from its next start on.
static bool send_activate(LinkHost *h, const Update *u)
{
    uint8_t body[4];

    sm_link_store(body, u->session, 2);
    sm_link_store(body + 2, u->period, 2);
    return send_request(h, LINK_ACTIVATE, body, sizeof body, 0);
}

// Sends the image, has the board verify it, reads it back and activates it.  Returns DEVICE_DONE or the step that failed.
static DeviceStep send_image(LinkHost *h, const DeviceInfo *info, Update *u)
{
    if (!send_begin(h, u))
        return DEVICE_BEGIN;
    if (!send_data(h, info, u))
        return DEVICE_DATA;
    if (!send_end(h, u))
        return DEVICE_END;
    if (!verify_slot(h, info, u))
        return DEVICE_READ;
    return send_activate(h, u) ? DEVICE_DONE : DEVICE_ACTIVATE;
}

// Finds whether the image is the one that the next start runs (chosen), and whether it also runs now.  Returns false if a request failed.
static bool find_status_of_image(LinkHost *h, const DeviceInfo *info, const Update *u, bool *chosen, bool *runs)
{
    DeviceImage image;

    *chosen = *runs = false;
    for (uint8_t slot = 0; slot < info->slots; slot++) {
        if (!device_read_image_info(h, slot, &image))
            return false;
        if (image.state != DEVICE_EMPTY && image.length == u->length && image.checksum == u->checksum && image.period == u->period) {
            *chosen |= image.chosen;
            *runs |= image.runs && image.chosen;
        }
    }
    return true;
}

// Sends the image unless it is already chosen.  A board that restarted unexpectedly has lost the session and answers SM_E_HANDLE; the update then
// starts again.
static DeviceStep send_image_with_retries(LinkHost *h, const DeviceInfo *info, Update *u, bool *runs)
{
    DeviceStep step = DEVICE_FIND;
    bool chosen;

    for (unsigned i = 0; i < RESTARTS_MAX; i++) {
        if (!find_status_of_image(h, info, u, &chosen, runs))
            return DEVICE_FIND;
        if (chosen)
            return DEVICE_DONE;
        step = send_image(h, info, u);
        if (step == DEVICE_DONE || !h->answered || h->result != SM_E_HANDLE)
            return step;
    }
    return step;
}

// Updates the board: sends the image, chooses it, restarts the board and checks that it runs.  Returns DEVICE_DONE, else the step that
// failed.
DeviceStep device_update(LinkHost *h, DeviceInfo *info, Update *u)
{
    bool chosen, runs;
    DeviceStep step;

    u->rule = 0;
    step = send_image_with_retries(h, info, u, &runs);
    u->was_running = step == DEVICE_DONE && runs;
    if (step != DEVICE_DONE || runs)
        return step;
    for (unsigned i = 0; i < RESTARTS_MAX; i++) {
        if (!device_restart(h, info))
            return DEVICE_RESTART;
        if (!find_status_of_image(h, info, u, &chosen, &runs))
            return DEVICE_RUN;
        if (runs)
            return DEVICE_DONE;
        if (!chosen)
            break;                         // the board has fallen back to another image
    }
    return DEVICE_RUN;
}
