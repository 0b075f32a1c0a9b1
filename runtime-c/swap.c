// SPDX-License-Identifier: Apache-2.0
// Swaps of machines: the phases of a swap, and the exchange between two ticks.
//
// One lock protects the phase of the swap and the flags that show which executors are inside a tick.  Each executor takes it at the
// beginning and at the end of its ticks, for a few memory accesses.  The exchange happens inside it, at the end of a tick, when the flags
// show that no executor of a concerned machine is inside a tick.  So no machine is exchanged while it steps, and an executor that begins
// a tick meanwhile waits for the exchange only.
//
// While the phase is PREPARING, the slots that do not run and the changes belong to the thread that prepares.  In all other phases they
// belong to the executors.
#include "runtime-c/swap.h"

#include "runtime-c/handover.h"
#include "runtime-c/pal/clock.h"
#include "runtime-c/shared.h"
#include "runtime-c/swap_log.h"

enum { TRIES = 1000 };        // after this many ticks without a common boundary, the swap is refused

// ---- machines ----

static void *running_slot(const SmSwappable *w) { return w->slot[w->running]; }
static void *other_slot(const SmSwappable *w) { return w->slot[w->running ^ 1]; }

// Returns the index, `from` or later, of the first machine that the current swap replaces (`concerned`); s->machines if none follows.
static uint16_t next_concerned(const SmSwaps *s, uint16_t from)
{
    while (from < s->machines && !s->machine[from].concerned)
        from++;
    return from;
}

static bool is_same_name(const char *a, const char *b)
{
    while (*a != '\0' && *a == *b)
        a++, b++;
    return *a == *b;
}

SmSwappable *sm_swap_find_machine(const SmSwaps *s, const char *name)
{
    for (uint16_t i = 0; name && i < s->machines; i++)
        if (is_same_name(s->machine[i].machine->name, name))
            return &s->machine[i];
    return NULL;
}

static void emit_event(const SmSwaps *s, const SmSwappable *w, SmEventKind kind, uint64_t time, uint32_t a, uint32_t b)
{
    SmEvent e = {time, a, b, w->machine->number, 0};

    e.kind = (uint8_t)kind;
    sm_event(s->events, &e);
}

// ---- phases ----

// Ends the current swap without an exchange. machine: index of the refused machine, or of the change if that has no machine.
static void refuse_swap(SmSwaps *s, SmSwapReason why, uint16_t machine)
{
    s->status.phase = SM_SWAP_REFUSED;
    s->status.reason = why;
    s->status.machine = machine;
    s->refusal_due = true;
}

// Ends the trial in this phase, confirmed or returned. The event follows at the end of the tick.
static void end_trial(SmSwaps *s, SmSwapPhase phase)
{
    s->status.phase = phase;
    s->end_due = true;
}

// Emits the events of a refusal, or of the end of a trial, since the last tick.
static void emit_due_events(SmSwaps *s, uint64_t time)
{
    if (s->refusal_due && sm_swap_refused_machine(s, &s->status)) {
        const SmSwappable *w = sm_swap_refused_machine(s, &s->status);
        const bool was_read = s->status.reason != SM_SWAP_NO_TWICE && s->status.reason != SM_SWAP_NO_MODE;
        emit_event(s, w, SM_EVENT_SWAP_REFUSED, time, s->status.reason, was_read ? w->type->identity(other_slot(w)) : 0);
    }
    for (uint16_t i = 0; s->end_due && i < s->machines; i++) {
        const SmSwappable *w = &s->machine[i];
        if (w->concerned)
            emit_event(s, w, SM_EVENT_TRIAL, time, s->status.end,
                       w->type->identity(s->status.phase == SM_SWAP_CONFIRMED ? running_slot(w) : other_slot(w)));
    }
    if (s->failure_due) {
        SmEvent e = {time, 0, 0, 0, SM_EVENT_NOT_STORED};
        e.a = (uint32_t)-s->status.stored;
        sm_event(s->events, &e);
    }
    s->refusal_due = s->end_due = s->failure_due = false;
}

