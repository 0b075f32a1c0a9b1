// SPDX-License-Identifier: Apache-2.0
// Refuses each allocation of each call of libsmc, one after the other.  The call returns SMC_E_MEMORY, and everything that the session reports
// is unchanged.  The memory in use does not grow with repeated calls.
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "compiler/library/smc.h"
#include "tests/test.h"

static const char machine[] = "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\nbool w\n[local]\nU32 n = 0\n[A] @safe\n.step\n    n = n + 1\n    v = roll_avg(p, 20) > 5 and n > 3\n"
                              "    p > 90: -> B\n[B]\n.step\n    v = false\n[C]\n";
static const char script[] = "[options]\ndelta_t 1\n[all_states]\nG == 5: p = 7\nG == 9 {\n    @assert v\n    @stop\n}\n";

// ---- malloc ----

static long refuse_at;            // number of the allocation that fails, counted from now, from 1; 0: none

void *__real_malloc(size_t size);
void *__wrap_malloc(size_t size);
static long allocations;
static clock_t last_allocation, longest_gap;      // CPU time between two allocations

void *__wrap_malloc(size_t size)
{
    const clock_t now = clock();

    longest_gap = now - last_allocation > longest_gap ? now - last_allocation : longest_gap;
    last_allocation = now;
    allocations++;
    return refuse_at > 0 && --refuse_at == 0 ? NULL : __real_malloc(size);
}

// ---- calls ----

static uint32_t sm, ss;

typedef SmcResult Call(SmcSession *s);

static SmcResult call_add(SmcSession *s)
{
    uint32_t source;

    return smc_source_add(s, SMC_KIND_SM, "new.sm", machine, strlen(machine), &source);
}

static SmcResult call_replace(SmcSession *s) { return smc_source_replace(s, sm, script, strlen(script)); }
static SmcResult call_select(SmcSession *s) { return smc_warning_select(s, "extra"); }
static SmcResult call_prefix(SmcSession *s) { return smc_prefix_set(s, "Other"); }
static SmcResult call_emit(SmcSession *s) { return smc_emit(s, SMC_EMIT_C); }
static SmcResult call_emit_ast(SmcSession *s) { return smc_emit(s, SMC_EMIT_AST); }
static SmcResult call_run(SmcSession *s) { return smc_run(s, ss, SMC_ENGINE_VM | SMC_ENGINE_REF, 0); }

static SmcResult call_render(SmcSession *s)
{
    const char *text;
    uint64_t size;

    return smc_render(s, SMC_RENDER_SARIF, &text, &size);
}

static SmcResult call_edit(SmcSession *s)
{
    const char *text;
    uint64_t size;
    uint32_t fixed;

    return smc_apply_edits(s, sm, &text, &size, &fixed);
}

static SmcResult call_draw(SmcSession *s)
{
    const char *text;
    uint64_t size;

    return smc_diagram(s, sm, SMC_DIAGRAM_SVG, &text, &size);
}

static SmcResult call_report(SmcSession *s)
{
    const char *text;
    uint64_t size;

    return smc_report(s, sm, SMC_REPORT_HTML, &text, &size);
}

static SmcResult call_open_and_close(SmcSession *s)
{
    SmcMachine m = 0;
    const SmcResult r = smc_machine_open(s, sm, &m);

    CHECK(r == SMC_OK ? smc_machine_close(s, m) == SMC_OK : m == 0);
    return r;
}

static unsigned char *image;       // the image of the machine
static uint64_t image_size;

static SmcResult call_open_image(SmcSession *s)
{
    SmcMachine m = 0;
    const SmcResult r = smc_machine_open_image(s, image, image_size, 0, &m);

    CHECK(r == SMC_OK ? smc_machine_close(s, m) == SMC_OK : m == 0);
    return r;
}

// Opens two machines, and closes them after a call.
static SmcResult with_two_machines(SmcSession *s, SmcResult (*call)(SmcSession *s, SmcMachine from, SmcMachine to))
{
    SmcMachine from = 0, to = 0;
    SmcResult r = smc_machine_open(s, sm, &from);

    if (r == SMC_OK)
        r = smc_machine_open(s, sm, &to);
    if (r == SMC_OK)
        r = call(s, from, to);
    CHECK(from == 0 || smc_machine_close(s, from) == SMC_OK);
    CHECK(to == 0 || smc_machine_close(s, to) == SMC_OK);
    return r;
}

static SmcResult call_compare(SmcSession *s) { return with_two_machines(s, smc_swap_compare); }
static SmcResult call_continue(SmcSession *s) { return with_two_machines(s, smc_machine_continue); }

static SmcResult call_add_and_remove(SmcSession *s)
{
    uint32_t source = 0;
    const SmcResult r = smc_source_add(s, SMC_KIND_SS, "other.ss", script, strlen(script), &source);

    if (r == SMC_OK)
        CHECK(source == 2 && smc_source_remove(s, source) == SMC_OK);
    return r;
}

