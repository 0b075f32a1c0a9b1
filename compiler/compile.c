// SPDX-License-Identifier: Apache-2.0
// The compiler: every stage, from source text to findings and artefacts.  Read compile_sources() at the end first.
//
//    .sv ── parse ── AST ── check ── StateVec ──┐
//    .io ── parse ── AST ── check ── IoMap ─────┤                                         ┌──── C (emit/c)
//                                               ├── Program ── IR ── passes ── IR ────────┤
//    .sm ── parse ── AST ── check ──────────────┘      │        │                         └──── image (emit/bytecode)
//                                                      │        └── analyse ── findings            │
//    .ss ── parse ── AST ── check ── Script ── run on engines (script/)                            └── costs ── limits
//                                                      │
//    .app ─ parse ── AST ── check ── App ───── names all of the above ── C for runtime-c
//
// Each stage is a function of its folder, and the header of that folder states what the stage relies on.  A stage that found errors
// returns NULL.  The stages that do not depend on its result still run, so that one call finds as many errors as possible.
#include "compiler/compile.h"

#include <string.h>

#include "compiler/analysis/analysis.h"
#include "compiler/emit/c/app.h"
#include "compiler/syntax/parse.h"

typedef struct Compilation {
    Session *s;
    const CompileInput *in;
    const CompileOptions *o;
    Compiled *out;
    const Program **program;      // of all machines without errors
    size_t programs;
    IoMap *image_pins;            // in->pins, or NULL
} Compilation;

static Buf *new_buf(Session *s)
{
    Buf *b = ARENA_NEW(&s->arena, Buf);

    buf_init(b, &s->arena);
    return b;
}

static Buf *add_artefact(Compilation *c, size_t source, const char *name, const char *ending)
{
    Artefact a = {source, name, ending, new_buf(c->s)};

    vec_push(&c->s->arena, &c->out->artefact, a);
    return a.bytes;
}

static size_t count_kind(const CompileInput *in, FileKind kind)
{
    size_t n = 0;

    for (size_t i = 0; i < in->n; i++)
        n += in->at[i].kind == kind;
    return n;
}

