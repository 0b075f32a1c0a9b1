// SPDX-License-Identifier: Apache-2.0
// libsmc through its public header alone: the effect of each function, and its result for bad arguments.  machines.c tests the functions
// that run machines.
#include <locale.h>
#include <stdlib.h>

#include "tests/library/session.h"

static const char script[] = "[options]\ndelta_t 10\n[all_states]\nG == 20: p = 800\nG == 50 {\n    @assert valve\n    @stop\n}\n";
static const char failing[] = "[options]\ndelta_t 10\n[all_states]\nG == 20 {\n    @assert p > 1\n    @stop\n}\n";

// ---- compiling ----

static void test_compiling(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "dir/tank.sm", tank);
    const void *bytes;
    uint64_t size;

    CHECK(smc_source_count(s) == 1 && is_text(smc_source_name(s, sm), "dir/tank.sm") && smc_source_kind(s, sm) == SMC_KIND_SM);
    CHECK(smc_emit(s, SMC_EMIT_IMAGE) == SMC_E_STATE);
    CHECK(smc_compile(s) == SMC_OK && smc_diag_count(s) == 0);
    CHECK(smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output_count(s) == 1 && is_text(smc_output_name(s, 0), "tank.smb"));
    CHECK(smc_output(s, 0, &bytes, &size) == SMC_OK && size > 50 && memcmp(bytes, "smb", 3) == 0);
    CHECK(smc_emit(s, SMC_EMIT_C) == SMC_OK && smc_output_count(s) == 2 && is_text(smc_output_name(s, 1), "tank.h"));
    CHECK(smc_output(s, 0, &bytes, &size) == SMC_OK && strstr(bytes, "#include \"tank.h\"") != NULL);
    CHECK(smc_emit(s, SMC_EMIT_ARRAY) == SMC_OK && is_text(smc_output_name(s, 0), "tank_image.h"));
    CHECK(smc_emit(s, SMC_EMIT_IR) == SMC_OK && is_text(smc_output_name(s, 0), "tank.ir"));
    CHECK(smc_emit(s, SMC_EMIT_AST) == SMC_OK && smc_emit(s, SMC_EMIT_TOKENS) == SMC_OK && is_text(smc_output_name(s, 0), "tank.tokens"));
    CHECK(smc_output(s, 1, &bytes, &size) == SMC_E_INDEX && is_text(smc_output_name(s, 1), ""));
    CHECK(smc_prefix_set(s, "Vent") == SMC_OK && smc_emit(s, SMC_EMIT_C) == SMC_OK);
    CHECK(smc_output(s, 1, &bytes, &size) == SMC_OK && strstr(bytes, "Vent_step") != NULL);
    CHECK(smc_option_set(s, SMC_OPTION_SOFT, 1) == SMC_OK && smc_emit(s, SMC_EMIT_C) == SMC_OK && smc_output_count(s) == 5);
    CHECK(is_text(smc_output_name(s, 2), "sm_soft.h"));
    CHECK(smc_close(s) == SMC_OK);
}

static void test_compiling_together(void)
{
    SmcSession *s = open_session();
    static const char vector[] = "[Tank]\nU64 G\nU32 S\nbool open\n", pins[] = "[digital]\no 8 open\n";
    static const char valve[] = "[state_vector]\nU64 G\nU32 S\nbool open\n[Idle]\n.step\n    open = G > 5\n";
    const void *bytes;
    uint64_t plain = 0, with_pins = 0;

    add(s, SMC_KIND_SM, "valve.sm", valve);
    add(s, SMC_KIND_SV, "tank.sv", vector);
    CHECK(smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output(s, 0, &bytes, &plain) == SMC_OK);
    add(s, SMC_KIND_IO, "tank.io", pins);
    CHECK(smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output(s, 0, &bytes, &with_pins) == SMC_OK);
    CHECK(with_pins > plain);
    CHECK(smc_emit(s, SMC_EMIT_C) == SMC_OK && smc_output_count(s) == 4);
    CHECK(smc_prefix_set(s, "X") == SMC_OK && smc_emit(s, SMC_EMIT_C) == SMC_E_STATE && smc_output_count(s) == 0);
    add(s, SMC_KIND_SV, "other.sv", vector);
    CHECK(smc_compile(s) == SMC_E_STATE && strstr(smc_error_text(s), "two state vectors") != NULL && smc_diag_count(s) == 0);
    CHECK(smc_sources_clear(s) == SMC_OK && smc_source_count(s) == 0 && smc_compile(s) == SMC_E_STATE);
    add(s, SMC_KIND_SM, "a/valve.sm", valve);
    add(s, SMC_KIND_SM, "b/valve.sm", valve);
    CHECK(smc_prefix_set(s, "") == SMC_OK && smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_C) == SMC_E_STATE);
    CHECK(strstr(smc_error_text(s), "same file name") != NULL);
    smc_close(s);
}

static void test_compiling_an_application(void)
{
    SmcSession *s = open_session();
    static const char app[] = "[options]\nstate_vector \"bus.sv\"\ntime G 1 ms\n[main]\nevery 10 ms:\n    machine valve \"valve.sm\"\n";
    const uint32_t of = add(s, SMC_KIND_APP, "rocket.app", app);

    (void)of;
    CHECK(smc_app_file_count(s) == 0 && smc_compile(s) == SMC_E_SOURCE && smc_diag_count(s) > 0);
    CHECK(smc_emit(s, SMC_EMIT_C) == SMC_E_STATE);
    CHECK(smc_app_file_count(s) == 2 && is_text(smc_app_file_name(s, 2), "") && smc_app_file_kind(s, 2) == -1);
    for (uint32_t i = 0; i < 2; i++) {
        const bool is_vector = smc_app_file_kind(s, i) == SMC_KIND_SV;
        CHECK(is_vector || smc_app_file_kind(s, i) == SMC_KIND_SM);
        CHECK(is_text(smc_app_file_name(s, i), is_vector ? "bus.sv" : "valve.sm"));
    }
    smc_close(s);
}

