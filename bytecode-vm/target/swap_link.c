// SPDX-License-Identifier: Apache-2.0
// Answers requests of hosts to an application (swap_link.h).  swap_serve.c has the connections.
//
// Requests can arrive twice, from several hosts, and in any order.  One transfer exists at a time.  It is identified by session, length and
// checksum, and another one can begin if it has been silent for SILENCE, or has become a swap.
#include "bytecode-vm/target/swap_link.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "bytecode-vm/permit.h"
#include "bytecode-vm/target/swap_numbers.h"
#include "runtime-c/pal/clock.h"
#include "stdlib/crc32.h"

#define SILENCE (3 * (uint64_t)PAL_SECOND)

// Sizes in bytes: the body of DATA before its payload; an event; offsets in the frame of an answer.
enum { DATA_HEAD = 5, EVENT = 19, RESULT_AT = 1 + LINK_HEAD, ANSWER_AT = RESULT_AT + 1, BODY_ROOM = LINK_BODY_MAX - 1 };

// A request and its answer.
typedef struct LinkExchange {
    SmSwapLink *link;
    const uint8_t *body;
    uint16_t n;               // number of bytes of `body`
    uint8_t *answer;          // where the answer's body is written, after the result
    uint16_t length;          // number of bytes in `answer`
} LinkExchange;

static void put_uint(LinkExchange *x, uint32_t value, uint8_t bytes)
{
    sm_link_store(x->answer + x->length, value, bytes);
    x->length = (uint16_t)(x->length + bytes);
}

// Appends a text, cut off at the end of the answer or after `most` bytes.
static void put_text(LinkExchange *x, const char *text, size_t most)
{
    for (size_t i = 0; i < most && text[i] != '\0' && x->length < BODY_ROOM; i++)
        x->answer[x->length++] = (uint8_t)text[i];
}

// ---- queries ----

static SmResult answer_app(LinkExchange *x)
{
    const SmSwapLink *l = x->link;

    put_uint(x, LINK_PROTOCOL, 1);
    put_uint(x, LINK_BODY_MAX, 1);
    put_uint(x, LINK_BODY_MAX - DATA_HEAD, 1);
    put_uint(x, l->machines, 2);
    put_uint(x, l->room, 4);
    put_uint(x, l->key_file != NULL, 1);
    put_uint(x, l->key_file ? smvm_auth_mark(l->key) : 0, 4);
    put_uint(x, l->newest, 4);
    put_text(x, l->app_name, LINK_BODY_MAX);
    return SM_OK;
}

// Returns the index of machine m in the list of machines that can be swapped; s->machines if m cannot be swapped.
static uint16_t find_swappable(const SmSwaps *s, const SmMachine *m)
{
    uint16_t i = 0;

    while (i < s->machines && s->machine[i].machine != m)
        i++;
    return i;
}

// Appends the identity of an image; zeros if the image has no identity.
static void put_identity(LinkExchange *x, const SmvmSlot *slot)
{
    SmvmReader r;
    const bool found = smvm_find_section(slot->target.image, SMVM_S_IDENTITY, &r) && (SmvmAt)(r.end - r.at) == 8;

    for (uint8_t i = 0; i < 8; i++)
        put_uint(x, found ? smvm_u8(slot->target.image, (SmvmAt)(r.at + i)) : 0, 1);
}

static SmResult answer_machine(LinkExchange *x)
{
    const SmSwapLink *l = x->link;
    const uint32_t which = sm_link_load(x->body, 2);
    const SmMachine *m = which < l->machines ? &l->machine[which] : NULL;
    SmSwapMachineState state;
    SmResult r;

    if (!m)
        return SM_E_MISSING;
    r = sm_swap_machine(l->swaps, find_swappable(l->swaps, m), &state);
    if (r != SM_OK && r != SM_E_MISSING)
        return r;
    if (r == SM_OK) {
        put_uint(x, LINK_SWAPPABLE | (state.is_on_trial ? LINK_ON_TRIAL : 0) | (state.is_built_in ? LINK_BUILT_IN : 0)
                 | (state.is_stored ? LINK_STORED : 0), 1);
        put_uint(x, state.identity, 4);
        put_identity(x, state.slot);
        put_uint(x, state.state, 4);
    } else {
        memset(x->answer, 0, 17);
        x->length = 17;
    }
    put_uint(x, 0, 1);
    put_text(x, m->name, SM_SWAP_NAME);
    x->answer[17] = (uint8_t)(x->length - 18);
    if (r == SM_OK)
        put_text(x, m->type->state_name(state.slot, state.state), LINK_BODY_MAX);
    return SM_OK;
}

