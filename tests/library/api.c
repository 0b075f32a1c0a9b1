// SPDX-License-Identifier: Apache-2.0
// libsmc by its public header alone: what each function does, and what it returns for bad arguments.
#include <locale.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/library/smc.h"
#include "tests/test.h"

static const char tank[] = "[state_vector]\n"
                           "U64 G\nU32 S\nF32 p @range 0 1000\nbool valve\nI16 small\n"
                           "[local]\nU8 n = 3\nF64 level = 1.5\nF64 limit = 700 @read_only\n"
                           "[Fill] @safe\n.step\n    n = n + 1\n    level = level + 0.25\n    small = n * 1000 + (level > 1e9)\n    valve = p > limit\n    p > 900: -> Abort\n"
                           "[Abort] @abort\n.entry\n    valve = true\n";
static const char script[] = "[options]\ndelta_t 10\n[all_states]\nG == 20: p = 800\nG == 50 {\n    @assert valve\n    @stop\n}\n";
static const char failing[] = "[options]\ndelta_t 10\n[all_states]\nG == 20 {\n    @assert p > 1\n    @stop\n}\n";

static bool is_text(const char *text, const char *expected) { return strcmp(text, expected) == 0; }

static SmcSession *open_session(void)
{
    SmcSession *s = NULL;

    CHECK(smc_open(NULL, 0, &s) == SMC_OK && s != NULL);
    return s;
}

static uint32_t add(SmcSession *s, int32_t kind, const char *name, const char *text)
{
    uint32_t source = 999;

    CHECK(smc_source_add(s, kind, name, text, strlen(text), &source) == SMC_OK);
    return source;
}

// ---- compiling ----

static void compiles(void)
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

static void compiles_together(void)
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

static void compiles_an_application(void)
{
    SmcSession *s = open_session();
    static const char app[] = "[options]\nstate_vector \"bus.sv\"\ntime_unit 1 ms\n[executor main]\nevery 10 ms {\n    machine valve \"valve.sm\"\n}\n";
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

// ---- diagnostics ----

static void has_diagnostics(void)
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

static void applies_edits(void)
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

static void counts_utf16_columns(void)
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
        CHECK(bytes - units == 3);            // before it: 4 bytes of 2 units, 2 bytes of 1 unit, and a byte that is no UTF-8
        found = true;
    }
    CHECK(found);
    smc_close(s);
}

static void selects_warnings(void)
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

// The text of an error is UTF-8, also if the argument is not, or is longer than the text can be.
static void reports_errors_in_utf8(void)
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

static void keeps_allowed_warnings(void)
{
    SmcSession *s = open_session();
    static const char text[] = "[state_vector]\nU64 G\nU32 S\nbool w\n[A]\n.step\n    w = true\n[B] @allow(unreachable-state, \"later\")\n";

    add(s, SMC_KIND_SM, "a.sm", text);
    CHECK(smc_compile(s) == SMC_OK && smc_diag_count(s) == 0 && smc_diag_allowed_count(s) == 1);
    CHECK(is_text(smc_diag_allowed(s, 0), "later") && is_text(smc_diag_warning(s, 0), "unreachable-state"));
    smc_close(s);
}

// ---- scripts, diagrams, reports ----

static void runs_scripts(void)
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
    CHECK(smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output_count(s) == 1 && smc_diag_count(s) == 1);     // a failed script is no error of the sources
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

static void cancels(void)
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

// ---- machines ----

static uint32_t find(SmcSession *s, SmcMachine m, const char *name)
{
    uint32_t at = 999;

    CHECK(smc_machine_find(s, m, name, &at) == SMC_OK);
    return at;
}

static double get(SmcSession *s, SmcMachine m, const char *name)
{
    double x = -1;

    CHECK(smc_machine_get(s, m, find(s, m, name), &x) == SMC_OK);
    return x;
}

