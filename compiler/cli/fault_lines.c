// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/fault_lines.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/base/os_signal.h"
#include "compiler/base/path.h"
#include "compiler/search/generated.h"
#include "compiler/whatif/fault_script.h"

#define MADE_BY "smc faults"

// Default limit of runs; default sizes of the faults `late` and `dropped`, in steps; the most scripts that are written.
enum { RUNS_MOST = 200000, LATE = 5, DROPPED = 10, SCRIPTS_MOST = 1000 };

void fault_lines_set_defaults(FaultOptions *o)
{
    o->kinds = (1u << FAULT_KIND_COUNT) - 1;
    o->max_runs = RUNS_MOST;
    o->sizes = (FaultSizes){0.05, 0.02, LATE, DROPPED, 0};
}

void fault_lines_show_progress(const Faults *f, ProgressLine *k)
{
    if (progress_is_due(k))
        progress_show(k, format_in(&k->c->session.arena, "faults: trigger %lu of %lu, %lu runs",
                                   f->result.n ? f->result.at[f->result.n - 1].trigger + 1UL : 1UL, (unsigned long)f->trigger.n,
                                   (unsigned long)f->runs));
}

// ---- the list ----

// Whether two results share a line of the report: the same faults with the same outcome, at different triggers.
static bool is_same_line(const FaultResult *a, const FaultResult *b)
{
    if (a->faults != b->faults || a->outcome != b->outcome)
        return false;
    for (uint32_t i = 0; i < a->faults; i++)
        if (a->fault[i].input != b->fault[i].input || a->fault[i].kind != b->fault[i].kind)
            return false;
    return true;
}

// By FaultOutcome: the place of its lines in the list.  A violated requirement and an abort are about the machine; an assert describes a flight
// without the fault, so one that fails says less.
static const uint8_t place_of_outcome[FAULT_OUTCOME_COUNT] = {
    [FAULT_HAS_VIOLATED] = 0, [FAULT_HAS_ABORTED] = 1, [FAULT_HAS_FAILED] = 2, [FAULT_HAS_ELSEWHERE] = 3, [FAULT_HAS_ENDLESS] = 4,
    [FAULT_HAS_DIFFERS] = 5, [FAULT_HAS_NONE] = 6,
};

// For qsort: single faults first, then the outcome by its place in the list, then the order in which they ran.
static int compare_lines(const void *a, const void *b)
{
    const FaultResult *x = ((const FaultLine *)a)->r, *y = ((const FaultLine *)b)->r;

    if (x->faults != y->faults)
        return x->faults < y->faults ? -1 : 1;
    if (x->outcome != y->outcome)
        return place_of_outcome[x->outcome] < place_of_outcome[y->outcome] ? -1 : 1;
    return x < y ? -1 : x > y;
}

// For qsort: results that share a line follow each other, in the order in which they ran.
static int compare_inputs(const void *a, const void *b)
{
    const FaultResult *x = *(const FaultResult *const *)a, *y = *(const FaultResult *const *)b;
    int by = (int)x->faults - (int)y->faults;

    by = by ? by : (int)x->outcome - (int)y->outcome;
    for (uint32_t i = 0; i < x->faults && by == 0; i++) {
        by = (int)x->fault[i].input - (int)y->fault[i].input;
        by = by ? by : (int)x->fault[i].kind - (int)y->fault[i].kind;
    }
    return by ? by : x < y ? -1 : x > y;
}

// Collects the results with an effect in lines. Results that differ only in the trigger share a line, unless `each`.
void fault_lines_collect(FaultLines *l, bool each)
{
    Arena *arena = &l->c->session.arena;
    const uint32_t n = l->f->result.n;
    const FaultResult **order = arena_array(arena, n + 1, sizeof *order);
    uint32_t shown = 0;

    for (uint32_t i = 0; i < n; i++)
        if (l->f->result.at[i].outcome != FAULT_HAS_NONE)
            order[shown++] = &l->f->result.at[i];
    qsort(order, shown, sizeof *order, compare_inputs);
    for (uint32_t i = 0; i < shown; i++) {
        const FaultLine line = {order[i], 0, NULL, NULL};
        if (!each && i > 0 && is_same_line(order[i], order[i - 1]))
            l->at.at[l->at.n - 1].others++;
        else
            vec_push(arena, &l->at, line);
    }
    if (l->at.n > 1)
        qsort(l->at.at, l->at.n, sizeof *l->at.at, compare_lines);
}

// ---- the scripts that reproduce ----

// Returns the path from a folder to that of a file, "" or with a separator at its end; NULL: that would need a system call.
static const char *path_to_folder_of(Arena *arena, const char *folder, const char *file)
{
    const size_t to_name = (size_t)(path_file_name(file) - file);
    const char *at = path_simplify(arena, folder), *up = "";

    if (path_is_absolute(file))
        return format_in(arena, "%.*s", (int)to_name, file);
    if (path_is_absolute(folder) || strncmp(at, "..", 2) == 0)
        return NULL;
    while (*at) {
        const size_t n = strcspn(at, "/\\");
        if (n > 0 && !(n == 1 && at[0] == '.'))
            up = format_in(arena, "%s../", up);
        at += n + (at[n] != '\0');
    }
    return format_in(arena, "%s%.*s", up, (int)to_name, file);
}

