// SPDX-License-Identifier: Apache-2.0
// Tokens: longest match, numbers, line ends, comments, operators of other languages, and files that are not programs.
#include <string.h>

#include "compiler/syntax/lex.h"
#include "compiler/syntax/parse.h"
#include "tests/test.h"
#include "tests/unit/host.h"

static Arena arena;
static StrPool strings;
static Diags diags;

static const Source *start(const char *text, size_t len)
{
    HOST_ARENA(&arena);
    str_pool_init(&strings, &arena);
    diags_init(&diags, &arena);
    return source_new(&arena, "a.sm", text, len);
}

// Returns the tokens as "kind kind kind", with a | before each token that begins a line.
static const char *token_kinds(const char *text, size_t len)
{
    const Source *src = start(text, len);
    Lexer l;
    Token t;
    Buf out;

    buf_init(&out, &arena);
    lex_init(&l, &strings, &diags, src);
    for (lex_next(&l, &t); t.kind != TOK_END; lex_next(&l, &t))
        buf_printf(&out, "%s%s%s", out.n ? " " : "", t.first ? "|" : "", lex_token_name(t.kind));
    lex_next(&l, &t);
    CHECK(t.kind == TOK_END && l.at == len);
    return buf_text(&out);
}

static void tokens(const char *text, const char *expected, size_t errors)
{
    const char *found = token_kinds(text, strlen(text));

    if (strcmp(found, expected) != 0 || diags.errors != errors)
        fprintf(stderr, "%s\n  found    %s, %lu errors\n  expected %s\n", text, found, (unsigned long)diags.errors, expected);
    CHECK(strcmp(found, expected) == 0);
    CHECK(diags.errors == errors);
    arena_free(&arena);
}

static void test_words(void)
{
    tokens("", "", 0);
    tokens("orbit note if0 _ _1 iff", "|name name name name name name", 0);
    tokens("or not if else and true false", "|or not if else and true false", 0);
    tokens("I8 U64 F32 bool Bool f64", "|type type type type name name", 0);
    tokens("a-b -> c->d", "|name - name -> name -> name", 0);
    tokens("a<=b>=c==d!=e<f>g", "|name <= name >= name == name != name < name > name", 0);
    tokens("!a!=b", "|! name != name", 0);
    tokens("x=-5--3", "|name = - number - - number", 0);
    tokens("{(:,)}", "|{ ( : , ) }", 0);
}

static void test_numbers(void)
{
    tokens("5 007.5 .5 5. 1e3 2.5E-3 0x1F 1_000 0 1e+05", "|number number number number number number number number number number", 0);
    tokens("5.e3 1_0.0_1e1_0 0xA_b", "|number number number", 0);
    tokens("1-2 1e3-2 1e-3", "|number - number number - number number", 0);
    tokens("5x 0x1G 0x 1e 1_ 1__0 1_.5 1._5 1.2.3 0x1F.8 0b1 1e5x 5.entry 0x_1",
           "|error error error error error error error error error error error error error error", 14);
    tokens("1e308 1e309 1e-999", "|number number number", 1);
    tokens("5..entry", "|number label", 0);
}

static void test_lines(void)
{
    tokens("a\nb\r\nc # d\n\n  # e\n\te", "|name |name |name |name", 0);
    tokens("a # no end", "|name", 0);
    tokens("[Idle] .step x", "|header label name", 0);
    tokens("[a/b1][c]\n[d]", "|header header |header", 0);
    tokens("@read_only@alias G", "|annotation annotation name", 0);
    tokens("\xef\xbb\xbf[a]", "|header", 0);
    tokens(" \xef\xbb\xbf[a]", "|header", 1);
}

static void test_hints(void)
{
    tokens("a && b || c & d | e", "|name and name or name and name or name", 4);
    tokens("a === b !== c <> d => e =< f := g", "|name == name != name != name >= name <= name = name", 6);
    tokens("a: => b\n=> c", "|name : -> name |-> name", 2);
    tokens("a ** b % c ^ d", "|name * name / name * name", 3);
    tokens("a; b;\nc", "|name |name |name", 2);
    tokens("a // b\nc /* d\ne */ f /* g", "|name |name |name", 3);
    tokens("x = \"a b\" + 'c", "|name = error + error", 1);
    tokens("x \xe2\x89\xa4 y \xe2\x88\x92 z\xc2\xa0w", "|name <= name - name name", 3);
    tokens("dr\xc3\xbc" "ck \xc3\xa4", "|name name", 1);
    tokens("a $ b \\ c", "|name name name", 1);
    tokens("f(a; b);c\na ? b : c # d\n{ a ? b }", "|name ( name , name ) |name |name |{ name }", 4);
    tokens("@ . a", "|error error name", 2);
    tokens("[a b] [ c ] [] [d", "|header header header header", 4);
}

static void test_characters(void)
{
    CHECK(strcmp(token_kinds("a\0b", 3), "|name name") == 0 && diags.errors == 1);
    arena_free(&arena);
    tokens("a\rb\nc\x7f#\x01\n", "|name name |name", 2);
    tokens("# \xff\n# \xc3\xa9\n# \xed\xa0\x80\n", "", 2);
    tokens("\xff\xfe" "a", "", 1);
    CHECK(strcmp(token_kinds("\177ELF\2\1\1\0\0\0\0\0\0\0\0\0\3\0>\0", 20), "") == 0 && diags.errors == 1);
    arena_free(&arena);
}

static void test_print(void)
{
    static const char text[] = "[Idle]\n  x = 0x1F # hi\n";
    const Source *src = start(text, sizeof text - 1);
    Buf out;

    buf_init(&out, &arena);
    lex_print(&strings, &diags, src, FILE_SM, &out);
    CHECK(strcmp(buf_text(&out), "1:1\theader\t[Idle]\n2:3\tname\tx\n2:5\t=\t=\n2:7\tnumber\t0x1F\n2:12\tcomment\t# hi\n"
                                 "3:1\tend\t\n") == 0);
    arena_free(&arena);
}

int main(void)
{
    test_words();
    test_numbers();
    test_lines();
    test_hints();
    test_characters();
    test_print();
    return test_end("lex");
}
