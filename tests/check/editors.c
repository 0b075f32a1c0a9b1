// SPDX-License-Identifier: Apache-2.0
// Writes a grammar for editors to standard output: editors/smc.tmLanguage.json with the argument `textmate`, editors/vim/syntax/smc.vim with
// `vim`. The words come from the tables of the compiler; `more_words` has those that are in no table. One grammar serves all kinds of files:
// a word that is reserved in some places only is recognized by what follows it.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/ir/text.h"
#include "compiler/syntax/parser.h"
#include "compiler/syntax/time_unit.h"

typedef enum Group { CONTROL, LOGICAL, CONSTANT, OPERATOR, TYPE, BUILTIN, MARK, OPTION, UNIT, BLOCK, CONTEXT, SECTION, NET_LINE, GROUPS } Group;

static const char *const group_names[GROUPS] = {"control", "logical", "constant", "operator", "type", "builtin", "mark",
                                                "option", "unit", "block", "context", "section", "line"};

typedef struct Entry { Group group; const char *word; } Entry;

#define WORD_IF CONTROL
#define WORD_ELSE CONTROL
#define WORD_AND LOGICAL
#define WORD_OR LOGICAL
#define WORD_NOT LOGICAL
#define WORD_TRUE CONSTANT
#define WORD_FALSE CONSTANT

static const Entry table_words[] = {
#define WORD(kind, spelling) {WORD_##kind, spelling},
#define PUNCTUATOR(kind, spelling) {OPERATOR, spelling},
#include "compiler/syntax/tokens.def"
#define SM_TYPE(name, wire, spelling, c_type, bytes, kind) {TYPE, spelling},
#include "stdlib/types.def"
#undef SM_TYPE
#define SM_PURE(name, arguments, usage, units, sentence) {BUILTIN, #name},
#define SM_COMPOSED(name, arguments, usage, units, steps, sentence) {BUILTIN, #name},
#define SM_LIST(name, units, sentence) {BUILTIN, #name},
#define SM_SAMPLED(name, arguments, usage, sentence) {BUILTIN, #name},
#define SM_ROLL(name, stat, sentence) {BUILTIN, #name},
#include "stdlib/builtins.def"
#define ANNOTATION(name, spelling, takes, where) {MARK, spelling},
#include "compiler/syntax/annotations.def"
#undef ANNOTATION
#define APP_ANNOTATION(name, takes, executor, task, machine, outputs, service, example) {MARK, #name},
#define APP_OPTION(name, element, file, amount, example) {OPTION, #name},
#define APP_TASK(word, named, file, option, example) {OPTION, #word},
#define APP_UNIT(spelling, of, factor) {UNIT, spelling},
#include "compiler/syntax/app.def"
#define NET_ANNOTATION(name, takes, send, receive, part, example) {MARK, #name},
#include "compiler/syntax/net.def"
#define OPTION(name, takes, sv, sm, ss) {OPTION, #name},
#include "compiler/syntax/section_options.def"
#undef OPTION
#define DATA_WORD(word, slot, takes, words) {OPTION, #word},
#include "compiler/syntax/data_words.def"
#undef DATA_WORD
};

// Words that the parser compares with, in no table. editors.sh checks that the compiler still has each.
static const Entry more_words[] = {
    {SECTION, "state_vector"}, {SECTION, "local"}, {SECTION, "options"}, {SECTION, "define"}, {SECTION, "all_states"},
    {SECTION, "data"}, {SECTION, "analog"}, {SECTION, "digital"}, {SECTION, "start"},
    {MARK, "assert"}, {MARK, "stop"}, {MARK, "fail"}, {MARK, "expect"}, {MARK, "print"}, {MARK, "compare"},
    {OPTION, "include"}, {BUILTIN, "random"}, {BUILTIN, "noise"},
    {NET_LINE, "endpoint"}, {NET_LINE, "send"}, {NET_LINE, "receive"},
    {CONTEXT, "to"}, {CONTEXT, "on"}, {CONTEXT, "tcp"}, {CONTEXT, "udp"}, {CONTEXT, "tolerance"}, {CONTEXT, "delay"},
    {CONTEXT, "always"}, {CONTEXT, "never"}, {CONTEXT, "before"}, {CONTEXT, "without"}, {CONTEXT, "leads"}, {CONTEXT, "within"},
    {CONTEXT, "implies"}, {UNIT, "steps"}};

