// SPDX-License-Identifier: Apache-2.0
// An application whose machine is replaced by a source from standard input.  A thread without a deadline compiles the source and begins the
// swap.  `watch` observes the swap, and prints the values of the new machine after its first step.
#include <stdio.h>
#include <string.h>

#include "runtime-c/pal/clock.h"
#include "runtime-c/pal/thread.h"
#include "runtime-c/shared.h"
#include "smc.h"
#include "stand_app.h"

enum { MEMORY = 8 << 20, TEXT = 65536, STACK = 1 << 20, TICKS_BEFORE = 40 };

static uint64_t memory[MEMORY / 8];           // the compiler's memory: the application allocates nothing while it runs
static PalThread thread;
static uint32_t ticks, is_observed, is_done;  // runtime-c/shared.h
static uint32_t machine;                      // the number of its source in the session

// ---- the thread that compiles ----

static uint64_t read_file(FILE *f, char *text) { return f ? fread(text, 1, TEXT, f) : 0; }

static void print_diagnostics(const SmcSession *s)
{
    for (uint32_t i = 0; i < smc_diag_count(s); i++)
        printf("line %d: %s\n", (int)smc_diag_place(s, i, SMC_PART_DIAG, 0, SMC_PLACE_LINE, SMC_COLUMN_BYTES), smc_diag_message(s, i));
}

static void print_what_is_kept(SmcSession *s, SmcMachine from, SmcMachine to)
{
    static const char *const kind[] = {"state", "local", "window"};           // by SMC_SWAP_STATE …

    if (smc_swap_compare(s, from, to) != SMC_OK)
        printf("%s\n", smc_error_text(s));
    for (uint32_t i = 0; i < smc_swap_item_count(s); i++)
        printf("%s %s is %s\n", kind[smc_swap_item_kind(s, i)], smc_swap_item_name(s, i), smc_swap_fate_text(smc_swap_item_fate(s, i)));
}

// Adds the state vector and the running machine as sources.  Returns that machine, for the comparison.
static SmcMachine open_running(SmcSession *s)
{
    static char text[TEXT];
    FILE *sv = fopen("stand.sv", "rb"), *sm = fopen("valve.sm", "rb");
    uint32_t vector;
    SmcMachine m = 0;

    smc_source_add(s, SMC_KIND_SV, "stand.sv", text, read_file(sv, text), &vector);
    smc_source_add(s, SMC_KIND_SM, "valve.sm", text, read_file(sm, text), &machine);
    if (smc_compile(s) != SMC_OK || smc_machine_open(s, machine, &m) != SMC_OK)
        printf("%s\n", smc_error_text(s));
    if (sv)
        fclose(sv);
    if (sm)
        fclose(sm);
    return m;
}

// Compiles a source, and begins to swap the machine for it.  The image belongs to the session, and is valid until the next call that emits or
// compiles.
static SmResult swap(SmcSession *s, const char *text, uint64_t size)
{
    SmSwapChange change = {.machine = "valve", .mode = SM_SWAP_CONTINUE};
    const void *image;
    uint64_t bytes;

    if (smc_source_replace(s, machine, text, size) != SMC_OK || smc_compile(s) != SMC_OK || smc_emit(s, SMC_EMIT_IMAGE) != SMC_OK ||
        smc_output(s, 0, &image, &bytes) != SMC_OK)
        return SM_E_ARGUMENT;
    change.image = image;
    change.size = (uint32_t)bytes;
    return sm_swap_begin(&stand_swaps, &change, 1);
}

static void pause_until(const uint32_t *word, uint32_t value)
{
    while (sm_shared_read(word) < value)
        (void)pal_clock_sleep_until(pal_clock_now() + 5 * PAL_MILLISECOND);
}

static void receive(void *unused)
{
    static char text[TEXT];
    SmcSession *s = NULL;
    SmcMachine from, to = 0;
    SmSwapStatus status;
    uint64_t size;

    (void)unused;
    if (smc_open(memory, sizeof memory, &s) == SMC_OK && smc_option_set(s, SMC_OPTION_NAMES, 1) == SMC_OK) {
        from = open_running(s);
        size = read_file(stdin, text);
        pause_until(&ticks, TICKS_BEFORE);
        if (swap(s, text, size) == SM_OK) {
            if (smc_machine_open(s, machine, &to) == SMC_OK)
                print_what_is_kept(s, from, to);
            pause_until(&is_observed, 1);
            if (sm_swap_status(&stand_swaps, &status) == SM_OK && status.phase == SM_SWAP_TRIAL && sm_swap_confirm(&stand_swaps) == SM_OK)
                printf("confirmed\n");
        } else {
            print_diagnostics(s);
        }
        smc_close(s);
    }
    sm_shared_write(&is_done, 1);
}

// ---- tasks ----

SmResult ramp_step(const SmTick *tick)
{
    stand_set_pressure((double)tick->number);
    return SM_OK;
}

SmResult watch_init(void)
{
    const PalThreadPlan plan = {"compile", 0, STACK};

    return pal_thread_create(&thread, &plan, receive, NULL);
}

// Prints the result of the swap once.  The exchange is between two ticks, so this is after the first step of the new machine.
SmResult watch_step(const SmTick *tick)
{
    static uint32_t count;
    SmSwapStatus s = {.phase = SM_SWAP_IDLE};

    (void)sm_swap_status(&stand_swaps, &s);
    if (!is_observed && (s.phase == SM_SWAP_TRIAL || s.phase == SM_SWAP_REFUSED)) {
        printf("%s, the average lags by %.1f, the count rose by %u\n", s.phase == SM_SWAP_TRIAL ? "swapped" : sm_swap_reason_text(s.reason),
               stand_pressure() - stand_average(), (unsigned)(stand_count() - count));
        sm_shared_write(&is_observed, 1);
    }
    count = stand_count();
    sm_shared_write(&ticks, (uint32_t)tick->number);
    if (sm_shared_read(&is_done)) {
        (void)pal_thread_join(thread, PAL_SECOND);
        sm_app_stop(&stand_app);
    }
    return SM_OK;
}