// ---- begin ----

// Takes the lock for a caller that may be in any thread.
static SmResult enter_from_outside(const SmSwaps *s) { return sm_shared_read(&s->is_open) ? sm_handover_lock(s->lock) : SM_E_BUSY; }

// Stores the changes in their machines.  Returns why that is not possible; then *failed is the machine, or the change if it has no machine.
static SmSwapReason store_changes(SmSwaps *s, const SmSwapChange *change, uint16_t n, uint16_t *failed)
{
    for (uint16_t i = 0; i < s->machines; i++)
        s->machine[i].concerned = false;
    for (uint16_t i = 0; i < n; i++) {
        SmSwappable *w = sm_swap_find_machine(s, change[i].machine);
        *failed = w ? (uint16_t)(w - s->machine) : i;
        if (!w)
            return SM_SWAP_NO_MACHINE;
        if (w->concerned)
            return SM_SWAP_NO_TWICE;
        if (change[i].mode != SM_SWAP_RESTART && change[i].mode != SM_SWAP_CONTINUE)
            return SM_SWAP_NO_MODE;
        w->concerned = true;
        w->change = change[i];
    }
    return SM_SWAP_NOT_REFUSED;
}

// Begins a swap of n machines.  SM_E_BUSY: another one is in progress, or the application has not started.
SmResult sm_swap_begin(SmSwaps *s, const SmSwapChange *change, uint16_t n)
{
    SmResult r = s && change && n > 0 ? enter_from_outside(s) : SM_E_ARGUMENT;
    uint16_t failed = 0;
    SmSwapReason why;

    if (r != SM_OK)
        return r;
    // the events of the last one are emitted at the end of this tick
    if (SM_SWAP_IS_IN_PROGRESS(s->status.phase) || s->refusal_due || s->end_due) {
        sm_handover_unlock(s->lock);
        return SM_E_BUSY;
    }
    s->status.number++;
    s->status.reason = SM_SWAP_NOT_REFUSED;
    s->status.end = 0;
    s->status.stored = SM_OK;
    why = store_changes(s, change, n, &failed);
    if (why != SM_SWAP_NOT_REFUSED) {
        refuse_swap(s, why, failed);
    } else {
        s->status.phase = SM_SWAP_PREPARING;
        s->at = next_concerned(s, 0);
        s->part = 0;
    }
    sm_handover_unlock(s->lock);
    return SM_OK;
}

// Reads the status of the last swap.  SM_E_BUSY: the application has not started.
SmResult sm_swap_status(SmSwaps *s, SmSwapStatus *status)
{
    SmResult r = s && status ? enter_from_outside(s) : SM_E_ARGUMENT;

    if (r != SM_OK)
        return r;
    *status = s->status;
    sm_handover_unlock(s->lock);
    return SM_OK;
}

static void confirm_trial(SmSwaps *s)
{
    s->status.end = SM_SWAP_WAS_CONFIRMED;
    end_trial(s, SM_SWAP_CONFIRMED);
}

// Ends the trial: the new machines stay.  SM_E_ARGUMENT: no machine is on trial.
SmResult sm_swap_confirm(SmSwaps *s)
{
    SmResult r = s ? enter_from_outside(s) : SM_E_ARGUMENT;

    if (r != SM_OK)
        return r;
    if (s->status.phase != SM_SWAP_TRIAL || s->status.end != 0) {
        r = SM_E_ARGUMENT;
    } else if (s->storage) {
        s->confirming = true;
    } else {
        confirm_trial(s);
    }
    sm_handover_unlock(s->lock);
    return r;
}

