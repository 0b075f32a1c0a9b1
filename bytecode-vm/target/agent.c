// SPDX-License-Identifier: Apache-2.0
// Handles requests, one function for each message of the link protocol (runtime-c/link/link.def).  Request and answer share one buffer: a
// handler must read the request before it writes the answer over it.
#include "bytecode-vm/target/agent.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "stdlib/flash.h"

// Sizes in bytes: DATA_HEAD, the body of DATA before its payload; EVENT, an event; IMAGE, the body of the answer to IMAGE.  Offsets in the
// frame: RESULT_AT, the result; ANSWER_AT, the rest of the answer.
enum { DATA_HEAD = 5, EVENT = 19, IMAGE = 20, RESULT_AT = 1 + LINK_HEAD, ANSWER_AT = RESULT_AT + 1 };

void smvm_agent_init(Agent *a, Store *store, const AgentBoard *board, SmEvents *events, uint8_t *frame, uint8_t body)
{
    memset(a, 0, sizeof *a);
    a->store = store;
    a->board = board;
    a->events = events;
    a->frame = frame;
    a->body = body > LINK_BODY_MAX ? LINK_BODY_MAX : body;
    a->block = (uint8_t)((unsigned)(a->body - DATA_HEAD) & ~(store->write - 1u));
    sm_link_receiver_init(&a->in, frame + 1, (uint16_t)(LINK_HEAD + a->body + LINK_TAIL));
}

// These return the body of the request, and the body of its answer after the result.  The two overlap.
static const uint8_t *body_of(const Agent *a) { return a->frame + RESULT_AT; }
static uint8_t *answer_of(const Agent *a) { return a->frame + ANSWER_AT; }

// put_u8 and the other put_ functions append to the answer.
static void put_u8(Agent *a, uint8_t value) { a->frame[ANSWER_AT + a->length++] = value; }

// Appends the low `bytes` bytes of a value to the answer, low byte first.
static void put_uint(Agent *a, uint32_t value, uint8_t bytes)
{
    for (; bytes > 0; bytes--, value >>= 8)
        put_u8(a, (uint8_t)value);
}

// ---- queries ----

static SmResult answer_hello(Agent *a)
{
    const AgentBoard *board = a->board;

    put_u8(a, LINK_PROTOCOL);
    put_u8(a, a->body);
    put_u8(a, a->block);
    put_u8(a, a->store->plan.slots);
    put_uint(a, a->store->slot_size, 3);
    put_uint(a, board->ram, 3);
    put_uint(a, board->longest_step, 4);
    put_u8(a, (uint8_t)board->may_update(board->context));
    put_u8(a, smvm_store_has_key(a->store));
    put_uint(a, sm_link_load(a->store->choice.newest, 4), 4);
    put_u8(a, (uint8_t)(board->machines | board->abilities));
    put_u8(a, board->ram_digital);
    put_u8(a, board->ram_analog);
    put_uint(a, board->period, 2);
    put_uint(a, board->cycles, 2);
    put_uint(a, smvm_store_has_key(a->store) ? board->mark : 0, 4);
    put_uint(a, board->functions, 4);
    return SM_OK;
}

SMVM_NOINLINE static SmvmBytes image_of_slot(const Agent *a, uint8_t slot)
{
    return slot == STORE_BUILT_IN ? a->board->built_in : a->store->plan.image[slot];
}

// Appends n bytes of an image to the answer.
static void put_bytes(Agent *a, SmvmBytes image, SmvmAt at, uint8_t n)
{
    while (n-- > 0)
        put_u8(a, smvm_u8(image, at++));
}

// Appends the length, checksum and identity of an image.  Without an identity, the zeros already in the answer remain.
static void put_image(Agent *a, SmvmBytes image)
{
    SmvmReader identity;

    put_bytes(a, image, SMVM_LENGTH_AT, 3);
    put_bytes(a, image, SMVM_CRC_AT, 4);
    if (smvm_find_section(image, SMVM_S_IDENTITY, &identity) && (SmvmAt)(identity.end - identity.at) == 8)
        put_bytes(a, image, identity.at, 8);
}

static StoreState slot_state(const Agent *a, uint8_t slot)
{
    if (slot != STORE_BUILT_IN)
        return smvm_store_state(a->store, slot);
    return a->board->built_in_size == 0 ? STORE_EMPTY : a->store->choice.active == slot ? STORE_CONFIRMED : STORE_INTACT;
}

