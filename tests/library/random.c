// SPDX-License-Identifier: Apache-2.0
// Random sequences of calls of all functions in smc.h: valid and invalid arguments, changed sources and images, little memory, closed handles.
// Nothing may crash, and every result must be one that the header lists.    random SEED COUNT      COUNT sequences, from seed SEED on
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/library/smc.h"
#include "tests/test.h"

enum { CALLS = 60, HANDLES = 6 };

static uint64_t state;

static uint64_t asked;        // calls while a machine had requirements

static uint32_t random_below(uint32_t n)
{
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)(((state >> 33) * n) >> 31);
}

// The sources that a sequence adds: names in two folders, and texts of which most fit together.
static const struct { const char *name; int32_t kind; const char *text; } source_of[] = {
    {"0.sv", SMC_KIND_SV, "[Bus]\nU64 G\nU32 S\nF64 p @range 0 100\nbool v\nI8 k\n"},
    {"1.sm", SMC_KIND_SM, "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\nI8 k\n[local]\nU32 n = 0\n[A] @safe\n.step\n    n = n + 1\n    k = n\n"
                          "    v = roll_avg(p, 20) > 5\n    p > 90: -> B\n[B] @abort\n.entry\n    v = false\n"},
    {"dir/2.sm", SMC_KIND_SM, "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\n[local]\nF64 n = 1\n[First]\n[A] @swap\n.step\n    n = n * 2\n"
                              "    v = roll_max(p, 20) > n\n"},
    {"3.ss", SMC_KIND_SS, "[options]\ndelta_t 1\n[all_states]\nG == 5: p = 7\nG == 9 {\n    @assert not v\n    @stop\n}\n"},
    {"4.ss", SMC_KIND_SS, "[options]\ndelta_t 1\n[A]\np > 5: @assert false\nG > 50: @stop\n"},
    {"5.io", SMC_KIND_IO, "[digital]\no 8 v\n"},
    {"6.app", SMC_KIND_APP, "[options]\nstate_vector \"0.sv\"\ntime G 1 ms\nnet \"8.net\"\n[main]\nevery 10 ms:\n    receive\n    machine m \"1.sm\"\n    send\n"},
    {"7.rq", SMC_KIND_RQ, "R1 \"p\" always p < 50\nR2 \"v\" never v and p < 1\n"},
    {"8.net", SMC_KIND_NET, "endpoint ground 10.0.0.2:5000\nsend telemetry every 20 ms to ground { [Bus] }\n"
                            "receive commands on 5001 @timeout 100 ms\n{\n    p @default 0.5\n}\n"},
    {"9.ss", SMC_KIND_SS, "[options]\ndelta_t 10\n[data]\nfile \"logs/10.csv\"\ntime \"t\" ms\np = \"P\"\n@compare v \"V\" delay 10 ms\n"
                          "[all_states]\nG == 40: @assert p == 79\nG == 40: @stop\n"},
    {"logs/10.csv", SMC_KIND_DATA, "t,P,V\n0,70,0\n20,79,1\n"},
    {"a\nb", SMC_KIND_SM, "if x then y = 1 else ->"},
    {"", SMC_KIND_SV, ""}};
enum { SOURCES = sizeof source_of / sizeof *source_of };

static double nan_value(void)
{
    const double zero = 0;

    return zero / zero;
}

// Copies a text with a few bytes changed or removed into `text`, which has room for 2000 bytes.  Half of the texts stay as they are.
static size_t mutate(const char *from, char *text)
{
    size_t n = strlen(from);

    memcpy(text, from, n);
    for (uint32_t i = random_below(4); i > 0 && n > 0 && random_below(2); i--) {
        const size_t at = random_below((uint32_t)n), length = random_below(20);
        if (random_below(2))
            text[at] = (char)random_below(256);
        else if (at + length <= n) {
            memmove(text + at, text + at + length, n - at - length);
            n -= length;
        }
    }
    return n;
}

