// SPDX-License-Identifier: Apache-2.0
// smc test --trace: one file for all scripts of the call, written incrementally.
#include <string.h>

#include "compiler/cli/test.h"

enum { BLOCK = 1 << 16, NEAR_MOST = 3 };      // bytes buffered before a write; most suggestions for a misspelt name

struct TestTrace {
    Cli *c;
    const Program *p;
    const Requirements *requirements;     // the requirements that the scripts judge; or NULL
    const Var **column;           // the `columns` variables that follow step, G and state in each row
    size_t columns;
    bool is_exact;                // --trace-format=exact: a line for each value instead of a row for each step
    const char *script;           // the current script; NULL: none has run yet
    const Var *rounded;           // the first column with a value that a double cannot represent
    Buf text;                     // text that is not yet written to the file
    OsStream file;
    const char *error;            // why writing failed; NULL: no failure
};

// ---- columns ----

static int report_unknown_column(TestTrace *t, const char *name)
{
    Cli *c = t->c;
    const char *near[NEAR_MOST];
    size_t n = 0, most = strlen(name) / 3 + 2;
    Buf list;

    buf_init(&list, &c->session.arena);
    for (size_t distance = 0; distance < most && n < NEAR_MOST; distance++)
        for (size_t i = 0; i < t->p->var.n && n < NEAR_MOST; i++)
            if (str_distance(name, t->p->var.at[i]->report_name->text, most) == distance)
                near[n++] = t->p->var.at[i]->report_name->text;
    if (n == 0) {
        const Var **order = report_order(&c->session.arena, t->p);
        for (size_t i = 0; i < t->p->var.n; i++)
            buf_printf(&list, "%s%s", i ? ", " : "", order[i]->report_name->text);
        return cli_usage_error(c, TEXT_trace_no_element, name, buf_text(&list));
    }
    for (size_t i = 0; i < n; i++)
        buf_printf(&list, "%s'%s'", i == 0 ? "" : i + 1 < n ? ", " : " or ", near[i]);
    return cli_usage_error(c, TEXT_trace_element_near, name, buf_text(&list));
}

static void add_column(TestTrace *t, const Var *v)
{
    for (size_t i = 0; i < t->columns; i++)
        if (t->column[i] == v)
            return;
    t->column[t->columns++] = v;
}

// Selects the columns that --trace-elements=a,b,c lists: elements, locals and T, by name or alias.
static int choose_columns(TestTrace *t, const char *list)
{
    Arena *arena = &t->c->session.arena;

    for (;; list++) {
        const size_t n = strcspn(list, ",");
        const char *name = format_in(arena, "%.*s", (int)n, list);
        const Var *v = map_find(&t->p->by_name, str_c(&t->c->session.strings, name));
        if (n == 0)
            return cli_usage_error(t->c, TEXT_trace_names);
        if (!v)
            return report_unknown_column(t, name);
        if (v != t->p->g)
            add_column(t, v);
        if (*(list += n) == '\0')
            return EXIT_OK;
    }
}

// Selects every column that can change, except G and S, which every row has.
static void choose_all_columns(TestTrace *t)
{
    const Var **order = report_order(&t->c->session.arena, t->p);

    for (size_t i = 0; i < t->p->var.n; i++)
        if (t->is_exact || (order[i] != t->p->g && !order[i]->state_of && !order[i]->is_constant))
            add_column(t, order[i]);
}

// ---- writing ----

static void write_buffered(TestTrace *t)
{
    const char *why;

    if (!t->error && !os_stream_put(&t->file, buf_text(&t->text), t->text.n, &why))
        t->error = why;
    t->text.n = 0;
}

static int report_write_error(TestTrace *t, const char *why)
{
    cli_print_error(t->c, TEXT_cannot_write, cli_printable_name(&t->c->session.arena, t->c->value[OPT_TRACE]), why);
    return EXIT_ENVIRONMENT;
}

// Whether a double can hold this whole number exactly. cell: the value in 64 bits, two's complement if the type is signed.
static bool is_exact_double(SmType type, uint64_t cell)
{
    const bool is_negative = sm_type_info[type].kind == SM_KIND_SIGNED && cell >> 63;
    const uint64_t x = is_negative ? (uint64_t)0 - cell : cell;

    return x <= (uint64_t)1 << 53 || (x < UINT64_MAX - 1024 && (uint64_t)(double)x == x);
}

// Finds the first column with a whole number beyond 2^53 that a reader would round when it converts to double.
static void find_rounded(TestTrace *t, const uint64_t *cell)
{
    const Var *g = t->p->g;

    if (!t->rounded && !is_exact_double(g->type, cell[g->index]))
        t->rounded = g;
    for (size_t i = 0; i < t->columns && !t->rounded; i++) {
        const Var *v = t->column[i];
        const SmKind kind = sm_type_info[v->type].kind;
        if (sm_type_info[v->type].bytes == 8 && (kind == SM_KIND_SIGNED || kind == SM_KIND_UNSIGNED) && !is_exact_double(v->type, cell[v->index]))
            t->rounded = v;
    }
}

void test_trace_step(void *context, const ScriptStep *step)
{
    TestTrace *t = context;

    if (t->is_exact) {
        script_trace_exact(&t->text, step, t->column, t->columns);
    } else {
        script_trace_row(&t->text, t->script, step, t->column, t->columns, t->requirements);
        find_rounded(t, step->cell);
    }
    if (t->text.n >= BLOCK)
        write_buffered(t);
}

void test_trace_script(TestTrace *t, const char *path) { t->script = path; }

// Reports a script without a trace; t may be NULL.
void test_trace_left_out(TestTrace *t, const char *path)
{
    if (t)
        cli_print_note(t->c, TEXT_not_in_trace, path);
}

// Opens the file that --trace names; *trace is NULL without --trace.  Returns EXIT_OK, or the exit code after a message.
int test_trace_open(TestRun *run, const Program *p, const Requirements *rq, TestTrace **trace)
{
    Cli *c = run->c;
    TestTrace *t = ARENA_NEW(run->arena, TestTrace);
    const char *why;
    int code;

    *trace = NULL;
    if (!c->given[OPT_TRACE])
        return EXIT_OK;
    t->c = c;
    t->p = p;
    t->requirements = rq;
    t->is_exact = c->given[OPT_TRACE_FORMAT] && strcmp(c->value[OPT_TRACE_FORMAT], "exact") == 0;
    t->column = ARENA_ARRAY(run->arena, const Var *, p->var.n);
    if (!c->given[OPT_TRACE_ELEMENTS])
        choose_all_columns(t);
    else if ((code = choose_columns(t, c->value[OPT_TRACE_ELEMENTS])) != EXIT_OK)
        return code;
    buf_init(&t->text, run->arena);
    if (!t->is_exact)
        script_trace_header(&t->text, p, t->column, t->columns, rq);
    if (!os_stream_open(&t->file, c->value[OPT_TRACE], &why))
        return report_write_error(t, why);
    *trace = t;
    return EXIT_OK;
}

// Closes the trace, which can be NULL.  The file appears if a script ran.
int test_trace_close(TestTrace *t)
{
    const char *why;

    if (!t)
        return EXIT_OK;
    if (t->script)
        write_buffered(t);
    if (!os_stream_close(&t->file, !t->error && t->script, &why) && !t->error)
        t->error = why;
    if (t->error)
        return report_write_error(t, t->error);
    if (!t->script)
        cli_print_note(t->c, TEXT_no_trace, t->c->value[OPT_TRACE]);
    if (t->rounded)
        cli_print_note(t->c, TEXT_trace_precision, t->rounded->report_name->text);
    return EXIT_OK;
}