static bool is_slot(const Agent *a, uint8_t slot) { return slot < a->store->plan.slots || slot == STORE_BUILT_IN; }

static SmResult answer_image(Agent *a)
{
    const Store *s = a->store;
    const uint8_t slot = body_of(a)[0];
    StoreState state;

    if (!is_slot(a, slot))
        return SM_E_MISSING;
    state = slot_state(a, slot);
    memset(answer_of(a), 0, IMAGE);
    put_u8(a, (uint8_t)state);
    if (state != STORE_EMPTY)
        put_image(a, image_of_slot(a, slot));
    a->length = IMAGE - 4;
    put_u8(a, (uint8_t)((slot == s->running ? 1 : 0) | (state >= STORE_TRIAL ? 2 : smvm_store_flags(s, slot))));
    put_u8(a, state == STORE_TRIAL ? s->choice.tries / STORE_START : 0);
    put_uint(a, smvm_store_period(s, slot), 2);
    return SM_OK;
}

static SmResult answer_pin(Agent *a)
{
    const uint8_t kind = body_of(a)[0];

    if (!a->board->physical_pin)
        return SM_E_UNSUPPORTED;
    put_u8(a, a->board->physical_pin((uint16_t)sm_link_load(body_of(a) + 1, 2), kind));
    return SM_OK;
}

// ---- an update ----

static uint16_t read_session(const Agent *a) { return (uint16_t)sm_link_load(body_of(a), 2); }

static SmResult answer_begin(Agent *a)
{
    const uint16_t session = read_session(a);
    Store *const s = a->store;
    SmvmAt length;
    SmResult r = session == 0 ? SM_E_ARGUMENT : smvm_load_offset(body_of(a) + 2, &length) ? smvm_store_may_begin(s, length) : SM_E_SPACE;

    if (r == SM_OK && s->plan.slots == 1 && s->running != STORE_BUILT_IN) {
        if ((r = a->board->leave_slot(a->board->context, body_of(a), a->n)) != SM_OK)
            return r;                  // a rejected update must not stop the running image
        smvm_store_run_built_in(s);
    }
    return r != SM_OK ? r : smvm_store_begin(s, session, length, sm_link_load(body_of(a) + 5, 4));
}

static SmResult answer_data(Agent *a)
{
    Store *s = a->store;
    const uint8_t n = (uint8_t)(a->n - DATA_HEAD);
    SmvmAt at;
    const SmResult r = smvm_load_offset(body_of(a) + 2, &at) ? smvm_store_write(s, read_session(a), at, body_of(a) + DATA_HEAD, n) : SM_E_ARGUMENT;

    put_uint(a, s->next, 3);
    return r;
}

static SmResult answer_end(Agent *a)
{
    SmvmVerdict why;
    SmResult r = smvm_store_end(a->store, read_session(a), &why);

    if (r == SM_OK) {
        r = SMVM_LONGEST && a->board->longest_step != 0 && why.longest > a->board->longest_step
                ? SM_E_SIZE : a->board->fits(a->board->context, a->store->plan.image[a->store->target]);
        a->store->is_accepted = r == SM_OK;
    } else if (why.rule != 0) {
        r = SM_E_IMAGE;
    }
    put_u8(a, why.rule);
    put_uint(a, why.at, 3);
    return r;
}

static SmResult answer_activate(Agent *a)
{
    return smvm_store_activate(a->store, read_session(a), a->n < 4 ? 0 : (uint16_t)sm_link_load(body_of(a) + 2, 2));
}

static SmResult answer_confirm(Agent *a) { return smvm_store_confirm(a->store, sm_link_load(body_of(a), 4)); }
static SmResult answer_erase(Agent *a) { return smvm_store_erase(a->store, sm_link_load(body_of(a), 4)); }

static SmResult answer_read(Agent *a)
{
    const uint8_t slot = body_of(a)[0], n = body_of(a)[4];
    const SmvmAt size = slot == STORE_BUILT_IN ? (SmvmAt)a->board->built_in_size : a->store->slot_size;
    SmvmAt at;

    if (!is_slot(a, slot))
        return SM_E_MISSING;
    if (!smvm_load_offset(body_of(a) + 1, &at) || n > a->body - 1 || at > size || n > size - at)
        return SM_E_ARGUMENT;
    put_bytes(a, image_of_slot(a, slot), at, n);
    return SM_OK;
}