static void add_source(SmcSession *s)
{
    const uint32_t i = random_below(SOURCES);
    char text[2000];
    const size_t size = mutate(source_of[random_below(8) ? i : random_below(SOURCES)].text, text);
    uint32_t source;

    smc_source_add(s, random_below(8) ? source_of[i].kind : (int32_t)random_below(10) - 1, source_of[i].name, text, size, &source);
}

static void read_diagnostics(const SmcSession *s)
{
    for (uint32_t i = 0; i < smc_diag_count(s) + smc_diag_allowed_count(s) + 1; i++) {
        CHECK(strlen(smc_diag_message(s, i)) + strlen(smc_diag_label(s, i)) + strlen(smc_diag_code(s, i)) < 100000);
        CHECK(strlen(smc_diag_warning(s, i)) + strlen(smc_diag_allowed(s, i)) < 100000 && smc_diag_severity(s, i) >= -1);
        for (int32_t place = -1; place < 8; place++)
            CHECK(smc_diag_place(s, i, (int32_t)random_below(4), random_below(3), place, (int32_t)random_below(3)) >= -1);
        for (uint32_t k = 0; k <= smc_diag_note_count(s, i); k++)
            CHECK(strlen(smc_diag_note(s, i, k)) < 100000 && smc_diag_note_step(s, i, k) < 10000);
        for (uint32_t k = 0; k <= smc_diag_edit_count(s, i); k++)
            CHECK(strlen(smc_diag_edit(s, i, k)) < 100000);
    }
}

static void open_changed_image(SmcSession *s, SmcMachine *m)
{
    const void *bytes;
    uint64_t size;
    unsigned char *copy;
    uint32_t count;

    if (smc_output(s, random_below(2), &bytes, &size) != SMC_OK || (copy = malloc((size_t)size + 1)) == NULL)
        return;
    memcpy(copy, bytes, (size_t)size);
    for (uint32_t i = random_below(3); i > 0 && size > 0; i--)
        copy[random_below((uint32_t)size)] ^= (unsigned char)(1u << random_below(8));
    size = random_below(10) ? size : random_below((uint32_t)size + 1);
    if (smc_image_machine_count(s, copy, size, &count) == SMC_OK)
        CHECK(count <= 256 && (count == 0 || smc_machine_open_image(s, copy, size, random_below(count), m) != SMC_E_INDEX));
    smc_machine_open_image(s, copy, size, random_below(3), m);
    free(copy);
}

static void run_columns(SmcSession *s, SmcMachine m)
{
    enum { ROWS = 40, COLUMNS = 3 };
    uint64_t g[ROWS], done = 99;
    double in[COLUMNS][ROWS], out[COLUMNS][ROWS];
    const double *from[COLUMNS];
    double *to[COLUMNS];
    uint32_t variable[2][COLUMNS], states[ROWS];
    const uint32_t rows = random_below(ROWS + 1), inputs = random_below(COLUMNS + 1), outputs = random_below(COLUMNS + 1);
    SmcResult r;

    for (uint32_t i = 0; i < ROWS; i++)
        g[i] = random_below(30) ? smc_machine_time(s, m) + 2000 + i : UINT64_MAX - random_below(40);
    for (uint32_t k = 0; k < COLUMNS; k++) {
        for (uint32_t i = 0; i < ROWS; i++)
            in[k][i] = random_below(9) ? (double)random_below(2000) - 1000 : nan_value();
        variable[0][k] = random_below(6);
        variable[1][k] = random_below(7);
        from[k] = random_below(20) ? in[k] : NULL;
        to[k] = random_below(20) ? random_below(4) ? out[k] : in[k] : NULL;
    }
    r = smc_machine_run(s, m, random_below(40) ? rows : UINT64_MAX, random_below(20) ? g : NULL, inputs, random_below(20) ? variable[0] : NULL, from, outputs, variable[1],
                        random_below(20) ? to : NULL, random_below(2) ? states : NULL, random_below(20) ? &done : NULL);
    CHECK(done == 99 || (r == SMC_OK ? done == rows : done <= rows));
}

