// SPDX-License-Identifier: Apache-2.0
// The stages of the compiler: text to tree, tree to program, program to IR, IR to executable form.  The header of each folder states
// what its stage relies on.
#include "compiler/session.h"

#include <string.h>

#include "compiler/analysis/analysis.h"
#include "compiler/emit/bytecode/bytecode.h"
#include "compiler/emit/c/emit_app.h"
#include "compiler/passes/pass.h"
#include "compiler/script/replay.h"
#include "compiler/sema/join.h"
#include "compiler/source_files.h"
#include "compiler/state_runs.h"
#include "compiler/syntax/parse.h"

// Prepares a session.  If `alloc` returns NULL, a call of the session jumps to *oom; the caller then calls session_free.
void session_init(Session *s, SmcAllocFn alloc, void *context, jmp_buf *oom)
{
    memset(s, 0, sizeof *s);
    arena_init(&s->arena, alloc, context, oom);
    arena_init(&s->tree, alloc, context, oom);
    arena_init(&s->work, alloc, context, oom);
    arena_init(&s->scratch, alloc, context, oom);
    str_pool_init(&s->strings, &s->arena);
    diags_init(&s->diags, &s->arena);
    s->warnings = DIAG_GROUPS_ALL;
}

void session_free(Session *s)
{
    arena_free(&s->scratch);
    arena_free(&s->work);
    arena_free(&s->tree);
    arena_free(&s->arena);
}

// ---- text to tree to program ----

// Returns a tree even if there were errors, so that checking finds further errors in the same run.  The caller frees s->tree after checking,
// because a tree is larger than the program that is built from it.
static AstFile *parse(Session *s, const Source *src, FileKind kind)
{
    return parse_file(&s->tree, &s->strings, &s->diags, src, kind);
}

static CheckContext make_check_context(Session *s)
{
    CheckContext c = {&s->arena, &s->strings, &s->diags, s->proposes_guards, s->has_requirements};
    return c;
}

AstFile *session_parse(Session *s, const Source *src, FileKind kind)
{
    size_t errors = s->diags.errors_seen;
    AstFile *f = parse_file(&s->arena, &s->strings, &s->diags, src, kind);

    return s->diags.errors_seen > errors ? NULL : f;
}

StateVec *session_state_vector(Session *s, const Source *sv)
{
    size_t errors = s->diags.errors_seen;
    CheckContext c = make_check_context(s);
    StateVec *out = check_state_vector(&c, parse(s, sv, FILE_SV));

    arena_free(&s->tree);
    return s->diags.errors_seen > errors ? NULL : out;
}

// Returns the pins of `io`; NULL if it or the state vector has errors.
IoMap *session_io(Session *s, const Source *io, const Source *sv)
{
    size_t errors = s->diags.errors_seen;
    CheckContext c = make_check_context(s);
    StateVec *vector = session_state_vector(s, sv);
    AstFile *f = parse(s, io, FILE_IO);
    IoMap *out = vector ? check_io(&c, f, vector) : NULL;

    arena_free(&s->tree);
    return s->diags.errors_seen > errors ? NULL : out;
}

Network *session_net(Session *s, const Source *net, const Source *sv)
{
    size_t errors = s->diags.errors_seen;
    CheckContext c = make_check_context(s);
    StateVec *vector = session_state_vector(s, sv);
    AstFile *f = parse(s, net, FILE_NET);
    Network *out = vector ? check_net(&c, f, vector) : NULL;

    arena_free(&s->tree);
    return s->diags.errors_seen > errors ? NULL : out;
}

Program *session_program(Session *s, const MachineInput *in)
{
    size_t errors = s->diags.errors_seen;
    CheckContext c = make_check_context(s);
    StateVec *sv = in->sv ? session_state_vector(s, in->sv) : NULL;
    AstFile *sm = parse(s, in->sm, FILE_SM);
    Program *p = check_machine(&c, sm, sv, in->written_outside, in->instance);

    arena_free(&s->tree);
    s->diags.known |= in->sv ? 1u << DIAG_JUDGED_VECTOR : 0;
    return s->diags.errors_seen > errors ? NULL : p;
}

