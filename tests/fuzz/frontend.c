// SPDX-License-Identifier: Apache-2.0
// Fuzz target: passes source text through lexer, parser, checker and renderers.  The first byte selects the kind of the rest: `v` a state
// vector, `s` a script (of the machine below), `p` pins, `a` an application (of the files below), any other byte a machine.  Nothing may crash
// or hang.  Every position of a diagnostic must be in the source.  A tree without an error must contain no error node and must not exceed its
// depth.
#include <string.h>

#include "compiler/emit/c/emit_app.h"
#include "compiler/compile.h"
#include "compiler/syntax/parse.h"
#include "tests/fuzz/fuzz.h"

enum { MEMORY_MOST = 512 << 20 };

static const char tested[] = "[state_vector]\nU64 G\nU32 S\nF64 x\nbool b\n[local]\nF64 k = 2 @read_only\n"
                             "[Idle]\n.step\n    x > 1: -> Run\n[Run]\n.entry\n    b = roll_max(x, 3) > k\n";

static size_t memory_taken;

// A host with little memory.  An input that needs more ends without a result, which is not a fault.
static void *small_heap(void *context, void *old, size_t size)
{
    if (size > MEMORY_MOST - memory_taken)
        return NULL;
    memory_taken += size;
    return heap_alloc(context, old, size);
}

// ---- what must hold of a tree ----

static bool errors_allowed;

static void check_span(Span span)
{
    FUZZ_CHECK(!span.src || (span.at <= span.src->len && span.len <= span.src->len - span.at));
}

static void check_expr(const AstExpr *e, unsigned depth)
{
    FUZZ_CHECK(e && depth <= AST_DEPTH_MAX && e->depth + depth <= AST_DEPTH_MAX + 1);
    FUZZ_CHECK(errors_allowed || e->kind != AST_ERROR);
    check_span(e->span);
    check_span(ast_op_span(e));
    if (e->kind == AST_NAME || e->kind == AST_CALL)
        FUZZ_CHECK(e->name);
    if (e->kind == AST_UNARY || e->kind == AST_BINARY || e->kind == AST_PAREN)
        check_expr(e->a, depth + 1);
    if (e->kind == AST_BINARY)
        check_expr(e->b, depth + 1);
    for (size_t i = 0; e->args && i < e->args->n; i++)
        check_expr(e->args->at[i], depth + 1);
}

static void check_stmts(const AstStmts *list, unsigned depth)
{
    FUZZ_CHECK(list->n == 0 || depth <= AST_DEPTH_MAX);
    for (size_t i = 0; i < list->n; i++) {
        const AstStmt *s = list->at[i];
        FUZZ_CHECK(errors_allowed || s->kind != AST_STMT_ERROR);
        check_span(s->span);
        if (s->kind == AST_STMT_ERROR)
            continue;
        FUZZ_CHECK((s->kind == AST_ASSIGN || s->kind == AST_TRANSITION) == (s->name != NULL));
        if (s->kind == AST_ASSIGN || s->kind == AST_IF || s->kind == AST_ASSERT)
            check_expr(s->value, 1);
        if (!s->arms)
            continue;
        check_span(s->arms->body_span);
        check_span(s->arms->else_body_span);
        check_stmts(&s->arms->then, depth + 1);
        check_stmts(&s->arms->otherwise, depth + 1);
    }
}

static void check_tree(const AstFile *f)
{
    for (size_t i = 0; i < f->sections.n; i++) {
        const AstSection *s = f->sections.at[i];
        FUZZ_CHECK(s->name && (errors_allowed || s->kind != AST_IGNORED));
        check_span(s->header);
        check_span(s->name_span);
        for (size_t k = 0; k < s->decls.n; k++) {
            FUZZ_CHECK(s->decls.at[k].name);
            if (s->decls.at[k].value)
                check_expr(s->decls.at[k].value, 1);
            else
                FUZZ_CHECK(errors_allowed || s->kind != AST_LOCAL);
        }
        for (int k = 0; k < AST_LABEL_COUNT; k++)
            check_stmts(&s->block[k].stmts, 0);
        check_stmts(&s->items, 0);
    }
}