static void runs_machines(void)
{
    SmcSession *s = open_session();
    const uint32_t sm = add(s, SMC_KIND_SM, "tank.sm", tank);
    SmcMachine m = 0, other = 0;
    int16_t small = 0;
    uint32_t at;
    double x;

    CHECK(smc_machine_open(s, sm, &m) == SMC_E_STATE);
    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, sm, &m) == SMC_OK && m != 0 && smc_machine_open(s, sm, &other) == SMC_OK && other != m);
    CHECK(smc_machine_state_count(s, m) == 2 && smc_machine_state(s, m) == 1 && is_text(smc_machine_state_name(s, m, 2), "Abort"));
    CHECK(smc_machine_state_marks(s, m, 1) == (SMC_MARK_SAFE | SMC_MARK_SWAP) && smc_machine_state_marks(s, m, 2) == SMC_MARK_ABORT);
    CHECK(smc_machine_state_marks(s, m, 3) == 0 && is_text(smc_machine_state_name(s, m, 0), "") && is_text(smc_machine_state_name(s, m, 3), ""));
    CHECK(smc_machine_variable_count(s, m) == 7);                  // G S p valve small n level; limit is a constant
    CHECK(smc_machine_variable_type(s, m, find(s, m, "n")) == SMC_TYPE_U8 && smc_machine_variable_kind(s, m, find(s, m, "n")) == SMC_VARIABLE_LOCAL);
    CHECK(smc_machine_variable_type(s, m, find(s, m, "p")) == SMC_TYPE_F32 && smc_machine_variable_offset(s, m, find(s, m, "S")) == 8);
    CHECK(smc_machine_set(s, m, find(s, m, "p"), 750) == SMC_OK && smc_machine_step(s, m, 10) == SMC_OK);
    CHECK(get(s, m, "valve") == 1 && get(s, m, "n") == 4 && get(s, m, "level") == 1.75 && get(s, m, "small") == 4000 && get(s, m, "S") == 1 && get(s, m, "G") == 10);
    CHECK(smc_machine_variable_stored(s, m, find(s, m, "valve")) == 1 && smc_machine_variable_stored(s, m, find(s, m, "S")) == 1 && smc_machine_variable_stored(s, m, find(s, m, "p")) == 0);
    CHECK(smc_machine_step(s, m, 10) == SMC_E_REFUSED && get(s, m, "n") == 4 && smc_machine_step(s, m, 30) == SMC_OK && smc_machine_time(s, m) == 20);
    CHECK(smc_machine_read(s, m, find(s, m, "small"), &small, sizeof small) == SMC_OK && small == 5000);
    CHECK(smc_machine_read(s, m, find(s, m, "small"), &small, 4) == SMC_E_SIZE && smc_machine_write(s, m, find(s, m, "small"), &small, 1) == SMC_E_SIZE);
    small = -7;
    CHECK(smc_machine_write(s, m, find(s, m, "small"), &small, sizeof small) == SMC_OK && get(s, m, "small") == -7);
    CHECK(smc_machine_set(s, m, find(s, m, "small"), 1e9) == SMC_OK && get(s, m, "small") == 32767);
    CHECK(smc_machine_set(s, m, find(s, m, "n"), 200) == SMC_OK && smc_machine_set(s, m, find(s, m, "p"), 950) == SMC_OK && smc_machine_step(s, m, 40) == SMC_OK);
    CHECK(get(s, m, "n") == 201 && smc_machine_state(s, m) == 2 && get(s, m, "S") == 1);
    CHECK(smc_machine_start(s, m, 3) == SMC_E_INDEX && smc_machine_start(s, m, 2) == SMC_OK && get(s, m, "S") == 2 && get(s, m, "n") == 3 && get(s, m, "p") == 0);
    CHECK(get(s, other, "n") == 3 && smc_machine_info(s, m, SMC_INFO_VECTOR) == 24 && smc_machine_info(s, m, SMC_INFO_LONGEST_STEP) > 3);
    CHECK(smc_machine_info(s, m, SMC_INFO_IMAGE) > 100 && smc_machine_info(s, m, 99) == 0 && smc_machine_vector(s, m) != NULL);
    CHECK(smc_machine_info(s, m, SMC_INFO_LAYOUT) == smc_machine_info(s, other, SMC_INFO_LAYOUT));
    CHECK(smc_machine_find(s, m, "nothing", &at) == SMC_E_INDEX && smc_machine_get(s, m, 7, &x) == SMC_E_INDEX && smc_machine_variable_type(s, m, 7) == -1);
    CHECK(smc_machine_close(s, m) == SMC_OK && smc_machine_close(s, m) == SMC_E_HANDLE && smc_machine_step(s, m, 50) == SMC_E_HANDLE);
    CHECK(smc_sources_clear(s) == SMC_OK && smc_machine_step(s, other, 10) == SMC_OK);
    smc_close(s);
}