// Stores a confirmed swap.  No machine is exchanged or prepared meanwhile, so the running slots do not change.
SmResult sm_swaps_save(SmSwaps *s)
{
    bool is_due;
    SmResult r;

    if (!s->storage || sm_handover_lock(s->lock) != SM_OK)
        return SM_OK;
    is_due = s->confirming;
    sm_handover_unlock(s->lock);
    if (!is_due)
        return SM_OK;
    r = s->storage->save(s->storage, s);
    if (sm_handover_lock(s->lock) != SM_OK)
        return SM_E_TIMEOUT;
    s->confirming = false;
    s->status.stored = r;
    if (r == SM_OK)
        confirm_trial(s);
    else
        s->failure_due = true;
    sm_handover_unlock(s->lock);
    return r;
}

// Reads what is known of a machine. Only for the thread that prepares swaps.
SmResult sm_swap_machine(SmSwaps *s, uint16_t machine, SmSwapMachineState *out)
{
    SmResult r = s && out ? enter_from_outside(s) : SM_E_ARGUMENT;
    const SmSwappable *w;
    bool is_new;

    if (r != SM_OK)
        return r;
    if (machine < s->machines) {
        w = &s->machine[machine];
        is_new = s->status.phase == SM_SWAP_TRIAL || s->status.phase == SM_SWAP_CONFIRMED;
        out->identity = w->type->identity(running_slot(w));
        out->state = w->state;
        out->slot = running_slot(w);
        out->newest = !w->concerned ? NULL : is_new ? running_slot(w) : other_slot(w);
        out->is_on_trial = w->concerned && s->status.phase == SM_SWAP_TRIAL;
        out->is_built_in = out->identity == w->built_in;
        out->is_stored = out->identity == w->stored;
    } else {
        r = SM_E_MISSING;
    }
    sm_handover_unlock(s->lock);
    return r;
}

const SmSwappable *sm_swap_refused_machine(const SmSwaps *s, const SmSwapStatus *status)
{
    const bool has_machine = status->phase == SM_SWAP_REFUSED && status->reason != SM_SWAP_NO_MACHINE && status->machine < s->machines;

    return has_machine ? &s->machine[status->machine] : NULL;
}

// Returns the sentence of a reason; "" for an unknown one.
const char *sm_swap_reason_text(SmSwapReason reason)
{
    switch (reason) {
#define SM_SWAP(name, number, text) case number: return text;
#include "runtime-c/swaps.def"
#undef SM_SWAP
    default: return "";
    }
}

// ---- prepare ----

static bool overlap(SmRange a, SmRange b) { return a.offset < b.offset + b.size && b.offset < a.offset + a.size; }

// Whether the machine in a slot stores bytes of this range of the state vector.
static bool stores_range(const SmSwapType *type, const void *slot, SmRange range)
{
    SmRange r;

    for (uint32_t i = 0; type->output(slot, i, &r); i++)
        if (overlap(r, range))
            return true;
    return false;
}

// Whether other code than machine w will store bytes of the range after the current swap.
static bool has_other_writer(const SmSwaps *s, const SmSwappable *w, SmRange range)
{
    for (uint16_t i = 0; i < s->writtens; i++)
        if (overlap(s->written[i], range))
            return true;
    for (uint16_t i = 0; i < s->machines; i++) {
        const SmSwappable *other = &s->machine[i];
        if (other != w && stores_range(other->type, other->concerned ? other_slot(other) : running_slot(other), range))
            return true;
    }
    return false;
}

// Whether the machine in slot `to`, unlike the one in slot `from`, stores an element that another part of the application also stores.
bool sm_swap_adds_writer(const SmSwaps *s, const SmSwappable *w, const void *from, const void *to)
{
    SmRange r;

    for (uint32_t i = 0; w->type->output(to, i, &r); i++)
        if (!stores_range(w->type, from, r) && has_other_writer(s, w, r))
            return true;
    return false;
}

// Returns the first replaced machine that would store an element that other code also stores; s->machines if none would.  All are prepared.
static uint16_t find_second_writer(const SmSwaps *s)
{
    uint16_t i = next_concerned(s, 0);

    while (i < s->machines && !sm_swap_adds_writer(s, &s->machine[i], running_slot(&s->machine[i]), other_slot(&s->machine[i])))
        i = next_concerned(s, (uint16_t)(i + 1));
    return i;
}