// Whether the machine declares a local that scripts write.
static bool declares_written_local(const Program *p, const Map *written)
{
    for (size_t i = 0; written && i < p->var.n; i++)
        if (p->var.at[i]->kind == VAR_LOCAL && !p->var.at[i]->parameter && map_find(written, p->var.at[i]->name))
            return true;
    return false;
}

// Removes the edits that would mark as @read_only a local that scripts write: the script would then get a warning.  The finding that the
// machine never writes the local stays.
static void withdraw_read_only_edits(Diags *d, const Program *p, const Map *written)
{
    for (size_t i = 0; i < d->list.n; i++) {
        Diag *x = d->list.at[i];
        for (size_t v = 0; x->code == DIAG_never_written && v < p->var.n; v++)
            if (p->var.at[v]->span.at == x->span.at && map_find(written, p->var.at[v]->name))
                x->edits.n = 0;
    }
}

// The first check uses a separate list of diagnostics, which is dropped, because the check of `flown` has reported the same warnings.  Only errors
// about a local that is constant in flight but variable for scripts can be new.  If there are any, a second check reports them.
const Program *session_program_for_scripts(Session *s, const MachineInput *in, const Program *flown)
{
    const Diags reported = s->diags;
    const Program *p;

    if (!declares_written_local(flown, in->written_outside))
        return flown;
    withdraw_read_only_edits(&s->diags, flown, in->written_outside);
    diags_init(&s->diags, &s->arena);
    p = session_program(s, in);
    s->diags = reported;
    return p ? p : session_program(s, in);
}

// ---- an application ----

static const Source *find_source(const AppFiles *files, FileKind kind)
{
    for (size_t i = 0; i < files->n; i++)
        if (files->at[i].kind == kind)
            return files->at[i].src;
    return NULL;
}

// Compiles a machine of an application.  If sv is NULL because the state vector has errors, only syntax errors are reported.
static const Program *app_program(Session *s, const Source *sm, StateVec *sv, const AstAppTask *task)
{
    size_t errors = s->diags.errors_seen;
    CheckContext c = make_check_context(s);
    AstFile *f = parse(s, sm, FILE_SM);
    const MachineInstance instance = {task->name.text, task->name.span, task->bindings.at, task->bindings.n, false};
    Program *p = sv ? check_machine(&c, f, sv, NULL, task->bindings.n ? &instance : NULL) : NULL;

    arena_free(&s->tree);
    return s->diags.errors_seen > errors ? NULL : p;
}

// Sets by how much time advances from one step of a machine to the next, in units of G; 0 if that is not a whole number, or if no task of
// an executor runs the machine.
static void set_time_per_step(Session *s, const App *a, const AppMachine *m)
{
    s->step = 0;
    s->pauses = false;
    for (size_t e = 0; e < a->executor.n; e++)
        for (size_t r = 0; r < a->executor.at[e]->rate.n; r++) {
            const AppRate *rate = a->executor.at[e]->rate.at[r];
            for (size_t t = 0; t < rate->task.n; t++)
                if (rate->task.at[t]->machine == m && a->unit > 0 && rate->period % a->unit == 0) {
                    s->step = rate->period / a->unit;
                    s->pauses = rate->task.at[t]->mode != NULL;
                    return;
                }
        }
}

// Sets which machine the following reports are about, if several machines use its file.
static void begin_instance(Session *s, const AppFiles *files, const AppInstance *m)
{
    s->diags.machine = files->at[m->file].machines > 1 ? m->task->name.text->text : NULL;
}

