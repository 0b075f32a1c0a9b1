// SPDX-License-Identifier: Apache-2.0
// The parser: trees of correct sources, one message for each mistake, edits that fix it, sizes and depths.
#include <string.h>
#include <time.h>

#include "compiler/syntax/parse.h"
#include "tests/test.h"
#include "tests/unit/host.h"

static Arena arena;
static Diags diags;
static const Source *src;

static AstFile *parse(const char *text, size_t len, FileKind kind)
{
    StrPool strings;

    HOST_ARENA(&arena);
    str_pool_init(&strings, &arena);
    diags_init(&diags, &arena);
    src = source_new(&arena, "a.sm", text, len);
    return parse_file(&arena, &strings, &diags, src, kind);
}

static void show(void)
{
    DiagStyle style = {false, 0};
    Buf out;

    diags_sort(&diags);
    buf_init(&out, &arena);
    diags_render_text(&diags, &style, &out);
    fputs(buf_text(&out), stderr);
}

// ---- correct sources ----

static void tree(FileKind kind, const char *text, const char *expected)
{
    AstFile *f = parse(text, strlen(text), kind);
    Buf out;

    buf_init(&out, &arena);
    ast_print(f, &out);
    if (diags.errors || strcmp(buf_text(&out), expected) != 0) {
        fprintf(stderr, "---- found\n%s---- expected\n%s", buf_text(&out), expected);
        show();
    }
    CHECK(diags.errors == 0 && strcmp(buf_text(&out), expected) == 0);
    arena_free(&arena);
}

static void test_expressions(void)
{
    static const struct { const char *text, *tree; } cases[] = {
        {"-a * b", "((- a) * b)"}, {"not a and b", "((not a) and b)"}, {"a or b and c", "(a or (b and c))"},
        {"10 - 4 - 3", "((10 - 4) - 3)"}, {"a + b * c / d", "(a + ((b * c) / d))"}, {"a < b == c", "((a < b) == c)"},
        {"a == b and c != d", "((a == b) and (c != d))"}, {"500 < p <= 825 > q", "(((500 < p) <= 825) > q)"},
        {"(3 < 5) < 4", "((paren (3 < 5)) < 4)"}, {"not a == b", "((not a) == b)"}, {"- -a", "(- (- a))"}, {"--a", "(- (- a))"},
        {"x -1", "(x - 1)"}, {"x-1", "(x - 1)"}, {"!(a)", "(not (paren a))"}, {"+a", "(+ a)"}, {"a ++b", "(a + (+ b))"},
        {"max(a, f(), (b))", "max(a, f(), (paren b))"}, {"(a +\n  b\n # c\n )", "(paren (a + b))"}, {"f\n", "f"},
        {"max(\na\n,\nb\n)", "max(a, b)"}, {"(f\n(a))", "(paren f(a))"}, {"a == (b == c)", "(a == (paren (b == c)))"},
        {"a == b < c", "(a == (b < c))"}, {"true or false", "(true or false)"}, {"max", "max"}, {"stop", "stop"}};
    Buf text, expected;

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        HOST_ARENA(&arena);
        buf_init(&text, &arena);
        buf_init(&expected, &arena);
        buf_printf(&text, "[A]\n.step\nx = %s\n", cases[i].text);
        buf_printf(&expected, "state A\n  .step\n    x = %s\n", cases[i].tree);
        {
            Arena keep = arena;               // parse() makes a new one
            tree(FILE_SM, buf_text(&text), buf_text(&expected));
            arena = keep;
        }
        arena_free(&arena);
    }
}