static void opens_images(void)
{
    SmcSession *s = open_session(), *second = open_session();
    const void *bytes;
    unsigned char *image;
    uint64_t size;
    SmcMachine m = 0, there = 0;

    add(s, SMC_KIND_SM, "tank.sm", tank);
    CHECK(smc_compile(s) == SMC_OK && smc_emit(s, SMC_EMIT_IMAGE) == SMC_OK && smc_output(s, 0, &bytes, &size) == SMC_OK);
    image = malloc((size_t)size);
    CHECK(image != NULL);
    memcpy(image, bytes, (size_t)size);
    CHECK(smc_machine_open_image(s, image, size, 0, &m) == SMC_OK && smc_machine_variable_count(s, m) == 0 && is_text(smc_machine_state_name(s, m, 1), ""));
    CHECK(smc_machine_step(s, m, 5) == SMC_OK && smc_machine_open_image(s, image, size, 1, &m) == SMC_E_INDEX);
    CHECK(smc_machine_open_image(second, image, size, 0, &there) == SMC_OK && smc_machine_step(s, there, 9) == SMC_E_HANDLE && smc_machine_step(second, m, 9) == SMC_E_HANDLE);
    CHECK(smc_machine_open_image(s, image, size - 1, 0, &m) == SMC_E_IMAGE && smc_error_text(s)[0] != '\0');
    for (uint64_t i = 0; i < size; i++) {             // every byte changed: refused, or harmless
        SmcMachine changed = 0;
        image[i] ^= 0x55;
        if (smc_machine_open_image(s, image, size, 0, &changed) == SMC_OK) {
            smc_machine_step(s, changed, 1);
            CHECK(smc_machine_close(s, changed) == SMC_OK);
        }
        image[i] ^= 0x55;
    }
    free(image);
    smc_close(s);
    smc_close(second);
}

static void continues(void)
{
    SmcSession *s = open_session();
    static const char newer[] = "[state_vector]\nU64 G\nU32 S\nF32 p\nbool valve\nI16 small\n[local]\nU8 n = 9\n[First]\n[Fill] @safe\n.step\n    n = n + 2\n    small = n\n    valve = p > 1\n";
    static const char vector[] = "[Bus]\nU64 G\nU32 S\nF32 p @range 0 1000\nbool valve\nI16 small\n";
    const uint32_t a = add(s, SMC_KIND_SM, "a.sm", tank), b = add(s, SMC_KIND_SM, "b.sm", newer);
    uint32_t bus;
    SmcMachine old, new, other;

    CHECK(smc_option_set(s, SMC_OPTION_WARNINGS, 0) == SMC_OK && smc_compile(s) == SMC_OK && smc_machine_open(s, b, &other) == SMC_OK);
    bus = add(s, SMC_KIND_SV, "bus.sv", vector);
    CHECK(smc_compile(s) == SMC_OK && smc_machine_open(s, a, &old) == SMC_OK && smc_machine_open(s, b, &new) == SMC_OK && smc_machine_open(s, bus, &other) == SMC_E_INDEX);
    CHECK(smc_machine_step(s, old, 10) == SMC_OK && smc_machine_step(s, old, 20) == SMC_OK);
    CHECK(smc_machine_continue(s, old, other) == SMC_E_REFUSED && strstr(smc_error_text(s), "layouts") != NULL);
    CHECK(smc_machine_continue(s, old, old) == SMC_E_ARGUMENT && smc_machine_continue(s, old, 5) == SMC_E_HANDLE);
    CHECK(smc_machine_continue(s, old, new) == SMC_OK && smc_machine_state(s, new) == 2 && get(s, new, "n") == 5 && smc_machine_time(s, new) == 10);
    CHECK(smc_machine_step(s, new, 20) == SMC_E_REFUSED && smc_machine_step(s, new, 30) == SMC_OK && get(s, new, "n") == 7 && get(s, old, "n") == 5);
    CHECK(smc_machine_set(s, old, find(s, old, "p"), 950) == SMC_OK && smc_machine_step(s, old, 30) == SMC_OK && smc_machine_continue(s, old, new) == SMC_E_REFUSED);
    smc_close(s);
}

// ---- bad arguments ----

static void refuses_closed_sessions(void)
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

static void refuses_null(void)
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
    CHECK(smc_source_add(s, SMC_KIND_SM, "a", "", 0, NULL) == SMC_E_ARGUMENT && smc_source_add(s, 6, "a", "", 0, &n) == SMC_E_ARGUMENT);
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

// Numbers look the same where the decimal separator of the program is a comma.
static void is_independent_of_the_locale(void)
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

int main(void)
{
    compiles();
    compiles_together();
    compiles_an_application();
    has_diagnostics();
    applies_edits();
    counts_utf16_columns();
    selects_warnings();
    reports_errors_in_utf8();
    keeps_allowed_warnings();
    runs_scripts();
    cancels();
    runs_machines();
    opens_images();
    continues();
    refuses_closed_sessions();
    refuses_null();
    is_independent_of_the_locale();
    return test_end("api");
}