static void use_machine(SmcSession *s, SmcMachine m, SmcMachine other)
{
    const uint32_t i = random_below(10);
    double x = random_below(3) ? (double)random_below(2000) - 1000 : nan_value();
    unsigned char bytes[8];

    switch (random_below(13)) {
    case 0: smc_machine_step(s, m, random_below(4) ? smc_machine_time(s, m) + random_below(1000) : UINT64_MAX - random_below(2)); break;
    case 1: smc_machine_start(s, m, random_below(4)); break;
    case 2: smc_machine_set(s, m, i, x); break;
    case 3: smc_machine_get(s, m, i, &x); break;
    case 4: smc_machine_read(s, m, i, bytes, random_below(10)); break;
    case 5: memset(bytes, (int)random_below(256), sizeof bytes); smc_machine_write(s, m, i, bytes, random_below(9)); break;
    case 6: smc_machine_continue(s, m, other); break;
    case 7: CHECK(smc_machine_variable_type(s, m, i) >= -1 && smc_machine_variable_kind(s, m, i) >= -1 && smc_machine_variable_stored(s, m, i) >= 0); break;
    case 8: CHECK(strlen(smc_machine_variable_name(s, m, i)) < 3000 && strlen(smc_machine_state_name(s, m, random_below(4))) < 3000); break;
    case 9: smc_machine_info(s, m, (int32_t)random_below(8) - 1); break;
    case 10: if (smc_machine_vector(s, m)) memset(smc_machine_vector(s, m), (int)random_below(256), (size_t)smc_machine_info(s, m, SMC_INFO_VECTOR)); break;
    case 11: smc_machine_state_marks(s, m, random_below(4)); break;
    case 12: run_columns(s, m); break;
    }
}

// Reads everything that the session reports about the structure of a source, and at one index beyond each end.
static void read_structure(const SmcSession *s, uint32_t sm)
{
    const uint32_t states = smc_model_state_count(s, sm), variables = smc_model_variable_count(s, sm);

    CHECK(smc_model_state_marks(s, sm, 0) == 0 && smc_model_state_line(s, sm, states + 1) == 0);
    for (uint32_t i = 0; i <= states + 1; i++)
        CHECK((smc_model_state_name(s, sm, i)[0] != '\0') == (i >= 1 && i <= states) && smc_model_state_marks(s, sm, i) < 16);
    for (uint32_t i = 0; i < smc_model_transition_count(s, sm); i++)
        CHECK(smc_model_transition_from(s, sm, i) - 1 < states && smc_model_transition_to(s, sm, i) - 1 < states && smc_model_transition_line(s, sm, i) > 0 &&
              smc_model_transition_block(s, sm, i) >= 0 && strlen(smc_model_transition_guard(s, sm, i)) < 100000);
    for (uint32_t i = 0; i < variables; i++)
        CHECK(smc_model_variable_name(s, sm, i)[0] != '\0' && smc_model_variable_type(s, sm, i) >= 0 && smc_model_variable_kind(s, sm, i) >= 0 &&
              smc_model_variable_line(s, sm, i) > 0);
    for (uint32_t i = 0; i < smc_model_use_count(s, sm); i++)
        CHECK(smc_model_use_state(s, sm, i) - 1 < states && smc_model_use_variable(s, sm, i) >= 0 && smc_model_use_variable(s, sm, i) < variables &&
              smc_model_use_access(s, sm, i) - 1 < 3);
}

static void compare_machines(SmcSession *s, SmcMachine from, SmcMachine to)
{
    if (smc_swap_compare(s, from, to) == SMC_OK && random_below(2))
        smc_machine_close(s, random_below(2) ? from : to);
    for (uint32_t i = 0; i < smc_swap_item_count(s); i++)
        CHECK(strlen(smc_swap_item_name(s, i)) > 0 && smc_swap_item_kind(s, i) >= 0 && smc_swap_fate_text(smc_swap_item_fate(s, i))[0] != '\0');
    CHECK(smc_swap_item_kind(s, smc_swap_item_count(s)) == -1);
}