static SmcResult call_run_columns(SmcSession *s)
{
    static const uint64_t g[] = {1, 2};
    static const double p[] = {7, 8};
    static const double *const from[] = {p};
    SmcMachine m = 0;
    uint32_t input;
    uint64_t done = 9;
    SmcResult r = smc_machine_open(s, sm, &m);

    if (r != SMC_OK)
        return r;
    CHECK(smc_machine_find(s, m, "p", &input) == SMC_OK);
    r = smc_machine_run(s, m, 2, g, 1, &input, from, 0, NULL, NULL, NULL, &done);
    CHECK(done == (r == SMC_OK ? 2 : 0) && smc_machine_close(s, m) == SMC_OK);
    return r;
}

static const struct { const char *name; Call *call; SmcResult result; } calls[] = {
    {"add", call_add, SMC_OK}, {"replace", call_replace, SMC_OK}, {"select", call_select, SMC_OK}, {"prefix", call_prefix, SMC_OK},
    {"emit", call_emit, SMC_OK}, {"emit the tree", call_emit_ast, SMC_OK}, {"run", call_run, SMC_E_FAILED}, {"render", call_render, SMC_OK},
    {"edit", call_edit, SMC_OK}, {"draw", call_draw, SMC_OK}, {"report", call_report, SMC_OK}, {"open", call_open_and_close, SMC_OK},
    {"open an image", call_open_image, SMC_OK}, {"compare", call_compare, SMC_OK}, {"continue", call_continue, SMC_OK},
    {"add and remove", call_add_and_remove, SMC_OK}, {"run columns", call_run_columns, SMC_OK}};
enum { CALLS = sizeof calls / sizeof *calls };

// ---- what a session shows ----

typedef struct Shown { char *text; size_t n; } Shown;

static void append(Shown *to, const void *bytes, size_t n)
{
    to->text = realloc(to->text, to->n + n + 1);
    CHECK(to->text != NULL);
    memcpy(to->text + to->n, bytes, n);
    to->n += n;
    to->text[to->n] = '\n';
}

static void append_text(Shown *to, const char *text) { append(to, text, strlen(text) + 1); }

// Reads everything that the session reports, with calls that allocate no memory.
static Shown read_session(const SmcSession *s)
{
    Shown to = {NULL, 0};
    const uint64_t number[] = {smc_source_count(s), smc_diag_count(s), smc_diag_allowed_count(s), smc_output_count(s), smc_run_steps(s, ss),
                               (uint64_t)smc_run_outcome(s, ss), smc_run_asserts(s, ss), smc_model_use_count(s, sm), smc_swap_item_count(s)};

    append(&to, number, sizeof number);
    for (uint32_t i = 0; i < smc_diag_count(s); i++) {
        const int64_t place[] = {smc_diag_severity(s, i), smc_diag_place(s, i, 0, 0, SMC_PLACE_OFFSET, 0), smc_diag_place(s, i, 0, 0, SMC_PLACE_SOURCE, 0)};
        append_text(&to, smc_diag_message(s, i));
        append_text(&to, smc_diag_label(s, i));
        append(&to, place, sizeof place);
    }
    for (uint32_t i = 0; i < smc_output_count(s); i++) {
        const void *bytes = NULL;
        uint64_t size = 0;
        CHECK(smc_output(s, i, &bytes, &size) == SMC_OK);
        append_text(&to, smc_output_name(s, i));
        append(&to, bytes, (size_t)size);
    }
    append_text(&to, smc_run_report(s, ss));
    for (uint32_t t = 0; t < smc_model_transition_count(s, sm); t++)
        append_text(&to, smc_model_transition_guard(s, sm, t));
    for (uint32_t i = 0; i < smc_swap_item_count(s); i++)
        append_text(&to, smc_swap_item_name(s, i));
    return to;
}

static bool is_equal(Shown a, Shown b) { return a.n == b.n && memcmp(a.text, b.text, a.n) == 0; }

// ---- tests ----

static SmcSession *open_compiled(void)
{
    SmcSession *s = NULL;

    CHECK(smc_open(NULL, 0, &s) == SMC_OK);
    CHECK(smc_source_add(s, SMC_KIND_SM, "a.sm", machine, strlen(machine), &sm) == SMC_OK);
    CHECK(smc_source_add(s, SMC_KIND_SS, "a.ss", script, strlen(script), &ss) == SMC_OK);
    CHECK(smc_option_set(s, SMC_OPTION_REVIEW, 1) == SMC_OK && smc_compile(s) == SMC_OK && smc_diag_count(s) > 0);
    return s;
}

static void emit_image(void)
{
    SmcSession *s = open_compiled();
    const void *bytes = NULL;

    CHECK(smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output(s, 0, &bytes, &image_size) == SMC_OK && (image = malloc((size_t)image_size)) != NULL);
    memcpy(image, bytes, (size_t)image_size);
    CHECK(smc_close(s) == SMC_OK);
}