static const char *name_script(const FaultLines *l, const FaultLine *line, unsigned long number)
{
    const char *folder = l->c->value[OPT_SCRIPTS];
    const char *name = format_in(&l->c->session.arena, "%03lu", number);

    for (uint32_t i = 0; i < line->r->faults; i++)
        name = format_in(&l->c->session.arena, "%s-%s-%s", name, l->f->input.at[line->r->fault[i].input].var->report_name->text,
                         fault_kind_name[line->r->fault[i].kind]);
    return format_in(&l->c->session.arena, "%s%s%s.ss", folder, path_ends_in_separator(folder) ? "" : "/", name);
}

// Returns the smc test command that runs the script, for the comment at its start.
static const char *test_command_for(const FaultLines *l, const char *script)
{
    const Cli *c = l->c;
    const char *command = "smc test";

    for (size_t i = 0; i < c->files; i++)
        if (!has_suffix(c->file[i], ".ss"))
            command = format_in(&l->c->session.arena, "%s %s", command, c->file[i]);
    if (c->given[OPT_SV])
        command = format_in(&l->c->session.arena, "%s --sv %s", command, c->value[OPT_SV]);
    for (size_t i = 0; i < c->set.n; i++)
        command = format_in(&l->c->session.arena, "%s --set=%s", command, c->set.at[i]);
    if (c->given[OPT_SEED])
        command = format_in(&l->c->session.arena, "%s --seed=%s", command, c->value[OPT_SEED]);
    return format_in(&l->c->session.arena, "%s %s", command, script);
}

static const char *machine_file(const Cli *c)
{
    const char *name = "";

    for (size_t i = 0; i < c->files; i++)
        if (has_suffix(c->file[i], ".sm") || has_suffix(c->file[i], ".app"))
            name = path_file_name(c->file[i]);
    return name;
}

// Whether a script of smc faults has this path and was edited since: it is kept.
static bool is_edited_script(const FaultLines *l, const char *path)
{
    enum { MOST = 1 << 24 };
    static const char begin[] = "# Generated by " MADE_BY " from ";
    const char *why;
    char *text = NULL;
    size_t n;
    bool edited = false;

    if (os_read_file(path, MOST, &text, &n, &why))
        edited = n >= sizeof begin - 1 && memcmp(text, begin, sizeof begin - 1) == 0 &&
                 generated_read(MADE_BY, machine_file(l->c), text, n) != GENERATED_WHOLE;
    os_alloc(NULL, text, 0);
    return edited;
}

// Checks and runs the text of a script.  Returns whether it reproduces the fault.
static bool reproduces_fault(FaultLines *l, const FaultResult *x, const char *path, const Buf *text)
{
    Session *session = &l->c->session;
    Source *src = source_new(&l->c->session.arena, path, buf_text(text), text->n);
    const Diags was = session->diags;
    const Script *s;
    bool is_good;

    session->diags.muted = true;
    s = session_script(session, src, l->p);
    is_good = s && session->diags.errors_seen == was.errors_seen && fault_script_reproduces(&l->c->session.arena, l->f, x, s);
    session->diags = was;
    return is_good;
}

// Stores a script that reproduces the fault of a line: the original script with edits, else a recording of its run. If neither reproduces it,
// line->script is NULL.
static void make_script(FaultLines *l, FaultLine *line, unsigned long number)
{
    Arena *const arena = &l->c->session.arena;
    const char *path = name_script(l, line, number), *original = l->f->script[l->f->trigger.at[line->r->trigger].script]->src->name;
    const FaultScriptPlace place = {path_to_folder_of(&l->c->session.arena, l->c->value[OPT_SCRIPTS], original), test_command_for(l, path)};
    Buf body, text;

    buf_init(&body, arena);
    line->script = path;
    if (fault_script_write_edited(arena, l->f, line->r, &place, &body) || !reproduces_fault(l, line->r, path, &body)) {
        buf_init(&body, arena);
        if (fault_script_write_recorded(arena, l->f, line->r, &place, &body) || !reproduces_fault(l, line->r, path, &body))
            line->script = NULL;
    }
    if (line->script && is_edited_script(l, path)) {
        cli_print_note(l->c, TEXT_faults_kept, cli_printable_name(arena, path));
        line->script = NULL;
    }
    buf_init(&text, arena);
    generated_write(MADE_BY, machine_file(l->c), &body, &text);
    line->text = buf_text(&text);
    l->scripts += line->script != NULL;
}

int fault_lines_write_scripts(FaultLines *l)
{
    OsOutput *out = ARENA_ARRAY(&l->c->session.arena, OsOutput, l->at.n + 1);
    const char *why;
    size_t n = 0;
    int code;

    if (!l->c->given[OPT_SCRIPTS])
        return EXIT_OK;
    if (!os_make_folder(l->c->value[OPT_SCRIPTS], &why)) {
        cli_print_error(l->c, TEXT_cannot_write, l->c->value[OPT_SCRIPTS], why);
        return EXIT_ENVIRONMENT;
    }
    for (uint32_t i = 0; i < l->at.n && i < SCRIPTS_MOST && !os_signal_waiting(); i++) {
        make_script(l, &l->at.at[i], i + 1);
        if (l->at.at[i].script)
            out[n++] = (OsOutput){l->at.at[i].script, l->at.at[i].text, strlen(l->at.at[i].text)};
    }
    code = outputs_check(l->c, out, n);
    for (size_t i = 0; i < n && code == EXIT_OK; i++)        // one at a time, because there can be very many
        code = cli_write_outputs(l->c, &out[i], 1);
    return code;
}
