// SPDX-License-Identifier: Apache-2.0
// Requests and their answers, one function a message (runtime-c/link/link.def).  One buffer serves both: a request has been used up
// when its answer is written.
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
    sm_link_receiver(&a->in, frame + 1, (uint16_t)(LINK_HEAD + a->body + LINK_TAIL));
}

// A request's body, and how long the answer's is behind its result.
typedef struct Exchange {
    Agent *a;
    const uint8_t *body;
    uint8_t n;
    uint8_t *answer;          // lies over the body
    uint8_t length;
} Exchange;

static void put1(Exchange *x, uint8_t value) { x->answer[x->length++] = value; }

static void put(Exchange *x, uint32_t value, uint8_t bytes)
{
    sm_link_put(x->answer + x->length, value, bytes);
    x->length = (uint8_t)(x->length + bytes);
}

// ---- what there is ----

static SmResult hello(Exchange *x)
{
    const Agent *a = x->a;

    put1(x, LINK_PROTOCOL);
    put1(x, a->body);
    put1(x, a->block);
    put1(x, a->store->plan.slots);
    put(x, a->store->slot_size, 3);
    put(x, a->board->ram, 3);
    put(x, a->board->longest_step, 4);
    put1(x, (uint8_t)a->board->may_update(a->board->context));
    put1(x, smvm_store_has_key(a->store));
    put(x, sm_link_get(a->store->now.newest, 4), 4);
    put1(x, (uint8_t)(a->board->machines | (a->board->windows ? LINK_WINDOWS : 0)));
    put1(x, a->board->ram_digital);
    put1(x, a->board->ram_analog);
    put(x, a->board->period, 2);
    put(x, a->board->cycles, 2);
    return SM_OK;
}

static SmvmBytes image_of(const Agent *a, uint8_t slot)
{
    return slot == STORE_BUILT_IN ? a->board->built_in : a->store->plan.image[slot];
}

// Of an image, as they lie there.
static void put_bytes(Exchange *x, SmvmBytes image, SmvmAt at, uint8_t n)
{
    while (n-- > 0)
        x->answer[x->length++] = smvm_u8(image, at++);
}

// What an image says of itself: length, checksum, identity; zeros where there is none.
static void put_image(Exchange *x, SmvmBytes image)
{
    SmvmReader identity;

    put_bytes(x, image, SMVM_LENGTH_AT, 3);
    put_bytes(x, image, SMVM_CRC_AT, 4);
    if (smvm_find(image, SMVM_S_IDENTITY, &identity) && (SmvmAt)(identity.end - identity.at) == 8)
        put_bytes(x, image, identity.at, 8);
}

static StoreState state_of(const Agent *a, uint8_t slot)
{
    if (slot != STORE_BUILT_IN)
        return smvm_store_state(a->store, slot);
    return a->board->built_in_size == 0 ? STORE_EMPTY : a->store->now.active == slot ? STORE_CONFIRMED : STORE_WHOLE;
}

static bool is_slot(const Agent *a, uint8_t slot) { return slot < a->store->plan.slots || slot == STORE_BUILT_IN; }

static SmResult image(Exchange *x)
{
    const Store *s = x->a->store;
    const uint8_t slot = x->body[0];
    StoreState state;

    if (!is_slot(x->a, slot))
        return SM_E_MISSING;
    state = state_of(x->a, slot);
    memset(x->answer, 0, IMAGE);
    put1(x, (uint8_t)state);
    if (state != STORE_EMPTY)
        put_image(x, image_of(x->a, slot));
    x->length = IMAGE - 4;
    put1(x, (uint8_t)((slot == s->running ? 1 : 0) | (slot == s->now.active ? 2 : 0)));
    put1(x, state == STORE_TRIAL ? s->now.tries : 0);
    put(x, smvm_store_period(s, slot), 2);
    return SM_OK;
}

// ---- an update ----

static uint16_t session_of(const Exchange *x) { return (uint16_t)sm_link_get(x->body, 2); }

static SmResult begin(Exchange *x)
{
    const Agent *a = x->a;
    SmvmAt length;
    const SmResult r = smvm_get_at(x->body + 2, &length) ? smvm_store_may_begin(a->store, length) : SM_E_SPACE;

    if (r != SM_OK)
        return r;                      // before a machine is stopped for nothing
    if (a->store->plan.slots == 1 && a->store->running != STORE_BUILT_IN) {
        a->board->leave_slot(a->board->context);
        smvm_store_leave(a->store);
    }
    return smvm_store_begin(a->store, session_of(x), length, sm_link_get(x->body + 5, 4));
}

static SmResult data(Exchange *x)
{
    Store *s = x->a->store;
    const uint8_t n = (uint8_t)(x->n - DATA_HEAD);
    SmvmAt at;
    const SmResult r = smvm_get_at(x->body + 2, &at) ? smvm_store_write(s, session_of(x), at, x->body + DATA_HEAD, n) : SM_E_ARGUMENT;

    put(x, s->next, 3);
    return r;
}

