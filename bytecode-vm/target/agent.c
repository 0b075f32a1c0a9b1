// SPDX-License-Identifier: Apache-2.0
// Requests and their answers, one function per message (runtime-c/link/link.def).  One buffer serves both: a handler has read the request
// before it writes the answer over it.
#include "bytecode-vm/target/agent.h"

#include <string.h>

#include "bytecode-vm/image.h"
#include "stdlib/flash.h"

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

// The body of a request, and that of its answer after the result, which overlaps it.
static const uint8_t *body_of(const Agent *a) { return a->frame + RESULT_AT; }
static uint8_t *answer_of(const Agent *a) { return a->frame + ANSWER_AT; }

static void put1(Agent *a, uint8_t value) { a->frame[ANSWER_AT + a->length++] = value; }

static void put(Agent *a, uint32_t value, uint8_t bytes)
{
    for (; bytes > 0; bytes--, value >>= 8)
        put1(a, (uint8_t)value);
}

// ---- queries ----

static SmResult hello(Agent *a)
{
    const AgentBoard *board = a->board;

    put1(a, LINK_PROTOCOL);
    put1(a, a->body);
    put1(a, a->block);
    put1(a, a->store->plan.slots);
    put(a, a->store->slot_size, 3);
    put(a, board->ram, 3);
    put(a, board->longest_step, 4);
    put1(a, (uint8_t)board->may_update(board->context));
    put1(a, smvm_store_has_key(a->store));
    put(a, sm_link_load(a->store->now.newest, 4), 4);
    put1(a, (uint8_t)(board->machines | (board->windows ? LINK_WINDOWS : 0)));
    put1(a, board->ram_digital);
    put1(a, board->ram_analog);
    put(a, board->period, 2);
    put(a, board->cycles, 2);
    if (smvm_store_has_key(a->store))
        put(a, board->mark, 4);
    return SM_OK;
}

SMVM_NOINLINE static SmvmBytes image_of(const Agent *a, uint8_t slot)
{
    return slot == STORE_BUILT_IN ? a->board->built_in : a->store->plan.image[slot];
}

// Copies bytes of an image.
static void put_bytes(Agent *a, SmvmBytes image, SmvmAt at, uint8_t n)
{
    while (n-- > 0)
        put1(a, smvm_u8(image, at++));
}

// The length, checksum and identity of an image; zeros for a missing identity.
static void put_image(Agent *a, SmvmBytes image)
{
    SmvmReader identity;

    put_bytes(a, image, SMVM_LENGTH_AT, 3);
    put_bytes(a, image, SMVM_CRC_AT, 4);
    if (smvm_find(image, SMVM_S_IDENTITY, &identity) && (SmvmAt)(identity.end - identity.at) == 8)
        put_bytes(a, image, identity.at, 8);
}

static StoreState state_of(const Agent *a, uint8_t slot)
{
    if (slot != STORE_BUILT_IN)
        return smvm_store_state(a->store, slot);
    return a->board->built_in_size == 0 ? STORE_EMPTY : a->store->now.active == slot ? STORE_CONFIRMED : STORE_WHOLE;
}

static bool is_slot(const Agent *a, uint8_t slot) { return slot < a->store->plan.slots || slot == STORE_BUILT_IN; }

static SmResult image(Agent *a)
{
    const Store *s = a->store;
    const uint8_t slot = body_of(a)[0];
    StoreState state;

    if (!is_slot(a, slot))
        return SM_E_MISSING;
    state = state_of(a, slot);
    memset(answer_of(a), 0, IMAGE);
    put1(a, (uint8_t)state);
    if (state != STORE_EMPTY)
        put_image(a, image_of(a, slot));
    a->length = IMAGE - 4;
    put1(a, (uint8_t)((slot == s->running ? 1 : 0) | (state >= STORE_TRIAL ? 2 : smvm_store_is_before(s, slot) ? 4 : 0)));
    put1(a, state == STORE_TRIAL ? s->now.tries : 0);
    put(a, smvm_store_period(s, slot), 2);
    return SM_OK;
}

static SmResult pin(Agent *a)
{
    const uint8_t kind = body_of(a)[0];

    if (!a->board->pin_place)
        return SM_E_UNSUPPORTED;
    put1(a, a->board->pin_place((uint16_t)sm_link_load(body_of(a) + 1, 2), kind));
    return SM_OK;
}

// ---- an update ----

static uint16_t session_of(const Agent *a) { return (uint16_t)sm_link_load(body_of(a), 2); }

static SmResult begin(Agent *a)
{
    SmvmAt length;
    const SmResult r = session_of(a) == 0 ? SM_E_ARGUMENT : smvm_get_at(body_of(a) + 2, &length) ? smvm_store_may_begin(a->store, length) : SM_E_SPACE;

    if (r != SM_OK)
        return r;                      // before a machine is stopped in vain
    if (a->store->plan.slots == 1 && a->store->running != STORE_BUILT_IN) {
        a->board->leave_slot(a->board->context);
        smvm_store_leave(a->store);
    }
    return smvm_store_begin(a->store, session_of(a), length, sm_link_load(body_of(a) + 5, 4));
}