// Checks every machine of the application. If a file has several machines without bindings, which is an error, only the first is checked, and the
// others get its program.
static void check_instances(Session *s, AppFiles *files, StateVec *sv)
{
    for (size_t i = 0; i < files->instances; i++) {
        AppInstance *m = &files->instance[i];
        const AppFile *f = &files->at[m->file];
        begin_instance(s, files, m);
        if (m->task->bindings.n == 0 && f->unbound != i + 1)
            m->program = files->instance[f->unbound - 1].program;
        else if (f->src)
            m->program = app_program(s, f->src, sv, m->task);
    }
    s->diags.machine = NULL;
}

// If several machines use one file, adds to each report the names of the machines that it is about.
static void name_machines(Session *s, const AppFiles *files)
{
    for (size_t i = 0; i < s->diags.list.n; i++) {
        Diag *d = s->diags.list.at[i];
        const char *list = "";
        size_t file = 0;
        while (file < files->n && files->at[file].src != d->span.src)
            file++;
        if (d->machines.n == 0 || file == files->n || d->machines.n == files->at[file].machines)
            continue;
        for (size_t m = 0; m < d->machines.n; m++)
            list = format_in(&s->arena, "%s%s'%s'", list, m == 0 ? "" : m + 1 < d->machines.n ? ", " : " and ", d->machines.at[m]);
        diag_note(&s->diags, d, (Span){0}, DIAG_note_in_machines, list);
    }
}

// Analyses each machine with the step of its rate group, and then all machines together.
static void analyse_app(Session *s, const App *a, const AppFiles *files)
{
    const Program **p = ARENA_ARRAY(&s->arena, const Program *, a->machine.n);

    for (size_t i = 0; i < a->machine.n; i++) {
        p[i] = a->machine.at[i]->program;
        set_time_per_step(s, a, a->machine.at[i]);
        begin_instance(s, files, &files->instance[i]);
        session_analyse(s, p[i]);
    }
    s->diags.machine = NULL;
    s->step = 0;
    s->pauses = false;
    s->diags.known |= 1u << DIAG_JUDGED_VECTOR | 1u << DIAG_JUDGED_APP;
    analyse_shared_vector(&s->arena, &s->diags, p, a->machine.n);
    for (size_t i = 0; a->pins && i < a->machine.n; i++)
        analyse_shared_pins(&s->arena, &s->diags, a->pins, p[i]);
}

// Compiles an application and everything that it names, analyses included.  NULL if there were errors.
App *session_app(Session *s, const AstFile *app, AppFiles *files)
{
    size_t errors = s->diags.errors_seen;
    CheckContext c = make_check_context(s);
    const Source *vector = find_source(files, FILE_SV), *pins = find_source(files, FILE_IO), *messages = find_source(files, FILE_NET);
    StateVec *sv = vector ? session_state_vector(s, vector) : NULL;
    AstFile *io = pins ? parse(s, pins, FILE_IO) : NULL;
    IoMap *map = io && sv ? check_io(&c, io, sv) : NULL;
    AstFile *net = messages ? parse(s, messages, FILE_NET) : NULL;
    Network *network = net && sv ? check_net(&c, net, sv) : NULL;
    App *a;

    arena_free(&s->tree);
    check_instances(s, files, sv);
    a = check_app(&c, app, sv, map, network, files);
    if (!a || s->diags.errors_seen > errors) {
        name_machines(s, files);
        return NULL;
    }
    emit_c_check_app_names(&s->arena, &s->diags, a);
    analyse_app(s, a, files);
    name_machines(s, files);
    return s->diags.errors_seen > errors ? NULL : a;
}

// For each name in `written` that begins with the machine's name and a dot, such as deploy.T, adds the rest of the name to `own`.
static void add_names_of_machine(Session *s, Str machine, const Map *written, Map *own)
{
    for (size_t i = 0; i < written->cap; i++) {
        const Str name = written->key[i];
        if (name && name->len > machine->len + 1 && name->text[machine->len] == '.' && memcmp(name->text, machine->text, machine->len) == 0) {
            const Str rest = str_c(&s->strings, name->text + machine->len + 1);
            map_put(own, rest, (void *)rest);
        }
    }
}

