// SPDX-License-Identifier: Apache-2.0
// [data] of a script (language.md 8.54, 8.55): its settings, and the variables of its columns. The file itself is not read here.
#include "compiler/sema/application.h"
#include "compiler/sema/sema.h"

#include <string.h>

#include "compiler/syntax/number.h"

static bool has_value(const AstDataSetting *s, const char *word) { return s->value && strcmp(s->value->text, word) == 0; }

// ---- columns ----

// Describes a data column. Without annotations its scale is 1 and its offset 0.
static void set_column(const AstDataLine *in, Var *var, ScriptColumn *out)
{
    *out = (ScriptColumn){var, in->column, in->column_span, false, sm_from_i32(1), sm_from_i32(0)};
    for (size_t i = 0; i < in->annotations.n; i++) {
        const AstAnnotation *a = &in->annotations.at[i];
        out->is_scaled = true;
        if (a->kind == AST_SCALE)
            out->scale = a->lo.value;
        else
            out->offset = a->lo.value;
    }
}

static void check_column(Sema *s, ScriptData *d, const AstDataLine *in)
{
    Var *var = check_target(s, in->element, in->element_span);
    ScriptColumn column;

    for (size_t i = 0; var && i < d->column.n; i++)
        if (d->column.at[i].var == var) {
            Diag *x = diag_report(s->diags, DIAG_data_element_twice, in->element_span, in->element->text);
            diag_note(s->diags, x, d->column.at[i].span, DIAG_note_first_here);
            return;
        }
    set_column(in, var, &column);
    if (var)
        vec_push(s->arena, &d->column, column);
}

static void check_compare(Sema *s, ScriptData *d, const AstDataLine *in)
{
    Var *var = scope_find_variable(s, in->element);
    ScriptCompare c = {.tolerance = in->tolerance.value};

    s->knows_a_name |= var != NULL;
    if (!var)
        scope_report_unknown(s, in->element, in->element_span);
    if (sm_lt(c.tolerance, sm_from_i32(0)))
        diag_report(s->diags, DIAG_data_value, in->tolerance.span, "a tolerance is a number of at least 0");
    if (in->delay && !literal_units(in->delay, s->p->time_unit, &c.delay))
        diag_report(s->diags, DIAG_data_value, in->delay->span,
                    format_in(s->arena, "a delay is a whole number of %s", time_unit_name(s->p->time_unit)));
    set_column(in, var, &c.column);
    if (var)
        vec_push(s->arena, &d->compare, c);
}

// ---- the section ----

// Reports what [data] lacks.
static void check_complete(Sema *s, const AstSection *in)
{
    const char *missing = !in->data->setting[AST_DATA_FILE].text   ? "file: add a line such as 'file \"flight.csv\"'"
                          : !in->data->setting[AST_DATA_TIME].text ? "column of times: add a line such as 'time \"t_ms\" ms'"
                          : in->data->line.n == 0                  ? "column: add a line such as 'pressure = \"P1\"'"
                                                                   : NULL;

    if (missing && !in->data->is_lost)
        diag_report(s->diags, DIAG_data_incomplete, in->header, missing);
}

// Returns true, and reports the section, if the script already has a [data] section.
static bool report_second_data_section(Sema *s, const Script *script, const AstSection *in)
{
    if (!script->data)
        return false;
    diag_note(s->diags, diag_report(s->diags, DIAG_data_twice, in->header), script->data->span, DIAG_note_first_here);
    return true;
}

void check_data(Sema *s, Script *script, const AstSection *in)
{
    const AstDataSetting *set = in->data->setting;
    ScriptData *d;

    if (map_find(&s->p->state_by_name, in->name)) {
        diag_report(s->diags, DIAG_data_is_state, in->header);
        return;
    }
    if (report_second_data_section(s, script, in))
        return;
    if (s->p->joint && s->p->time_unit == TIME_NONE) {
        diag_report(s->diags, DIAG_app_time_literal, in->header, "[data]", app_time_text(s->arena, s->p->joint->unit));
        return;
    }
    check_complete(s, in);
    d = ARENA_NEW(s->arena, ScriptData);
    d->span = in->header;
    d->file = set[AST_DATA_FILE].text;
    d->file_span = set[AST_DATA_FILE].text_span;
    d->time = set[AST_DATA_TIME].text;
    d->time_span = set[AST_DATA_TIME].text_span;
    d->unit = set[AST_DATA_TIME].value ? time_unit_find(set[AST_DATA_TIME].value->text) : TIME_MS;
    d->is_linear = set[AST_DATA_BETWEEN].word && strcmp(set[AST_DATA_BETWEEN].word->text, "linear") == 0;
    d->stops_at_bad_time = has_value(&set[AST_DATA_BAD_TIME], "error");
    d->skips_bad_times = has_value(&set[AST_DATA_BAD_TIME], "skip");
    d->missing_is_nan = has_value(&set[AST_DATA_MISSING], "nan");
    script->data = d;
    for (size_t i = 0; i < in->data->line.n; i++)
        if (in->data->line.at[i].is_compare)
            check_compare(s, d, &in->data->line.at[i]);
        else
            check_column(s, d, &in->data->line.at[i]);
}