// Stores the status of the last swap, and whether it came over the link.
static SmResult read_status(const SmSwapLink *l, SmSwapStatus *s, bool *is_mine)
{
    const SmResult r = sm_swap_status(l->swaps, s);

    *is_mine = r == SM_OK && l->number != 0 && s->number == l->number;
    return r;
}

// Returns the index among all machines of the machine that was refused; 0xffff if the application has no such machine.
static uint16_t refused_machine(const SmSwapLink *l, const SmSwapStatus *s)
{
    const SmSwappable *w = sm_swap_refused_machine(l->swaps, s);

    return w ? (uint16_t)(w->machine - l->machine) : UINT16_MAX;
}

static SmResult answer_swap(LinkExchange *x)
{
    SmSwapStatus s;
    bool is_mine;
    const SmResult r = read_status(x->link, &s, &is_mine);

    if (r != SM_OK)
        return r;
    put_uint(x, is_mine ? x->link->swap_checksum : 0, 4);
    put_uint(x, s.phase, 1);
    put_uint(x, s.reason, 1);
    put_uint(x, s.end, 1);
    put_uint(x, refused_machine(x->link, &s), 2);
    put_uint(x, is_mine ? x->link->swap_number : 0, 4);
    return SM_OK;
}

static SmResult answer_kept(LinkExchange *x)
{
    const SmSwapLink *l = x->link;
    const uint32_t which = sm_link_load(x->body, 2);
    const uint16_t i = which < l->machines ? find_swappable(l->swaps, &l->machine[which]) : l->swaps->machines;
    SmSwapMachineState state;
    SmvmSwapItem item;
    SmResult r = sm_swap_machine(l->swaps, i, &state);

    if (r != SM_OK)
        return r;
    if (!state.newest || !smvm_slot_item(state.newest, sm_link_load(x->body + 2, 4), &item))
        return SM_E_MISSING;
    put_uint(x, item.kind, 1);
    put_uint(x, item.fate, 1);
    for (uint32_t k = 0; k < item.length && x->length < BODY_ROOM; k++)
        x->answer[x->length++] = (uint8_t)item.name[k];
    return SM_OK;
}

static void put_event(LinkExchange *x, const SmEvent *e)
{
    put_uint(x, (uint32_t)e->time, 4);
    put_uint(x, (uint32_t)(e->time >> 32), 4);
    put_uint(x, e->kind, 1);
    put_uint(x, e->source, 2);
    put_uint(x, e->a, 4);
    put_uint(x, e->b, 4);
}

static SmResult answer_events(LinkExchange *x)
{
    uint32_t cursor = sm_link_load(x->body, 4), lost = 0, gone;
    SmEvent e;

    if (!x->link->events)
        return SM_E_UNSUPPORTED;
    x->length = 8;
    while (x->length + EVENT <= BODY_ROOM && sm_events_read(x->link->events, &cursor, &e, 1, &gone) == 1) {
        lost += gone;
        put_event(x, &e);
    }
    sm_link_store(x->answer, cursor, 4);
    sm_link_store(x->answer + 4, lost, 4);
    return SM_OK;
}

// ---- a transfer ----

static bool is_current(const SmSwapLink *l, const uint8_t *body)
{
    return l->transfer != SM_SWAP_NO_TRANSFER && sm_link_load(body, 2) == l->session;
}

