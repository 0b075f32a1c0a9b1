// SPDX-License-Identifier: Apache-2.0
#include "compiler/artefacts.h"

#include <string.h>

#include "compiler/emit/c/emit_app.h"
#include "compiler/syntax/parse.h"

static Buf *new_buf(Session *s)
{
    Buf *b = ARENA_NEW(&s->arena, Buf);

    buf_init(b, &s->arena);
    return b;
}

static Buf *add_artefact(Compilation *c, size_t source, const char *name, const char *suffix)
{
    Artefact a = {source, name, suffix, new_buf(c->s)};

    vec_push(&c->s->arena, &c->out->artefact, a);
    return a.bytes;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

void artefacts_add_syntax_dump(Compilation *c)
{
    const bool tokens = c->o->emit == EMIT_TOKENS;
    Buf *out = add_artefact(c, 0, NULL, NULL);

    for (size_t i = 0; i < c->in->n; i++) {
        const Source *src = c->in->at[i].text;
        const AstFile *f;
        buf_str(out, tokens ? "# Tokens of " : "# Syntax tree of ");
        diag_put_printable(out, base_name(src->name), strlen(base_name(src->name)));
        buf_str(out, ", printed by smc\n");
        if (tokens)
            lex_print(&c->s->strings, &c->s->diags, src, c->in->at[i].kind, out);
        else if ((f = session_parse(c->s, src, c->in->at[i].kind)) != NULL)
            ast_print(f, out);
    }
}

// ---- machines, state vectors, pins ----

SessionLocals artefacts_image_locals(const CompileOptions *o) { return o->names ? LOCALS_SWAPPED : LOCALS_HIDDEN; }

static void emit_image(Compilation *c)
{
    const ImageOptions o = {c->o->names, c->out->image_pins};
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

static void emit_c_for_source(Compilation *c, size_t i)
{
    const CompiledSource *of = &c->out->of[i];
    const FileKind kind = c->in->at[i].kind;
    const char *end = kind == FILE_IO ? "_io" : kind == FILE_NET ? "_net" : "";
    Buf *code = add_artefact(c, i, NULL, format_in(&c->s->arena, "%s.c", end));
    Buf *header = add_artefact(c, i, NULL, format_in(&c->s->arena, "%s.h", end));

    if (of->ir)
        session_emit_c(c->s, of->ir, &c->in->at[i].c, header, code);
    else if (of->vector)
        emit_c_state_vector(&c->s->arena, of->vector, &c->in->at[i].c, header, code);
    else if (of->pins)
        emit_c_io(&c->s->arena, of->pins, &c->in->at[i].c, header, code);
    else if (of->net)
        emit_c_net(&c->s->arena, of->net, &c->in->at[i].c, header, code);
}

// Emits the outputs that o->emit requests.
void artefacts_emit(Compilation *c)
{
    Buf *text = NULL;

    if (c->o->emit == EMIT_BYTECODE || c->o->emit == EMIT_ARRAY)
        emit_image(c);
    if (c->o->emit == EMIT_IR)
        text = add_artefact(c, 0, NULL, NULL);
    for (size_t i = 0; i < c->in->n; i++)
        if (c->o->emit == EMIT_C && c->in->at[i].kind != FILE_SS)
            emit_c_for_source(c, i);
        else if (text && c->out->of[i].ir)
            ir_print(c->out->of[i].ir, text);
}

// ---- an application ----

// Adds the output file `stem``end` of an application.  Returns the buffer for its content.
static Buf *add_app_file(Compilation *c, const char *stem, const char *end)
{
    return add_artefact(c, 0, format_in(&c->s->arena, "%s%s", stem, end), NULL);
}

// Two output files with C that are generated from one source.
typedef struct CPair {
    EmitCOptions o;
    Buf *header, *code;
} CPair;

// Adds the output files STEM.h and STEM.c, which are generated from the file whose name is `source` followed by `suffix`.
static CPair add_app_pair(Compilation *c, const char *stem, Str source, const char *suffix)
{
    CPair f;

    memset(&f, 0, sizeof f);
    f.o.header = format_in(&c->s->arena, "%s.h", stem);
    f.o.source = format_in(&c->s->arena, "%s%s", source->text, suffix);
    f.o.runtime = true;
    f.o.soft = c->o->soft;
    f.code = add_app_file(c, stem, ".c");
    f.header = add_app_file(c, stem, ".h");
    return f;
}

// Returns the image of a machine that runs as bytecode; NULL after a report.
static const Buf *app_image(Compilation *c, const Program *p)
{
    const ImageOptions o = {c->o->names, NULL};
    Buf *bytes = new_buf(c->s);
    IrMachine *m;

    c->s->locals = artefacts_image_locals(c->o);
    m = session_ir(c->s, p, c->o->opt_level);
    c->s->locals = LOCALS_READ;
    return session_image(c->s, &m, 1, &o, bytes) ? bytes : NULL;
}

// Adds NAME_app.c and NAME_app.h, which contain the images.  Returns false after a report.
static bool emit_app_tables(Compilation *c, const App *a)
{
    const Buf **image = ARENA_ARRAY(&c->s->arena, const Buf *, a->machine.n);
    const char *stem = format_in(&c->s->arena, "%s_app", a->name->text);
    Buf *code = add_app_file(c, stem, ".c"), *header = add_app_file(c, stem, ".h");

    for (size_t i = 0; i < a->machine.n; i++)
        if (a->machine.at[i]->bytecode && (image[i] = app_image(c, a->machine.at[i]->program)) == NULL)
            return false;
    emit_c_app(&c->s->arena, a, image, header, code);
    return true;
}

void artefacts_emit_app(Compilation *c, const App *a)
{
    CPair f;

    if (!emit_app_tables(c, a))
        return;
    f = add_app_pair(c, a->sv->name->text, a->sv->name, ".sv");
    emit_c_state_vector(&c->s->arena, a->sv, &f.o, f.header, f.code);
    for (size_t i = 0; i < a->machine.n; i++)
        if (!a->machine.at[i]->bytecode) {
            const Program *p = a->machine.at[i]->program;
            f = add_app_pair(c, p->name->text, p->stem, ".sm");
            session_emit_c(c->s, session_ir(c->s, p, c->o->opt_level), &f.o, f.header, f.code);
        }
    if (a->pins) {
        f = add_app_pair(c, format_in(&c->s->arena, "%s_io", a->io_name->text), a->io_name, ".io");
        emit_c_io(&c->s->arena, a->pins, &f.o, f.header, f.code);
    }
    if (a->net) {
        f = add_app_pair(c, format_in(&c->s->arena, "%s_net", a->net_name->text), a->net_name, ".net");
        emit_c_net(&c->s->arena, a->net, &f.o, f.header, f.code);
    }
}