const Program *session_join(Session *s, const App *a, const AppFiles *files, const Map *written)
{
    const CheckContext c = make_check_context(s);
    const Program **p = ARENA_ARRAY(&s->arena, const Program *, a->machine.n);

    for (size_t i = 0; i < a->machine.n; i++) {
        const AppMachine *m = a->machine.at[i];
        const AstAppTask *task = files->instance[i].task;
        const MachineInstance instance = {task->name.text, task->name.span, task->bindings.at, task->bindings.n, false};
        Map own = {&s->arena, NULL, NULL, 0, 0};
        const MachineInput in = {files->at[m->file].src, find_source(files, FILE_SV), &own, task->bindings.n ? &instance : NULL};
        add_names_of_machine(s, m->name, written, &own);
        if ((p[i] = session_program_for_scripts(s, &in, m->program)) == NULL)
            return NULL;
    }
    return join_machines(&c, a, p);
}

// ---- scripts: their items are parsed, checked and freed one after the other ----

static void add_written_columns(void *context, const AstSection *section)
{
    script_add_names_of_section(section, context);
}

static void add_written_names(void *context, const AstStmt *item)
{
    script_add_names_of_item(item, context);
}

// Parses a script without reporting errors, and adds the names that it writes to `written`.  Returns NULL if it has syntax errors; otherwise
// its tree without items, in s->tree.
static const AstFile *parse_silently(Session *s, const Source *ss, Map *written)
{
    const ScriptVisitor v = {add_written_columns, add_written_names, written, &s->work};
    const bool muted = s->diags.muted;
    const size_t before = s->diags.errors_seen;
    const AstFile *f;
    bool good;

    s->diags.muted = true;
    f = parse_script(&s->tree, &s->strings, &s->diags, ss, &v);
    good = s->diags.errors_seen == before;
    s->diags.muted = muted;
    s->diags.errors_seen = before;
    return good ? f : NULL;
}

// Finds the file with recorded data of a checked script, and reads its header.  Returns false after a report.
static bool read_data_header(Session *s, Script *script)
{
    const char *problem = "no file can be read here";
    const ScriptData *d = script->data;

    if (!d)
        return true;
    if (s->finder.find_data && strlen(d->file->text) == d->file->len)
        script->data->source = s->finder.find_data(s->finder.context, d->file_span.src, d->file->text, &problem);
    if (!d->source)
        diag_report(&s->diags, DIAG_data_wrong, d->file_span, d->file->text, problem);
    return d->source && replay_check(&s->arena, &s->diags, script);
}

// Adds a note to what the check of a script has reported, from `first` on, in the files that the script includes: the same text can be right in
// one script and wrong in another, which has another delta_t or other variables.
static void note_includes(Session *s, const ScriptFiles *files, size_t first)
{
    for (size_t i = first; i < s->diags.list.n; i++)
        for (size_t k = 0; k + 1 < files->n; k++)
            if (s->diags.list.at[i]->span.src == files->at[k])
                diag_note(&s->diags, s->diags.list.at[i], files->include[k], DIAG_note_script_includes);
}

// A script without syntax errors is checked item by item, which needs little memory.  For a script with syntax errors, builds the whole tree
// first: the checker does not report names whose declarations an error may have hidden.  If an included file is missing, nothing is checked.
static Script *check_script_files(Session *s, const ScriptFiles *files, bool is_whole, const Program *p)
{
    CheckContext c = make_check_context(s);
    Map unused = {&s->tree, NULL, NULL, 0, 0};
    const AstFile **tree = ARENA_ARRAY(&s->tree, const AstFile *, files->n);
    bool good = is_whole;

    for (size_t i = 0; i < files->n && good; i++)
        good = (tree[i] = parse_silently(s, files->at[i], &unused)) != NULL;
    for (size_t i = 0; i < files->n && !good; i++)
        tree[i] = parse(s, files->at[i], FILE_SS);
    if (good)
        return check_script_source(&c, &s->tree, &s->work, tree, files->n, p);
    return is_whole ? check_script(&c, tree, files->n, p) : NULL;
}

