// SPDX-License-Identifier: Apache-2.0
#include "compiler/device/app_host.h"

#include <string.h>

#include "bytecode-vm/permit.h"
#include "stdlib/crc32.h"

// After SM_E_BUSY from END, the events of the last swap are still due: until the next tick.  END is sent again BUSY_TRIES times, by line->receive
// with a wait of BUSY_WAIT milliseconds apart.
enum { BUSY_TRIES = 40, BUSY_WAIT = 25 };

// Sends a request with a body of n bytes. Returns whether the application answered SM_OK with at least `least` bytes; fewer set h->result to
// SM_E_SIZE.
static bool request_answer(LinkHost *h, LinkMessage message, const uint8_t *body, size_t n, size_t least)
{
    if (!link_request(h, message, body, n) || h->result != SM_OK)
        return false;
    if (h->n < least)
        h->result = SM_E_SIZE;
    return h->n >= least;
}

// Copies a text of n bytes from an answer.  Bytes that no terminal should receive become '?'.
static void copy_text(char *out, size_t room, const uint8_t *text, size_t n)
{
    size_t i = 0;

    for (; i < n && i + 1 < room; i++)
        out[i] = text[i] < 0x20 || text[i] >= 0x7f ? '?' : (char)text[i];
    out[i] = '\0';
}

bool application_query(LinkHost *h, ApplicationInfo *info)
{
    const uint8_t *b;

    memset(info, 0, sizeof *info);
    if (!request_answer(h, LINK_APP, NULL, 0, 18))
        return false;
    b = h->body;
    info->protocol = b[0];
    info->body = b[1];
    info->block = b[2];
    info->machines = (uint16_t)sm_link_load(b + 3, 2);
    info->room = sm_link_load(b + 5, 4);
    info->requires_signature = b[9] != 0;
    info->mark = sm_link_load(b + 10, 4);
    info->newest = sm_link_load(b + 14, 4);
    copy_text(info->name, sizeof info->name, b + 18, h->n - 18);
    return true;
}

bool application_read_machine(LinkHost *h, uint16_t machine, ApplicationMachine *out)
{
    uint8_t body[2];
    const uint8_t *b;

    memset(out, 0, sizeof *out);
    sm_link_store(body, machine, 2);
    if (!request_answer(h, LINK_MACHINE, body, sizeof body, 18))
        return false;
    b = h->body;
    if (h->n < 18u + b[17]) {
        h->result = SM_E_SIZE;
        return false;
    }
    out->can_swap = (b[0] & LINK_SWAPPABLE) != 0;
    out->is_on_trial = (b[0] & LINK_ON_TRIAL) != 0;
    out->is_built_in = (b[0] & LINK_BUILT_IN) != 0;
    out->is_stored = (b[0] & LINK_STORED) != 0;
    out->checksum = sm_link_load(b + 1, 4);
    memcpy(out->identity, b + 5, sizeof out->identity);
    out->state = sm_link_load(b + 13, 4);
    copy_text(out->name, sizeof out->name, b + 18, b[17]);
    copy_text(out->state_name, sizeof out->state_name, b + 18 + b[17], h->n - 18u - b[17]);
    return true;
}

bool application_read_swap(LinkHost *h, ApplicationSwap *out)
{
    memset(out, 0, sizeof *out);
    if (!request_answer(h, LINK_SWAP, NULL, 0, 13))
        return false;
    out->checksum = sm_link_load(h->body, 4);
    out->phase = h->body[4];
    out->reason = h->body[5];
    out->end = h->body[6];
    out->machine = (uint16_t)sm_link_load(h->body + 7, 2);
    out->number = sm_link_load(h->body + 9, 4);
    return true;
}

// Reads what a swap did with a state, local or window of a machine. `item`: its index.
bool application_read_item(LinkHost *h, uint16_t machine, uint32_t item, ApplicationItem *out)
{
    uint8_t body[6];

    sm_link_store(body, machine, 2);
    sm_link_store(body + 2, item, 4);
    if (!request_answer(h, LINK_KEPT, body, sizeof body, 2))
        return false;
    out->kind = h->body[0];
    out->fate = h->body[1];
    copy_text(out->name, sizeof out->name, h->body + 2, h->n - 2);
    return true;
}

// Confirms a swap on trial. `key`: signs the confirmation; NULL if the application requires no signature.
bool application_confirm(LinkHost *h, const ApplicationSwap *swap, const uint8_t *key)
{
    uint8_t body[4 + SMVM_CODE];

    sm_link_store(body, swap->checksum, 4);
    if (key)
        smvm_confirm_code(swap->number, swap->checksum, key, body + 4);
    return request_answer(h, LINK_CONFIRM, body, key ? sizeof body : 4, 0);
}