enum { TABLE_WORDS = sizeof table_words / sizeof *table_words, MORE_WORDS = sizeof more_words / sizeof *more_words };

static Entry words[TABLE_WORDS + MORE_WORDS + BLOCK_COUNT + AST_WHENS + TIME_UNITS];
static size_t word_count;

static void add_word(Group group, const char *word)
{
    for (size_t i = 0; i < word_count; i++)
        if (words[i].group == group && strcmp(words[i].word, word) == 0)
            return;
    words[word_count++] = (Entry){group, word};
}

static void collect_words(void)
{
    for (size_t i = 0; i < TABLE_WORDS; i++)
        add_word(table_words[i].group, table_words[i].word);
    for (size_t i = 0; i < MORE_WORDS; i++)
        add_word(more_words[i].group, more_words[i].word);
    for (int i = 0; i < BLOCK_COUNT; i++)
        add_word(BLOCK, ir_block_name[i]);
    for (int i = 0; i < AST_WHENS; i++)
        add_word(CONTEXT, parser_when_words[i]);
    for (TimeUnit u = TIME_US; u < TIME_UNITS; u++)
        add_word(UNIT, time_unit_name(u));
}

// ---- the rules ----

// A regular expression of the subset that TextMate and Python share, with {group} for the words of a group. Its groups are (?: ), (?= ), (?! )
// and (?<! ) only, because as_vim translates it.
typedef struct Part { const char *pattern, *scope, *vim, *link; } Part;

enum { PARTS = 3 };

// What is highlighted: a part, which can follow `before`, then the others as far as they match, with white space between them. Of the rules that
// match at one position, the first is used.
typedef struct Rule { const char *before; Part parts[PARTS]; } Rule;

#define NAME "[A-Za-z_][A-Za-z0-9_]*\\b"
#define STATE(vim) {NAME "(?!\\s*[(.])", "entity.name.type.state", vim, "Identifier"}
#define AT_LINE "^\\s*"
// What follows a name on its line in no statement of a machine.
#define NO_STATEMENT "(?!\\s+(?:{control}|{logical})\\b)(?=\\s*(?:$|#|\"|@|[A-Za-z0-9_]))"

