// SPDX-License-Identifier: Apache-2.0
// An executor: runs a tick, and determines the next one.  PAL clock times are compared by their difference.
#include "runtime-c/executor.h"

#include "runtime-c/pal/clock.h"

// ---- configuration ----

// Whether e is NULL or an element of the vector.
static bool belongs_to(const SmStateVec *sv, const SmElement *e)
{
    return !e || (sv && sv->layout && (uintptr_t)e - (uintptr_t)sv->layout->element < sv->layout->elements * sizeof *e);
}

// Whether e is NULL or an integer element of the vector (the integer types precede the others in stdlib/types.def).
static bool can_receive_statistic(const SmStateVec *sv, const SmElement *e)
{
    return belongs_to(sv, e) && (!e || e->type <= SM_U64);
}

static bool are_elements_valid(const SmExecutor *e)
{
    const SmVitals *v = &e->vitals;

    if (e->time && (!belongs_to(e->sv, e->time) || e->time->type != SM_U64 || e->unit == 0))
        return false;
    return can_receive_statistic(e->sv, v->ticks) && can_receive_statistic(e->sv, v->overruns) && can_receive_statistic(e->sv, v->skipped) &&
           can_receive_statistic(e->sv, v->late) && can_receive_statistic(e->sv, v->busy);
}

static bool is_rate_valid(const SmExecutor *e, const SmRate *r)
{
    if (r->every == 0 || r->tasks == 0 || !r->task)
        return false;
    for (uint16_t i = 0; i < r->tasks; i++)
        if (!r->task[i] || !belongs_to(e->sv, r->task[i]->mode))
            return false;
    return true;
}

static bool is_config_valid(const SmExecutor *e)
{
    if (!e || e->period == 0 || e->rates == 0 || !e->rate || !are_elements_valid(e))
        return false;
    for (uint16_t i = 0; i < e->rates; i++)
        if (!is_rate_valid(e, &e->rate[i]))
            return false;
    return true;
}

// Calls init of all tasks of a rate group. Stores the one that fails in *failed.
static SmResult init_tasks(const SmRate *r, const SmTask **failed)
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

static void *element_address(const SmExecutor *e, const SmElement *element)
{
    return (uint8_t *)e->sv->at + element->offset;
}

// Checks the configuration, calls init of all tasks in order, and reads the starting value of G.
SmResult sm_executor_init(SmExecutor *e, const SmTask **failed)
{
    SmResult r = SM_OK;

    if (failed)
        *failed = NULL;
    if (!is_config_valid(e))
        return SM_E_ARGUMENT;
    for (uint16_t i = 0; i < e->rates && r == SM_OK; i++)
        r = init_tasks(&e->rate[i], failed);
    if (r != SM_OK || !e->time)
        return r;
    e->step = e->period % e->unit == 0 ? e->period / e->unit : 0;
    r = sm_enter(e->sv);
    if (r == SM_OK) {                     // G continues from its value at the start, which may have been restored
        e->base = *(const uint64_t *)element_address(e, e->time);
        sm_leave(e->sv);
    }
    return r;
}

// ---- elements ----

// Sets G to the time of the tick.  Several executors may set the same G, so a smaller value is not stored.
static void set_time(const SmExecutor *e, const SmTick *tick)
{
    const uint64_t since = e->step > 0 ? tick->number * e->step : tick->time / e->unit;
    const uint64_t time = since <= UINT64_MAX - e->base ? e->base + since : UINT64_MAX;
    uint64_t *const g = element_address(e, e->time);

    if (sm_enter(e->sv) != SM_OK)
        return;
    if (*g < time)
        *g = time;
    sm_leave(e->sv);
}

static uint64_t min_u64(uint64_t value, uint64_t most)
{
    return value < most ? value : most;
}

// Stores `value` in an element of integer type, saturated to the type's largest value.
static void store_statistic(const SmExecutor *e, const SmElement *element, uint64_t value)
{
    void *const at = element ? element_address(e, element) : NULL;

    if (!element)
        return;
    switch (element->type) {
    case SM_I8:  *(int8_t *)at = (int8_t)min_u64(value, INT8_MAX); return;
    case SM_I16: *(int16_t *)at = (int16_t)min_u64(value, INT16_MAX); return;
    case SM_I32: *(int32_t *)at = (int32_t)min_u64(value, INT32_MAX); return;
    case SM_I64: *(int64_t *)at = (int64_t)min_u64(value, INT64_MAX); return;
    case SM_U8:  *(uint8_t *)at = (uint8_t)min_u64(value, UINT8_MAX); return;
    case SM_U16: *(uint16_t *)at = (uint16_t)min_u64(value, UINT16_MAX); return;
    case SM_U32: *(uint32_t *)at = (uint32_t)min_u64(value, UINT32_MAX); return;
    default:     *(uint64_t *)at = value; return;
    }
}