// An application whose files of pins and messages are complete and whose machine is missing: what the compiler parsed is freed once.
static void test_emitting_of_an_incomplete_application(void)
{
    static const char app[] = "[options]\nstate_vector \"bus.sv\"\ntime G 1 ms\nnet \"bus.net\"\n[main]\nevery 10 ms:\n    machine valve \"valve.sm\"\n";
    SmcSession *s = open_session();

    add(s, SMC_KIND_APP, "rocket.app", app);
    add(s, SMC_KIND_SV, "bus.sv", "[Bus]\nU64 G\nF64 p\n");
    add(s, SMC_KIND_NET, "bus.net", "receive commands on 5001\n{\n    p @hold\n}\n");
    CHECK(smc_compile(s) == SMC_E_SOURCE);
    CHECK(smc_emit(s, SMC_EMIT_TOKENS) == SMC_OK);
    CHECK(smc_emit(s, SMC_EMIT_AST) == SMC_OK);
    CHECK(smc_compile(s) == SMC_E_SOURCE && smc_close(s) == SMC_OK);
}

// ---- the structure of machines ----

static uint32_t find_model_variable(const SmcSession *s, uint32_t sm, const char *name)
{
    for (uint32_t v = 0; v < smc_model_variable_count(s, sm); v++)
        if (is_text(smc_model_variable_name(s, sm, v), name))
            return v;
    CHECK(false);                 // the variable does not exist
    return 0;
}

// Returns how a state accesses a variable: a sum of SMC_ACCESS_….
static uint32_t access_of(const SmcSession *s, uint32_t sm, uint32_t state, const char *name)
{
    const uint32_t variable = find_model_variable(s, sm, name);

    for (uint32_t u = 0; u < smc_model_use_count(s, sm); u++)
        if (smc_model_use_state(s, sm, u) == state && smc_model_use_variable(s, sm, u) == variable)
            return smc_model_use_access(s, sm, u);
    return 0;
}

static void test_structure(void)
{
    SmcSession *s = open_session();
    static const char text[] = "[state_vector]\nU64 time @alias G\nU32 S\nF64 p\nbool v\n[local]\nF64 limit = 9 @read_only\nU8 n = 0\n[Fill] @safe\n.step\n"
                               "    n = n + 1\n    if p > limit or n > 5 {\n        T > 2: -> Stop\n    }\n    v = roll_max(p, 3) > 1\n    time > 99: -> Fill\n[Stop] @abort\n.entry\n    v = false\n"
                               "    p < 0: -> Stop\n";
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", text);

    CHECK(smc_model_state_count(s, sm) == 0 && smc_compile(s) == SMC_OK && smc_model_state_count(s, sm) == 2);
    CHECK(is_text(smc_model_state_name(s, sm, 2), "Stop") && smc_model_state_line(s, sm, 1) == 9 && smc_model_state_line(s, sm, 2) == 17);
    CHECK(smc_model_state_marks(s, sm, 1) == (SMC_MARK_SAFE | SMC_MARK_SWAP) && smc_model_state_marks(s, sm, 2) == (SMC_MARK_ABORT | SMC_MARK_FINAL));
    CHECK(smc_model_transition_count(s, sm) == 3 && smc_model_transition_from(s, sm, 0) == 1 && smc_model_transition_to(s, sm, 0) == 2);
    CHECK(is_text(smc_model_transition_guard(s, sm, 0), "(p > limit or n > 5) and T > 2") && smc_model_transition_line(s, sm, 0) == 13);
    CHECK(is_text(smc_model_transition_guard(s, sm, 1), "time > 99") && smc_model_transition_to(s, sm, 1) == 1 && smc_model_transition_block(s, sm, 1) == SMC_BLOCK_STEP);
    CHECK(smc_model_transition_block(s, sm, 2) == SMC_BLOCK_ENTRY && smc_model_transition_from(s, sm, 2) == 2);
    CHECK(smc_model_variable_count(s, sm) == 6 && find_model_variable(s, sm, "limit") == 5 && smc_model_variable_kind(s, sm, 5) == SMC_VARIABLE_CONSTANT);
    CHECK(smc_model_variable_line(s, sm, 5) == 7 && smc_model_variable_type(s, sm, find_model_variable(s, sm, "time")) == SMC_TYPE_U64);
    CHECK(access_of(s, sm, 1, "p") == SMC_ACCESS_READ && access_of(s, sm, 1, "n") == (SMC_ACCESS_READ | SMC_ACCESS_WRITE) && access_of(s, sm, 1, "v") == SMC_ACCESS_WRITE);
    CHECK(access_of(s, sm, 2, "v") == SMC_ACCESS_WRITE && access_of(s, sm, 2, "p") == SMC_ACCESS_READ && access_of(s, sm, 2, "n") == 0 && smc_model_use_count(s, sm) == 7);
    for (uint32_t u = 1; u < smc_model_use_count(s, sm); u++)
        CHECK(smc_model_use_state(s, sm, u - 1) < smc_model_use_state(s, sm, u) || smc_model_use_variable(s, sm, u - 1) < smc_model_use_variable(s, sm, u));
    CHECK(smc_model_state_count(s, 1) == 0 && smc_model_state_count(NULL, sm) == 0 && is_text(smc_model_state_name(s, sm, 0), "") && is_text(smc_model_state_name(s, sm, 3), ""));
    CHECK(smc_model_state_marks(s, sm, 3) == 0 && smc_model_state_line(s, sm, 3) == 0 && smc_model_transition_from(s, sm, 3) == 0 && smc_model_transition_to(s, sm, 3) == 0);
    CHECK(smc_model_transition_block(s, sm, 3) == -1 && smc_model_transition_line(s, sm, 3) == 0 && is_text(smc_model_transition_guard(s, sm, 3), ""));
    CHECK(is_text(smc_model_variable_name(s, sm, 6), "") && smc_model_variable_type(s, sm, 6) == -1 && smc_model_variable_kind(s, sm, 6) == -1 && smc_model_variable_line(s, sm, 6) == 0);
    CHECK(smc_model_use_state(s, sm, 7) == 0 && smc_model_use_variable(s, sm, 7) == -1 && smc_model_use_access(s, sm, 7) == 0);
    CHECK(smc_source_replace(s, sm, "[", 1) == SMC_OK && smc_model_state_count(s, sm) == 2 && smc_compile(s) == SMC_E_SOURCE && smc_model_state_count(s, sm) == 0);
    smc_close(s);
}