const char *application_reason_text(uint8_t reason)
{
    switch (reason) {
#define SM_SWAP(name, number, text) case number: return text;
#include "runtime-c/swaps.def"
#undef SM_SWAP
    default: return "for a reason that this smc does not know";
    }
}

// ---- a swap ----

uint32_t application_swap_checksum(const Buf *swap) { return sm_crc32(swap->at, swap->n); }

static void append_uint(Buf *out, uint32_t value, int bytes)
{
    for (; bytes > 0; bytes--, value >>= 8)
        buf_char(out, (char)value);
}

// Appends a name with its final NUL, after a byte with their length.
static void append_name(Buf *out, const char *name)
{
    const size_t n = name ? strlen(name) + 1 : 0;

    append_uint(out, (uint32_t)n, 1);
    buf_put(out, name ? name : "", n);
}

// Appends the bytes of a swap of n machines, signed with `key` and `number` if key is not NULL.
void application_write_swap(const ApplicationChange *change, size_t n, const uint8_t *key, uint32_t number, Buf *out)
{
    uint8_t code[SMVM_CODE];
    SmvmMac m;

    append_uint(out, SM_SWAP_VERSION, 1);
    append_uint(out, (uint32_t)n, 1);
    for (size_t i = 0; i < n; i++) {
        append_uint(out, change[i].mode, 1);
        append_name(out, change[i].machine);
        append_name(out, change[i].state);
        append_uint(out, change[i].size, 3);
        buf_put(out, (const char *)change[i].image, change[i].size);
    }
    if (!key)
        return;
    append_uint(out, number, 4);
    smvm_mac_begin(&m, key);
    for (size_t i = 0; i < out->n; i++)
        smvm_mac_byte(&m, (uint8_t)out->at[i]);
    smvm_mac_end(&m, key, code);
    buf_put(out, (const char *)code, sizeof code);
}

// Announces a swap of swap->n bytes. With `key`, adds the permit that an application that accepts signed swaps only requires.
static bool send_begin(LinkHost *h, const Buf *swap, const uint8_t *key, uint32_t number, uint16_t session)
{
    uint8_t body[SMVM_PERMIT_AT + SMVM_PERMIT];

    sm_link_store(body, session, 2);
    sm_link_store(body + 2, (uint32_t)swap->n, 3);
    sm_link_store(body + 5, application_swap_checksum(swap), 4);
    sm_link_store(body + SMVM_PERMIT_AT, number, 4);
    if (key)
        smvm_permit_code(number, (uint32_t)swap->n, key, body + SMVM_PERMIT_AT + 4);
    return request_answer(h, LINK_BEGIN, body, key ? sizeof body : SMVM_PERMIT_AT, 0);
}

// Sends the swap in blocks of the size that the application accepts.
static bool send_data(LinkHost *h, const ApplicationInfo *info, const Buf *swap, uint16_t session)
{
    uint8_t body[LINK_BODY_MAX];
    const uint32_t block = info->block < sizeof body - 5 ? info->block : sizeof body - 5;

    for (uint32_t at = 0; at < swap->n; at += block) {
        const uint32_t n = swap->n - at < block ? (uint32_t)swap->n - at : block;
        sm_link_store(body, session, 2);
        sm_link_store(body + 2, at, 3);
        memcpy(body + 5, swap->at + at, n);
        if (!request_answer(h, LINK_DATA, body, 5 + n, 0))
            return false;
    }
    return true;
}

// Waits `wait` milliseconds, and drops what arrives meanwhile.
static void pause_for(LinkHost *h, uint32_t wait)
{
    const uint32_t start = h->line->now(h->line->context);
    uint8_t byte;

    while (h->line->now(h->line->context) - start < wait && h->line->receive(h->line->context, &byte, 1, wait) >= 0) {}
}

ApplicationStep application_send_swap(LinkHost *h, const ApplicationInfo *info, const Buf *swap, const uint8_t *key, uint32_t number,
                                      uint16_t session)
{
    uint8_t body[2];
    bool begun;

    sm_link_store(body, session, 2);
    if (!send_begin(h, swap, key, number, session))
        return APPLICATION_BEGIN;
    if (info->block == 0 || !send_data(h, info, swap, session))
        return APPLICATION_DATA;
    begun = request_answer(h, LINK_END, body, sizeof body, 0);
    for (int i = 0; i < BUSY_TRIES && !begun && h->answered && h->result == SM_E_BUSY; i++) {
        pause_for(h, BUSY_WAIT);
        begun = request_answer(h, LINK_END, body, sizeof body, 0);
    }
    return begun ? APPLICATION_DONE : APPLICATION_END;
}