// ---- what must hold of diagnostics ----

static void check_diags(Session *s)
{
    const PlainMessages none = {NULL, 0, 0};
    DiagStyle plain = {false, 20};
    Buf out;

    diags_sort(&s->diags);
    for (size_t i = 0; i < s->diags.list.n; i++) {
        const Diag *d = s->diags.list.at[i];
        check_span(d->span);
        FUZZ_CHECK(d->text && d->text[0]);
        for (size_t k = 0; k < d->notes.n; k++)
            check_span(d->notes.at[k].span);
        for (size_t k = 0; k < d->edits.n; k++)
            check_span(d->edits.at[k].span);
    }
    buf_init(&out, &s->arena);
    diags_render_text(&s->diags, &plain, &out);
    FUZZ_CHECK(strlen(buf_text(&out)) == out.n);              // the text contains no NUL
    diags_render_json(&s->diags, &out);
    diags_render_sarif(&s->diags, &none, "1", &out);
    FUZZ_CHECK(strlen(buf_text(&out)) == out.n);
}

// ---- one text ----

static void try_parse(Session *s, const Source *src, FileKind kind)
{
    AstFile *f = parse_file(&s->arena, &s->strings, &s->diags, src, kind);
    Buf out;

    errors_allowed = s->diags.errors > 0;
    check_tree(f);
    check_diags(s);
    buf_init(&out, &s->arena);
    diags_apply_edits(&s->diags, src, &out);
    parse_file(&s->arena, &s->strings, &s->diags, source_new(&s->arena, "fixed", buf_text(&out), out.n), kind);
    ast_print(f, &out);
    lex_print(&s->strings, &s->diags, src, kind, &out);
}

// The state vector to which pins are connected.
static const char wired[] = "[R]\nF64 x\nbool b\nU8 i\nF32 o\n";

// Returns the content of a file that an application names: one of these, whatever its name is.
static const char *file_text(FileKind kind)
{
    static const char vector[] = "[options]\nlock\n[A]\nU64 time\nU32 state\nF64 x\nbool b\nU8 mode\nU32 late\n";
    static const char machine[] = "[state_vector]\nU64 time @alias G\nU32 state @alias S\nF64 x\n[Idle]\n.step\n    T > 5: -> Run\n"
                                  "[Run]\n.step\n    x = roll_avg(x, 5)\n";

    return kind == FILE_SV ? vector : kind == FILE_SM ? machine : kind == FILE_NET ? "send a every 1 s to 10.0.0.2:1 { x }\nreceive b on 2 { b }\n"
                                     : "[analog]\ni 0 x\n[digital]\no 0 b @safe true\n";
}

static void emit_app(Session *s, const App *a)
{
    const Buf **image = ARENA_ARRAY(&s->arena, const Buf *, a->machine.n);
    ImageOptions o = {true, NULL};
    Buf header, code;

    buf_init(&header, &s->arena);
    buf_init(&code, &s->arena);
    for (size_t i = 0; i < a->machine.n; i++)
        if (a->machine.at[i]->bytecode) {
            IrMachine *m = session_ir(s, a->machine.at[i]->program, 2);
            Buf *bytes = ARENA_NEW(&s->arena, Buf);
            buf_init(bytes, &s->arena);
            FUZZ_CHECK(session_image(s, &m, 1, &o, bytes));
            image[i] = bytes;
        }
    emit_c_app(&s->arena, a, image, &header, &code);
    FUZZ_CHECK(strlen(buf_text(&header)) == header.n && strlen(buf_text(&code)) == code.n);
}