// A transition of [all_states] leads from each state in which the section runs, and always has its own line.  A definition in a guard reads what
// its expression reads.
static void test_structure_of_all_states(void)
{
    SmcSession *s = open_session();
    static const char text[] = "[state_vector]\nU64 G\nU32 S\nF64 p\nbool v\n[define]\nhigh = p > 9\n"
                               "[all_states] @except Stop\n.step\n    high: -> Stop\n    v = true\n"
                               "[Idle]\n.step\n    G > 5: -> Run\n[Run]\n[Stop] @abort\n";
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", text);

    CHECK(smc_compile(s) == SMC_OK && smc_model_state_count(s, sm) == 3 && smc_model_transition_count(s, sm) == 3);
    for (uint32_t t = 0; t < 3; t++) {
        const bool copy = t != 1;
        CHECK(smc_model_transition_from(s, sm, t) == 1 + t / 2 && smc_model_transition_to(s, sm, t) == (copy ? 3u : 2u));
        CHECK(smc_model_transition_line(s, sm, t) == (copy ? 10u : 14u) && is_text(smc_model_transition_guard(s, sm, t), copy ? "high" : "G > 5"));
        CHECK(smc_model_transition_block(s, sm, t) == SMC_BLOCK_STEP);
    }
    CHECK(smc_model_state_marks(s, sm, 1) == 0 && smc_model_state_marks(s, sm, 2) == 0 && smc_model_state_marks(s, sm, 3) == (SMC_MARK_ABORT | SMC_MARK_FINAL));
    for (uint32_t state = 1; state <= 3; state++) {
        CHECK(access_of(s, sm, state, "p") == (state < 3 ? SMC_ACCESS_READ : 0) && access_of(s, sm, state, "v") == (state < 3 ? SMC_ACCESS_WRITE : 0));
        CHECK(smc_model_state_line(s, sm, state) == (state == 1 ? 12u : state == 2 ? 15u : 16u));
    }
    CHECK(smc_model_variable_count(s, sm) == 4);
    smc_close(s);
}

// The machines of an application also have a structure.
static void test_structure_of_an_application(void)
{
    SmcSession *s = open_session();
    static const char app[] = "[options]\nstate_vector \"bus.sv\"\ntime G 1 ms\n[main]\nevery 10 ms:\n    machine valve \"valve.sm\"\n";
    static const char two[] = "[options]\nstate_vector \"bus.sv\"\ntime G 1 ms\n[main]\nevery 10 ms:\n    machine valve \"valve.sm\"\n"
                              "    machine second \"valve.sm\" { open = other  S = state }\n";
    static const char wrong[] = "[options]\nstate_vector \"bus.sv\"\ntime G 1 ms\n[main]\nevery 10 ms:\n    machine valve \"valve.sm\"\n"
                                "    machine second \"valve.sm\" { open = nosuch  S = state }\n";
    static const char bus[] = "[Bus]\nU64 G\nU32 S\nU32 state\nbool open\nbool other\n";
    const uint32_t of = add(s, SMC_KIND_APP, "rocket.app", app);
    const uint32_t sm = add(s, SMC_KIND_SM, "valve.sm", "[state_vector]\nU64 G\nU32 S\nbool open\n[Idle]\n.step\n    open = G > 5\n");

    add(s, SMC_KIND_SV, "bus.sv", "[Bus]\nU64 G\nU32 S\nbool open\n");
    CHECK(smc_compile(s) == SMC_OK && smc_model_state_count(s, of) == 0 && smc_model_state_count(s, sm) == 1 && smc_model_variable_count(s, sm) == 3);
    // Two machines of one file: the structure is that of the first.
    CHECK(smc_source_replace(s, of, two, strlen(two)) == SMC_OK && smc_source_replace(s, of + 2, bus, strlen(bus)) == SMC_OK);
    CHECK(smc_compile(s) == SMC_OK && smc_app_file_count(s) == 2 && smc_model_state_count(s, sm) == 1 && smc_emit(s, SMC_EMIT_C) == SMC_OK);
    CHECK(smc_source_replace(s, of, wrong, strlen(wrong)) == SMC_OK && smc_compile(s) == SMC_E_SOURCE);
    smc_close(s);
}

// ---- sources that come and go ----

static void test_removing_sources(void)
{
    SmcSession *s = open_session();
    const uint32_t broken = add(s, SMC_KIND_SM, "broken.sm", "["), sm = add(s, SMC_KIND_SM, "tank.sm", tank), ss = add(s, SMC_KIND_SS, "a.ss", script);
    const char *text;
    uint64_t size;
    uint32_t fixed;

    CHECK(smc_compile(s) == SMC_E_SOURCE && smc_source_remove(s, broken) == SMC_OK && smc_source_remove(s, broken) == SMC_E_INDEX);
    CHECK(smc_source_count(s) == 3 && smc_source_kind(s, broken) == -1 && is_text(smc_source_name(s, broken), "") && is_text(smc_source_name(s, sm), "tank.sm"));
    CHECK(smc_source_replace(s, broken, "", 0) == SMC_E_INDEX && smc_source_remove(s, 3) == SMC_E_INDEX && smc_source_remove(NULL, 0) == SMC_E_HANDLE);
    CHECK(smc_diag_count(s) > 0 && smc_diag_place(s, 0, SMC_PART_DIAG, 0, SMC_PLACE_SOURCE, 0) == broken && smc_apply_edits(s, broken, &text, &size, &fixed) == SMC_OK);
    CHECK(smc_compile(s) == SMC_OK && smc_run(s, ss, SMC_ENGINE_VM, 0) == SMC_OK && smc_apply_edits(s, broken, &text, &size, &fixed) == SMC_E_INDEX);
    CHECK(smc_source_remove(s, ss) == SMC_OK && smc_run_outcome(s, ss) == SMC_OUTCOME_PASSED);
    CHECK(add(s, SMC_KIND_SS, "b.ss", failing) == ss && add(s, SMC_KIND_SV, "bus.sv", "") == broken && smc_source_remove(s, broken) == SMC_OK);
    CHECK(smc_compile(s) == SMC_OK && smc_run(s, ss, SMC_ENGINE_VM, 0) == SMC_E_FAILED);
    CHECK(smc_source_remove(s, sm) == SMC_OK && smc_source_remove(s, ss) == SMC_OK && smc_compile(s) == SMC_E_STATE && smc_source_count(s) == 3);
    CHECK(smc_sources_clear(s) == SMC_OK && smc_source_count(s) == 0 && add(s, SMC_KIND_SM, "a.sm", tank) == 0);
    smc_close(s);
}

// ---- diagnostics ----

