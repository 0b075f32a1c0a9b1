// SPDX-License-Identifier: Apache-2.0
// A task: calls the function that its mode selects, counts calls, and emits events for changes.
#include "runtime-c/task.h"

// Calls init of the task.  SM_E_ARGUMENT: `step` is NULL, or `mode` is not a U8.
SmResult sm_task_init(SmTask *t)
{
    if (!t || !t->step || (t->mode && t->mode->type != SM_U8))
        return SM_E_ARGUMENT;
    return t->init ? t->init(t->context) : SM_OK;
}

static void emit_event(const SmTask *t, SmEvents *events, const SmTick *tick, SmEventKind kind, uint32_t a, uint32_t b)
{
    SmEvent e = {tick->time, a, b, t->number, 0};

    e.kind = (uint8_t)kind;
    sm_event(events, &e);
}

// Returns the mode that element t->mode of sv selects: SM_SAFED if its value is no mode, SM_ENABLED without such an element.  If the vector cannot be
// entered, returns the mode of the last tick.
static uint8_t read_mode(const SmTask *t, SmStateVec *sv)
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

// Emits MODE if the mode has changed.
static void update_mode(SmTask *t, uint8_t mode, SmEvents *events, const SmTick *tick)
{
    if (t->mode && mode != t->last_mode)
        emit_event(t, events, tick, SM_EVENT_MODE, t->last_mode, mode);
    t->last_mode = mode;
}

// Returns the number of an error in event FAULT: -r, because errors are negative.
static uint32_t fault_number(SmResult r)
{
    return 0u - (uint32_t)(int32_t)r;
}

// Counts failures, and emits FAULT at the first of several and at the first success after them.
static void record_result(SmTask *t, SmResult r, SmEvents *events, const SmTick *tick)
{
    t->last_result = r;
    if (r == SM_OK) {
        if (t->failures_in_row > 0)
            emit_event(t, events, tick, SM_EVENT_FAULT, 0, t->failures_in_row);
        t->failures_in_row = 0;
        return;
    }
    t->failures++;
    t->failures_in_row += t->failures_in_row < UINT32_MAX;
    if (t->failures_in_row == 1)
        emit_event(t, events, tick, SM_EVENT_FAULT, fault_number(r), 1);
}

static void call_safe(SmTask *t, SmEvents *events, const SmTick *tick)
{
    if (!t->safe)
        return;
    t->safings++;
    record_result(t, t->safe(t->context, tick), events, tick);
}

// Runs the task once in the mode selected in sv.
void sm_task_run(SmTask *t, SmStateVec *sv, SmEvents *events, const SmTick *tick)
{
    const uint8_t mode = read_mode(t, sv);

    update_mode(t, mode, events, tick);
    if (mode == SM_SAFED)
        call_safe(t, events, tick);
    if (mode != SM_ENABLED)
        return;
    t->steps++;
    record_result(t, t->step(t->context, tick), events, tick);
}

// Called at the end of the application: calls `safe` once, unless the task is disabled.
void sm_task_safe(SmTask *t, SmStateVec *sv, SmEvents *events, const SmTick *tick)
{
    if (read_mode(t, sv) != SM_DISABLED)
        call_safe(t, events, tick);
}