Script *session_script(Session *s, const Source *ss, const Program *p)
{
    const size_t errors = s->diags.errors_seen, reported = s->diags.list.n;
    const ScriptFiles files = session_script_files(s, ss, false);
    Script *out = check_script_files(s, &files, s->diags.errors_seen == errors, p);
    bool good;

    if (out && s->warnings)
        analyse_units_of_script(&s->tree, &s->diags, out);
    if (out && s->warnings && s->diags.errors_seen == errors) {           // items with errors may lack their guards
        analyse_inputs_of_script(&s->diags, out);
        analyse_asserts_of_script(&s->tree, &s->diags, out);
    }
    arena_free(&s->tree);
    good = out && s->diags.errors_seen == errors && read_data_header(s, out);
    note_includes(s, &files, reported);
    for (size_t i = 0; good && i + 1 < files.n; i++)          // last: what a run reports has another note
        vec_push(&s->arena, &out->part, ((ScriptPart){files.at[i], files.include[i]}));
    return good ? out : NULL;
}

// Adds the names of the locals and elements that a script, with the files that it includes, writes to `written`, and returns its delta_t in
// the unit `unit`; 0 if it has none, or errors.
uint64_t session_script_writes(Session *s, const Source *ss, TimeUnit unit, Map *written)
{
    Map names = {&s->tree, NULL, NULL, 0, 0};
    const ScriptFiles files = session_script_files(s, ss, true);
    uint64_t delta_t = 0;
    bool good = true;

    for (size_t i = 0; i < files.n && good; i++) {
        const AstFile *f = parse_silently(s, files.at[i], &names);
        const uint64_t of_file = f ? script_delta_t(f, unit) : 0;
        good = f != NULL;
        delta_t = of_file ? of_file : delta_t;
    }
    for (size_t i = 0; good && i < names.cap; i++)
        if (names.key[i])
            map_put(written, names.key[i], names.value[i]);
    arena_free(&s->tree);
    return good ? delta_t : 0;
}

// ---- requirements ----

Requirements *session_requirements(Session *s, const Source *const *rq, size_t n, const Program *p)
{
    const size_t errors = s->diags.errors_seen;
    CheckContext c = make_check_context(s);
    const AstFile **file = ARENA_ARRAY(&s->tree, const AstFile *, n);
    Requirements *out;

    for (size_t i = 0; i < n; i++)
        file[i] = parse(s, rq[i], FILE_RQ);
    out = check_requirements(&c, file, n, p);
    if (s->diags.errors_seen == errors)
        check_requirement_marks(&c, out);
    if (s->diags.errors_seen == errors && s->warnings)
        analyse_requirements(&s->diags, out);
    arena_free(&s->tree);
    return s->diags.errors_seen > errors ? NULL : out;
}

void session_check_requirements_of_script(Session *s, const Requirements *r, const Script *script)
{
    CheckContext c = make_check_context(s);

    check_requirements_of_script(&c, r, script);
}

// ---- analyses ----

// Reports warnings for a machine without errors.  Leaves the IR that it builds in s->built.
void session_analyse(Session *s, const Program *p)
{
    s->diags.analysed |= s->warnings;
    s->diags.known |= 1u << (s->step ? DIAG_JUDGED_STEP : DIAG_JUDGED_NO_STEP);
    if (s->warnings == 0)
        return;
    s->built = ir_build(&s->arena, p);
    analyse_machine(&s->work, &s->scratch, &s->diags, s->built, s->warnings, s->step, s->pauses, state_runs_find);
    arena_free(&s->work);
}

// ---- program to IR ----

static void print_requested_stage(Session *s, const char *stage, const IrMachine *m)
{
    if (!s->print_after || strcmp(s->print_after, stage) != 0)
        return;
    buf_printf(s->print_to, "# after %s\n", stage);
    ir_print(m, s->print_to);
}