// Whether the current part of the preparation is the last part of the last machine.
static bool is_last_part(const SmSwaps *s)
{
    return s->part + 1 == s->machine[s->at].type->parts && next_concerned(s, (uint16_t)(s->at + 1)) == s->machines;
}

// Records the result of one part of the preparation: continues with the next part, the next machine, or the exchange.  `machine`: the one that is
// refused.
static void finish_part(SmSwaps *s, SmSwapReason why, uint16_t machine)
{
    if (why != SM_SWAP_NOT_REFUSED) {
        refuse_swap(s, why, machine);
        return;
    }
    if (++s->part < s->machine[s->at].type->parts)
        return;
    s->machine[s->at].unnamed = other_slot(&s->machine[s->at]);
    s->part = 0;
    s->at = next_concerned(s, (uint16_t)(s->at + 1));
    if (s->at == s->machines) {
        s->status.phase = SM_SWAP_WAITING;
        s->tries = 0;
    }
}

// Runs the next part of a preparation.  Returns false if there was none.  Only one thread may call it.
bool sm_swaps_prepare(SmSwaps *s)
{
    SmSwappable *w;
    bool is_due;
    SmSwapReason why;
    uint16_t failed;

    if (sm_handover_lock(s->lock) != SM_OK)
        return false;
    is_due = s->status.phase == SM_SWAP_PREPARING;
    sm_handover_unlock(s->lock);
    if (!is_due)
        return false;
    w = &s->machine[s->at];
    w->logged.self = running_slot(w);             // the log must not read names in the slot that changes now
    w->unnamed = NULL;
    why = w->type->prepare(other_slot(w), running_slot(w), &w->change, w->machine, s->part);
    failed = s->at;
    if (why == SM_SWAP_NOT_REFUSED && is_last_part(s)) {
        failed = find_second_writer(s);
        why = failed < s->machines ? SM_SWAP_NO_WRITER : SM_SWAP_NOT_REFUSED;
    }
    if (sm_handover_lock(s->lock) != SM_OK)
        return false;
    finish_part(s, why, failed);
    sm_handover_unlock(s->lock);
    return true;
}

static SmSwaps *swaps_of(const SmApp *app) { return (SmSwaps *)(uintptr_t)app->writing; }

SmResult sm_swaps_restore(SmApp *app)
{
    SmSwaps *const s = swaps_of(app);
    const SmResult opened = s->service ? s->service->open(s->service, app) : SM_OK;
    SmResult r = opened;

    if (r == SM_OK && s->storage)
        r = s->storage->open(s->storage, s, app);         // after the service, which reads the key
    if (r == SM_OK && s->next)
        r = s->next->restore(app);
    if (r != SM_OK && opened == SM_OK && s->service)
        s->service->close(s->service);
    return r;
}

// Whether the log is in the middle of a description, which has the names of the machines and must not change until it is written.
static bool is_log_describing(const SmLog *log) { return log && log->description_done < log->description_size; }

// Writes the names of the machines that have been prepared into the log.
static void log_names(SmSwaps *s, SmLog *log)
{
    for (uint16_t i = 0; i < s->machines; i++) {
        SmSwappable *w = &s->machine[i];
        if (w->unnamed && sm_swap_log_names(log, w->machine, w->unnamed, w->type->identity(w->unnamed)))
            w->unnamed = NULL;
    }
}

void sm_swaps_write(SmApp *app, uint64_t budget)
{
    SmSwaps *const s = swaps_of(app);
    const uint64_t start = pal_clock_now();

    while (!is_log_describing(app->log) && sm_swaps_prepare(s) && pal_clock_now() - start < budget) {}
    if (app->log)
        log_names(s, app->log);
    (void)sm_swaps_save(s);
    if (s->next)
        s->next->write(app, budget);
    if (s->service)
        s->service->serve(s->service, budget);
}

