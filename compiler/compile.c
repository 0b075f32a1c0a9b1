// SPDX-License-Identifier: Apache-2.0
// The compiler: every stage from source text to findings and artefacts.  Read compile_sources() at the end first.
//
//    .sv ── parse ── AST ── check ──▶ StateVec; parsed again for each .sm, .io and .net that is bound to it
//    .io ── parse ── AST ── check ──▶ IoMap: of a source, for the C of the pins; of --io (CompileInput.pins), for the image; of both, for
//                                     findings about pins
//    .sm ── parse ── AST ── check ──▶ Program ── build ──▶ IR ──┬── analyse ──▶ findings
//                                        │                      └── passes ──▶ IR ──┬──▶ image (emit/bytecode), verified
//                                        │                                          ├── passes for C ──▶ C (emit/c)
//                                        │                                          ├──▶ image with lines ── costs ── limits ──▶ findings
//                                        │                                          └──▶ image without lines ── bytes ── limit ──▶ findings
//                                        └── parsed and checked again if scripts write its locals ──▶ Program for scripts
//    .ss ── parse without messages ──▶ the locals that it writes and its delta_t, for the stages above
//        ── parse ── AST ── check with the Program for scripts ──▶ Script; if `scripts_later`, the caller does this with session_script(), as
//                                     smc test, report, graph and diff do
//    .net ─ parse ── AST ── check ──▶ Network, for the C of the messages and their dictionary
//    .app ─ parse ── AST ── check ──▶ App, with the IoMap of its pins, a StateVec for all and a Program for each machine, as above;
//                                     ── analyse ──▶ findings; C: X_app.c with the tasks and the images, and a file for each
//                                     vector, map of pins and machine in C
//    findings ── @allow ── -W ── sort ──▶ diagnostics of the caller
//    .rq ── parse ── AST ── check with the Program for scripts ──▶ Requirements, for the runs of its scripts and for proofs
//    tokens, AST or IR ──▶ dump (--emit=tokens, ast or ir)
//
// Machines pass their stages one after the other; then findings about all of them together.  Images, C and IR are emitted last, and only if
// there is no error; C of an application is emitted before its scripts are checked.  A dump of tokens or the AST skips the stages after it.
// All of these are artefacts (Compiled.artefact).
//
// Results are in Session.arena and live as long as the session.  A tree is in Session.tree, which is freed when the file has been checked, so a
// source that is needed again is parsed again; only the tree of an application stays, in Session.arena.  The optimised IR of a machine is stored in
// Compiled.of.  That of an application's machines is not: the limits and the emission each build it.
//
// Values that a variable can have are computed from the IR (facts/): analyses, passes and emit/c use them.
//
// The caller runs scripts on engines (script/), writes reports (report/), and writes the artefacts if compile_sources() returned true:
// -Werror turns findings into errors after they have been emitted.  The engines do not run the artefacts: session_open_vm() makes its own
// IR and image from the Program, and device/engine_c.c its own C, one program with two variants of each machine (emit_c_driver).
//
// Each stage is a function of its folder, and the header of that folder states what the stage relies on.  A function of session.h that
// parses or checks returns NULL after errors.  Stages that do not depend on its result still run, so that one call reports as many errors as
// possible.
// Parsing always produces a tree, with error nodes, so that checking finds further errors.
#include "compiler/compile.h"

#include <string.h>

#include "compiler/analysis/analysis.h"
#include "compiler/artefacts.h"
#include "compiler/source_files.h"
#include "compiler/syntax/parse.h"

// Returns the index of the only machine; SIZE_MAX if there is not exactly one.
static size_t find_only_machine(const CompileInput *in)
{
    size_t found = SIZE_MAX, n = 0;

    for (size_t i = 0; i < in->n; i++)
        if (in->at[i].kind == FILE_SM) {
            found = i;
            n++;
        }
    return n == 1 ? found : SIZE_MAX;
}

// Marks the scripts that other scripts of the call include.
static void mark_included_scripts(Compilation *c)
{
    for (size_t i = 0; i < c->in->n; i++) {
        ScriptFiles files = {NULL, NULL, 1};
        if (c->in->at[i].kind == FILE_SS && !c->out->of[i].is_included)       // files that include each other: the first one runs as a script
            files = session_script_files(c->s, c->in->at[i].text, true);
        for (size_t k = 0; k + 1 < files.n; k++)
            for (size_t n = 0; n < c->in->n; n++)
                c->out->of[n].is_included |= c->in->at[n].text == files.at[k];
    }
}