// Reads what the session reports without an argument or by a number: about the library, the sources, the options, the application and the outputs.
static void read_session(const SmcSession *s)
{
    const uint32_t n = random_below(4) ? random_below(12) : UINT32_MAX;
    const int32_t kind = smc_source_kind(s, n);

    CHECK(smc_api_version() == SMC_API_VERSION && smc_version()[0] != '\0' && smc_result_text((SmcResult)((int32_t)random_below(20) - 16))[0] != '\0');
    CHECK((n < smc_warning_count()) == (smc_warning_name(n)[0] != '\0' && smc_warning_group(n)[0] != '\0' && smc_warning_sentence(n)[0] != '\0'));
    CHECK(strlen(smc_explain(smc_warning_name(n))) < 100000 && strlen(smc_explain(smc_diag_code(s, n))) < 100000);
    CHECK(smc_memory_used(s) <= smc_memory_peak(s));
    CHECK(kind >= -1 && kind <= SMC_KIND_DATA && (kind < 0 || (n < smc_source_count(s) && smc_source_name(s, n)[0] != '\0')));
    CHECK(smc_option(s, (int32_t)random_below(14) - 1) < 100);
    CHECK((n < smc_app_file_count(s)) == (smc_app_file_kind(s, n) >= 0) && (n < smc_app_file_count(s) || smc_app_file_name(s, n)[0] == '\0'));
    CHECK((n < smc_output_count(s)) == (smc_output_name(s, n)[0] != '\0'));
}

// Reads what the session reports about a machine's requirements and a script's run, each by a number that often does not exist.
static void read_run(const SmcSession *s, uint32_t source)
{
    const uint32_t n = random_below(4) ? random_below(3) : UINT32_MAX;

    asked += smc_requirement_count(s, n) > 0;
    CHECK(smc_requirement_count(s, n) < 1000 && strlen(smc_requirement_id(s, n, source)) < 1000 && strlen(smc_requirement_text(s, source, n)) < 100000);
    CHECK(smc_run_requirement(s, source, n) <= SMC_REQUIREMENT_UNDECIDED && smc_run_judged(s, source, n) <= 1000000);
    CHECK(smc_run_outcome(s, source) <= SMC_OUTCOME_DIFFERENT && smc_run_steps(s, source) <= 1000000 && smc_run_asserts(s, source) <= 1000000);
    CHECK(strlen(smc_run_report(s, source)) < 1000000 && strlen(smc_run_trace(s, source)) < 10000000);
}

static void read_machine(const SmcSession *s, SmcMachine m)
{
    const uint32_t states = smc_machine_state_count(s, m), variables = smc_machine_variable_count(s, m);
    uint32_t i = random_below(variables + 2), found = UINT32_MAX;
    const char *name = smc_machine_variable_name(s, m, i);

    CHECK(smc_machine_state(s, m) <= states && strlen(smc_machine_name(s, m)) < 100000);
    CHECK(smc_machine_variable_offset(s, m, i) <= 100000);
    CHECK((smc_machine_find(s, m, name, &found) == SMC_OK && found < variables) || i >= variables || name[0] == '\0');
}