static void test_conditionals(void)
{
    tree(FILE_SM, "[A]\n.step a: x = 1\nelse: y = 2", "state A\n  .step\n    if a :\n      x = 1\n    else :\n      y = 2\n");
    tree(FILE_SM, "[A]\n.step\nif a: if b: x = 1\nelse: y = 2\n\nelse: z = 3",
         "state A\n  .step\n    if a :\n      if b :\n        x = 1\n      else :\n        y = 2\n    else :\n      z = 3\n");
    tree(FILE_SM, "[A]\n.step\na\n{\nx = 1 } else\n{ y = 2 } z = 3",
         "state A\n  .step\n    if a {}\n      x = 1\n    else {}\n      y = 2\n    z = 3\n");
    tree(FILE_SM, "[A]\n.step\na: x = 1 else if b { y = 2 } # c\nelse if c: z = 3 else { }",
         "state A\n  .step\n    if a :\n      x = 1\n    else :\n      if b {}\n        y = 2\n      else :\n"
         "        if c :\n          z = 3\n        else {}\n");
    tree(FILE_SM, "[A]\n.step\nwhen: while = 1\nstep = entry\nend { }\n",
         "state A\n  .step\n    if when :\n      while = 1\n    step = entry\n    if end {}\n");
}

static void test_sections(void)
{
    tree(FILE_SV, "[options] lock\n[A/1]\nF64\nx U8 y\n[options2] bool b",
         "options options\n  lock\nregion A/1\n  F64 x\n  U8 y\nregion options2\n  bool b\n");
    tree(FILE_SM, "[state_vector]\nU64 t @alias\nG @read_only U32\nS\n[local]\nF64\na\n=\n1 +(\n2)\n@read_only\nU8 b = a",
         "state_vector state_vector\n  U64 t @alias G @read_only\n  U32 S\nlocal local\n  F64 a = (1 + (paren 2)) @read_only\n  U8 b = a\n");
    tree(FILE_SM, "[A] .exit x = 1 .entry [B][C]", "state A\n  .entry\n  .exit\n    x = 1\nstate B\nstate C\n");
    tree(FILE_SS, "[options]\ndelta_t\n10 init_state A delta_t 0x5\n[all_states]\nG == 0 { x = 1\n@assert x > 0\n@stop }\nif a: @stop\n[A]",
         "options options\n  delta_t 10\n  init_state A\n  delta_t 0x5\nscript all_states\n  if (G == 0) {}\n    x = 1\n"
         "    @assert (x > 0)\n    @stop\n  if a :\n    @stop\nscript A\n");
}

// ---- mistakes ----

// Returns the ids of the errors in their order, "E0312 E0330".
static const char *error_ids(void)
{
    Buf out;

    diags_sort(&diags);
    buf_init(&out, &arena);
    for (size_t i = 0; i < diags.list.n; i++)
        buf_printf(&out, "%s%s", i ? " " : "", diag_info[diags.list.at[i]->code].id);
    return buf_text(&out);
}

static void wrong(FileKind kind, const char *text, const char *expected)
{
    parse(text, strlen(text), kind);
    if (strcmp(error_ids(), expected) != 0) {
        fprintf(stderr, "---- expected %s, found\n", expected);
        show();
    }
    CHECK(strcmp(error_ids(), expected) == 0);
    arena_free(&arena);
}