static void test_diagnostics(void)
{
    SmcSession *s = open_session();
    static const char text[] = "[state_vector]\nU64 G\nU32 S\nbool valveOpen\n[A]\n.step\n    # \xc3\xa4\xf0\x9f\x9a\x80\n    valve0pen = true   # \xf0\x9f\x9a\x80\n";
    const uint32_t sm = add(s, SMC_KIND_SM, "a.sm", text);
    const char *out;
    uint64_t size;

    CHECK(smc_compile(s) == SMC_E_SOURCE && smc_diag_count(s) == 1 && smc_diag_severity(s, 0) == SMC_SEVERITY_ERROR);
    CHECK(is_text(smc_diag_code(s, 0), "E0204") && is_text(smc_diag_warning(s, 0), "") && strstr(smc_diag_message(s, 0), "valve0pen") != NULL);
    CHECK(strstr(smc_diag_label(s, 0), "valveOpen") != NULL && smc_diag_note_count(s, 0) == 1 && smc_diag_note(s, 0, 0)[0] != '\0');
    CHECK(smc_diag_place(s, 0, SMC_PART_DIAG, 0, SMC_PLACE_SOURCE, SMC_COLUMN_BYTES) == sm);
    CHECK(smc_diag_place(s, 0, SMC_PART_DIAG, 0, SMC_PLACE_LINE, SMC_COLUMN_BYTES) == 8);
    CHECK(smc_diag_place(s, 0, SMC_PART_DIAG, 0, SMC_PLACE_COLUMN, SMC_COLUMN_UTF16) == 5);
    CHECK(smc_diag_place(s, 0, SMC_PART_DIAG, 0, SMC_PLACE_END_COLUMN, SMC_COLUMN_BYTES) == 14);
    CHECK(smc_diag_place(s, 0, SMC_PART_NOTE, 0, SMC_PLACE_LINE, SMC_COLUMN_BYTES) == 4);
    CHECK(smc_diag_place(s, 0, SMC_PART_DIAG, 0, SMC_PLACE_LENGTH, SMC_COLUMN_BYTES) == 9);
    CHECK(smc_diag_place(s, 1, SMC_PART_DIAG, 0, SMC_PLACE_LINE, SMC_COLUMN_BYTES) == -1 && smc_diag_severity(s, 1) == -1);
    CHECK(smc_diag_place(s, 0, 7, 0, SMC_PLACE_LINE, SMC_COLUMN_BYTES) == -1 && smc_diag_place(s, 0, 0, 0, 99, 0) == -1 && smc_diag_place(s, 0, 0, 0, 1, 2) == -1);
    CHECK(smc_diag_edit_count(s, 0) == 0 && is_text(smc_diag_edit(s, 0, 0), ""));
    CHECK(smc_render(s, SMC_RENDER_TEXT, &out, &size) == SMC_OK && strstr(out, "a.sm:8:5: error") != NULL && strstr(out, "1 error") != NULL);
    CHECK(smc_render(s, SMC_RENDER_COLOR, &out, &size) == SMC_OK && strchr(out, '\033') != NULL);
    CHECK(smc_render(s, SMC_RENDER_JSON, &out, &size) == SMC_OK && out[0] == '{');
    CHECK(smc_render(s, SMC_RENDER_SARIF, &out, &size) == SMC_OK && strstr(out, "2.1.0") != NULL);
    CHECK(smc_source_replace(s, sm, "", 0) == SMC_OK && smc_diag_count(s) == 1 && smc_diag_place(s, 0, 0, 0, SMC_PLACE_LINE, 0) == 8);
    smc_close(s);
}

static void test_applying_edits(void)
{
    SmcSession *s = open_session();
    static const char text[] = "[state_vector]\nU64 G\nU32 S\nbool v\n[A]\n.step\n    G > 5 && v: v = false\n";
    const uint32_t sm = add(s, SMC_KIND_SM, "a.sm", text);
    const char *out;
    uint64_t size;
    uint32_t fixed;

    CHECK(smc_compile(s) == SMC_E_SOURCE && smc_diag_edit_count(s, 0) == 1 && is_text(smc_diag_edit(s, 0, 0), "and") && is_text(smc_diag_edit(s, 0, 1), ""));
    CHECK(smc_diag_place(s, 0, SMC_PART_EDIT, 0, SMC_PLACE_COLUMN, 0) == 11 && smc_diag_place(s, 0, SMC_PART_EDIT, 0, SMC_PLACE_LENGTH, 0) == 2);
    CHECK(smc_apply_edits(s, sm, &out, &size, &fixed) == SMC_OK && fixed == 1 && strstr(out, "    G > 5 and v: v = false") != NULL && size == strlen(out));
    smc_close(s);
}

static void test_utf16_columns(void)
{
    SmcSession *s = open_session();
    static const char text[] = "[state_vector]\nU64 G\nU32 S\nbool v\n[A] @allow(dead-code, \"\xf0\x9f\x9a\x80\xc3\xa4\xff\") @wrong\n";
    bool found = false;

    add(s, SMC_KIND_SM, "a.sm", text);
    CHECK(smc_compile(s) == SMC_E_SOURCE && smc_diag_count(s) >= 1);
    for (uint32_t i = 0; i < smc_diag_count(s); i++) {
        const int64_t bytes = smc_diag_place(s, i, 0, 0, SMC_PLACE_COLUMN, SMC_COLUMN_BYTES);
        const int64_t units = smc_diag_place(s, i, 0, 0, SMC_PLACE_COLUMN, SMC_COLUMN_UTF16);
        if (bytes < 30)
            continue;
        CHECK(bytes - units == 3);            // before it: 4 bytes of 2 units, 2 bytes of 1 unit, and a byte that is not UTF-8
        found = true;
    }
    CHECK(found);
    smc_close(s);
}