static void call_once(SmcSession *s, SmcMachine *machine)
{
    const char *text;
    uint64_t size;
    uint32_t n, source = random_below(9);
    char changed[2000];
    SmcMachine *m = &machine[random_below(HANDLES)];
    static const char *const words[] = {"everything", "no-dead-code", "error", "flight", "nonsense", "error=output-left-on"};
    static const char *const prefixes[] = {"", "tank", "a_b", "9", "a b"};

    switch (random_below(24)) {
    case 0: case 1: case 2: add_source(s); break;
    case 3: size = mutate(source_of[random_below(SOURCES)].text, changed); smc_source_replace(s, source, changed, size); break;
    case 4: if (random_below(5) == 0) smc_sources_clear(s); break;
    case 5: smc_option_set(s, (int32_t)random_below(14) - 1, random_below(3)); break;
    case 6: if (random_below(5)) smc_warning_select(s, words[random_below(6)]); else smc_warnings_reset(s); break;
    case 7: if (random_below(4) == 0) smc_cancel(s, (int32_t)random_below(3)); break;
    case 8: case 9: smc_compile(s); break;
    case 10: if (random_below(6) == 0) smc_prefix_set(s, prefixes[random_below(5)]); smc_emit(s, (int32_t)random_below(8)); break;
    case 11: smc_run(s, source, random_below(9), random_below(200)); break;
    case 12: smc_diagram(s, source, (int32_t)random_below(4), &text, &size); break;
    case 13: smc_report(s, source, (int32_t)random_below(4), &text, &size); break;
    case 14: smc_render(s, (int32_t)random_below(5), &text, &size); break;
    case 15: smc_apply_edits(s, source, &text, &size, &n); break;
    case 16: smc_machine_open(s, source, m); break;
    case 17: open_changed_image(s, m); break;
    case 18: if (random_below(3) == 0) smc_source_remove(s, source); break;
    case 22: smc_script_assign(s, source, random_below(6)); break;
    case 19: read_structure(s, source); break;
    case 20: compare_machines(s, *m, machine[random_below(HANDLES)]); break;
    case 21: if (random_below(4) == 0) smc_machine_close(s, *m); else read_diagnostics(s); break;
    default: use_machine(s, *m, machine[random_below(HANDLES)]); break;
    }
    read_session(s);
    read_run(s, source);
    read_machine(s, *m);
    CHECK(strlen(smc_error_text(s)) < 1000);
}

static void run_sequence(uint64_t seed)
{
    SmcSession *s = NULL;
    SmcMachine machine[HANDLES] = {0};
    uint64_t size;
    void *area;

    state = seed * UINT64_C(0x9e3779b97f4a7c15) + 1;
    size = random_below(3) == 0 ? 10000 + random_below(600000) : 4000000;
    area = random_below(2) ? malloc((size_t)size) : NULL;
    if (smc_open(area, size, &s) == SMC_OK) {
        for (int i = 0; i < CALLS; i++)
            call_once(s, machine);
        CHECK(smc_memory_peak(s) <= size);
        CHECK(smc_close(s) == SMC_OK);
    }
    free(area);
}

// The texts as they are fit together: the machine with its scripts, pins, requirements and recorded data, and the application with its messages.
static void check_sources(void)
{
    for (int of_app = 0; of_app < 2; of_app++) {
        SmcSession *s = NULL;
        uint32_t source[SOURCES];
        CHECK(smc_open(NULL, 0, &s) == SMC_OK);
        for (uint32_t i = 0; i < 11; i++) {
            const int32_t kind = source_of[i].kind;
            const bool belongs = of_app ? kind == SMC_KIND_APP || kind == SMC_KIND_NET || i < 2 : kind != SMC_KIND_APP && kind != SMC_KIND_NET && i != 2;
            if (belongs)
                CHECK(smc_source_add(s, kind, source_of[i].name, source_of[i].text, strlen(source_of[i].text), &source[i]) == SMC_OK);
        }
        CHECK(smc_compile(s) == SMC_OK);
        if (of_app)
            CHECK(smc_app_file_count(s) == 3 && smc_emit(s, SMC_EMIT_C) == SMC_OK);
        else
            CHECK(smc_requirement_count(s, source[1]) == 2 && smc_run(s, source[9], SMC_ENGINE_VM, 0) == SMC_E_FAILED);
        CHECK(smc_close(s) == SMC_OK);
    }
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 1, count = argc > 2 ? strtoull(argv[2], NULL, 10) : 300;

    check_sources();
    for (uint64_t i = 0; i < count; i++) {
        run_sequence(seed + i);
        test_passed++;
        if (i % 10000 == 9999)
            fprintf(stderr, "seeds up to %" PRIu64 " done\n", seed + i);
    }
    CHECK(count < 500 || asked > 0);
    return test_end("random");
}