void sm_swaps_close(SmApp *app, const SmTick *last)
{
    SmSwaps *const s = swaps_of(app);

    if (s->service)
        s->service->close(s->service);
    if (s->storage) {
        (void)sm_swaps_save(s);
        s->storage->close(s->storage);
    }
    if (s->next)
        s->next->close(app, last);
}

// ---- the exchange ----

// Whether all concerned machines are between two steps: no executor of one is inside a tick, and no machine has stores to write back.
static bool are_between_steps(const SmSwaps *s)
{
    for (uint16_t i = 0; i < s->machines; i++)
        if (s->machine[i].concerned && (s->gate[s->machine[i].executor].is_in_tick || s->machine[i].machine->write_back_due))
            return false;
    return true;
}

// Returns why the concerned machines may not be exchanged now; then *failed is the machine.  Called inside a critical section.
static SmSwapReason check_exchange(const SmSwaps *s, uint16_t *failed)
{
    SmSwapReason why = SM_SWAP_NOT_REFUSED;

    *failed = next_concerned(s, 0);
    if (s->armed && ((const uint8_t *)s->sv->at)[s->armed->offset] != 0)
        return SM_SWAP_NO_ARMED;
    for (uint16_t i = 0; i < s->machines && why == SM_SWAP_NOT_REFUSED; i++) {
        const SmSwappable *w = &s->machine[i];
        if (!w->concerned)
            continue;
        *failed = i;
        why = w->machine->last_state == 0 ? SM_SWAP_NO_STOPPED : w->type->check(running_slot(w), other_slot(w), w->change.mode);
    }
    return why;
}

// Makes the machine in the other slot the one that runs.  `starts`: it starts in a state instead of continuing.
static void switch_slots(const SmSwaps *s, SmSwappable *w, bool starts, uint64_t time)
{
    SmMachine *const m = w->machine;
    const uint32_t old = w->type->identity(running_slot(w));

    w->running ^= 1;
    w->steps = 0;
    m->self = running_slot(w);
    m->last_state = m->type->state(m->self);
    m->was_refused = false;
    w->was_aborting = w->type->is_aborting(m->self);
    emit_event(s, w, SM_EVENT_SWAP, time, old, w->type->identity(m->self));
    if (starts)
        emit_event(s, w, SM_EVENT_STATE, time, 0, m->last_state);
}

// Exchanges all machines of the swap, which are then on trial. Called inside the critical section.
static void exchange_machines(SmSwaps *s, uint64_t time)
{
    for (uint16_t i = 0; i < s->machines; i++) {
        SmSwappable *w = &s->machine[i];
        if (!w->concerned)
            continue;
        w->type->exchange(running_slot(w), other_slot(w), w->change.mode, w->machine);
        switch_slots(s, w, w->change.mode == SM_SWAP_RESTART, time);
    }
    s->status.phase = SM_SWAP_TRIAL;
}

// Exchanges the machines if all are between two steps. Else the end of the next tick tries again, TRIES times in all.
static void try_exchange(SmSwaps *s, uint64_t time)
{
    SmSwapReason why;
    uint16_t failed;

    if (!are_between_steps(s) || sm_enter(s->sv) != SM_OK) {
        if (++s->tries == TRIES)
            refuse_swap(s, SM_SWAP_NO_BOUNDARY, next_concerned(s, 0));
        return;
    }
    why = check_exchange(s, &failed);
    if (why == SM_SWAP_NOT_REFUSED)
        exchange_machines(s, time);
    else
        refuse_swap(s, why, failed);
    sm_leave(s->sv);
}

// ---- the trial ----

