// SPDX-License-Identifier: Apache-2.0
// An executor: runs a tick, and determines the next one.  PAL clock times are compared by their difference.
#include "runtime-c/executor.h"

#include "runtime-c/pal/clock.h"

// ---- the plan ----

// NULL is accepted for any vector.
static bool is_of(const SmStateVec *sv, const SmElement *e)
{
    return !e || (sv && sv->layout && (uintptr_t)e - (uintptr_t)sv->layout->element < sv->layout->elements * sizeof *e);
}

static bool is_vital(const SmStateVec *sv, const SmElement *e)
{
    return is_of(sv, e) && (!e || e->type <= SM_U64);
}

static bool is_told_well(const SmExecutor *e)
{
    const SmVitals *v = &e->vitals;

    if (e->time && (!is_of(e->sv, e->time) || e->time->type != SM_U64 || e->unit == 0))
        return false;
    return is_vital(e->sv, v->ticks) && is_vital(e->sv, v->overruns) && is_vital(e->sv, v->skipped) &&
           is_vital(e->sv, v->late) && is_vital(e->sv, v->busy);
}

static bool is_whole(const SmExecutor *e, const SmRate *r)
{
    if (r->every == 0 || r->tasks == 0 || !r->task)
        return false;
    for (uint16_t i = 0; i < r->tasks; i++)
        if (!r->task[i] || !is_of(e->sv, r->task[i]->mode))
            return false;
    return true;
}

static bool is_plan(const SmExecutor *e)
{
    if (!e || e->period == 0 || e->rates == 0 || !e->rate || !is_told_well(e))
        return false;
    for (uint16_t i = 0; i < e->rates; i++)
        if (!is_whole(e, &e->rate[i]))
            return false;
    return true;
}

static SmResult init_group(const SmRate *r, const SmTask **failed)
{
    for (uint16_t i = 0; i < r->tasks; i++) {
        const SmResult result = sm_task_init(r->task[i]);

        if (result != SM_OK) {
            if (failed)
                *failed = r->task[i];
            return result;
        }
    }
    return SM_OK;
}

static void *place(const SmExecutor *e, const SmElement *element)
{
    return (uint8_t *)e->sv->at + element->offset;
}

SmResult sm_executor_init(SmExecutor *e, const SmTask **failed)
{
    SmResult r = SM_OK;

    if (failed)
        *failed = NULL;
    if (!is_plan(e))
        return SM_E_ARGUMENT;
    for (uint16_t i = 0; i < e->rates && r == SM_OK; i++)
        r = init_group(&e->rate[i], failed);
    if (r != SM_OK || !e->time)
        return r;
    e->step = e->period % e->unit == 0 ? e->period / e->unit : 0;
    r = sm_enter(e->sv);
    if (r == SM_OK) {                     // otherwise it would count from 0, less than a restored G
        e->base = *(const uint64_t *)place(e, e->time);
        sm_leave(e->sv);
    }
    return r;
}

// ---- elements ----

// Several executors may set G, so it only increases.
static void set_time(const SmExecutor *e, const SmTick *tick)
{
    const uint64_t since = e->step > 0 ? tick->number * e->step : tick->time / e->unit;
    const uint64_t time = since <= UINT64_MAX - e->base ? e->base + since : UINT64_MAX;
    uint64_t *const g = place(e, e->time);

    if (sm_enter(e->sv) != SM_OK)
        return;
    if (*g < time)
        *g = time;
    sm_leave(e->sv);
}

static uint64_t at_most(uint64_t value, uint64_t most)
{
    return value < most ? value : most;
}

static void put(const SmExecutor *e, const SmElement *element, uint64_t value)
{
    void *const at = element ? place(e, element) : NULL;

    if (!element)
        return;
    switch (element->type) {
    case SM_I8:  *(int8_t *)at = (int8_t)at_most(value, INT8_MAX); return;
    case SM_I16: *(int16_t *)at = (int16_t)at_most(value, INT16_MAX); return;
    case SM_I32: *(int32_t *)at = (int32_t)at_most(value, INT32_MAX); return;
    case SM_I64: *(int64_t *)at = (int64_t)at_most(value, INT64_MAX); return;
    case SM_U8:  *(uint8_t *)at = (uint8_t)at_most(value, UINT8_MAX); return;
    case SM_U16: *(uint16_t *)at = (uint16_t)at_most(value, UINT16_MAX); return;
    case SM_U32: *(uint32_t *)at = (uint32_t)at_most(value, UINT32_MAX); return;
    default:     *(uint64_t *)at = value; return;
    }
}

