// SPDX-License-Identifier: Apache-2.0
#include "tests/check/fixes_meaning.h"

#include <string.h>

#include "compiler/base/buf.h"
#include "compiler/script/engine.h"
#include "compiler/script/ref.h"
#include "compiler/syntax/lex.h"
#include "tests/unit/random.h"

// ---- statements of a text ----

typedef struct Found { const char *key; unsigned conditions; uint32_t line; } Found;
typedef VEC(Found) FoundList;

enum { NESTING = 64 };

typedef struct Scan {
    Arena *arena;
    const Source *src;
    Token *t;                 // all tokens, of which the last is END
    size_t n;
    bool inside;              // the current line is in a state or in a section of a script
    unsigned open[NESTING], braces;           // by brace: the conditions around its content
    unsigned colons;          // colons before this position on its line
    unsigned parens;          // open parentheses
    unsigned around;          // conditions around the content of the innermost braces
    uint32_t hanging[NESTING];                // columns of the lines that end with a colon
    unsigned hangings;
} Scan;

static LineCol place(const Scan *s, size_t i) { return source_position(s->src, s->t[i].at); }

static void read_tokens(Scan *s, Source *src)
{
    VEC(Token) all = {NULL, 0, 0};
    StrPool strings;
    Diags diags;
    Lexer lexer;
    Token t;

    str_pool_init(&strings, s->arena);
    diags_init(&diags, s->arena);
    diags.muted = true;
    lex_init(&lexer, &strings, &diags, src);
    do {
        lex_next(&lexer, &t);
        vec_push(s->arena, &all, t);
    } while (t.kind != TOK_END);
    s->src = src;
    s->t = all.at;
    s->n = all.n;
}

// Whether the = at i + 1 belongs to a condition: x = 5: …, x = 5 { …
static bool is_condition(const Scan *s, size_t i)
{
    const uint32_t line = place(s, i).line;

    for (size_t k = i + 2; k < s->n && place(s, k).line == line && s->t[k].kind != TOK_ARROW; k++) {
        if (s->t[k].kind == TOK_COLON || s->t[k].kind == TOK_LBRACE)
            return true;
        if (s->t[k].kind == TOK_ASSIGN)
            return false;
    }
    return false;
}

static bool is_assignment(const Scan *s, size_t i)
{
    return s->t[i].kind == TOK_NAME && s->t[i + 1].kind == TOK_ASSIGN && (i == 0 || s->t[i - 1].kind != TOK_TYPE) && !is_condition(s, i);
}

// Begins a line.  Lines with deeper indentation belong to the colon that ended an earlier line.
static void begin_line(Scan *s, size_t i)
{
    const uint32_t column = place(s, i).col;

    s->colons = s->parens = 0;
    while (s->hangings > 0 && column <= s->hanging[s->hangings - 1])
        s->hangings--;
}

static void end_line_with_colon(Scan *s, size_t i)
{
    uint32_t len, column = 1;
    const char *text = source_line(s->src, place(s, i).line, &len);

    while (column <= len && (text[column - 1] == ' ' || text[column - 1] == '\t'))
        column++;
    if (s->hangings < NESTING)
        s->hanging[s->hangings++] = column;
}

static bool holds_statements(const char *section)
{
    return strcmp(section, "state_vector") != 0 && strcmp(section, "local") != 0 && strcmp(section, "options") != 0;
}

// Whether the word is a label without its point, as in `step:` on its own line.
static bool is_label_word(const Scan *s, size_t i)
{
    static const char *const labels[] = {"entry", "step", "exit"};

    for (size_t k = 0; k < 3; k++)
        if (s->t[i].kind == TOK_NAME && s->t[i].first && strcmp(s->t[i].text->text, labels[k]) == 0)
            return true;
    return false;
}