// Mistakes in the statements of a block: each causes one message, and the statements after it are parsed normally.
static void test_recovery(void)
{
    static const struct { const char *text, *ids; } cases[] = {
        {"x = * 2\ny = )", "E0312 E0312"}, {"if x > {\ny = 1\n}\nelse: y = 2", "E0312"}, {"if x > : y = 1\nelse: y = 2", "E0312"},
        {"if x >\n{ y = 1 }\nelse { z = 2 }", "E0312"}, {"a: x = 1 y\nelse: z = 2", "E0330"},
        {"a:\nx = 1\ny = 2\nelse:\nz = 3", "E0316 E0316"}, {"a {\nb:\n}\nc = 1", "E0316"}, {"foo bar {\nx = 1\n}\nelse { y = 2 }", "E0328"},
        {"while (a) {\nx = 1\n}\nx = 2", "E0329"}, {"switch x {\ncase 1: y = 2\n}", "E0329"}, {"(a: x = 1\ny = 2", "E0313"},
        {"x = (1 +\ny = 2\nz = 3", "E0313"}, {"x = f(1,\n-> A\ny = 2", "E0312"}, {"a { x = 1", "E0321"}, {"a { b {\nx = 1 }\n.exit y = 1", "E0321"},
        {"}\n}\nx = 1", "E0322 E0322"}, {"else: x = 1\nelse: y = 1", "E0318"}, {"else if a: x = 1\nelse: y = 1", "E0318"},
        {"{ x = 1\n}\nelse: y = 2", "E0320 E0318"}, {"-> \n-> 3\n-> A B", "E0323 E0323 E0330"}, {"x = 1 -> A", "E0330"},
        {"a b -> c", "E0328"}, {"if a b: x = 1", "E0315"}, {"F64 x = 1\ny = 2", "E0338"}, {"x.y = 1", "E0335"}, {"x[1] = 2", "E0336"},
        {"[] x = 1", "E0120"}, {"x = \"a\nb\"\ny = 1", "E0106 E0106"}, {"x = 5x\ny = 1", "E0114"}, {"if: x = 1", "E0334"},
        {"if\na: x = 1", "E0334"}, {"else\nx = 1", "E0318"}, {"a: x = 1\nelse\ny = 2", "E0319"}, {"a: else: x = 1", "E0316"},
        {"a: , x = 1", "E0341"}, {"x = a = b", "E0330"}, {"f(x) = 1", "E0325"}, {"a: b: c + 1", "E0327"}, {"a:: x = 1", "E0341"},
        {"x = a b c d", "E0330"}, {"@assert a\n@stop\n@foo", "E0339 E0339 E0340"}, {"x = 1,\ny = 2", "E0330"}, {"* x\n) = 1\n, a", "E0341 E0341 E0341"},
        {"x == 1\nx != 1: y = 2", "E0327"}, {"x = = 1", "E0312"}, {"x = 1 = 2", "E0330"}, {"(x) = 1", "E0325"}, {"a { x = 1 ) }", "E0314"},
        {"x++\ny--", "E0326 E0326"}, {"x = a +\n  b and\n  c\ny = *", "E0312 E0312"}, {"x = a +\ny = 1\nz = *", "E0312 E0312"},
        {"x = a or\nb: y = 1\nz = *", "E0312 E0312"}, {"go to B\ny = 1", "E0329"}, {"-> [B]\ny = 1", "E0323"}, {"x: = 1", "E0341"},
        {"x = f(a; b)", "E0107"}, {"T > 5 bar: x = 1", "E0330"}, {"a < 5 and > 3: x = 1", "E0312"}, {"-> A if x", "E0330"}, {"x = a ? b : c\ny = 1", "E0108"}, {"x = 'a' + 1", "E0106"}, {"if a then\nx = 1\nend", "E0329 E0329"}};
    char text[256];

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        snprintf(text, sizeof text, "[A]\n.step\n%s\n", cases[i].text);
        wrong(FILE_SM, text, cases[i].ids);
    }
}

static void test_wrong_lists(void)
{
    wrong(FILE_SM, "[state_vector]\nF64 x = 1\nfloat y\nz\nF64\nF64 if\nU8 a, b\n@read_only F64 c\n= 5\n", "E0356 E0351 E0352 E0353 E0354 E0357 E0364 E0350");
    wrong(FILE_SM, "[local]\nF64 x\nF64 y =\nF64 z = 1 2\nF64 w = @read_only\nF64 v = (1\nF64 u = 3 @foo bar @alias q\n",
          "E0355 E0312 E0330 E0312 E0313 E0360 E0362");
    wrong(FILE_SV, "[options] lock = true\n[A]\nF64 tank.p\nF64 2nd\nF64 p-2\nF64 my name\nU8 a U8 b\n", "E0374 E0335 E0114 E0330 E0330");
    wrong(FILE_SS, "[options]\ndelta_t 10ms\n[all_states]\na: @assert p > 5, \"low\"\na: x = 5x\n", "E0114 E0349 E0114");
    wrong(FILE_SV, "[A]\nF64 x @read_only\nF64 y @alias z\n.step\nx = 1\n", "E0363 E0363 E0307 E0352");
    wrong(FILE_SS, "[options]\ndelta_t = 5\ndelta_t -5\ndelta_t\ninit_state 3\nfoo bar\nlock\n5", "E0373 E0374 E0374 E0374 E0371 E0372 E0370");
    wrong(FILE_SS, "[all_states]\nx = 1\ny = 2\na: b: x = 1\na { }\na { @stop x = 1 }\n[local]\n x y z\n[B]\n.step\nx = 1\n",
          "E0380 E0384 E0330 E0351 E0386 E0380");
    wrong(FILE_SS, "[A]\na { @stop\nx = 1\ny = 1 }\nelse: x = 1\n-> A\n", "E0385 E0383");
    wrong(FILE_SM, "some text\n'quoted' && more;\n[A]\n", "E0301");
    wrong(FILE_SM, "[A\n[B c]\n[1]\n[if]\n[options]\n[all_states]\nits\n", "E0119 E0120 E0305 E0306 E0310");
}