// Returns SM_E_BUSY while a swap is in progress. No transfer can begin then: the buffer may be in use, and the swap would be refused.
static SmResult check_no_swap(const SmSwapLink *l)
{
    SmSwapStatus s;
    const SmResult r = sm_swap_status(l->swaps, &s);

    if (r != SM_OK)
        return r;
    return SM_SWAP_IS_IN_PROGRESS(s.phase) ? SM_E_BUSY : SM_OK;
}

static SmResult answer_begin(LinkExchange *x)
{
    SmSwapLink *l = x->link;
    const uint16_t session = (uint16_t)sm_link_load(x->body, 2);
    const uint32_t length = sm_link_load(x->body + 2, 3), checksum = sm_link_load(x->body + 5, 4);
    const uint64_t now = pal_clock_now();
    SmResult r;

    if (is_current(l, x->body) && l->length == length && l->checksum == checksum) {
        l->heard = now;
        return SM_OK;
    }
    if (l->transfer == SM_SWAP_RECEIVING && now - l->heard < SILENCE)
        return SM_E_BUSY;
    if (session == 0 || length == 0)
        return SM_E_ARGUMENT;
    r = l->key_file ? smvm_permit_check(x->body, (uint8_t)x->n, l->newest, l->key) : SM_OK;
    r = r == SM_OK && length > l->room ? SM_E_SPACE : r;
    r = r == SM_OK ? check_no_swap(l) : r;
    if (r != SM_OK)
        return r;
    l->transfer = SM_SWAP_RECEIVING;
    l->session = session;
    l->length = length;
    l->checksum = checksum;
    l->received = 0;
    l->is_number_used = false;
    l->heard = now;
    return SM_OK;
}

// Stores n bytes of the transfer at offset `at`.  Compares them instead if these bytes have been received before.  `received` never exceeds `length`,
// which never exceeds the buffer.
static SmResult store_data(SmSwapLink *l, uint32_t at, const uint8_t *bytes, uint32_t n)
{
    if (at > l->length || n > l->length - at || at > l->received)
        return SM_E_ARGUMENT;
    if (at < l->received)
        return n <= l->received - at && memcmp(l->buffer + at, bytes, n) == 0 ? SM_OK : SM_E_ARGUMENT;
    memcpy(l->buffer + at, bytes, n);
    l->received += n;
    return SM_OK;
}

static SmResult answer_data(LinkExchange *x)
{
    SmSwapLink *l = x->link;
    SmResult r = SM_E_HANDLE;

    if (is_current(l, x->body) && l->transfer == SM_SWAP_RECEIVING) {
        l->heard = pal_clock_now();
        r = store_data(l, sm_link_load(x->body + 2, 3), x->body + DATA_HEAD, (uint32_t)(x->n - DATA_HEAD));
    }
    put_uint(x, l->received, 3);
    return r;
}

// ---- a swap ----

typedef struct SwapReader { uint8_t *at; uint32_t left; } SwapReader;

// Returns the next n bytes; NULL if there are fewer.
static uint8_t *next_bytes(SwapReader *r, uint32_t n)
{
    uint8_t *at = r->at;

    if (n > r->left)
        return NULL;
    r->at += n;
    r->left -= n;
    return at;
}

// Whether the only zero byte of a text is its last one.
static bool is_terminated(const uint8_t *text, uint8_t n)
{
    uint8_t i = 0;

    while (i < n && text[i] != 0)
        i++;
    return i + 1 == n;
}

// Reads a length and a name.  An empty name has no bytes, and sets *name to NULL. Any other name must end with a zero byte and contain no other one.
static bool read_name(SwapReader *r, const char **name)
{
    const uint8_t *n = next_bytes(r, 1), *text = n ? next_bytes(r, *n) : NULL;

    *name = NULL;
    if (!text || *n == 0)
        return text != NULL;
    *name = (const char *)text;
    return *n <= SM_SWAP_NAME && is_terminated(text, *n);
}

static bool read_change(SwapReader *r, SmSwapChange *c)
{
    const uint8_t *mode = next_bytes(r, 1), *size;

    if (!mode || !read_name(r, &c->machine) || !read_name(r, &c->state) || !c->machine)
        return false;
    size = next_bytes(r, 3);
    c->mode = *mode;
    c->size = size ? sm_link_load(size, 3) : 0;
    c->image = size ? next_bytes(r, c->size) : NULL;
    c->built_in = c->size == 0;
    return c->image != NULL;
}