static void test_selecting_warnings(void)
{
    SmcSession *s = open_session();
    static const char text[] = "[state_vector]\nU64 G\nU32 S\nbool v @allow(never-written, \"a driver\")\nbool w\n[A]\n.step\n    w = v\n[B]\n";

    add(s, SMC_KIND_SM, "a.sm", text);
    CHECK(smc_compile(s) == SMC_OK && smc_diag_count(s) > 0 && smc_diag_severity(s, 0) == SMC_SEVERITY_WARNING && smc_diag_warning(s, 0)[0] != '\0');
    CHECK(smc_warning_select(s, "no-unreachable-statee") == SMC_E_ARGUMENT && strstr(smc_error_text(s), "unreachable-state'") != NULL);
    CHECK(smc_warning_select(s, "error=unreachable-state") == SMC_OK && smc_compile(s) == SMC_E_SOURCE && smc_diag_severity(s, 1) == SMC_SEVERITY_ERROR);
    CHECK(smc_warnings_reset(s) == SMC_OK && smc_option_set(s, SMC_OPTION_WARNINGS, 0) == SMC_OK && smc_compile(s) == SMC_OK && smc_diag_count(s) == 0);
    CHECK(smc_option_set(s, SMC_OPTION_WARNINGS, 2) == SMC_E_ARGUMENT && smc_option_set(s, 99, 0) == SMC_E_ARGUMENT && smc_option_set(s, -1, 0) == SMC_E_ARGUMENT);
    CHECK(smc_option(s, SMC_OPTION_LEVEL) == 2 && smc_option(s, 99) == 0);
    CHECK(smc_option_set(s, SMC_OPTION_MAX_RAM, 10) == SMC_OK && smc_compile(s) == SMC_E_SOURCE && is_text(smc_diag_code(s, 0), "E0860"));
    smc_close(s);
}

// The text of an error is UTF-8, even if the argument is not UTF-8, or is longer than the text can be.
static void test_errors_are_utf8(void)
{
    SmcSession *s = open_session();
    char word[700] = "";

    for (int i = 0; i < 200; i++)
        strcat(word, "\xe2\x82\xac");
    CHECK(smc_warning_select(s, word) == SMC_E_ARGUMENT && strlen(smc_error_text(s)) > 390);
    CHECK(strcmp(smc_error_text(s) + strlen(smc_error_text(s)) - 3, "\xe2\x82\xac") == 0);
    CHECK(smc_warning_select(s, "\xff") == SMC_E_ARGUMENT && strstr(smc_error_text(s), "'?'") != NULL);
    smc_close(s);
}

static void test_allowed_warnings_are_kept(void)
{
    SmcSession *s = open_session();
    static const char text[] = "[state_vector]\nU64 G\nU32 S\nbool w\n[A]\n.step\n    w = true\n[B] @allow(unreachable-state, \"later\")\n";

    add(s, SMC_KIND_SM, "a.sm", text);
    CHECK(smc_compile(s) == SMC_OK && smc_diag_count(s) == 0 && smc_diag_allowed_count(s) == 1);
    CHECK(is_text(smc_diag_allowed(s, 0), "later") && is_text(smc_diag_warning(s, 0), "unreachable-state"));
    smc_close(s);
}

// ---- scripts, diagrams, reports ----

static void test_running_scripts(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", tank), good = add(s, SMC_KIND_SS, "good.ss", script), bad = add(s, SMC_KIND_SS, "bad.ss", failing);
    const char *text;
    uint64_t size;

    CHECK(smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_E_STATE);
    CHECK(smc_option_set(s, SMC_OPTION_REVIEW, 1) == SMC_OK && smc_compile(s) == SMC_OK);
    CHECK(smc_run_outcome(s, good) == SMC_OUTCOME_NONE && is_text(smc_run_report(s, good), ""));
    CHECK(smc_run(s, good, SMC_ENGINE_VM | SMC_ENGINE_REF | SMC_ENGINE_VM_SOFT, 0) == SMC_OK);
    CHECK(smc_run_outcome(s, good) == SMC_OUTCOME_PASSED && smc_run_steps(s, good) == 6 && smc_run_asserts(s, good) == 1);
    CHECK(strstr(smc_run_report(s, good), "state script ran for 6 steps") == smc_run_report(s, good) && is_text(smc_run_trace(s, good), ""));
    CHECK(smc_option_set(s, SMC_OPTION_TRACE, 1) == SMC_OK && smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_OK);
    CHECK(strncmp(smc_run_trace(s, good), "script,step,", 12) == 0);
    CHECK(smc_run(s, bad, SMC_ENGINE_VM, 0) == SMC_E_FAILED && smc_run_outcome(s, bad) == SMC_OUTCOME_FAILED && smc_diag_count(s) == 1);
    CHECK(smc_diag_place(s, 0, 0, 0, SMC_PLACE_SOURCE, 0) == bad && smc_diag_severity(s, 0) == SMC_SEVERITY_ERROR);
    CHECK(smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output_count(s) == 1 && smc_diag_count(s) == 1);     // no error of the sources
    CHECK(smc_run(s, good, SMC_ENGINE_VM, 2) == SMC_E_FAILED && smc_run_outcome(s, good) == SMC_OUTCOME_ENDLESS);
    CHECK(smc_run(s, good, 0, 0) == SMC_E_ARGUMENT && smc_run(s, good, 8, 0) == SMC_E_ARGUMENT && smc_run(s, sm, 1, 0) == SMC_E_INDEX && smc_run(s, 77, 1, 0) == SMC_E_INDEX);
    CHECK(smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_OK);
    CHECK(smc_diagram(s, sm, SMC_DIAGRAM_SVG, &text, &size) == SMC_OK && strncmp(text, "<svg", 4) == 0 && size == strlen(text));
    CHECK(smc_diagram(s, sm, SMC_DIAGRAM_DOT, &text, &size) == SMC_OK && strstr(text, "digraph") != NULL);
    CHECK(smc_diagram(s, sm, SMC_DIAGRAM_MERMAID, &text, &size) == SMC_OK && smc_diagram(s, sm, 3, &text, &size) == SMC_E_ARGUMENT);
    CHECK(smc_report(s, sm, SMC_REPORT_HTML, &text, &size) == SMC_OK && strstr(text, "</html>") != NULL);
    CHECK(smc_report(s, sm, SMC_REPORT_JSON, &text, &size) == SMC_OK && text[0] == '{' && smc_report(s, sm, SMC_REPORT_TEXT, &text, &size) == SMC_OK);
    CHECK(smc_report(s, good, SMC_REPORT_TEXT, &text, &size) == SMC_E_INDEX && smc_diagram(s, 9, 0, &text, &size) == SMC_E_INDEX);
    CHECK(smc_option_set(s, SMC_OPTION_REVIEW, 0) == SMC_OK && smc_compile(s) == SMC_OK && smc_report(s, sm, 0, &text, &size) == SMC_E_STATE);
    smc_close(s);
}