// Returns the index of the machine to which source i belongs, or of the application; SIZE_MAX: none.
static size_t machine_of_source(const Compilation *c, size_t i)
{
    return c->in->app ? 0 : c->in->at[i].machine ? c->in->at[i].machine - 1 : c->only_machine;
}

// Returns the index of the machine that source i is a script of; SIZE_MAX: it is no script, or has no machine.
static size_t machine_of_script(const Compilation *c, size_t i)
{
    if (c->in->at[i].kind != FILE_SS || c->out->of[i].is_included)
        return SIZE_MAX;
    return machine_of_source(c, i);
}

// Adds the locals that the scripts of machine m, which has the program p, write to `written`.  If the option `step` is 0, the session's step
// becomes the step that the machine declares, or else the delta_t of its scripts if all of them have the same.  Errors in a script are
// reported when the script is compiled, not here.
static void read_script_writes_and_step(Compilation *c, size_t m, const Program *p, Map *written)
{
    uint64_t step = p->step;
    bool agree = true;

    for (size_t i = 0; i < c->in->n; i++)
        if (machine_of_script(c, i) == m) {
            const uint64_t delta_t = session_script_writes(c->s, c->in->at[i].text, p->time_unit, written);
            agree = agree && delta_t > 0 && (step == 0 || delta_t == step);
            step = delta_t;
        }
    if (c->o->step == 0)
        c->s->step = p->step ? p->step : agree ? step : 0;
}

static void check_limits(Compilation *c, const CompiledSource *of)
{
    const ImageOptions as_sent = {false, c->out->image_pins};
    LimitSubject m = {of->program, of->ir, of->measured, 0, c->out->image_pins};
    Buf image;

    buf_init(&image, &c->s->arena);
    if (session_image(c->s, &m.ir, 1, &as_sent, &image))
        m.length = (uint32_t)image.n;
    limits_check(&c->s->arena, &c->s->diags, &m, &c->o->limits);
}

// Optimises a machine.  If its costs are needed, also builds an image with line numbers.  The limits of steps and RAM are checked on that
// image, the bytes of a board on another one.
static void build_ir_and_measure(Compilation *c, CompiledSource *of)
{
    const ImageOptions with_lines = {true, NULL};
    const bool is_limited = limits_exist(&c->o->limits);

    if (c->o->emit == EMIT_NOTHING && !is_limited && !c->o->measure)
        return;
    of->ir = session_ir(c->s, of->program, c->o->opt_level);
    if (is_limited || c->o->measure) {
        Buf image;
        buf_init(&image, &c->s->arena);
        if (session_image(c->s, &of->ir, 1, &with_lines, &image))
            of->measured = (const uint8_t *)image.at;
    }
    if (is_limited && of->measured)
        check_limits(c, of);
}

static bool has_requirements(const Compilation *c, size_t m)
{
    for (size_t i = 0; i < c->in->n; i++)
        if (c->in->at[i].kind == FILE_RQ && machine_of_source(c, i) == m)
            return true;
    return false;
}

// Reports an option `step` other than the step that the machine declares.
static void check_step_option(const Compilation *c, const Program *p)
{
    if (p->step && c->o->step && c->o->step != p->step)
        diag_report(&c->s->diags, DIAG_step_option_differs, p->step_span, format_in(&c->s->arena, "%llu", (unsigned long long)c->o->step),
                    format_in(&c->s->arena, "%llu", (unsigned long long)p->step));
}

static void compile_machine(Compilation *c, size_t i)
{
    CompiledSource *of = &c->out->of[i];
    MachineInput m = {c->in->at[i].text, c->in->vector, NULL, c->in->instance};
    Map written = {&c->s->arena, NULL, NULL, 0, 0};

    c->s->step = c->o->step;
    c->s->has_requirements = has_requirements(c, i);
    if ((of->program = session_program(c->s, &m)) == NULL)
        return;
    check_step_option(c, of->program);
    read_script_writes_and_step(c, i, of->program, &written);
    c->program[c->programs++] = of->program;
    session_analyse(c->s, of->program);
    build_ir_and_measure(c, of);
    m.written_outside = &written;
    of->scripted = session_program_for_scripts(c->s, &m, of->program);
}

