// SPDX-License-Identifier: Apache-2.0
// A task: calls the function that its mode selects, counts calls, and emits events for changes.
#include "runtime-c/task.h"

SmResult sm_task_init(SmTask *t)
{
    if (!t || !t->step || (t->mode && t->mode->type != SM_U8))
        return SM_E_ARGUMENT;
    return t->init ? t->init(t->context) : SM_OK;
}

static void tell(const SmTask *t, SmEvents *events, const SmTick *tick, SmEventKind kind, uint32_t a, uint32_t b)
{
    SmEvent e = {tick->time, a, b, t->number, 0};

    e.kind = (uint8_t)kind;
    sm_event(events, &e);
}

// If the mode cannot be read, it has not changed.
static uint8_t mode_of(const SmTask *t, SmStateVec *sv)
{
    uint8_t mode;

    if (!t->mode)
        return SM_ENABLED;
    if (sm_enter(sv) != SM_OK)
        return t->last_mode;
    mode = ((const uint8_t *)sv->at)[t->mode->offset];     // executor.c has checked that it is an element of sv
    sm_leave(sv);
    return mode <= SM_ENABLED ? mode : (uint8_t)SM_SAFED;
}

static void note_mode(SmTask *t, uint8_t mode, SmEvents *events, const SmTick *tick)
{
    if (t->mode && mode != t->last_mode)
        tell(t, events, tick, SM_EVENT_MODE, t->last_mode, mode);
    t->last_mode = mode;
}

// The event contains -r, because results are negative.
static uint32_t fault_number(SmResult r)
{
    return 0u - (uint32_t)(int32_t)r;
}

static void note_result(SmTask *t, SmResult r, SmEvents *events, const SmTick *tick)
{
    t->last = r;
    if (r == SM_OK) {
        if (t->failing > 0)
            tell(t, events, tick, SM_EVENT_FAULT, 0, t->failing);
        t->failing = 0;
        return;
    }
    t->failures++;
    t->failing += t->failing < UINT32_MAX;
    if (t->failing == 1)
        tell(t, events, tick, SM_EVENT_FAULT, fault_number(r), 1);
}

static void call_safe(SmTask *t, SmEvents *events, const SmTick *tick)
{
    if (!t->safe)
        return;
    t->safings++;
    note_result(t, t->safe(t->context, tick), events, tick);
}

void sm_task_run(SmTask *t, SmStateVec *sv, SmEvents *events, const SmTick *tick)
{
    const uint8_t mode = mode_of(t, sv);

    note_mode(t, mode, events, tick);
    if (mode == SM_SAFED)
        call_safe(t, events, tick);
    if (mode != SM_ENABLED)
        return;
    t->steps++;
    note_result(t, t->step(t->context, tick), events, tick);
}

void sm_task_rest(SmTask *t, SmStateVec *sv, SmEvents *events, const SmTick *tick)
{
    if (mode_of(t, sv) != SM_DISABLED)
        call_safe(t, events, tick);
}