static const Rule rules[] = {
    {"", {{"#.*", "comment.line.number-sign", "Comment", "Comment"}}},
    {"", {{"\"[^\"]*\"", "string.quoted.double", "String", "String"}}},
    {"", {{"\\[(?=\\s*(?:{section})\\s*\\])", "punctuation.section", "SectionBegin", "Delimiter"},
          {"(?:{section})\\b", "keyword.control.section", "Section", "Structure"}, {"\\]", "punctuation.section", "SectionEnd", "Delimiter"}}},
    {"", {{"\\[(?=\\s*[A-Za-z0-9_/.]+\\s*\\])", "punctuation.section", "HeaderBegin", "Delimiter"},
          {"[A-Za-z0-9_/.]+", "entity.name.type.state", "Header", "Identifier"}, {"\\]", "punctuation.section", "HeaderEnd", "Delimiter"}}},
    {AT_LINE, {{"\\.(?:{block})\\b", "keyword.control.block", "Block", "Label"}}},
    {"", {{"->", "keyword.operator.transition", "Transition", "Statement"}, STATE("TransitionState")}},
    {"", {{"\\bS(?=\\s*[!=]=)", "variable.language", "CompareVariable", "Special"}, {"[!=]=", "keyword.operator", "CompareOperator", "Operator"},
          STATE("ComparedState")}},
    {"", {{"@unit\\b", "storage.modifier.mark", "MarkUnit", "PreProc"}, {"[^\\s#@,()\"]+", "keyword.other.unit", "MarkedUnit", "Type"}}},
    {"", {{"@req\\b", "storage.modifier.mark", "MarkRequirement", "PreProc"}, {NAME, "constant.other.requirement", "MarkedRequirement", "Tag"}}},
    {"", {{"@(?:state|except)\\b", "storage.modifier.mark", "MarkState", "PreProc"}, STATE("MarkedState")}},
    {"", {{"\\bstate(?=\\s+[A-Za-z_])(?!\\s+(?:{control}|{logical})\\b)", "keyword.other.context", "StateOf", "Keyword"}, STATE("NamedState")}},
    {AT_LINE, {{"init_state\\b(?=\\s+[A-Za-z_])", "keyword.other.option", "InitState", "Keyword"}, STATE("FirstState")}},
    {"", {{"@allow\\b", "storage.modifier.mark", "MarkAllow", "PreProc"}, {"\\(", "punctuation", "AllowBegin", "Delimiter"},
          {"[a-z][a-z0-9-]*", "constant.other.warning", "Warning", "Constant"}}},
    {"", {{"@(?:{mark})\\b", "storage.modifier.mark", "Mark", "PreProc"}}},
    {AT_LINE, {{"(?:{line})\\b(?=\\s+[A-Za-z_])", "keyword.other.line", "Line", "Keyword"}, {NAME, "entity.name.function.message", "Message", "Function"}}},
    {AT_LINE, {{"(?:{option})\\b" NO_STATEMENT, "keyword.other.option", "Option", "Keyword"}}},
    {AT_LINE, {{NAME "(?=\\s*\")", "constant.other.requirement", "Requirement", "Tag"}}},
    {"", {{"(?<![A-Za-z0-9_.])[0-9]+\\.[0-9]+\\.[0-9]+\\.[0-9]+(?::[0-9]+)?", "constant.numeric.address", "Address", "Number"}}},
    {"", {{"(?<![A-Za-z0-9_.])(?:0[xX][0-9A-Fa-f_]+|(?:[0-9][0-9_]*\\.?[0-9_]*|\\.[0-9][0-9_]*)(?:[eE][+-]?[0-9]+)?)", "constant.numeric", "Number",
           "Number"}, {"(?:{unit})\\b", "keyword.other.unit", "Unit", "Type"}}},
    {"", {{"\\b(?:{type})\\b", "storage.type", "Type", "Type"}}},
    {"", {{"\\b(?:{control})\\b", "keyword.control", "Control", "Conditional"}}},
    {"", {{"\\b(?:{logical})\\b", "keyword.operator.logical", "Logical", "Operator"}}},
    {"", {{"\\b(?:{constant})\\b", "constant.language", "Constant", "Boolean"}}},
    {"", {{"\\b(?:{builtin})(?=\\s*\\()", "support.function", "Builtin", "Function"}}},
    {"", {{"\\b(?:{context})\\b(?!\\s+(?:{control}|{logical})\\b)(?=\\s+[A-Za-z0-9_(.])", "keyword.other.context", "Context", "Keyword"}}},
    {"", {{"\\b[GST]\\b", "variable.language", "Variable", "Special"}}},
    {"", {{"{operator}", "keyword.operator", "Operator", "Operator"}}},
};

enum { RULES = sizeof rules / sizeof *rules, PATTERN_MAX = 4000 };

typedef struct Pattern { char at[PATTERN_MAX]; size_t n; } Pattern;

static void put_char(Pattern *p, char c)
{
    if (p->n == PATTERN_MAX - 1) {
        fputs("editors: a pattern is longer than PATTERN_MAX\n", stderr);
        exit(1);
    }
    p->at[p->n++] = c;
    p->at[p->n] = '\0';
}

static void put_text(Pattern *p, const char *s)
{
    while (*s)
        put_char(p, *s++);
}

static void put_words(Pattern *p, Group group)
{
    const char *between = "";

    for (size_t i = 0; i < word_count; i++)
        if (words[i].group == group) {
            put_text(p, between);
            for (const char *s = words[i].word; *s; s++) {
                if (strchr("*+.(){}/", *s))
                    put_char(p, '\\');
                put_char(p, *s);
            }
            between = "|";
        }
}

static Pattern with_words(const char *s)
{
    Pattern p = {.n = 0};

    while (*s) {
        Group g = GROUPS;

        if (*s == '{')
            for (g = 0; g < GROUPS; g++)
                if (strncmp(s + 1, group_names[g], strlen(group_names[g])) == 0 && s[1 + strlen(group_names[g])] == '}')
                    break;
        if (g == GROUPS)
            put_char(&p, *s++);
        else {
            put_words(&p, g);
            s += strlen(group_names[g]) + 2;
        }
    }
    return p;
}

// ---- TextMate ----

static void print_json(const char *s)
{
    for (; *s; s++) {
        if (*s == '\\' || *s == '"')
            putchar('\\');
        putchar(*s);
    }
}