// Checks the requirements of machine m, from all its files.
static void compile_requirements_of(Compilation *c, size_t m)
{
    const Source **rq = ARENA_ARRAY(&c->s->arena, const Source *, c->in->n);
    size_t n = 0;

    for (size_t i = 0; i < c->in->n; i++)
        if (c->in->at[i].kind == FILE_RQ && machine_of_source(c, i) == m)
            rq[n++] = c->in->at[i].text;
    if (n && c->out->of[m].scripted)
        c->out->of[m].requirements = session_requirements(c->s, rq, n, c->out->of[m].scripted);
}

static void compile_requirements(Compilation *c)
{
    for (size_t i = 0; i < c->in->n; i++) {
        const size_t m = c->in->at[i].kind == FILE_RQ ? machine_of_source(c, i) : SIZE_MAX;
        if (c->in->at[i].kind == FILE_SM || c->in->at[i].kind == FILE_APP)
            compile_requirements_of(c, i);
        else if (c->in->at[i].kind == FILE_RQ && (m == SIZE_MAX || !c->out->of[m].scripted))
            session_parse(c->s, c->in->at[i].text, FILE_RQ);
    }
}

static void compile_scripts(Compilation *c)
{
    for (size_t i = 0; i < c->in->n; i++) {
        const size_t m = machine_of_script(c, i);
        const Program *p = m != SIZE_MAX ? c->out->of[m].scripted : NULL;
        if (p && (c->out->of[i].script = session_script(c->s, c->in->at[i].text, p)) != NULL && c->out->of[m].requirements)
            session_check_requirements_of_script(c->s, c->out->of[m].requirements, c->out->of[i].script);
        if (p)
            continue;
        if (c->in->at[i].kind == FILE_SS && !c->out->of[i].is_included)
            session_parse(c->s, c->in->at[i].text, FILE_SS);
    }
}

// Reports conflicts between all machines of this compilation over their shared state vector, and between each machine and the pins.
static void analyse_all_machines(Compilation *c)
{
    if (c->in->vector)
        analyse_shared_vector(&c->s->arena, &c->s->diags, c->program, c->programs);
    for (size_t i = 0; i <= c->in->n; i++) {
        const IoMap *pins = i < c->in->n ? c->out->of[i].pins : c->out->image_pins;
        for (size_t m = 0; pins && m < c->programs; m++)
            analyse_shared_pins(&c->s->arena, &c->s->diags, pins, c->program[m]);
    }
}

static void compile_files(Compilation *c)
{
    mark_included_scripts(c);
    if (c->in->pins)                                      // before the machines: check_limits counts the pins
        c->out->image_pins = session_io(c->s, c->in->pins, c->in->vector);
    for (size_t i = 0; i < c->in->n; i++) {
        const CompileSource *src = &c->in->at[i];
        CompiledSource *of = &c->out->of[i];
        if (src->kind == FILE_SM)
            compile_machine(c, i);
        else if (src->kind == FILE_SV)
            of->vector = session_state_vector(c->s, src->text);
        else if (src->kind == FILE_IO && c->in->vector)
            of->pins = session_io(c->s, src->text, c->in->vector);
        else if (src->kind == FILE_NET && c->in->vector)
            of->net = session_net(c->s, src->text, c->in->vector);
        else if (src->kind == FILE_IO || src->kind == FILE_NET || src->kind == FILE_APP)
            session_parse(c->s, src->text, src->kind);
    }
    compile_requirements(c);
    if (!c->o->scripts_later)
        compile_scripts(c);
    analyse_all_machines(c);
    if (c->s->diags.errors == 0)
        artefacts_emit(c);
}

// Checks the limits of each bytecode machine, on the image that artefacts_emit_app generates: with names, unless the option `names` is off.
// A machine that becomes C is an error.
static void check_app_limits(Compilation *c, const App *a)
{
    c->s->locals = artefacts_image_locals(c->o);
    for (size_t i = 0; i < a->machine.n; i++) {
        CompiledSource of = {.program = a->machine.at[i]->program};
        if (a->machine.at[i]->bytecode)
            build_ir_and_measure(c, &of);
        else
            limits_report_c(&c->s->diags, of.program);
    }
    c->s->locals = LOCALS_READ;
}