// ---- edits ----

// Returns the text after the edits of a diagnostic.
static const char *edited(const Diag *d, const char *text)
{
    static char out[512];
    size_t at = 0;

    out[0] = '\0';
    for (size_t i = 0; i < d->edits.n; i++) {
        const DiagEdit *e = &d->edits.at[i];
        snprintf(out + strlen(out), sizeof out - strlen(out), "%.*s%s", (int)(e->span.at - at), text + at, e->text);
        at = e->span.at + e->span.len;
    }
    snprintf(out + strlen(out), sizeof out - strlen(out), "%s", text + at);
    return out;
}

// Whether one edit after the other leads to a correct source.
static void repaired(const char *before, const char *after)
{
    char text[512], expected[512];

    snprintf(text, sizeof text, "[A]\n.step\n%s\n", before);
    snprintf(expected, sizeof expected, "[A]\n.step\n%s\n", after);
    for (int rounds = 0; rounds < 20; rounds++) {
        const Diag *d = NULL;
        parse(text, strlen(text), FILE_SM);
        diags_sort(&diags);
        for (size_t i = diags.list.n; i-- > 0; )
            if (diags.list.at[i]->edits.n)
                d = diags.list.at[i];
        if (!d)
            break;
        strcpy(text, edited(d, text));
        arena_free(&arena);
    }
    if (strcmp(text, expected) != 0 || diags.errors) {
        fprintf(stderr, "repaired:\n%s", text);
        show();
    }
    CHECK(strcmp(text, expected) == 0 && diags.errors == 0);
    arena_free(&arena);
}

static void test_edits(void)
{
    repaired("a && b || !c: x = 1", "a and b or !c: x = 1");
    repaired("a||b > 2|c: x = 1", "a or b > 2 or c: x = 1");
    repaired("a === b: x := 1;", "a == b: x = 1");
    repaired("IF a THEN x = 1   // y", "if a: x = 1   # y");
    repaired("if a: x = 1\nELIF b -> A\nElse y = 1", "if a: x = 1\nelse if b: -> A\nelse: y = 1");
    repaired("a: { x = 3,14 }", "a { x = 3.14 }");
    repaired("if a = 5: => A", "if a == 5: -> A");
    repaired("a = 5: goto A", "a == 5: -> A");
    repaired("NOT a AND b: set x = 1", "not a and b: x = 1");
    repaired("x = a \xe2\x88\x92\xc2\xa0" "b\na \xe2\x89\xa5 b: x = 1", "x = a - b\na >= b: x = 1");
    repaired("x = max(a; b)\nNOT(a): go to B\n-> [B]\nx: = 1", "x = max(a, b)\nnot(a): -> B\n-> B\nx = 1");
    repaired("[ B ]\n.exit: x = 1\nentry:\nx = 2", "[B]\n.exit x = 1\n.entry\nx = 2");
}

// ---- sizes ----

static Buf big;

static void begin(const char *text)
{
    static Arena a;
    static bool open;

    if (open)
        arena_free(&a);
    open = true;
    HOST_ARENA(&a);
    buf_init(&big, &a);
    buf_str(&big, text);
}