static void take(Scan *s, size_t i)
{
    switch ((int)s->t[i].kind) {
    case TOK_HEADER: case TOK_LABEL:
        s->braces = s->around = s->hangings = 0;
        s->inside = s->t[i].kind == TOK_LABEL || holds_statements(s->t[i].text->text);
        break;
    case TOK_COLON:
        if (i == 0 || s->t[i - 1].kind == TOK_LABEL || is_label_word(s, i - 1))
            break;
        s->colons++;
        if (place(s, i + 1).line != place(s, i).line)
            end_line_with_colon(s, i);
        break;
    case TOK_LPAREN:
        s->parens++;
        break;
    case TOK_RPAREN:
        s->parens -= s->parens > 0;
        break;
    case TOK_ELSE:
        s->colons = 0;
        break;
    case TOK_LBRACE:
        if (s->braces < NESTING)
            s->open[s->braces++] = s->around;
        s->around += s->colons + (i > 0 && s->t[i - 1].kind == TOK_COLON ? 0 : 1);
        s->colons = 0;
        break;
    case TOK_RBRACE:
        if (s->braces > 0)
            s->around = s->open[--s->braces];
        s->colons = 0;
        break;
    default: break;
    }
}

static FoundList find_statements(Scan *s)
{
    FoundList out = {NULL, 0, 0};

    for (size_t i = 0; i + 1 < s->n; i++) {
        const bool arrow = s->t[i].kind == TOK_ARROW, named = s->t[i + 1].kind == TOK_NAME || s->t[i + 1].kind == TOK_HEADER;
        if (i == 0 || place(s, i).line != place(s, i - 1).line)
            begin_line(s, i);
        if (s->inside && s->parens == 0 && (arrow || is_assignment(s, i))) {
            Found f = {arrow ? format_in(s->arena, "-> %s", named ? s->t[i + 1].text->text : "") : s->t[i].text->text,
                       s->around + s->colons + s->hangings, place(s, i).line};
            vec_push(s->arena, &out, f);
        }
        take(s, i);
    }
    return out;
}

// Whether two statements are the same.  "-> " is a transition whose target has no name.
static bool same_statement(const Found *was, const Found *is)
{
    return strcmp(was->key, is->key) == 0 || (strcmp(was->key, "-> ") == 0 && strncmp(is->key, "-> ", 3) == 0);
}

const char *statements_lost(Arena *arena, const Source *was, const Source *is, size_t *n)
{
    Scan before = {.arena = arena}, after = {.arena = arena};
    FoundList a, b;
    size_t k = 0;

    read_tokens(&before, (Source *)was);
    read_tokens(&after, (Source *)is);
    a = find_statements(&before);
    b = find_statements(&after);
    for (size_t i = 0; i < a.n; i++, k++) {
        while (k < b.n && !same_statement(&a.at[i], &b.at[k]))
            k++;
        if (k == b.n)
            return format_in(arena, "loses '%s' of line %lu", a.at[i].key, (unsigned long)a.at[i].line);
        if (b.at[k].conditions < a.at[i].conditions)
            return format_in(arena, "takes a condition from '%s' of line %lu", a.at[i].key, (unsigned long)a.at[i].line);
        ++*n;
    }
    return NULL;
}

// ---- behaviour ----

enum { RUNS = 6, STEPS = 200, NUMBERS_MAX = 200 };

// Collects the numbers of the machine, so that inputs can make its guards true.
static size_t numbers_of(Arena *arena, const Source *src, double *out)
{
    Scan s = {.arena = arena};
    size_t n = 0;

    read_tokens(&s, (Source *)src);
    for (size_t i = 0; i < s.n && n < NUMBERS_MAX; i++)
        if (s.t[i].kind == TOK_NUMBER)
            memcpy(&out[n++], &s.t[i].number, sizeof *out);
    return n;
}

static double random_input(const double *numbers, size_t n)
{
    static const double near[] = {0, 0, 1, -1, 0.5, -0.5};
    const uint64_t r = random_u64();
    double x;

    switch (r % 8) {
    case 0: return 0;
    case 1: return 1;
    case 2: return (double)(r >> 8 & 0xfff) - 1000;
    case 3: x = 0; memcpy(&x, &(uint64_t){random_f64_bits()}, sizeof x); return x;
    default: return n ? numbers[(r >> 8) % n] + near[(r >> 40) % 6] : (double)(r >> 50);
    }
}