static SmResult answer_restart(Agent *a)
{
    a->restart = true;
    return SM_OK;
}

// ---- events ----

// The fields of an event in the order of transmission.
static const struct EventField { uint8_t at, bytes; } event_fields[] SM_FLASH = {
    {offsetof(SmEvent, time), 8}, {offsetof(SmEvent, kind), 1}, {offsetof(SmEvent, source), 2}, {offsetof(SmEvent, a), 4}, {offsetof(SmEvent, b), 4},
};

static void put_event(Agent *a, const uint8_t *event)
{
    for (uint8_t i = 0; i < sizeof event_fields / sizeof *event_fields; i++) {
        struct EventField f;
        sm_flash_read(&f, &event_fields[i], sizeof f);
        for (uint8_t b = 0; b < f.bytes; b++)
            put_u8(a, event[f.at + sm_roll_byte(b, f.bytes)]);
    }
}

static SmResult answer_events(Agent *a)
{
    uint32_t cursor = sm_link_load(body_of(a), 4), lost = 0, gone;
    SmEvent e;

    if (!a->events)
        return SM_E_UNSUPPORTED;
    a->length = 8;
    while (a->length + EVENT < a->body && sm_events_read(a->events, &cursor, &e, 1, &gone) == 1) {
        lost += gone;
        put_event(a, (const uint8_t *)&e);
    }
    sm_link_store(answer_of(a), cursor, 4);
    sm_link_store(answer_of(a) + 4, lost, 4);
    return SM_OK;
}

// ---- dispatch ----

typedef struct AgentHandler {
    uint8_t message;
    uint8_t min_body;         // bytes of the shortest valid body of the request
    bool guarded;             // the request changes the board or keeps it busy: allowed only while may_update returns SM_OK
    SmResult (*run)(Agent *a);
} AgentHandler;

static const AgentHandler handlers[] SM_FLASH = {
    {LINK_HELLO, 0, false, answer_hello},       {LINK_IMAGE, 1, false, answer_image},           {LINK_PIN, 3, false, answer_pin},
    {LINK_BEGIN, 9, true, answer_begin},        {LINK_DATA, DATA_HEAD + 1, true, answer_data},  {LINK_END, 2, true, answer_end},
    {LINK_ACTIVATE, 2, true, answer_activate},  {LINK_CONFIRM, 4, true, answer_confirm},        {LINK_ERASE, 4, true, answer_erase},
    {LINK_READ, 5, false, answer_read},         {LINK_RESTART, 0, true, answer_restart},        {LINK_EVENTS, 4, false, answer_events},
};

// Runs the handler of a request, after checking that the board permits updates (if the handler requires that) and the body's length.
static SmResult run_handler(const AgentHandler *h, Agent *a)
{
    const AgentBoard *board = a->board;
    const SmResult may = h->guarded ? board->may_update(board->context) : SM_OK;

    return a->n < h->min_body ? SM_E_ARGUMENT : may != SM_OK ? may : h->run(a);
}

// Runs the handler that the table lists for the message.
static SmResult dispatch_request(Agent *a, uint8_t message)
{
    for (uint8_t i = 0; i < sizeof handlers / sizeof *handlers; i++) {
        AgentHandler h;
        sm_flash_read(&h, &handlers[i], sizeof h);
        if (h.message == message)
            return run_handler(&h, a);
    }
    return SM_E_UNSUPPORTED;
}

// Processes a received byte.  Returns the length of the answer in a->frame, or 0 if no answer is to be sent.
uint16_t smvm_agent_receive(Agent *a, uint8_t byte)
{
    uint8_t *const frame = a->frame;
    uint8_t message;
    SmResult r;

    if (!sm_link_receive(&a->in, byte) || ((message = frame[2]) & LINK_ANSWER) != 0)
        return 0;
    a->n = (uint8_t)(a->in.n - LINK_HEAD);
    a->length = 0;
    r = dispatch_request(a, message);
    frame[2] = (uint8_t)(message | LINK_ANSWER);
    frame[RESULT_AT] = (uint8_t)(int8_t)r;
    return sm_link_encode(frame, (uint16_t)(LINK_HEAD + 1 + a->length));
}