static SmResult end(Exchange *x)
{
    const Agent *a = x->a;
    SmvmVerdict why;
    SmResult r = smvm_store_end(a->store, session_of(x), &why);

    if (r == SM_OK) {
        r = SMVM_LONGEST && a->board->longest_step != 0 && why.longest > a->board->longest_step
                ? SM_E_SIZE : a->board->fits(a->board->context, a->store->plan.image[a->store->target]);
        a->store->whole = r == SM_OK;
    } else if (why.rule != 0) {
        r = SM_E_IMAGE;
    }
    put1(x, why.rule);
    put(x, why.at, 3);
    return r;
}

static SmResult activate(Exchange *x)
{
    return smvm_store_activate(x->a->store, session_of(x), x->n < 4 ? 0 : (uint16_t)sm_link_get(x->body + 2, 2));
}

static SmResult confirm(Exchange *x) { return smvm_store_confirm(x->a->store, sm_link_get(x->body, 4)); }
static SmResult erase(Exchange *x) { return smvm_store_erase(x->a->store, sm_link_get(x->body, 4)); }

static SmResult read(Exchange *x)
{
    const Agent *a = x->a;
    const uint8_t slot = x->body[0], n = x->body[4];
    const SmvmAt size = slot == STORE_BUILT_IN ? (SmvmAt)a->board->built_in_size : a->store->slot_size;
    SmvmAt at;

    if (!is_slot(a, slot))
        return SM_E_MISSING;
    if (!smvm_get_at(x->body + 1, &at) || n > a->body - 1 || at > size || n > size - at)
        return SM_E_ARGUMENT;
    put_bytes(x, image_of(a, slot), at, n);
    return SM_OK;
}

static SmResult restart(Exchange *x)
{
    x->a->restart = true;
    return SM_OK;
}

// ---- events ----

static SmResult events(Exchange *x)
{
    Agent *a = x->a;
    uint32_t cursor = sm_link_get(x->body, 4), lost = 0, gone;
    SmEvent e;

    if (!a->events)
        return SM_E_UNSUPPORTED;
    x->length = 8;
    while (x->length + EVENT < a->body && sm_events_read(a->events, &cursor, &e, 1, &gone) == 1) {
        lost += gone;
        put(x, (uint32_t)e.time, 4);
        put(x, (uint32_t)(e.time >> 32), 4);
        put1(x, e.kind);
        put(x, e.source, 2);
        put(x, e.a, 4);
        put(x, e.b, 4);
    }
    sm_link_put(x->answer, cursor, 4);
    sm_link_put(x->answer + 4, lost, 4);
    return SM_OK;
}

// ---- all of them ----

typedef struct Handler {
    uint8_t message, least;   // the shortest body
    bool guarded;             // it changes something, or keeps the board busy: only while may_update agrees
    SmResult (*run)(Exchange *x);
} Handler;

static const Handler handlers[] SM_FLASH = {
    {LINK_HELLO, 0, false, hello},      {LINK_IMAGE, 1, false, image},      {LINK_BEGIN, 9, true, begin},
    {LINK_DATA, DATA_HEAD + 1, true, data},     {LINK_END, 2, true, end},   {LINK_ACTIVATE, 2, true, activate},
    {LINK_CONFIRM, 4, true, confirm},   {LINK_ERASE, 4, true, erase},       {LINK_READ, 5, false, read},
    {LINK_RESTART, 0, true, restart},   {LINK_EVENTS, 4, false, events},
};

static SmResult run(const Handler *h, Exchange *x)
{
    const AgentBoard *board = x->a->board;
    const SmResult may = h->guarded ? board->may_update(board->context) : SM_OK;

    return x->n < h->least ? SM_E_ARGUMENT : may != SM_OK ? may : h->run(x);
}

static SmResult answer(Exchange *x, uint8_t message)
{
    for (uint8_t i = 0; i < sizeof handlers / sizeof *handlers; i++) {
        Handler h;
        sm_flash_get(&h, &handlers[i], sizeof h);
        if (h.message == message)
            return run(&h, x);
    }
    return SM_E_UNSUPPORTED;
}

uint16_t smvm_agent_receive(Agent *a, uint8_t byte)
{
    uint8_t *const frame = a->frame;
    Exchange x = {a, frame + RESULT_AT, 0, frame + ANSWER_AT, 0};
    uint8_t message;
    SmResult r;

    if (!sm_link_receive(&a->in, byte) || ((message = frame[2]) & LINK_ANSWER) != 0)
        return 0;
    x.n = (uint8_t)(a->in.n - LINK_HEAD);
    r = answer(&x, message);
    frame[2] = (uint8_t)(message | LINK_ANSWER);
    frame[RESULT_AT] = (uint8_t)(int8_t)r;
    return sm_link_frame(frame, (uint16_t)(LINK_HEAD + 1 + x.length));
}