// Requirements are checked with the single machine and judged in the runs of its scripts, and the report has a row for each.
static void test_requirements(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", tank), good = add(s, SMC_KIND_SS, "good.ss", script);
    const uint32_t rq = add(s, SMC_KIND_RQ, "tank.rq", "R1 \"opens\" always p > 700 implies valve\n");
    const char *text;
    uint64_t size;

    CHECK(smc_source_kind(s, rq) == SMC_KIND_RQ && smc_option_set(s, SMC_OPTION_REVIEW, 1) == SMC_OK && smc_compile(s) == SMC_OK);
    CHECK(smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_OK && smc_report(s, sm, SMC_REPORT_TEXT, &text, &size) == SMC_OK);
    CHECK(strstr(text, "opens") != NULL && strstr(text, "tank.rq:1") != NULL);
    CHECK(add(s, SMC_KIND_RQ, "more.rq", "R2 \"stays shut\" never valve\n") != rq && smc_compile(s) == SMC_OK);
    CHECK(smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_E_FAILED && smc_run_outcome(s, good) == SMC_OUTCOME_FAILED);
    CHECK(smc_diag_count(s) > 0 && strstr(smc_diag_message(s, 0), "R2 violated") != NULL);
    CHECK(add(s, SMC_KIND_RQ, "wrong.rq", "R2 \"twice\" never nosuch\n") > rq && smc_compile(s) == SMC_E_SOURCE);
    smc_close(s);
}

// Two machines, each with its own script, and a script without a machine.
static void test_results_of_requirements(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", tank), ss = add(s, SMC_KIND_SS, "good.ss", script);
    static const char text[] = "R1 \"opens\" always p > 700 implies valve\nR2 \"never\" always p > 9000 implies not valve\n"
                               "R3 \"in time\" always valve leads to not valve within 5 s\n";

    add(s, SMC_KIND_RQ, "tank.rq", text);
    CHECK(smc_requirement_count(s, sm) == 0 && is_text(smc_requirement_id(s, sm, 0), ""));
    CHECK(smc_compile(s) == SMC_OK && smc_requirement_count(s, sm) == 3 && smc_requirement_count(s, ss) == 0);
    CHECK(is_text(smc_requirement_id(s, sm, 0), "R1") && is_text(smc_requirement_text(s, sm, 2), "in time") && is_text(smc_requirement_id(s, sm, 3), ""));
    CHECK(smc_run_requirement(s, ss, 0) == SMC_REQUIREMENT_UNJUDGED && smc_run_judged(s, ss, 0) == 0);
    CHECK(smc_run(s, ss, SMC_ENGINE_VM, 0) == SMC_OK);
    CHECK(smc_run_requirement(s, ss, 0) == SMC_REQUIREMENT_MET && smc_run_judged(s, ss, 0) > 0);
    CHECK(smc_run_requirement(s, ss, 1) == SMC_REQUIREMENT_UNJUDGED && smc_run_requirement(s, ss, 2) == SMC_REQUIREMENT_UNDECIDED);
    CHECK(smc_run_requirement(s, ss, 3) == SMC_REQUIREMENT_UNJUDGED && smc_run_requirement(s, 77, 0) == SMC_REQUIREMENT_UNJUDGED);
    add(s, SMC_KIND_RQ, "more.rq", "R4 \"stays shut\" never valve\n");
    CHECK(smc_compile(s) == SMC_OK && smc_run(s, ss, SMC_ENGINE_VM, 0) == SMC_E_FAILED);
    CHECK(smc_run_requirement(s, ss, 3) == SMC_REQUIREMENT_VIOLATED && smc_run_requirement(s, ss, 0) == SMC_REQUIREMENT_MET);
    smc_close(s);
}

static void test_running_scripts_of_several_machines(void)
{
    SmcSession *s = open_session();
    static const char other[] = "[state_vector]\nU64 G\nU32 S\nbool on\n[local]\nF64 most = 5 @read_only\n[Off]\n.step\n    on = G > most\n    G > 30: -> On\n[On]\n";
    static const char writes[] = "[options]\ndelta_t 10\n[all_states]\nG == 0: most = 15\nG == 10: @assert not on\nG == 20 {\n    @assert on\n    @stop\n}\n";
    const uint32_t first = add(s, SMC_KIND_SM, "tank.sm", tank), second = add(s, SMC_KIND_SM, "valve.sm", other);
    const uint32_t good = add(s, SMC_KIND_SS, "good.ss", script), bad = add(s, SMC_KIND_SS, "bad.ss", failing), wrote = add(s, SMC_KIND_SS, "writes.ss", writes);
    const char *text;
    uint64_t size;

    CHECK(smc_compile(s) == SMC_OK && smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_E_STATE && strstr(smc_error_text(s), "smc_script_assign") != NULL);
    CHECK(smc_script_assign(s, good, first) == SMC_OK && smc_script_assign(s, bad, first) == SMC_OK && smc_script_assign(s, wrote, second) == SMC_OK);
    CHECK(smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_E_STATE && smc_compile(s) == SMC_OK);
    CHECK(smc_run(s, wrote, SMC_ENGINE_VM | SMC_ENGINE_REF, 0) == SMC_OK && smc_run_asserts(s, wrote) == 2);
    CHECK(smc_run(s, good, SMC_ENGINE_VM | SMC_ENGINE_REF | SMC_ENGINE_VM_SOFT, 0) == SMC_OK && smc_run(s, bad, SMC_ENGINE_VM, 0) == SMC_E_FAILED);
    CHECK(smc_diagram(s, first, SMC_DIAGRAM_SVG, &text, &size) == SMC_OK && smc_diagram(s, second, SMC_DIAGRAM_SVG, &text, &size) == SMC_OK);
    CHECK(smc_report(s, first, SMC_REPORT_TEXT, &text, &size) == SMC_E_STATE);
    CHECK(smc_script_assign(s, good, second) == SMC_OK && smc_compile(s) == SMC_E_SOURCE && smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_E_SOURCE);       // it has no `p`
    CHECK(smc_script_assign(s, first, second) == SMC_E_ARGUMENT && smc_script_assign(s, good, bad) == SMC_E_ARGUMENT && smc_script_assign(s, 9, first) == SMC_E_INDEX);
    CHECK(smc_script_assign(s, good, 9) == SMC_E_INDEX && smc_script_assign(NULL, good, first) == SMC_E_HANDLE);
    CHECK(smc_source_remove(s, second) == SMC_OK && smc_source_remove(s, wrote) == SMC_OK && smc_compile(s) == SMC_OK && smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_OK);
    CHECK(add(s, SMC_KIND_SM, "valve.sm", other) == wrote && smc_compile(s) == SMC_OK && smc_run(s, good, SMC_ENGINE_VM, 0) == SMC_E_STATE && smc_run(s, bad, SMC_ENGINE_VM, 0) == SMC_E_FAILED);
    smc_close(s);
}