static SmResult data(Agent *a)
{
    Store *s = a->store;
    const uint8_t n = (uint8_t)(a->n - DATA_HEAD);
    SmvmAt at;
    const SmResult r = smvm_get_at(body_of(a) + 2, &at) ? smvm_store_write(s, session_of(a), at, body_of(a) + DATA_HEAD, n) : SM_E_ARGUMENT;

    put(a, s->next, 3);
    return r;
}

static SmResult end(Agent *a)
{
    SmvmVerdict why;
    SmResult r = smvm_store_end(a->store, session_of(a), &why);

    if (r == SM_OK) {
        r = SMVM_LONGEST && a->board->longest_step != 0 && why.longest > a->board->longest_step
                ? SM_E_SIZE : a->board->fits(a->board->context, a->store->plan.image[a->store->target]);
        a->store->whole = r == SM_OK;
    } else if (why.rule != 0) {
        r = SM_E_IMAGE;
    }
    put1(a, why.rule);
    put(a, why.at, 3);
    return r;
}

static SmResult activate(Agent *a)
{
    return smvm_store_activate(a->store, session_of(a), a->n < 4 ? 0 : (uint16_t)sm_link_load(body_of(a) + 2, 2));
}

static SmResult confirm(Agent *a) { return smvm_store_confirm(a->store, sm_link_load(body_of(a), 4)); }
static SmResult erase(Agent *a) { return smvm_store_erase(a->store, sm_link_load(body_of(a), 4)); }

static SmResult read(Agent *a)
{
    const uint8_t slot = body_of(a)[0], n = body_of(a)[4];
    const SmvmAt size = slot == STORE_BUILT_IN ? (SmvmAt)a->board->built_in_size : a->store->slot_size;
    SmvmAt at;

    if (!is_slot(a, slot))
        return SM_E_MISSING;
    if (!smvm_get_at(body_of(a) + 1, &at) || n > a->body - 1 || at > size || n > size - at)
        return SM_E_ARGUMENT;
    put_bytes(a, image_of(a, slot), at, n);
    return SM_OK;
}

static SmResult restart(Agent *a)
{
    a->restart = true;
    return SM_OK;
}

// ---- events ----

// The fields of an event in the order of transmission.
static const struct Field { uint8_t at, bytes; } fields[] SM_FLASH = {
    {offsetof(SmEvent, time), 8}, {offsetof(SmEvent, kind), 1}, {offsetof(SmEvent, source), 2}, {offsetof(SmEvent, a), 4}, {offsetof(SmEvent, b), 4},
};

static void put_event(Agent *a, const uint8_t *event)
{
    for (uint8_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        struct Field f;
        sm_flash_get(&f, &fields[i], sizeof f);
        for (uint8_t b = 0; b < f.bytes; b++)
            put1(a, event[f.at + sm_roll_byte(b, f.bytes)]);
    }
}

static SmResult events(Agent *a)
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

typedef struct Handler {
    uint8_t message, least;   // the shortest body
    bool guarded;             // changes something, or keeps the board busy: only allowed while may_update returns SM_OK
    SmResult (*run)(Agent *a);
} Handler;

static const Handler handlers[] SM_FLASH = {
    {LINK_HELLO, 0, false, hello},      {LINK_IMAGE, 1, false, image},      {LINK_PIN, 3, false, pin},
    {LINK_BEGIN, 9, true, begin},       {LINK_DATA, DATA_HEAD + 1, true, data},     {LINK_END, 2, true, end},   {LINK_ACTIVATE, 2, true, activate},
    {LINK_CONFIRM, 4, true, confirm},   {LINK_ERASE, 4, true, erase},       {LINK_READ, 5, false, read},
    {LINK_RESTART, 0, true, restart},   {LINK_EVENTS, 4, false, events},
};

static SmResult run(const Handler *h, Agent *a)
{
    const AgentBoard *board = a->board;
    const SmResult may = h->guarded ? board->may_update(board->context) : SM_OK;

    return a->n < h->least ? SM_E_ARGUMENT : may != SM_OK ? may : h->run(a);
}

static SmResult answer(Agent *a, uint8_t message)
{
    for (uint8_t i = 0; i < sizeof handlers / sizeof *handlers; i++) {
        Handler h;
        sm_flash_get(&h, &handlers[i], sizeof h);
        if (h.message == message)
            return run(&h, a);
    }
    return SM_E_UNSUPPORTED;
}

uint16_t smvm_agent_receive(Agent *a, uint8_t byte)
{
    uint8_t *const frame = a->frame;
    uint8_t message;
    SmResult r;

    if (!sm_link_receive(&a->in, byte) || ((message = frame[2]) & LINK_ANSWER) != 0)
        return 0;
    a->n = (uint8_t)(a->in.n - LINK_HEAD);
    a->length = 0;
    r = answer(a, message);
    frame[2] = (uint8_t)(message | LINK_ANSWER);
    frame[RESULT_AT] = (uint8_t)(int8_t)r;
    return sm_link_encode(frame, (uint16_t)(LINK_HEAD + 1 + a->length));
}