// Stores the statistics in the state-vector elements that the configuration names, in one critical section.
static void store_statistics(const SmExecutor *e)
{
    const SmVitals *v = &e->vitals;

    if (!(v->ticks || v->overruns || v->skipped || v->late || v->busy) || sm_enter(e->sv) != SM_OK)
        return;
    store_statistic(e, v->ticks, e->ticks);
    store_statistic(e, v->overruns, e->overruns);
    store_statistic(e, v->skipped, e->skipped);
    store_statistic(e, v->late, e->late / PAL_MICROSECOND);
    store_statistic(e, v->busy, e->busy / PAL_MICROSECOND);
    sm_leave(e->sv);
}

// ---- ticks ----

// Sets the PAL clock time at which tick 0 is due.
void sm_executor_start(SmExecutor *e, uint64_t at)
{
    e->start = e->ended = at;
}

// Returns the PAL clock time at which the next tick is due.
uint64_t sm_executor_due(const SmExecutor *e)
{
    return e->start + e->next * e->period;
}

// Whether the rate group runs at that tick.  A 32-bit division is several times faster than a 64-bit one on small chips.
static bool is_due(const SmRate *r, uint64_t number)
{
    if (r->every == 1)
        return true;
    return number <= UINT32_MAX ? (uint32_t)number % r->every == 0 : number % r->every == 0;
}

static void run_due_rate_groups(const SmExecutor *e, const SmTick *tick)
{
    for (uint16_t i = 0; i < e->rates; i++) {
        const SmRate *const r = &e->rate[i];

        if (!is_due(r, tick->number))
            continue;
        for (uint16_t t = 0; t < r->tasks; t++)
            sm_task_run(r->task[t], e->sv, e->events, tick);
    }
}

// Returns the time from a to b; 0 if b is before a.
static uint64_t time_between(uint64_t a, uint64_t b)
{
    return (int64_t)(b - a) > 0 ? b - a : 0;
}

// Returns how many of the ticks that are due before `now` the overrun policy leaves out.
static uint64_t ticks_to_skip(const SmExecutor *e, uint64_t now)
{
    const uint64_t behind = time_between(sm_executor_due(e), now);
    const uint64_t missed = behind / e->period + (behind % e->period != 0);
    const uint64_t run = e->overrun == SM_CATCH_UP ? e->most : 0;

    return missed > run ? missed - run : 0;
}

// Emits OVERRUN, unless the last one was less than a second ago.
static void emit_overrun(SmExecutor *e, uint64_t time)
{
    SmEvent event = {time, 0, 0, e->number, SM_EVENT_OVERRUN};

    if (e->overruns > 1 && time - e->reported_at < PAL_SECOND)
        return;
    event.a = (uint32_t)min_u64(e->skipped - e->reported_skipped, UINT32_MAX);
    event.b = (uint32_t)min_u64(e->late / PAL_MICROSECOND, UINT32_MAX);
    e->reported_at = time;
    e->reported_skipped += event.a;
    sm_event(e->events, &event);
}

// Counts an overrun, and skips the ticks that the policy leaves out.
static void count_overrun_and_skip(SmExecutor *e, const SmTick *tick, uint64_t now)
{
    const uint64_t skip = ticks_to_skip(e, now);

    e->overruns++;
    e->skipped += skip;
    e->next += skip;
    emit_overrun(e, tick->time);
}

// Updates the delay and the duration of ticks after one that was due at `due` and began at `began` (PAL clock times in ns).
static void record_tick_times(SmExecutor *e, uint64_t due, uint64_t began)
{
    e->ticks++;
    e->next++;
    e->late = time_between(due, began);
    e->busy = time_between(began, e->ended);
    e->late_max = e->late > e->late_max ? e->late : e->late_max;
    e->busy_max = e->busy > e->busy_max ? e->busy : e->busy_max;
}

// Runs the next tick immediately, and determines which tick follows it.
void sm_executor_tick(SmExecutor *e)
{
    const SmTick tick = {e->next * e->period, e->next};
    const uint64_t due = sm_executor_due(e), began = pal_clock_now();

    if (e->time)
        set_time(e, &tick);
    run_due_rate_groups(e, &tick);
    e->ended = pal_clock_now();
    record_tick_times(e, due, began);
    if (e->late >= e->period)
        count_overrun_and_skip(e, &tick, e->ended);
    store_statistics(e);
}

// Called after the last tick: puts all tasks into their safe state, in order (sm_task_safe).
void sm_executor_safe(SmExecutor *e)
{
    const SmTick tick = {e->next * e->period, e->next};

    for (uint16_t i = 0; i < e->rates; i++)
        for (uint16_t t = 0; t < e->rate[i].tasks; t++)
            sm_task_safe(e->rate[i].task[t], e->sv, e->events, &tick);
}