// Reads the changes in `n` bytes of the buffer.  Returns their number; 0 if the bytes are not exactly a swap.
static uint16_t read_changes(const SmSwapLink *l, uint32_t n)
{
    SwapReader r = {l->buffer, n};
    const uint8_t *head = next_bytes(&r, 2);

    if (!head || head[0] != SM_SWAP_VERSION || head[1] == 0 || head[1] > l->swaps->machines)
        return 0;
    for (uint8_t i = 0; i < head[1]; i++)
        if (!read_change(&r, &l->change[i]))
            return 0;
    return r.left == 0 ? head[1] : 0;
}

static bool is_same_code(const uint8_t *a, const uint8_t *b)
{
    uint8_t differs = 0;

    for (uint8_t i = 0; i < SMVM_CODE; i++)
        differs |= (uint8_t)(a[i] ^ b[i]);
    return differs == 0;
}

// Checks the signature of the swap in the buffer and stores its number, which cannot be used again.
static SmResult use_number(SmSwapLink *l)
{
    const uint32_t end = l->length - SMVM_CODE, number = sm_link_load(l->buffer + end - 4, 4);
    uint8_t code[SMVM_CODE];
    SmvmMac m;
    SmResult r;

    if (l->is_number_used)                                // the host repeats END, because the swap could not begin when END first came
        return SM_OK;
    smvm_mac_begin(&m, l->key);
    for (uint32_t i = 0; i < end; i++)
        smvm_mac_byte(&m, l->buffer[i]);
    smvm_mac_end(&m, l->key, code);
    if (!is_same_code(code, l->buffer + end))
        return SM_E_UNSIGNED;
    r = number <= l->newest ? SM_E_REPLAY : sm_swap_store_number(l, number);
    l->is_number_used = r == SM_OK;
    return r;
}

// Begins the swap in the buffer, which is complete.
static SmResult begin_swap(SmSwapLink *l)
{
    const uint32_t signature = l->key_file ? SM_SWAP_SIGNATURE : 0;
    SmSwapStatus s;
    uint16_t n;
    SmResult r;

    if (l->length < signature || sm_crc32(l->buffer, l->length) != l->checksum)
        return SM_E_IMAGE;
    r = check_no_swap(l);
    r = r == SM_OK && l->key_file ? use_number(l) : r;
    n = r == SM_OK ? read_changes(l, l->length - signature) : 0;
    if (r != SM_OK || n == 0)
        return r != SM_OK ? r : SM_E_ARGUMENT;
    r = sm_swap_begin(l->swaps, l->change, n);
    if (r == SM_OK && sm_swap_status(l->swaps, &s) == SM_OK) {
        l->number = s.number;
        l->swap_checksum = l->checksum;
        l->swap_number = l->key_file ? l->newest : 0;
    }
    return r;
}

static SmResult answer_end(LinkExchange *x)
{
    SmSwapLink *l = x->link;
    SmResult r;

    if (!is_current(l, x->body))
        return SM_E_HANDLE;
    if (l->transfer == SM_SWAP_SENT)
        return SM_OK;
    l->heard = pal_clock_now();
    if (l->received < l->length)
        return SM_E_ARGUMENT;
    r = begin_swap(l);
    if (r == SM_OK)
        l->transfer = SM_SWAP_SENT;
    else if (r != SM_E_BUSY)
        l->transfer = SM_SWAP_NO_TRANSFER;
    return r;
}

// Whether the request has the authentication code with which a host confirms the last swap. True without a key.
static bool may_confirm(const LinkExchange *x)
{
    uint8_t code[SMVM_CODE];

    if (!x->link->key_file)
        return true;
    if (x->n < 4 + SMVM_CODE)
        return false;
    smvm_confirm_code(x->link->swap_number, x->link->swap_checksum, x->link->key, code);
    return is_same_code(code, x->body + 4);
}