// Sets status.end if a machine on trial has entered a state marked @abort, or was not confirmed in time.  Skips machines whose executor is inside a
// tick.
static void check_trial(SmSwaps *s)
{
    for (uint16_t i = 0; i < s->machines && s->status.end == 0; i++) {
        SmSwappable *w = &s->machine[i];
        bool was_aborting = w->was_aborting;
        if (!w->concerned || s->gate[w->executor].is_in_tick)
            continue;
        w->was_aborting = w->type->is_aborting(running_slot(w));
        if (w->was_aborting && !was_aborting)
            s->status.end = SM_SWAP_ABORTED;
        else if (w->steps >= s->trial)
            s->status.end = SM_SWAP_TOOK_TOO_LONG;
    }
}

// Exchanges all machines back for the old ones.  If not all machines are between two steps, the end of the next tick tries again.
static void try_return(SmSwaps *s, uint64_t time)
{
    if (!are_between_steps(s) || sm_enter(s->sv) != SM_OK)
        return;
    for (uint16_t i = 0; i < s->machines; i++) {
        SmSwappable *w = &s->machine[i];
        if (w->concerned)
            switch_slots(s, w, !w->type->give_back(running_slot(w), other_slot(w), w->machine), time);
    }
    sm_leave(s->sv);
    end_trial(s, SM_SWAP_RETURNED);
}

// ---- tasks ----

SmResult sm_swappable_init(void *swappable)
{
    SmSwappable *w = swappable;
    SmResult r = sm_machine_init(w->machine);

    w->logged = *w->machine;
    if (r == SM_OK) {
        w->type->init(w->slot[0], w->slot[1]);
        w->built_in = w->type->identity(w->slot[0]);
    }
    return r;
}

SmResult sm_swappable_step(void *swappable, const SmTick *tick)
{
    SmSwappable *w = swappable;
    const SmResult r = sm_machine_step(w->machine, tick);

    w->steps += r == SM_OK;
    return r;
}

SmResult sm_swap_gate_init(void *gate)
{
    SmSwapGate *g = gate;
    const SmResult r = sm_handover_open(&g->swaps->lock);

    if (r == SM_OK)
        sm_shared_write(&g->swaps->is_open, 1);
    return r;
}

// The first task of a tick: records that the executor is inside a tick.  If the lock times out, a thread has ended inside a critical section.  Then
// no exchange follows, and the machines run on.
SmResult sm_swap_gate_enter(void *gate, const SmTick *tick)
{
    SmSwapGate *g = gate;
    const SmResult r = sm_handover_lock(g->swaps->lock);

    (void)tick;
    if (r != SM_OK)
        return r;
    g->is_in_tick = true;
    sm_handover_unlock(g->swaps->lock);
    return SM_OK;
}

// Whether the executor runs a machine that the current swap concerns.
static bool runs_concerned(const SmSwapGate *g)
{
    const SmSwaps *s = g->swaps;

    for (uint16_t i = 0; i < s->machines; i++)
        if (s->machine[i].concerned && &s->gate[s->machine[i].executor] == g)
            return true;
    return false;
}

// Publishes the states of the executor's machines to sm_swap_machine, which another thread calls.
static void publish_states(const SmSwapGate *g)
{
    const SmSwaps *s = g->swaps;

    for (uint16_t i = 0; i < s->machines; i++)
        if (&s->gate[s->machine[i].executor] == g)
            s->machine[i].state = s->machine[i].machine->last_state;
}

// The last task of a tick: exchanges machines or ends a trial, if that is due.
SmResult sm_swap_gate_leave(void *gate, const SmTick *tick)
{
    SmSwapGate *g = gate;
    SmSwaps *s = g->swaps;
    const SmResult r = sm_handover_lock(s->lock);

    if (r != SM_OK)
        return r;
    g->is_in_tick = false;
    if (s->status.phase == SM_SWAP_WAITING && runs_concerned(g))
        try_exchange(s, tick->time);
    if (s->status.phase == SM_SWAP_TRIAL && !s->confirming)
        check_trial(s);
    if (s->status.phase == SM_SWAP_TRIAL && s->status.end != 0 && runs_concerned(g))
        try_return(s, tick->time);
    publish_states(g);
    emit_due_events(s, tick->time);
    sm_handover_unlock(s->lock);
    return SM_OK;
}