// Refuses each allocation of one call in turn, until the call allocates no more.  Returns the number of allocations.
static long refuse_each(SmcSession *s, Call *call, SmcResult expected)
{
    for (long k = 1; k < 100000; k++) {
        const Shown before = read_session(s);
        Shown after;
        SmcResult r;
        bool was_refused;

        refuse_at = k;
        r = call(s);
        was_refused = refuse_at == 0;
        refuse_at = 0;
        CHECK(r == (was_refused ? SMC_E_MEMORY : expected));
        after = read_session(s);
        CHECK(!was_refused || is_equal(before, after) || (call == call_report && smc_run_outcome(s, ss) == SMC_OUTCOME_FAILED));       // it ran the script
        free(before.text);
        free(after.text);
        if (!was_refused)
            return k - 1;
    }
    return 0;
}

// In a new session, and in one in which the same call and an emission have succeeded before.
static void test_refused_allocations(int i)
{
    SmcSession *s = open_compiled();

    CHECK(refuse_each(s, calls[i].call, calls[i].result) > 0);
    CHECK(smc_close(s) == SMC_OK);
    s = open_compiled();
    CHECK(smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_run(s, ss, SMC_ENGINE_VM, 0) == SMC_E_FAILED);
    refuse_each(s, calls[i].call, calls[i].result);
    CHECK(calls[i].call == call_replace || calls[i].call == call_add || smc_compile(s) == SMC_OK);
    CHECK(smc_close(s) == SMC_OK);
}

static void test_refused_while_compiling(void)
{
    SmcSession *s = open_compiled();
    SmcResult r = SMC_E_MEMORY;

    for (long k = 1; r == SMC_E_MEMORY && k < 100000; k++) {
        refuse_at = k;
        r = smc_compile(s);
        CHECK(r == SMC_E_MEMORY ? refuse_at == 0 && smc_diag_count(s) == 0 && smc_emit(s, SMC_EMIT_IMAGE) == SMC_E_STATE : r == SMC_OK && k > 3);
        refuse_at = 0;
    }
    CHECK(smc_close(s) == SMC_OK);
}

static void test_refused_while_opening(void)
{
    SmcSession *s = NULL;

    refuse_at = 1;
    CHECK(smc_open(NULL, 0, &s) == SMC_E_MEMORY && s == NULL);
    refuse_at = 0;
}

static void use_everything(SmcSession *s, int round)
{
    const char *text;
    uint64_t size;

    for (int i = 2; i < CALLS; i++)
        CHECK(calls[i].call(s) == calls[i].result || calls[i].call == call_replace);
    for (int i = 0; i < 3; i++) {
        CHECK(smc_render(s, i, &text, &size) == SMC_OK && smc_diagram(s, sm, i, &text, &size) == SMC_OK && smc_report(s, sm, i, &text, &size) == SMC_OK);
        CHECK(smc_emit(s, SMC_EMIT_IMAGE + (round + i) % 6) == SMC_OK);
    }
    CHECK(smc_run(s, ss, 1u << round % 3, 0) == SMC_E_FAILED && smc_run(s, ss, 1, 3) == SMC_E_FAILED);
    CHECK(smc_warning_select(s, "nonsense") == SMC_E_ARGUMENT && smc_warnings_reset(s) == SMC_OK);
}

static void test_memory_is_bounded(void)
{
    SmcSession *s = open_compiled();
    uint64_t peak = 0;

    for (int round = 0; round < 36; round++) {
        use_everything(s, round);
        if (round == 11)
            peak = smc_memory_peak(s);
    }
    CHECK(peak > 0 && smc_memory_peak(s) == peak);
    CHECK(smc_close(s) == SMC_OK);
}

// smc_cancel is noticed at an allocation, so every long search must allocate.
static void test_cancel_is_noticed(void)
{
    SmcSession *s = open_compiled();
    clock_t start;

    CHECK(smc_warning_select(s, "flight") == SMC_OK && smc_option_set(s, SMC_OPTION_REVIEW, 0) == SMC_OK);
    longest_gap = 0;
    start = last_allocation = clock();
    CHECK(smc_compile(s) == SMC_OK);
    CHECK(longest_gap <= (last_allocation - start) / 4);
    CHECK(smc_close(s) == SMC_OK);
}

static void test_many_sources(void)
{
    enum { SOURCES = 2000 };
    SmcSession *s = NULL;
    uint32_t source;

    CHECK(smc_open(NULL, 0, &s) == SMC_OK);
    allocations = 0;
    for (int i = 0; i < SOURCES; i++)
        CHECK(smc_source_add(s, SMC_KIND_SM, "a.sm", "", 0, &source) == SMC_OK && smc_warning_select(s, "all") == SMC_OK);
    CHECK(allocations < 5 * SOURCES);              // name, text, word, and two for the check of the word; but no array for each source
    CHECK(smc_close(s) == SMC_OK);
}

int main(void)
{
    emit_image();
    for (int i = 0; i < CALLS; i++)
        test_refused_allocations(i);
    test_refused_while_compiling();
    test_refused_while_opening();
    test_memory_is_bounded();
    test_cancel_is_noticed();
    test_many_sources();
    free(image);
    return test_end("refuse");
}