static const char *file_part(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

static void print_stage(Compilation *c)
{
    const bool tokens = c->o->emit == EMIT_TOKENS;
    Buf *out = add_artefact(c, 0, NULL, NULL);

    for (size_t i = 0; i < c->in->n; i++) {
        const Source *src = c->in->at[i].text;
        const AstFile *f;
        buf_str(out, tokens ? "# Tokens of " : "# Syntax tree of ");
        diag_put_printable(out, file_part(src->name), strlen(file_part(src->name)));
        buf_str(out, ", printed by smc\n");
        if (tokens)
            lex_print(&c->s->strings, &c->s->diags, src, c->in->at[i].kind, out);
        else if ((f = session_parse(c->s, src, c->in->at[i].kind)) != NULL)
            ast_print(f, out);
    }
}

// Adds the locals that the scripts write to `written`.  Without the option `step`, the session's step is the delta_t of the scripts if
// all have the same one.  Errors in a script are reported when it is compiled, not here.
static void read_scripts(Compilation *c, Map *written)
{
    const bool muted = c->s->diags.muted;
    uint64_t step = 0;
    bool agree = true;

    c->s->diags.muted = true;
    for (size_t i = 0; i < c->in->n; i++)
        if (c->in->at[i].kind == FILE_SS) {
            const size_t met = c->s->diags.met;
            const AstFile *f = session_parse(c->s, c->in->at[i].text, FILE_SS);
            const uint64_t delta_t = f ? script_delta_t(f) : 0;
            if (f)
                script_written_names(f, written);
            agree = agree && delta_t > 0 && (step == 0 || delta_t == step);
            step = delta_t;
            c->s->diags.met = met;
        }
    c->s->diags.muted = muted;
    if (c->o->step == 0 && agree)
        c->s->step = step;
}

// Optimises a machine and, if its costs are of interest, makes an image with lines of it, from which they are counted.
static void lower_machine(Compilation *c, CompiledSource *of)
{
    const ImageOptions with_lines = {true, NULL};
    const bool is_limited = limits_exist(&c->o->limits);

    if (c->o->emit == EMIT_NOTHING && !is_limited && !c->o->measure)
        return;
    of->ir = session_ir(c->s, of->program, c->o->opt_level);
    if (is_limited || c->o->measure) {
        Buf *image = new_buf(c->s);
        if (session_image(c->s, &of->ir, 1, &with_lines, image))
            of->measured = (const uint8_t *)image->at;
    }
    if (is_limited && of->measured)
        limits_check(&c->s->arena, &c->s->diags, of->program, of->measured, &c->o->limits);
}

static void compile_machine(Compilation *c, size_t i)
{
    const bool has_scripts = count_kind(c->in, FILE_SM) == 1 && count_kind(c->in, FILE_SS) > 0;
    CompiledSource *of = &c->out->of[i];
    MachineInput m = {c->in->at[i].text, c->in->vector, NULL, c->o->opt_level};
    Map written = {&c->s->arena, NULL, NULL, 0, 0};

    c->s->step = c->o->step;
    if (has_scripts)
        read_scripts(c, &written);
    if ((of->program = session_program(c->s, &m)) == NULL)
        return;
    c->program[c->programs++] = of->program;
    session_analyse(c->s, of->program);
    lower_machine(c, of);
    m.written_outside = &written;
    of->scripted = session_program_for_scripts(c->s, &m, of->program);
}

static void compile_scripts(Compilation *c)
{
    const Program *p = NULL;

    for (size_t i = 0; i < c->in->n && count_kind(c->in, FILE_SM) == 1; i++)
        if (c->in->at[i].kind == FILE_SM)
            p = c->out->of[i].scripted;
    for (size_t i = 0; i < c->in->n; i++)
        if (c->in->at[i].kind == FILE_SS && p)
            c->out->of[i].script = session_script(c->s, c->in->at[i].text, p);
        else if (c->in->at[i].kind == FILE_SS)
            session_parse(c->s, c->in->at[i].text, FILE_SS);
}

// Reports findings that require all machines of the call, and those about their pins.
static void analyse_all(Compilation *c)
{
    if (c->in->vector)
        analyse_together(&c->s->arena, &c->s->diags, c->program, c->programs);
    for (size_t i = 0; i <= c->in->n; i++) {
        const IoMap *pins = i < c->in->n ? c->out->of[i].pins : c->image_pins;
        for (size_t m = 0; pins && m < c->programs; m++)
            analyse_pins(&c->s->arena, &c->s->diags, pins, c->program[m]);
    }
}

static void emit_image_of_machines(Compilation *c)
{
    const ImageOptions o = {c->o->names, c->image_pins};
    IrMachine **m = ARENA_ARRAY(&c->s->arena, IrMachine *, c->in->n);
    size_t n = 0;
    Buf *image;

    for (size_t i = 0; i < c->in->n; i++)
        if (c->out->of[i].ir)
            m[n++] = c->out->of[i].ir;
    if (c->o->emit == EMIT_BYTECODE) {
        session_image(c->s, m, n, &o, add_artefact(c, 0, NULL, ".smb"));
        return;
    }
    image = new_buf(c->s);
    if (session_image(c->s, m, n, &o, image))
        emit_c_image(&c->s->arena, c->in->at[0].array, image, &c->in->at[0].c, add_artefact(c, 0, NULL, "_image.h"));
}

static void emit_c_of_source(Compilation *c, size_t i)
{
    const CompiledSource *of = &c->out->of[i];
    const bool is_pins = c->in->at[i].kind == FILE_IO;
    Buf *code = add_artefact(c, i, NULL, is_pins ? "_io.c" : ".c"), *header = add_artefact(c, i, NULL, is_pins ? "_io.h" : ".h");

    if (of->ir)
        session_emit_c(c->s, of->ir, &c->in->at[i].c, header, code);
    else if (of->vector)
        emit_c_state_vector(&c->s->arena, of->vector, &c->in->at[i].c, header, code);
    else if (of->pins)
        emit_c_io(&c->s->arena, of->pins, &c->in->at[i].c, header, code);
}

static void emit_files(Compilation *c)
{
    Buf *text = NULL;

    if (c->o->emit == EMIT_BYTECODE || c->o->emit == EMIT_ARRAY)
        emit_image_of_machines(c);
    if (c->o->emit == EMIT_IR)
        text = add_artefact(c, 0, NULL, NULL);
    for (size_t i = 0; i < c->in->n; i++)
        if (c->o->emit == EMIT_C)
            emit_c_of_source(c, i);
        else if (text && c->out->of[i].ir)
            ir_print(c->out->of[i].ir, text);
}

static void compile_files(Compilation *c)
{
    for (size_t i = 0; i < c->in->n; i++) {
        const CompileSource *src = &c->in->at[i];
        CompiledSource *of = &c->out->of[i];
        if (src->kind == FILE_SM)
            compile_machine(c, i);
        else if (src->kind == FILE_SV)
            of->vector = session_state_vector(c->s, src->text);
        else if (src->kind == FILE_IO && c->in->vector)
            of->pins = session_io(c->s, src->text, c->in->vector);
        else if (src->kind == FILE_IO || src->kind == FILE_APP)
            session_parse(c->s, src->text, src->kind);
    }
    if (!c->o->scripts_later)
        compile_scripts(c);
    if (c->in->pins)
        c->image_pins = session_io(c->s, c->in->pins, c->in->vector);
    analyse_all(c);
    if (c->s->diags.errors == 0)
        emit_files(c);
}

// ---- an application ----

static Buf *add_app_file(Compilation *c, const char *stem, const char *end)
{
    return add_artefact(c, 0, format_in(&c->s->arena, "%s%s", stem, end), NULL);
}

static EmitCOptions app_c_options(Compilation *c, const char *stem, const char *source, const char *ending)
{
    EmitCOptions e;

    memset(&e, 0, sizeof e);
    e.header = format_in(&c->s->arena, "%s.h", stem);
    e.source = format_in(&c->s->arena, "%s%s", source, ending);
    e.runtime = true;
    e.soft = c->o->soft;
    return e;
}

// Emits the application, then its state vector, its machines that are C, and its pins.
static void emit_app(Compilation *c, const App *a)
{
    const ImageOptions image_options = {c->o->names, NULL};
    const Buf **image = ARENA_ARRAY(&c->s->arena, const Buf *, a->machine.n);
    const char *stem = format_in(&c->s->arena, "%s_app", a->name->text);
    Buf *code = add_app_file(c, stem, ".c"), *header = add_app_file(c, stem, ".h");
    EmitCOptions e;

    for (size_t i = 0; i < a->machine.n; i++)
        if (a->machine.at[i]->bytecode) {
            Buf *bytes = new_buf(c->s);
            IrMachine *m;
            c->s->hide_locals = !c->o->names;
            m = session_ir(c->s, a->machine.at[i]->program, c->o->opt_level);
            c->s->hide_locals = false;
            if (!session_image(c->s, &m, 1, &image_options, bytes))
                return;
            image[i] = bytes;
        }
    emit_c_app(&c->s->arena, a, image, header, code);

    stem = a->sv->name->text;
    e = app_c_options(c, stem, stem, ".sv");
    code = add_app_file(c, stem, ".c"), header = add_app_file(c, stem, ".h");
    emit_c_state_vector(&c->s->arena, a->sv, &e, header, code);
    for (size_t i = 0; i < a->machine.n; i++)
        if (!a->machine.at[i]->bytecode) {
            const Program *p = a->machine.at[i]->program;
            stem = p->name->text;
            e = app_c_options(c, stem, stem, ".sm");
            code = add_app_file(c, stem, ".c"), header = add_app_file(c, stem, ".h");
            session_emit_c(c->s, session_ir(c->s, p, c->o->opt_level), &e, header, code);
        }
    if (!a->pins)
        return;
    stem = format_in(&c->s->arena, "%s_io", a->io_name->text);
    e = app_c_options(c, stem, a->io_name->text, ".io");
    code = add_app_file(c, stem, ".c"), header = add_app_file(c, stem, ".h");
    emit_c_io(&c->s->arena, a->pins, &e, header, code);
}

// Images of machines are limited as they fly: without names.
static void check_app_limits(Compilation *c, const App *a)
{
    CompiledSource of;

    memset(&of, 0, sizeof of);
    c->s->hide_locals = true;
    for (size_t i = 0; i < a->machine.n && limits_exist(&c->o->limits); i++)
        if (a->machine.at[i]->bytecode) {
            of.program = a->machine.at[i]->program;
            lower_machine(c, &of);
        }
    c->s->hide_locals = false;
}

static void compile_app(Compilation *c)
{
    const App *a = session_app(c->s, c->in->app->tree, &c->in->app->files);

    c->out->app = a;
    if (!a)
        return;
    check_app_limits(c, a);
    if (c->o->emit == EMIT_C)
        emit_app(c, a);
}

void compile_open_app(Session *s, const Source *app, CompileApp *out)
{
    out->tree = parse_file(&s->arena, &s->strings, &s->diags, app, FILE_APP);
    app_files(&s->arena, out->tree, &out->files);
}

bool compile_sources(Session *s, const CompileInput *in, const CompileOptions *o, Compiled *out)
{
    Compilation c = {s, in, o, out, ARENA_ARRAY(&s->arena, const Program *, in->n), 0, NULL};

    memset(out, 0, sizeof *out);
    out->of = ARENA_ARRAY(&s->arena, CompiledSource, in->n);
    s->warnings = o->skip_analyses ? 0 : o->warnings ? diag_selection_groups(o->warnings) : DIAG_GROUPS_ALL;
    s->step = o->step;
    s->hide_locals = o->emit != EMIT_C && !o->names;       // in C other code can read them
    if (o->emit == EMIT_AST || o->emit == EMIT_TOKENS)
        print_stage(&c);
    else if (in->app)
        compile_app(&c);
    else
        compile_files(&c);
    s->hide_locals = false;

    diags_apply_allows(&s->diags);
    if (o->warnings)
        diags_select(&s->diags, o->warnings);
    diags_sort(&s->diags);
    return s->diags.errors == 0;
}