static void put_vitals(const SmExecutor *e)
{
    const SmVitals *v = &e->vitals;

    if (!(v->ticks || v->overruns || v->skipped || v->late || v->busy) || sm_enter(e->sv) != SM_OK)
        return;
    put(e, v->ticks, e->ticks);
    put(e, v->overruns, e->overruns);
    put(e, v->skipped, e->skipped);
    put(e, v->late, e->late / PAL_MICROSECOND);
    put(e, v->busy, e->busy / PAL_MICROSECOND);
    sm_leave(e->sv);
}

// ---- ticks ----

void sm_executor_start(SmExecutor *e, uint64_t at)
{
    e->start = e->ended = at;
}

uint64_t sm_executor_due(const SmExecutor *e)
{
    return e->start + e->next * e->period;
}

// A division of 32 bits is several times faster than one of 64 bits on small chips.
static bool is_due(const SmRate *r, uint64_t number)
{
    if (r->every == 1)
        return true;
    return number <= UINT32_MAX ? (uint32_t)number % r->every == 0 : number % r->every == 0;
}

static void run_groups(const SmExecutor *e, const SmTick *tick)
{
    for (uint16_t i = 0; i < e->rates; i++) {
        const SmRate *const r = &e->rate[i];

        if (!is_due(r, tick->number))
            continue;
        for (uint16_t t = 0; t < r->tasks; t++)
            sm_task_run(r->task[t], e->sv, e->events, tick);
    }
}

// The time from a to b; 0 if b is before a.
static uint64_t since(uint64_t a, uint64_t b)
{
    return (int64_t)(b - a) > 0 ? b - a : 0;
}

// How many of the ticks that are due before `now` the policy leaves out.
static uint64_t left_out(const SmExecutor *e, uint64_t now)
{
    const uint64_t behind = since(sm_executor_due(e), now);
    const uint64_t missed = behind / e->period + (behind % e->period != 0);
    const uint64_t run = e->overrun == SM_CATCH_UP ? e->most : 0;

    return missed > run ? missed - run : 0;
}

static void tell(SmExecutor *e, uint64_t time)
{
    SmEvent event = {time, 0, 0, e->number, SM_EVENT_OVERRUN};

    if (e->overruns > 1 && time - e->told < PAL_SECOND)
        return;
    event.a = (uint32_t)at_most(e->skipped - e->told_skipped, UINT32_MAX);
    event.b = (uint32_t)at_most(e->late / PAL_MICROSECOND, UINT32_MAX);
    e->told = time;
    e->told_skipped += event.a;
    sm_event(e->events, &event);
}

static void overrun(SmExecutor *e, const SmTick *tick, uint64_t now)
{
    const uint64_t skip = left_out(e, now);

    e->overruns++;
    e->skipped += skip;
    e->next += skip;
    tell(e, tick->time);
}

static void count(SmExecutor *e, uint64_t due, uint64_t began)
{
    e->ticks++;
    e->next++;
    e->late = since(due, began);
    e->busy = since(began, e->ended);
    e->late_most = e->late > e->late_most ? e->late : e->late_most;
    e->busy_most = e->busy > e->busy_most ? e->busy : e->busy_most;
}

void sm_executor_tick(SmExecutor *e)
{
    const SmTick tick = {e->next * e->period, e->next};
    const uint64_t due = sm_executor_due(e), began = pal_clock_now();

    if (e->time)
        set_time(e, &tick);
    run_groups(e, &tick);
    e->ended = pal_clock_now();
    count(e, due, began);
    if (e->late >= e->period)
        overrun(e, &tick, e->ended);
    put_vitals(e);
}

void sm_executor_rest(SmExecutor *e)
{
    const SmTick tick = {e->next * e->period, e->next};

    for (uint16_t i = 0; i < e->rates; i++)
        for (uint16_t t = 0; t < e->rate[i].tasks; t++)
            sm_task_rest(e->rate[i].task[t], e->sv, e->events, &tick);
}