static void test_cancelling(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", tank), ss = add(s, SMC_KIND_SS, "good.ss", script);

    (void)sm;
    CHECK(smc_cancel(s, 1) == SMC_OK && smc_compile(s) == SMC_E_CANCELLED && smc_compile(s) == SMC_OK);
    CHECK(smc_cancel(s, 1) == SMC_OK && smc_warning_select(s, "all") == SMC_OK && smc_compile(s) == SMC_E_CANCELLED && smc_compile(s) == SMC_OK);
    CHECK(smc_cancel(s, 1) == SMC_OK && smc_run(s, ss, SMC_ENGINE_VM, 0) == SMC_E_CANCELLED && smc_run_outcome(s, ss) == SMC_OUTCOME_NONE);
    CHECK(smc_run(s, ss, SMC_ENGINE_VM, 0) == SMC_OK);
    CHECK(smc_cancel(s, 1) == SMC_OK && smc_cancel(s, 0) == SMC_OK && smc_compile(s) == SMC_OK && smc_cancel(s, 2) == SMC_E_ARGUMENT);
    smc_close(s);
}

// ---- bad arguments ----

static void test_closed_sessions_are_refused(void)
{
    static uint64_t area[100000];
    SmcSession *s = NULL;
    uint32_t source;
    SmcMachine m;

    CHECK(smc_open(area, 8, &s) == SMC_E_MEMORY && smc_open(area, 0, &s) == SMC_E_MEMORY && s == NULL);
    CHECK(smc_open((char *)area + 3, sizeof area - 3, &s) == SMC_OK);
    source = add(s, SMC_KIND_SM, "tank.sm", tank);
    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, source, &m) == SMC_OK && smc_machine_step(s, m, 1) == SMC_OK);
    CHECK(smc_memory_used(s) > 10000 && smc_memory_peak(s) >= smc_memory_used(s) && smc_memory_peak(s) <= sizeof area);
    CHECK(smc_close(s) == SMC_OK && smc_close(s) == SMC_E_HANDLE && smc_compile(s) == SMC_E_HANDLE && smc_machine_step(s, m, 2) == SMC_E_HANDLE);
    CHECK(smc_diag_count(s) == 0 && is_text(smc_error_text(s), "") && smc_cancel(s, 1) == SMC_E_HANDLE && smc_memory_used(s) == 0);
}

static void test_null_is_refused(void)
{
    SmcSession *s = open_session();
    const void *bytes;
    const char *text;
    uint64_t size;
    uint32_t n;
    double x;
    SmcMachine m;

    CHECK(smc_open(NULL, 0, NULL) == SMC_E_ARGUMENT && smc_close(NULL) == SMC_E_HANDLE && smc_compile(NULL) == SMC_E_HANDLE);
    CHECK(smc_source_add(s, SMC_KIND_SM, NULL, "", 0, &n) == SMC_E_ARGUMENT && smc_source_add(s, SMC_KIND_SM, "a", NULL, 1, &n) == SMC_E_ARGUMENT);
    CHECK(smc_source_add(s, SMC_KIND_SM, "a", "", 0, NULL) == SMC_E_ARGUMENT && smc_source_add(s, 8, "a", "", 0, &n) == SMC_E_ARGUMENT);
    CHECK(smc_source_add(s, -1, "a", "", 0, &n) == SMC_E_ARGUMENT && smc_source_add(s, SMC_KIND_SM, "", "", 0, &n) == SMC_E_ARGUMENT);
    CHECK(smc_source_add(s, SMC_KIND_SM, "a\nb", "", 0, &n) == SMC_E_ARGUMENT && smc_source_add(s, SMC_KIND_SM, "a", "", UINT64_C(1) << 40, &n) == SMC_E_SIZE);
    CHECK(smc_source_replace(s, 0, "", 0) == SMC_E_INDEX && smc_source_kind(s, 0) == -1 && is_text(smc_source_name(s, 0), ""));
    CHECK(smc_source_add(s, SMC_KIND_SM, "a.sm", NULL, 0, &n) == SMC_OK && smc_source_replace(s, n, NULL, 3) == SMC_E_ARGUMENT);
    CHECK(smc_compile(s) == SMC_E_SOURCE && smc_machine_open(s, n, &m) == SMC_E_STATE && smc_diagram(s, n, 0, &text, &size) == SMC_E_STATE);
    CHECK(smc_emit(s, 0) == SMC_E_ARGUMENT && smc_emit(s, 7) == SMC_E_ARGUMENT && smc_output(s, 0, NULL, &size) == SMC_E_ARGUMENT && smc_output(s, 0, &bytes, NULL) == SMC_E_ARGUMENT);
    CHECK(smc_render(s, 0, NULL, &size) == SMC_E_ARGUMENT && smc_render(s, 4, &text, &size) == SMC_E_ARGUMENT && smc_render(NULL, 0, &text, &size) == SMC_E_HANDLE);
    CHECK(smc_prefix_set(s, NULL) == SMC_E_ARGUMENT && smc_prefix_set(s, "1x") == SMC_E_ARGUMENT && smc_warning_select(s, NULL) == SMC_E_ARGUMENT);
    CHECK(smc_apply_edits(s, 9, &text, &size, &n) == SMC_E_INDEX && smc_apply_edits(s, 0, NULL, &size, &n) == SMC_E_ARGUMENT);
    CHECK(smc_source_replace(s, 0, tank, strlen(tank)) == SMC_OK && smc_compile(s) == SMC_OK && smc_machine_open(s, 0, NULL) == SMC_E_ARGUMENT && smc_machine_open(s, 0, &m) == SMC_OK);
    CHECK(smc_machine_get(s, m, 0, NULL) == SMC_E_ARGUMENT && smc_machine_read(s, m, 0, NULL, 8) == SMC_E_ARGUMENT && smc_machine_find(s, m, NULL, &n) == SMC_E_ARGUMENT);
    CHECK(smc_machine_find(s, m, "G", NULL) == SMC_E_ARGUMENT && smc_machine_open_image(s, NULL, 5, 0, &m) == SMC_E_ARGUMENT && smc_machine_open_image(s, "x", 1, 0, &m) == SMC_E_IMAGE);
    CHECK(smc_machine_get(s, 0, 0, &x) == SMC_E_HANDLE && smc_machine_get(NULL, m, 0, &x) == SMC_E_HANDLE && smc_machine_vector(s, 0) == NULL && smc_machine_state(NULL, m) == 0);
    CHECK(is_text(smc_result_text(12345), "unknown result") && is_text(smc_explain(NULL), "") && is_text(smc_explain("E9999"), "") && strstr(smc_explain("E0204"), "element") != NULL);
    CHECK(smc_warning_count() > 40 && is_text(smc_warning_name(100000), "") && is_text(smc_warning_group(100000), "") && smc_warning_sentence(0)[0] != '\0');
    CHECK(smc_api_version() == SMC_API_VERSION && smc_version()[0] != '\0');
    smc_close(s);
}