static const Var *same_variable(const Program *p, const Var *v)
{
    for (size_t i = 0; i < p->var.n; i++)
        if (strcmp(p->var.at[i]->name->text, v->name->text) == 0)
            return p->var.at[i];
    return NULL;
}

typedef struct Pair {
    Arena *arena;
    const Program *p, *q;
    Engine *a, *b;
    EngineStep of_a, of_b;
    const uint32_t *twin;     // by element of p: its index in q
    double number[NUMBERS_MAX];
    size_t numbers;
} Pair;

static const char *difference(const Pair *t)
{
    if (t->of_a.status != t->of_b.status || t->of_a.next_state != t->of_b.next_state)
        return "another state";
    for (size_t i = 0; i < t->p->var.n; i++)
        if (t->p->var.at[i]->kind == VAR_ELEMENT && t->of_a.cell[i] != t->of_b.cell[t->twin[i]])
            return format_in(t->arena, "another '%s'", t->p->var.at[i]->name->text);
    return NULL;
}

// Writes random values to some elements, as external code would; time advances.
static uint32_t random_writes(const Pair *t, uint64_t g, EngineWrite *of_a, EngineWrite *of_b)
{
    uint32_t n = 0;

    for (uint32_t i = 0; i < t->p->var.n; i++) {
        const Var *v = t->p->var.at[i];
        if (v->kind != VAR_ELEMENT || v == t->p->s || (v != t->p->g && random_u64() % 3 != 0))
            continue;
        of_a[n].var = i;
        of_b[n].var = t->twin[i];
        of_a[n].cell = v == t->p->g ? g : ref_convert(v->type, random_input(t->number, t->numbers));
        of_b[n].cell = of_a[n].cell;
        n++;
    }
    return n;
}

static const char *run_pair(Pair *t, uint32_t state, size_t *steps)
{
    EngineWrite *of_a = ARENA_ARRAY(t->arena, EngineWrite, t->p->var.n), *of_b = ARENA_ARRAY(t->arena, EngineWrite, t->p->var.n);
    uint64_t g = 0;
    const char *why;

    t->a->init(t->a, state, &t->of_a);
    t->b->init(t->b, state, &t->of_b);
    for (int i = 0; i < STEPS; i++) {
        const uint32_t n = random_writes(t, g, of_a, of_b);
        t->a->step(t->a, of_a, n, &t->of_a);
        t->b->step(t->b, of_b, n, &t->of_b);
        if ((why = difference(t)) != NULL)
            return format_in(t->arena, "changes what the machine does: in step %d %s", i + 1, why);
        g += random_u64() % 4 ? 10 : random_u64() % 3000;
        ++*steps;
    }
    return NULL;
}

const char *behaviour_changed(Arena *arena, const Program *was, const Program *is, size_t *n)
{
    uint32_t *twin = ARENA_ARRAY(arena, uint32_t, was->var.n);
    Pair t = {.arena = arena, .p = was, .q = is, .twin = twin};
    const char *why = NULL;

    if (was->state.n != is->state.n)
        return "changes the number of states";
    for (size_t i = 0; i < was->var.n; i++) {
        const Var *v = same_variable(is, was->var.at[i]);
        if (!v && was->var.at[i]->kind == VAR_ELEMENT)
            return "loses an element";
        twin[i] = v ? v->index : 0;
    }
    t.a = engine_ref_open(arena, was);
    t.b = engine_ref_open(arena, is);
    engine_step_init(&t.of_a, arena, was);
    engine_step_init(&t.of_b, arena, is);
    t.numbers = numbers_of(arena, was->src, t.number);
    for (uint32_t state = 1; state <= was->state.n && !why; state++)
        for (int run = 0; run < RUNS && !why; run++)
            why = run_pair(&t, state, n);
    t.a->close(t.a);
    t.b->close(t.b);
    return why;
}