static void repeat(size_t n, const char *text)
{
    while (n--)
        buf_str(&big, text);
}

// Parses `big`.  Returns the ids of the errors.
static const char *parse_big(void)
{
    static char out[64];
    clock_t t = clock();

    parse(big.at, big.n, FILE_SM);
    CHECK(clock() - t < 5 * CLOCKS_PER_SEC);
    snprintf(out, sizeof out, "%s", error_ids());
    arena_free(&arena);
    return out;
}

static void test_depth(void)
{
    begin("[A]\n.step\nx = ");
    repeat(1900, "(");
    repeat(1, "p");
    repeat(1900, ")");
    CHECK(strcmp(parse_big(), "") == 0);
    begin("[A]\n.step\nx = ");
    repeat(100000, "(");
    repeat(1, "p");
    repeat(100000, ")");
    repeat(1, "\ny = ");
    repeat(100000, "not ");
    repeat(1, "1\nz = 1");
    repeat(100000, " + 1");
    repeat(1, "\nz = f");
    repeat(100000, "(f");
    CHECK(strcmp(parse_big(), "E0332 E0332 E0332 E0332") == 0);
    begin("[A]\n.step\n");
    repeat(1999, "p {\n");
    repeat(1999, "}\n");
    repeat(1, "p: x = 1\n");
    repeat(1999, "else if p: x = 1\n");
    CHECK(strcmp(parse_big(), "") == 0);
    begin("[A]\n.step\n");
    repeat(100000, "p: ");
    repeat(1, "x = 1\nx = *\n");
    CHECK(strcmp(parse_big(), "E0333") == 0);
    begin("[A]\n.step\n");
    repeat(1, "p: x = 1\n");
    repeat(100000, "else if p: x = 1\n");
    CHECK(strcmp(parse_big(), "E0333") == 0);
}

static void test_size(void)
{
    begin("");
    for (int i = 0; i < 10000; i++)
        buf_printf(&big, "[S%d]\n.step\n    x = p * 2 + 1\n    x > 5: -> S1\n", i);
    CHECK(strcmp(parse_big(), "") == 0);
    begin("[A]\n.step\n");
    repeat(100000, "    x = p * 2 + 1\n");
    CHECK(strcmp(parse_big(), "") == 0);
    begin("[A]\n.step\nx = (p");
    for (int i = 0; i < 900; i++)
        repeat(1, "                                                                 \t+ (p                              ");
    repeat(901, ")");
    CHECK(strcmp(parse_big(), "") == 0);
    begin("[local]\n");
    for (int i = 0; i < 16000; i++)
        buf_printf(&big, "F64 local_%d = %d.5e-7\n", i, i);
    CHECK(strcmp(parse_big(), "") == 0);
    begin("[state_vector]\nF64 a ");
    repeat(100000, "@alias b ");
    parse(big.at, big.n, FILE_SM);
    CHECK(diags.errors == 99999);
    arena_free(&arena);
}

// ---- cut anywhere ----

// A program that is cut at any position causes messages or a tree.
static void test_cut(void)
{
    static const char text[] = "[state_vector]\nU64 t @alias G\nU32 S\n[local]\nF64 a = (1 + 2) * 3 @read_only\n[A]\n.entry\nif a > 5 {\n"
                               "x = -a\n}\nelse if roll_avg(x, 3) >= 1.5e3: -> A\nelse: { y = 1 }\n.exit x = \"s\"\n";

    for (size_t n = 0; n < sizeof text; n++)
        for (int kind = FILE_SV; kind <= FILE_SS; kind++) {
            char *copy = malloc(n + 1);
            memcpy(copy, text, n);
            copy[n] = '\0';
            CHECK(parse(copy, n, (FileKind)kind) != NULL);
            arena_free(&arena);
            free(copy);
        }
}

int main(void)
{
    test_expressions();
    test_conditionals();
    test_sections();
    test_recovery();
    test_wrong_lists();
    test_edits();
    test_depth();
    test_size();
    test_cut();
    return test_end("parse");
}