// ---- locales ----

// Numbers are written and read with a point even if the locale of the program has a decimal comma.
static void test_locale_has_no_effect(void)
{
    static const char text[] = "[state_vector]\nU64 G\nU32 S\nF64 p\nF64 q\n[A]\n.step\n    q = p * 1.5 + 0.1\n    p > 2.5: -> A\n";
    char *c_code = NULL;
    const void *bytes;
    uint64_t size;

    for (int german = 0; german < 2; german++) {
        SmcSession *s = open_session();
        add(s, SMC_KIND_SM, "a.sm", text);
        if (german && !setlocale(LC_ALL, getenv("COMMA_LOCALE") ? getenv("COMMA_LOCALE") : "de_DE.UTF-8"))
            CHECK(getenv("COMMA_LOCALE") == NULL);
        CHECK(smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_C) == SMC_OK && smc_output(s, 0, &bytes, &size) == SMC_OK);
        if (!german) {
            c_code = malloc((size_t)size);
            memcpy(c_code, bytes, (size_t)size);
        } else {
            char number[8];
            if (getenv("COMMA_LOCALE")) {
                snprintf(number, sizeof number, "%.1f", 1.5);
                CHECK(number[1] == ',');
            }
            CHECK(memcmp(c_code, bytes, (size_t)size) == 0);
        }
        smc_close(s);
    }
    setlocale(LC_ALL, "C");
    free(c_code);
}

// A script finds the scripts that it includes among the sources, by paths relative to its own.
static void test_including_scripts(void)
{
    static const char plant[] = "include \"../common.ss\"\n[local]\nF64 height = 2 * start\n[all_states]\ntrue: height = height + 1\n";
    static const char flight[] = "include \"lib/plant.ss\"\n[all_states]\nG == 20: @assert height == 23 @req R1\nG == 20: @stop\n";
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "dir/tank.sm", tank), part = add(s, SMC_KIND_SS, "dir/lib/plant.ss", plant);
    const uint32_t common = add(s, SMC_KIND_SS, "dir/common.ss", "[options]\ndelta_t 10\n[local]\nF64 start = 10\n");
    const uint32_t ss = add(s, SMC_KIND_SS, "dir/flight.ss", flight);

    CHECK(smc_compile(s) == SMC_OK && smc_run(s, ss, SMC_ENGINE_VM | SMC_ENGINE_REF, 0) == SMC_OK && smc_run_asserts(s, ss) == 1);
    CHECK(smc_run(s, part, SMC_ENGINE_VM, 0) == SMC_E_INDEX && strstr(smc_error_text(s), "another script includes") != NULL);
    CHECK(smc_run(s, common, SMC_ENGINE_VM, 0) == SMC_E_INDEX);
    CHECK(smc_source_remove(s, common) == SMC_OK && smc_compile(s) == SMC_E_SOURCE && smc_diag_count(s) > 0);
    CHECK(smc_source_kind(s, sm) == SMC_KIND_SM && smc_close(s) == SMC_OK);
}

// A script finds its recorded data among the sources, and the library opens no file.
static void test_recorded_data(void)
{
    static const char flight[] = "[options]\ndelta_t 10\n[data]\nfile \"../logs/flight.txt\"\ntime \"t\" ms\np = \"P\"\n"
                                 "@compare valve \"V\" delay 10 ms\n[all_states]\nG == 40: @assert p == 790\nG == 40: @stop\n";
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "dir/tank.sm", tank), ss = add(s, SMC_KIND_SS, "dir/flight.ss", flight);
    const uint32_t data = add(s, SMC_KIND_DATA, "logs/flight.txt", "t,P,V\n0,700,0\n20,790,1\n");
    const char *report;
    uint64_t size;
    uint32_t added;

    CHECK(smc_compile(s) == SMC_OK && smc_run(s, ss, SMC_ENGINE_VM | SMC_ENGINE_REF, 0) == SMC_E_FAILED && smc_run_outcome(s, ss) == SMC_OUTCOME_FAILED);
    CHECK(smc_source_replace(s, data, "t,P,V\n0,700,0\n20,790,1\n", 0) == SMC_OK && smc_compile(s) == SMC_E_SOURCE && smc_diag_count(s) > 0);
    CHECK(smc_source_remove(s, data) == SMC_OK && smc_compile(s) == SMC_E_SOURCE && smc_diag_count(s) > 0);
    CHECK(smc_source_add(s, SMC_KIND_DATA, "dir/../logs/flight.txt", "t,P,V\n0,790,1\n", 14, &added) == SMC_OK && smc_compile(s) == SMC_OK);
    CHECK(smc_run(s, ss, SMC_ENGINE_VM | SMC_ENGINE_REF | SMC_ENGINE_VM_SOFT, 0) == SMC_OK && smc_run_asserts(s, ss) == 2);
    CHECK(smc_report(s, sm, SMC_REPORT_TEXT, &report, &size) == SMC_E_STATE || strstr(report, "flight.txt: 1 rows read") != NULL);
    CHECK(smc_close(s) == SMC_OK);
}

int main(void)
{
    test_recorded_data();
    test_compiling();
    test_compiling_together();
    test_compiling_an_application();
    test_emitting_of_an_incomplete_application();
    test_structure();
    test_structure_of_all_states();
    test_structure_of_an_application();
    test_removing_sources();
    test_diagnostics();
    test_applying_edits();
    test_utf16_columns();
    test_selecting_warnings();
    test_errors_are_utf8();
    test_allowed_warnings_are_kept();
    test_running_scripts();
    test_requirements();
    test_results_of_requirements();
    test_including_scripts();
    test_running_scripts_of_several_machines();
    test_cancelling();
    test_closed_sessions_are_refused();
    test_null_is_refused();
    test_locale_has_no_effect();
    return test_end("api");
}