// Joins the machines of an application for its scripts and requirements, and compiles these.
static void compile_scripts_of_app(Compilation *c, const App *a)
{
    Map written = {&c->s->arena, NULL, NULL, 0, 0};

    for (size_t i = 0; i < c->in->n; i++)
        if (machine_of_script(c, i) == 0)
            session_script_writes(c->s, c->in->at[i].text, TIME_NONE, &written);
    c->out->of[0].scripted = session_join(c->s, a, &c->in->app->files, &written);
    compile_requirements(c);
    if (!c->o->scripts_later)
        compile_scripts(c);
}

static void compile_app(Compilation *c)
{
    const App *a = session_app(c->s, c->in->app->tree, &c->in->app->files);

    mark_included_scripts(c);
    c->out->app = a;
    if (!a)
        return;
    if (limits_exist(&c->o->limits))
        check_app_limits(c, a);
    if (c->o->emit == EMIT_C && c->s->diags.errors == 0)
        artefacts_emit_app(c, a);
    if (c->in->n > 1 || c->o->scripts_later)
        compile_scripts_of_app(c, a);
}

// Parses an application, and lists the files that it names in out->files.  The caller then reads each of them.
void compile_open_app(Session *s, const Source *app, CompileApp *out)
{
    out->tree = parse_file(&s->arena, &s->strings, &s->diags, app, FILE_APP);
    app_list_files(&s->arena, out->tree, &out->files);
}

static bool is_syntax_dump(const CompileOptions *o) { return o->emit == EMIT_AST || o->emit == EMIT_TOKENS; }

// Returns what code outside the machines does with their locals.  Emitted C declares locals where the user's code can read them.
static SessionLocals locals_of_output(const CompileOptions *o) { return o->emit == EMIT_C ? LOCALS_READ : artefacts_image_locals(o); }

static bool finish_diagnostics(Session *s, const CompileOptions *o)
{
    diags_apply_allows(&s->diags);
    if (o->warnings)
        diags_select(&s->diags, o->warnings);
    diags_sort(&s->diags);
    return s->diags.errors == 0;
}

// Compiles everything that `o` requests.  s->diags then has the diagnostics, sorted, without the allowed and the disabled ones.
bool compile_sources(Session *s, const CompileInput *in, const CompileOptions *o, Compiled *out)
{
    Compilation c = {s, in, o, out, ARENA_ARRAY(&s->arena, const Program *, in->n), 0, find_only_machine(in)};

    memset(out, 0, sizeof *out);
    out->of = ARENA_ARRAY(&s->arena, CompiledSource, in->n);
    s->warnings = o->skip_analyses ? 0 : o->warnings ? diag_selection_groups(o->warnings) : DIAG_GROUPS_ALL;
    s->proposes_guards = o->warnings && diag_selection_enables(o->warnings, DIAG_guard_by_time);
    s->step = o->step;
    s->locals = locals_of_output(o);
    if (is_syntax_dump(o))
        artefacts_add_syntax_dump(&c);
    else if (in->app)
        compile_app(&c);
    else
        compile_files(&c);
    s->locals = LOCALS_READ;
    return finish_diagnostics(s, o);
}

// Adds the artefacts of o->emit to those of an earlier compile_sources of the same input, which found no error; other options must be as
// they were then.
bool compile_emit(Session *s, const CompileInput *in, const CompileOptions *o, Compiled *out)
{
    Compilation c = {s, in, o, out, NULL, 0, find_only_machine(in)};

    s->locals = locals_of_output(o);
    if (is_syntax_dump(o))
        artefacts_add_syntax_dump(&c);
    else if (in->app && o->emit == EMIT_C)
        artefacts_emit_app(&c, out->app);
    else if (!in->app) {
        for (size_t i = 0; i < in->n; i++)
            if (out->of[i].program)
                build_ir_and_measure(&c, &out->of[i]);
        artefacts_emit(&c);
    }
    s->locals = LOCALS_READ;
    return finish_diagnostics(s, o);
}