static void print_after_pass(void *context, const PassInfo *pass, const IrMachine *m)
{
    print_requested_stage(context, pass->name, m);
}

// Marks the locals that code outside the machine reads or writes between steps.
static void mark_locals(IrMachine *m, SessionLocals locals)
{
    for (size_t v = 0; v < m->var.n; v++) {
        IrVar *var = &m->var.at[v];
        if (var->space != IR_LOCAL || var->parameter)
            continue;
        var->outside = var->outside || locals == LOCALS_SWAPPED;
        var->hidden = locals == LOCALS_HIDDEN && !var->outside;
    }
}

// Returns the IR of p before any pass: the one that session_analyse built if it analysed p last, otherwise a new one.  The caller's passes change
// the IR in place, so s->built can be used only once.
static IrMachine *reuse_or_build_ir(Session *s, const Program *p)
{
    IrMachine *m = s->built && s->built->program == p ? s->built : ir_build(&s->arena, p);

    s->built = NULL;
    return m;
}

// Leaves the compiler, because a pass has broken a machine: no wrong program may be emitted.
static void leave_because_of_bug(Session *s, const char *wrong)
{
    s->bug = format_in(&s->arena, "smc has a bug; please report it: a pass has broken the machine (%s)", wrong);
    longjmp(*s->arena.oom, 1);
}

// Returns a sentence that begins with the name of the pass that broke a machine: runs the passes again, with a check after each of them.
// `wrong`: what was wrong after the last pass.
static const char *name_broken_pass(Session *s, const Program *p, int opt_level, const char *wrong)
{
    const PassOptions o = {opt_level, NULL, true, false, NULL, NULL};
    IrMachine *m = ir_build(&s->arena, p);
    const char *named;

    mark_locals(m, s->locals);
    named = passes_run(&s->arena, m, &o);
    return named ? named : format_in(&s->arena, "after the last pass: %s", wrong);
}

// Returns the optimised IR of p.
IrMachine *session_ir(Session *s, const Program *p, int opt_level)
{
    IrMachine *m = reuse_or_build_ir(s, p);
    PassOptions o = {opt_level, NULL, s->check_passes, false, s->print_after ? print_after_pass : NULL, s};
    const char *wrong;

    mark_locals(m, s->locals);
    print_requested_stage(s, "build", m);
    wrong = passes_run(&s->arena, m, &o);
    if (wrong || (wrong = ir_verify(&s->arena, m)) != NULL)
        leave_because_of_bug(s, name_broken_pass(s, p, opt_level, wrong));
    return m;
}

// ---- IR to executable form ----

// Emits an image with n machines, which share one state vector.  Returns false after reporting what exceeds the format.
bool session_image(Session *s, IrMachine *const *m, size_t n, const ImageOptions *o, Buf *out)
{
    return emit_image(&s->arena, &s->diags, m, n, o->io, o->debug, out);
}

// Opens the VM, or the VM with soft numbers, on an image built for this engine.  NULL if it cannot be opened; *error is then a sentence.
Engine *session_open_vm(Session *s, const Program *p, int opt_level, bool soft, const char **error)
{
    IrMachine *m = session_ir(s, p, opt_level);
    const ImageOptions with_names = {true, NULL};
    Buf image;

    buf_init(&image, &s->arena);
    if (!session_image(s, &m, 1, &with_names, &image)) {
        *error = "the machine could not be made into an image";
        return NULL;
    }
    return (soft ? engine_vm_soft_open : engine_vm_open)(&s->arena, p, (const uint8_t *)image.at, image.n, 0, error);
}

void session_emit_c(Session *s, const IrMachine *m, const EmitCOptions *o, Buf *header, Buf *code)
{
    const PassOptions p = {0, NULL, s->check_passes, o && o->soft, print_after_pass, s};
    const char *wrong;
    const IrMachine *prepared = passes_for_c(&s->arena, m, &p, &wrong);

    if (!prepared)
        leave_because_of_bug(s, wrong);
    emit_c_machine(&s->arena, prepared, o, header, code);
}
