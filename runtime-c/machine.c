// SPDX-License-Identifier: Apache-2.0
// Runs a machine as a task, either in place or on a snapshot of a guarded state vector, and emits its events.
#include "runtime-c/machine.h"

#include <string.h>

static uint8_t *address_of(void *vector, SmRange p) { return (uint8_t *)vector + p.offset; }

static void emit_event(const SmMachine *m, SmEventKind kind, uint64_t time, uint32_t a, uint32_t b)
{
    SmEvent e;

    e.time = time;
    e.a = a;
    e.b = b;
    e.source = m->number;
    e.kind = (uint8_t)kind;
    sm_event(m->events, &e);
}

// ---- init ----

// Whether p is aligned for any element of a state vector.
static bool is_aligned(const void *p)
{
    struct Strictest { char c; union { uint64_t time; SmF64 number; } at; };

    return (uintptr_t)p % offsetof(struct Strictest, at) == 0;
}

static SmResult check_config(const SmMachine *m)
{
    if (!is_aligned(m->sv->at) || !is_aligned(m->copy))
        return SM_E_ALIGNMENT;
    if (!m->sv->guarded)
        return SM_OK;
    if (m->copy == NULL)
        return SM_E_ARGUMENT;
    return m->type->publish != NULL ? SM_OK : SM_E_UNSUPPORTED;
}

// Stores in *state the state number in S, or 0 if there is no such state.
static SmResult read_restored_state(const SmMachine *m, uint32_t *state)
{
    SmResult r = sm_enter(m->sv);

    if (r != SM_OK)
        return r;
    memcpy(state, address_of(m->sv->at, m->type->state_number(m->self)), sizeof *state);
    sm_leave(m->sv);
    if (*state > m->type->states(m->self))
        *state = 0;
    return SM_OK;
}

// Chooses the state to start in: that of the restored state vector, if there is one, or else the initial one.
static SmResult choose_first_state(const SmMachine *m, uint32_t *state)
{
    SmResult r = SM_OK;

    *state = 0;
    if (m->resume && m->restored != NULL && *m->restored)
        r = read_restored_state(m, state);
    if (*state == 0)
        *state = m->initial != 0 ? m->initial : 1;
    return r;
}

// Enters the state, and copies its number from the snapshot to the vector.
static SmResult start_in_state(SmMachine *m, uint32_t state)
{
    SmRange number = m->type->state_number(m->self);
    SmResult r;

    if (!m->sv->guarded)
        return m->type->init(m->self, m->sv->at, state);
    r = m->type->init(m->self, m->copy, state);
    if (r == SM_OK)
        r = sm_enter(m->sv);
    if (r != SM_OK)
        return r;
    memcpy(address_of(m->sv->at, number), address_of(m->copy, number), (size_t)number.size);
    sm_leave(m->sv);
    return SM_OK;
}

// Starts the machine: sets locals to their initial values, empties windows, and stores the number of the state in S.
SmResult sm_machine_init(void *machine)
{
    SmMachine *m = machine;
    SmResult r = check_config(m);
    uint32_t state;

    m->last_state = m->refused = 0;
    m->was_refused = m->write_back_due = false;
    if (r == SM_OK)
        r = m->type->open(m->self, m->sv->layout->hash, m->sv->layout->whole.size);
    if (r == SM_OK)
        r = choose_first_state(m, &state);
    if (r == SM_OK)
        r = start_in_state(m, state);
    if (r != SM_OK)
        return r;
    m->last_state = state;
    emit_event(m, SM_EVENT_STATE, 0, 0, state);
    return SM_OK;
}

// ---- step ----

// Makes the last step's stores visible to others.  Must be called inside the critical section.
static void write_back(SmMachine *m)
{
    m->type->publish(m->self, m->copy, m->sv->at);
    m->write_back_due = false;
}

// Copies the bytes that the machine may access to `copy`, after writing back stores that are still due.
static SmResult take_snapshot(SmMachine *m)
{
    SmRange uses = m->type->accessed(m->self);
    SmResult r = sm_enter(m->sv);

    if (r != SM_OK)
        return r;
    if (m->write_back_due)
        write_back(m);
    memcpy(address_of(m->copy, uses), address_of(m->sv->at, uses), (size_t)uses.size);
    sm_leave(m->sv);
    return SM_OK;
}

static SmResult enter_and_write_back(SmMachine *m)
{
    SmResult r = sm_enter(m->sv);

    if (r != SM_OK)
        return r;
    write_back(m);
    sm_leave(m->sv);
    return SM_OK;
}

// Steps the machine on its snapshot and writes its stores back.  Returns the result of the step; *delivered is the result of writing back.
static SmResult step_on_copy(SmMachine *m, SmResult *delivered)
{
    SmResult r = take_snapshot(m);

    if (r == SM_OK)
        r = m->type->step(m->self, m->copy);
    if (r != SM_OK)
        return r;
    m->write_back_due = true;
    *delivered = enter_and_write_back(m);
    return SM_OK;
}

// Counts the refused step, and emits REFUSED for the first of several.
static void report_refused_step(SmMachine *m, const SmTick *tick)
{
    m->refused++;
    if (!m->was_refused)
        emit_event(m, SM_EVENT_REFUSED, tick->time, m->refused, 0);
    m->was_refused = true;
}

// Emits STATE if the step made a transition.
static void report_step(SmMachine *m, const SmTick *tick)
{
    uint32_t state;

    m->was_refused = false;
    if (!m->type->moved(m->self))
        return;
    state = m->type->state(m->self);
    emit_event(m, SM_EVENT_STATE, tick->time, m->last_state, state);
    m->last_state = state;
}

// Runs one step, and emits event STATE at each transition.  SM_REFUSED: time did not advance, and nothing has changed.
SmResult sm_machine_step(void *machine, const SmTick *tick)
{
    SmMachine *m = machine;
    SmResult delivered = SM_OK, r;

    if (m->last_state == 0)               // init has not succeeded
        return SM_E_ARGUMENT;
    r = m->sv->guarded ? step_on_copy(m, &delivered) : m->type->step(m->self, m->sv->at);
    if (r == SM_REFUSED)
        report_refused_step(m, tick);
    else if (r == SM_OK)
        report_step(m, tick);
    return r != SM_OK ? r : delivered;
}

// ---- access ----

uint32_t sm_machine_state(const SmMachine *m) { return m->type->state(m->self); }
uint64_t sm_machine_time(const SmMachine *m) { return m->type->time(m->self); }
const char *sm_machine_state_name(const SmMachine *m, uint32_t state) { return m->type->state_name(m->self, state); }