static void try_app(Session *s, const Source *src)
{
    AstFile *tree = parse_file(&s->arena, &s->strings, &s->diags, src, FILE_APP);
    AppFiles files;
    App *a;

    app_list_files(&s->arena, tree, &files);
    for (size_t i = 0; i < files.n; i++) {
        const char *text = file_text(files.at[i].kind);
        if (!files.at[i].wrong_kind)
            files.at[i].src = source_new(&s->arena, files.at[i].name.text->text, text, strlen(text));
    }
    a = session_app(s, tree, &files);
    FUZZ_CHECK((a != NULL) == (s->diags.errors == 0));
    if (a)
        emit_app(s, a);
}

static void try_net(Session *s, const Source *src)
{
    const Network *net = session_net(s, src, source_new(&s->arena, "wired.sv", wired, sizeof wired - 1));
    Buf header, code;

    FUZZ_CHECK((net != NULL) == (s->diags.errors == 0));
    if (!net)
        return;
    buf_init(&header, &s->arena);
    buf_init(&code, &s->arena);
    emit_c_net(&s->arena, net, NULL, &header, &code);
    FUZZ_CHECK(strlen(buf_text(&header)) == header.n && strlen(buf_text(&code)) == code.n);
}

// Parses requirements of the machine that scripts test, and runs a monitor on them.
static void try_requirements(Session *s, const Source *src)
{
    const MachineInput machine = {.sm = source_new(&s->arena, "tested.sm", tested, sizeof tested - 1)};
    const Program *p = session_program(s, &machine);
    const Requirements *r = session_requirements(s, &src, 1, p);
    uint64_t *cell = ARENA_ARRAY(&s->arena, uint64_t, p->var.n);
    Monitor *m;
    void *situation;

    FUZZ_CHECK((r != NULL) == (s->diags.errors == 0));
    if (!r)
        return;
    m = monitor_new(&s->arena, r, 10);
    situation = arena_alloc(&s->arena, m->size);
    monitor_start(m, situation);
    for (int i = 0; i < 3; i++, cell[p->g->index] += 10)
        monitor_step(m, situation, cell);
}

unsigned long fuzz_reached;           // texts without a mistake
const unsigned fuzz_floor = 2;

static void try_check(Session *s, const Source *src, FileKind kind)
{
    MachineInput machine = {.sm = src};

    if (kind == FILE_SV) {
        session_state_vector(s, src);
    } else if (kind == FILE_APP) {
        try_app(s, src);
    } else if (kind == FILE_SM) {
        session_program(s, &machine);
    } else if (kind == FILE_NET) {
        try_net(s, src);
    } else if (kind == FILE_RQ) {
        try_requirements(s, src);
    } else if (kind == FILE_IO) {
        session_io(s, src, source_new(&s->arena, "wired.sv", wired, sizeof wired - 1));
    } else {
        machine.sm = source_new(&s->arena, "tested.sm", tested, sizeof tested - 1);
        session_script(s, src, session_program(s, &machine));
    }
    fuzz_reached += s->diags.errors == 0;
    check_diags(s);
}

static FileKind kind_of(char letter)
{
    switch (letter) {
    case 'v': return FILE_SV;
    case 's': return FILE_SS;
    case 'p': return FILE_IO;
    case 'a': return FILE_APP;
    case 'n': return FILE_NET;
    case 'r': return FILE_RQ;
    }
    return FILE_SM;
}

static void run(const uint8_t *data, size_t size, void (*try)(Session *s, const Source *src, FileKind kind))
{
    FileKind kind = size ? kind_of((char)data[0]) : FILE_SM;
    Session s;
    jmp_buf oom;
    char *text;

    memory_taken = 0;
    session_init(&s, small_heap, NULL, &oom);
    if (setjmp(oom) == 0) {
        text = arena_alloc(&s.arena, size + 1);
        if (size)
            memcpy(text, data + 1, size - 1);
        try(&s, source_new(&s.arena, "fuzz", text, size ? size - 1 : 0), kind);
    }
    session_free(&s);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    run(data, size, try_parse);
    run(data, size, try_check);
    return 0;
}