static void print_textmate_rule(const Rule *r)
{
    int n;

    printf("    { \"match\": \"");
    print_json(r->before);
    for (n = 0; n < PARTS && r->parts[n].pattern; n++) {
        printf(n ? "(?:\\\\s*(" : "(");
        print_json(with_words(r->parts[n].pattern).at);
        putchar(')');
    }
    for (int i = 1; i < n; i++)
        printf(")?");
    printf("\",\n      \"captures\": {");
    for (int i = 0; i < n; i++)
        printf("%s \"%d\": { \"name\": \"%s.smc\" }", i ? "," : "", i + 1, r->parts[i].scope);
    printf(" } }");
}

static void print_textmate(void)
{
    printf("{\n  \"comment\": \"Generated by tests/check/editors.c from the tables of the compiler: make grammars\",\n"
           "  \"name\": \"smc\",\n  \"scopeName\": \"source.smc\",\n"
           "  \"fileTypes\": [\"sm\", \"sv\", \"ss\", \"io\", \"app\", \"net\", \"rq\"],\n  \"patterns\": [\n");
    for (int i = 0; i < RULES; i++) {
        print_textmate_rule(&rules[i]);
        printf(i + 1 < RULES ? ",\n" : "\n");
    }
    printf("  ]\n}\n");
}

// ---- Vim ----

// Translates a pattern to Vim's with \v, where other characters are special, and a group says after it what it is.
static Pattern as_vim(const Pattern *from)
{
    static const struct { const char *open, *close; } groups[] = {{"(?:", ")"}, {"(?=", ")@="}, {"(?!", ")@!"}, {"(?<!", ")@<!"}};
    const char *closes[20];
    size_t depth = 0;
    bool in_class = false;
    Pattern p = {.n = 0};

    for (const char *s = from->at; *s; s++) {
        size_t g = 0;

        while (g < 4 && (in_class || strncmp(s, groups[g].open, strlen(groups[g].open)) != 0))
            g++;
        if (g < 4 && depth < 20) {
            put_text(&p, "%(");
            closes[depth++] = groups[g].close;
            s += strlen(groups[g].open) - 1;
        } else if (*s == ')' && !in_class && depth > 0)
            put_text(&p, closes[--depth]);
        else if (s[0] == '\\' && s[1] == 'b') {
            put_text(&p, "%(<|>)");
            s++;
        } else if (s[0] == '\\' && s[1] == 's' && in_class) {
            put_text(&p, " \\t");
            s++;
        } else if (s[0] == '\\' && s[1]) {
            put_char(&p, *s++);
            put_char(&p, *s);
        } else {
            if (!in_class && strchr("<>=@~&%", *s))
                put_char(&p, '\\');
            in_class = in_class ? *s != ']' : *s == '[';
            put_char(&p, *s);
        }
    }
    return p;
}

static void print_vim_rule(const Rule *r)
{
    for (int i = 0; i < PARTS && r->parts[i].pattern; i++) {
        const Pattern before = with_words(i ? "" : r->before), part = with_words(r->parts[i].pattern);
        const bool more = i + 1 < PARTS && r->parts[i + 1].pattern;

        printf("syn match smc%s ;\\v%s%s%s;%s", r->parts[i].vim, as_vim(&before).at, before.n ? "\\zs" : "", as_vim(&part).at,
               i ? " contained" : "");
        if (more)
            printf(" nextgroup=smc%s skipwhite", r->parts[i + 1].vim);
        printf("\nhi def link smc%s %s\n", r->parts[i].vim, r->parts[i].link);
    }
}

// Of the matches at one position, Vim uses the last that was defined.
static void print_vim(void)
{
    printf("\" SPDX-License-Identifier: Apache-2.0\n\" Vim syntax file of smc: .sm .sv .ss .io .app .net .rq\n"
           "\" Generated by tests/check/editors.c from the tables of the compiler: make grammars\n"
           "if exists('b:current_syntax')\n  finish\nendif\nsyn case match\n\n");
    for (int i = RULES; i-- > 0;)
        print_vim_rule(&rules[i]);
    printf("\nlet b:current_syntax = 'smc'\n");
}

int main(int argc, char **argv)
{
    collect_words();
    if (argc == 2 && strcmp(argv[1], "textmate") == 0)
        print_textmate();
    else if (argc == 2 && strcmp(argv[1], "vim") == 0)
        print_vim();
    else {
        fputs("usage: editors textmate|vim\n", stderr);
        return 2;
    }
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 1;
}