static SmResult answer_confirm(LinkExchange *x)
{
    SmSwapStatus s;
    bool is_mine;
    const SmResult r = read_status(x->link, &s, &is_mine);
    SmResult confirmed;

    if (r != SM_OK)
        return r;
    if (!is_mine || sm_link_load(x->body, 4) != x->link->swap_checksum)
        return SM_E_HANDLE;
    if (!may_confirm(x))
        return SM_E_UNSIGNED;
    if (s.phase == SM_SWAP_CONFIRMED)
        return SM_OK;
    confirmed = sm_swap_confirm(x->link->swaps);
    if (confirmed == SM_OK && sm_swaps_save(x->link->swaps) != SM_OK)
        return SM_E_DEVICE;
    return confirmed;
}

// ---- refusals ----

// Returns the checksum of the swap that a request names; 0 if it names none.
static uint32_t named_checksum(const LinkExchange *x, uint8_t message)
{
    const SmSwapLink *l = x->link;

    if (message == LINK_BEGIN)
        return sm_link_load(x->body + 5, 4);
    if (message == LINK_CONFIRM)
        return sm_link_load(x->body, 4);
    return is_current(l, x->body) ? l->checksum : 0;
}

// Logs that a request of a swap was refused.  A host that repeats its request, or that sends many, cannot fill the ring of events.
static void log_refusal(LinkExchange *x, uint8_t message, SmResult r)
{
    SmSwapLink *l = x->link;
    const uint64_t now = pal_clock_now();
    const uint32_t bit = UINT32_C(1) << (-r & 31);
    SmEvent e = {l->app ? now - l->app->start : 0, (uint32_t)-r, 0, 0, SM_EVENT_HOST_REFUSED};

    if (now - l->refused_since >= PAL_SECOND) {
        l->refused = 0;
        l->refused_since = now;
    }
    if ((l->refused & bit) != 0)
        return;
    l->refused |= bit;
    e.b = named_checksum(x, message);
    sm_event(l->events, &e);
}

// ---- dispatch ----

static const struct { uint8_t message, min_body; SmResult (*run)(LinkExchange *x); bool is_logged; } handlers[] = {
    {LINK_APP, 0, answer_app, false},
    {LINK_MACHINE, 2, answer_machine, false},
    {LINK_SWAP, 0, answer_swap, false},
    {LINK_KEPT, 6, answer_kept, false},
    {LINK_BEGIN, SMVM_PERMIT_AT, answer_begin, true},
    {LINK_DATA, DATA_HEAD + 1, answer_data, false},
    {LINK_END, 2, answer_end, true},
    {LINK_CONFIRM, 4, answer_confirm, true},
    {LINK_EVENTS, 4, answer_events, false},
};

static SmResult run_row(LinkExchange *x, size_t row)
{
    SmResult r;

    if (x->n < handlers[row].min_body)
        return SM_E_ARGUMENT;
    r = handlers[row].run(x);
    if (r != SM_OK && handlers[row].is_logged)
        log_refusal(x, handlers[row].message, r);
    return r;
}

static SmResult run_handler(LinkExchange *x, uint8_t message)
{
    for (size_t i = 0; i < sizeof handlers / sizeof *handlers; i++)
        if (handlers[i].message == message)
            return run_row(x, i);
    return SM_E_UNSUPPORTED;
}

uint16_t sm_swap_link_answer(SmSwapLink *l, const uint8_t *request, uint16_t n, uint8_t *answer)
{
    LinkExchange x = {l, request + LINK_HEAD, 0, answer + ANSWER_AT, 0};
    SmResult r;

    if (n < LINK_HEAD || n > LINK_HEAD + LINK_BODY_MAX || (request[1] & LINK_ANSWER) != 0)
        return 0;
    x.n = (uint16_t)(n - LINK_HEAD);
    answer[1] = request[0];
    answer[2] = (uint8_t)(request[1] | LINK_ANSWER);
    r = run_handler(&x, request[1]);
    answer[RESULT_AT] = (uint8_t)r;
    return sm_link_encode(answer, (uint16_t)(LINK_HEAD + 1 + x.length));
}
