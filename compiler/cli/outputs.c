// SPDX-License-Identifier: Apache-2.0
// Decides which files a command can write. Sources, inputs and keys are never replaced; other files only if smc wrote them, or with
// --force.
#include <string.h>

#include "bytecode-vm/image.h"
#include "compiler/cli/key.h"

enum { HEAD = 1 << 16 };                  // bytes read from an existing file to recognise it

// The first n bytes of a file.  is_whole: the file has no more.
typedef struct Head { const char *at; size_t n; bool is_whole; } Head;

// ---- recognising files of smc ----

// Whether text begins with `pattern`, in which * matches any text within a line.
static bool matches_pattern(const char *text, const char *end, const char *pattern)
{
    for (; *pattern; pattern++, text++) {
        if (*pattern == '*') {
            for (; text < end && *text != '\n'; text++)
                if (matches_pattern(text, end, pattern + 1))
                    return true;
            return matches_pattern(text, end, pattern + 1);
        }
        if (text == end || *text != *pattern)
            return false;
    }
    return true;
}

static bool is_image(const Head *h)
{
    const unsigned char *b = (const unsigned char *)h->at;

    return h->n >= 4 && (b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16) == SMVM_MAGIC;
}

// Reads the next word of a make rule, where a backslash escapes spaces and '#'; returns false at the end of the line.
static bool read_make_word(const char **at, const char *end, const char **word, size_t *n)
{
    while (*at < end && **at == ' ')
        ++*at;
    *word = *at;
    while (*at < end && **at != ' ' && **at != '\n')
        *at += **at == '\\' && *at + 1 < end ? 2 : 1;
    *n = (size_t)(*at - *word);
    return *n > 0;
}

static bool ends_with(const char *word, size_t n, const char *suffix)
{
    const size_t m = strlen(suffix);

    return n > m && memcmp(word + n - m, suffix, m) == 0;
}

// Whether the file is an output of -MD. Other outputs contain a line that says that smc generated them; this one is recognised by its
// structure. It is one rule without commands whose prerequisites are sources (none if the machine came from standard input). With -MP an
// empty rule for each follows.
static bool is_make_rule(const Head *h)
{
    const char *end = h->at + h->n, *at = memchr(h->at, ':', h->n), *word, *first_end;
    const size_t target = at ? (size_t)(at - h->at) : 0;
    size_t n;

    while (!h->is_whole && end > h->at && end[-1] != ' ' && end[-1] != '\n')
        end--;                                    // the last word may be truncated
    first_end = memchr(h->at, '\n', (size_t)(end - h->at));
    first_end = first_end || h->is_whole ? first_end : end;
    if (!at || !first_end || at >= first_end || *h->at == '\t' || *h->at == ' ')
        return false;
    if (++at == first_end)
        return ends_with(h->at, target, ".smb") || ends_with(h->at, target, ".c") || ends_with(h->at, target, ".h");
    while (read_make_word(&at, first_end, &word, &n))
        if (!outputs_is_source_name(word, n))
            return false;
    for (at = first_end < end ? first_end + 1 : end; at < end; at++) {
        if (*at == '\n')
            continue;
        if (!read_make_word(&at, end, &word, &n) || word[n - 1] != ':' || !outputs_is_source_name(word, n - 1) || at == end || *at != '\n')
            return false;
    }
    return true;
}

static bool is_name_char(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// Whether the text is a value as --trace-format=exact writes it: whole, true or false, or hexadecimal with an exponent.
static bool is_exact_value(const char *at, const char *end)
{
    static const char *const words[] = {"true", "false", "nan", "inf", "-inf"};
    const size_t n = (size_t)(end - at);

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (n == strlen(words[i]) && memcmp(at, words[i], n) == 0)
            return true;
    at += n && *at == '-';
    if (end - at > 2 && at[0] == '0' && at[1] == 'x')
        return memchr(at, 'p', (size_t)(end - at)) != NULL;
    for (const char *c = at; c < end; c++)
        if (*c < '0' || *c > '9')
            return false;
    return at < end;
}

// Whether the file is an exact trace: lines `STEP NAME VALUE`, at least three, because every machine has G, S and T.
static bool is_exact_trace(const Head *h)
{
    const char *at = h->at, *end = h->at + h->n, *lf;
    size_t lines = 0;

    for (; (lf = memchr(at, '\n', (size_t)(end - at))) != NULL; at = lf + 1, lines++) {
        const char *name, *value;
        if (lines < 3 ? lf - at < 2 || at[0] != '1' || at[1] != ' ' : *at < '1' || *at > '9')
            return false;
        name = memchr(at, ' ', (size_t)(lf - at));
        if (!name || (value = memchr(name + 1, ' ', (size_t)(lf - name - 1))) == NULL || !is_exact_value(value + 1, lf))
            return false;
        while (++name < value)
            if (!is_name_char(*name))
                return false;
    }
    return lines >= 3;
}

// ---- tables ----

// Reads a field of CSV; *n: its length. Returns false if smc would not have written the line like this.
static bool read_csv_field(const char **at, const char *lf, const char **field, size_t *n)
{
    const char *c = *at;

    *field = c;
    if (c < lf && *c == '"') {
        for (c++; c < lf && (*c != '"' || (c + 1 < lf && c[1] == '"')); c++)
            c += *c == '"';
        if (c++ == lf)
            return false;
    } else {
        while (c < lf && *c != ',')
            c++;
    }
    *n = (size_t)(c - *field);
    *at = c < lf ? c + 1 : lf;
    return *n > 0 && (c == lf || (*c == ',' && c + 1 < lf));
}

// Whether n characters in the header of a table can be the name of an element or a local.
static bool is_name(const char *at, size_t n)
{
    size_t i = 0;

    while (i < n && (is_name_char(at[i]) || at[i] == '.'))         // with a point as in "tank.state", if another column is called "state"
        i++;
    return i == n;
}

// Whether n characters in a row of a table can be a value.
static bool is_value(const char *at, size_t n)
{
    static const char *const words[] = {"true", "false", "inf", "-inf", "nan", "-nan"};
    size_t i = 0;

    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (n == strlen(words[k]) && memcmp(at, words[k], n) == 0)
            return true;
    while (i < n && at[i] && strchr("0123456789+-.e", at[i]))
        i++;
    return i == n;
}

// Whether the file is a header that begins with the columns `first`, followed by lines with a value for each. `kinds` has a letter for
// each of these columns: t text, n name, # value. The other columns are named after elements and contain values.
static bool is_table(const Head *h, const char *first, const char *kinds)
{
    const char *at = h->at, *end = h->at + h->n, *lf = memchr(at, '\n', h->n), *field;
    size_t columns = strlen(kinds), n;

    if (!lf || (size_t)(lf - at) < strlen(first) || memcmp(at, first, strlen(first)) != 0)
        return false;
    for (at += strlen(first); at < lf; columns++)
        if (*at++ != ',' || !read_csv_field(&at, lf, &field, &n) || !is_name(field, n))
            return false;
        else
            at -= at < lf;                                         // go back to the comma, which is read with the column after it
    for (at = lf + 1; at < end && (lf = memchr(at, '\n', (size_t)(end - at))) != NULL; at = lf + 1)
        for (size_t i = 0; i < columns; i++) {
            const char kind = i < strlen(kinds) ? kinds[i] : '#';
            if (!read_csv_field(&at, lf, &field, &n) || (kind != 't' && !(kind == 'n' ? is_name(field, n) : is_value(field, n))) ||
                (at == lf) != (i + 1 == columns))
                return false;
        }
    return at == end || !h->is_whole;                              // without its last line feed, a line may be truncated
}

static bool is_trace(const Head *h) { return is_table(h, "script,step,G,state", "t##n"); }
static bool is_log_table(const Head *h) { return is_table(h, "session,seconds", "##"); }

// ---- results as JUnit XML ----

typedef struct XmlElementRule {
    const char *tag, *parent, *attributes;
    const char *text;         // how its text begins; NULL: it has none
} XmlElementRule;

static const XmlElementRule junit_rules[] = {
    {"testsuites", "", " name tests failures errors time ", NULL},
    {"testsuite", "testsuites", " name tests failures errors skipped time file ", NULL},
    {"testcase", "testsuite", " name classname time ", NULL},
    {"failure", "testcase", " message type ", ""},
    {"error", "testcase", " message type ", ""},
    {"skipped", "testcase", " message ", ""},
    {"properties", "testcase", " ", NULL},
    {"property", "properties", " name value ", NULL},
    {"system-out", "testcase", " ", "step "},
};

enum { JUNIT_DEPTH = 5 };

typedef struct XmlOpen { const XmlElementRule *rule[JUNIT_DEPTH]; size_t depth; } XmlOpen;

// Whether `words`, a list with a space before and after each word, contains this word.
static bool has_word(const char *words, const char *word, size_t n)
{
    for (; (words = strchr(words, ' ')) != NULL && words[1]; words++)
        if (n > 0 && n < strlen(words) && memcmp(words + 1, word, n) == 0 && words[1 + n] == ' ')
            return true;
    return false;
}

// Reads the tag that begins at `at`. Returns the text after it, or NULL if smc would not have written it there.
static const char *read_tag(XmlOpen *open, const char *at, const char *end)
{
    const bool closes = end - at > 1 && at[1] == '/';
    const char *name = at + 1 + closes, *const parent = open->depth ? open->rule[open->depth - 1]->tag : "";
    const XmlElementRule *rule = NULL;
    size_t n = 0;

    while (name + n < end && (is_name_char(name[n]) || name[n] == '-'))
        n++;
    at = name + n;
    if (closes) {
        if (at == end || *at != '>' || strlen(parent) != n || memcmp(parent, name, n) != 0 || n == 0)
            return NULL;
        open->depth--;
        return at + 1;
    }
    for (size_t i = 0; i < sizeof junit_rules / sizeof *junit_rules; i++)
        if (strlen(junit_rules[i].tag) == n && memcmp(junit_rules[i].tag, name, n) == 0 && strcmp(junit_rules[i].parent, parent) == 0)
            rule = &junit_rules[i];
    while (rule && at < end && *at == ' ') {
        const char *equals = memchr(at, '=', (size_t)(end - at)), *quote = equals && end - equals > 1 && equals[1] == '"' ? equals + 2 : NULL;
        if (!quote || !has_word(rule->attributes, at + 1, (size_t)(equals - at - 1)) ||
            (quote = memchr(quote, '"', (size_t)(end - quote))) == NULL)
            return NULL;
        at = quote + 1;
    }
    if (rule && end - at > 1 && at[0] == '/' && at[1] == '>')
        return at + 2;
    if (!rule || at == end || *at != '>' || (rule->text && at + 1 < end && !matches_pattern(at + 1, end, rule->text)))
        return NULL;
    open->rule[open->depth++] = rule;
    return at + 1;
}

// Whether the file begins like the JUnit report of smc test, and contains only the XML elements that it writes.
static bool is_junit(const Head *h)
{
    static const char mark[] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"smc test\" ";
    const char *at = h->at, *end = h->at + h->n, *root;
    XmlOpen open = {{NULL}, 0};

    if (!matches_pattern(at, end, mark))
        return false;
    at = root = strchr(at, '\n') + 1;
    while (!h->is_whole && end[-1] != '>')                         // '>' only ends tags
        end--;
    while (at < end)
        if (*at == '<') {
            if ((open.depth == 0 && at != root) || (at = read_tag(&open, at, end)) == NULL)
                return false;
        } else if (*at == ' ' || *at == '\n' || (open.depth && open.rule[open.depth - 1]->text)) {
            at++;
        } else {
            return false;
        }
    return open.depth == 0 || !h->is_whole;
}

// ---- messages as text ----

// Makes the format of a message a pattern of a line: each directive becomes *. Returns false if it is too long, or too little of it is fixed.
static bool make_pattern(const char *format, char *pattern, size_t room)
{
    enum { LEAST_FIXED = 10 };
    size_t n = 0, directives = 0;

    for (const char *at = format; *at && n + 2 < room; at++) {
        const bool is_directive = *at == '%';
        pattern[n++] = is_directive ? '*' : *at;
        directives += is_directive;
        at += is_directive ? strspn(at + 1, "0123456789l") + 1 : 0;       // to the letter of the directive
    }
    memcpy(pattern + n, "\n", 2);
    return n + 2 < room && n - directives >= LEAST_FIXED;
}

// Whether the text begins with a message of the command, as cli_print_error and the others write it.
static bool is_plain_message(const char *at, const char *end)
{
    static const char *const text[] = {
#define CLI_TEXT(name, format) format,
#include "compiler/cli/texts.def"
#undef CLI_TEXT
    };
    char pattern[500];

    if (!matches_pattern(at, end, "smc: "))
        return false;
    at += matches_pattern(at, end, "smc: warning: ") ? strlen("smc: warning: ") : strlen("smc: ");
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        if (make_pattern(text[i], pattern, sizeof pattern) && matches_pattern(at, end, pattern))
            return true;
    return matches_pattern(at, end, "*.smt: failed\n");
}

static bool begins_with_any(const char *at, const char *end, const char *const *pattern, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (matches_pattern(at, end, pattern[i]))
            return true;
    return false;
}

// Whether the file begins with a message, and every further line is another one or belongs to one.
static bool is_message_text(const Head *h)
{
    static const char *const first[] = {"*error: * [E*", "*error: * [W*", "*warning: * [W*"};
    static const char *const more[] = {" ", "note: ", "*: note: ", "1 error", "1 warning", "* errors", "* warnings"};
    const char *at = h->at, *end = at + h->n, *lf;

    for (; at < end && (lf = memchr(at, '\n', (size_t)(end - at))) != NULL; at = lf + 1)
        if (!begins_with_any(at, end, first, sizeof first / sizeof *first) && !is_plain_message(at, end) &&
            (at == h->at || !begins_with_any(at, end, more, sizeof more / sizeof *more)))
            return false;
    return at > h->at && (at == end || !h->is_whole);
}

// ---- all kinds ----

#define GENERATED_SCRIPT "# Generated by smc faults from "

// Every kind of file that smc writes through an option, and how to recognise it.
static const struct {
    const char *mark;                     // how a file that smc has written begins, as matches_pattern reads it; or NULL
    bool (*is_written_by_smc)(const Head *h);
} kinds[] = {
    {NULL, is_image},                                                     // build, sign, set
    {"// *Generated by smc from ", NULL},                                 // C, headers, assembly
    {"// *Made by smc from ", NULL},                                      // C, headers, assembly of older versions of smc
    {"machine \"*\"\nvector \"*\" size * hash 0x", NULL},                 // build --emit=ir
    {"# Syntax tree of *, printed by smc\n", NULL},
    {"# Tokens of *, printed by smc\n", NULL},
    {"{\"smc-dictionary\":", NULL},                                        // emit-dictionary
    {"# The messages of *Generated by smc from ", NULL},
    {"<?xml *?>\n<!-- Generated by smc from ", NULL},
    {NULL, is_make_rule},                                                 // build -MD
    {"<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"generator\" content=\"smc\"/>", NULL},
    {"*\n=*\nDesign review of the state machine in ", NULL},              // report --format=text
    {"{\"smc-report\": ", NULL},
    {"<svg *class=\"smc-graph\"", NULL},
    {"digraph \"*\" { // drawn by smc\n", NULL},
    {"stateDiagram-v2\n    %% drawn by smc\n", NULL},
    {"*: * bytes, * session*\n\nsession *: ", NULL},                      // log --format=text
    {NULL, is_log_table},                                                 // log --format=csv
    {"{\"time\":*,\"values\":{", NULL},                                   // log --format=json: a record, an event or a gap
    {"{\"time\":*,\"event\":\"*\",\"number\":*,\"source\":", NULL},
    {"{\"dropped\":*,\"lost\":", NULL},
    {"<svg *class=\"plot smc-flight\"", NULL},
    {"{\"severity\":\"*\",\"code\":*,\"message\":\"*", NULL},               // --message-file, as JSON, SARIF and text
    {"{\"$schema\":\"*\",\"version\":\"2.1.0\",\"runs\":[{\n\"tool\":{\"driver\":{\"name\":\"smc\",", NULL},
    {NULL, is_message_text},
    {"smc-coverage 1\n", NULL},                                          // test --coverage-data
    {"{\"smc-coverage\":", NULL},                                        // test --coverage-json
    {"requirements of ", NULL},                                          // prove
    {"{\"smc-proofs\":", NULL},
    {"faults of *: * input", NULL},                                       // faults
    {"{\"smc-faults\":", NULL},
    {"sweep of *: * script", NULL},                                       // sweep
    {"{\"smc-sweep\":", NULL},
    {"<svg *class=\"smc-sweep\"", NULL},
    {"*,failing,checks\n", NULL},                                         // sweep --format=csv
    {GENERATED_SCRIPT, NULL},                                             // faults --scripts
    {"mutations of ", NULL},                                              // mutate
    {"{\"smc-mutations\":", NULL},
    {"comparison of ", NULL},                                             // diff
    {"### *: no change of behaviour", NULL},
    {"### *: behaviour changed: ", NULL},
    {"{\"smc-diff\":", NULL},
    {"goals of ", NULL},                                                  // cover
    {"{\"smc-goals\":", NULL},
    {"TN:smc\nSF:", NULL},                                               // test --coverage-lcov
    {"kind,name,text,place,requirements,by,implemented,asserts,scripts,times,result,proof\r\n", NULL},      // test --traceability
    {"{\"smc-traceability\":", NULL},
    {NULL, is_junit},                                                     // test --junit
    {NULL, is_trace},                                                     // test --trace
    {NULL, is_exact_trace},
};

static bool is_written_by_smc(const Head *h)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (kinds[i].mark ? matches_pattern(h->at, h->at + h->n, kinds[i].mark) : kinds[i].is_written_by_smc(h))
            return true;
    return false;
}

// ---- sources and inputs ----

// Whether a name has the suffix of a source, in capital or small letters.
bool outputs_is_source_name(const char *name, size_t n)
{
    static const char *const suffix[] = {".sm", ".ss", ".sv", ".io", ".net", ".app", ".smt", ".rq"};

    for (size_t i = 0; i < sizeof suffix / sizeof *suffix; i++) {
        const size_t m = strlen(suffix[i]);
        size_t k = 0;
        while (n >= m && k < m && (name[n - m + k] | (suffix[i][k] & 0x20)) == suffix[i][k])      // also matches capitals
            k++;
        if (k == m)
            return true;
    }
    return false;
}

// Whether the path is a script that smc faults can write: one in the folder of --scripts, which does not exist or which smc faults has written.
static bool is_generated_script(Cli *c, const char *path)
{
    const char *folder = c->given[OPT_SCRIPTS] ? c->value[OPT_SCRIPTS] : NULL;
    char head[sizeof GENERATED_SCRIPT];
    size_t n = 0;

    if (!folder || strncmp(path, folder, strlen(folder)) != 0 || !has_suffix(path, ".ss"))
        return false;
    return os_read_head(path, head, sizeof head - 1, &n) && (n == 0 || matches_pattern(head, head + n, GENERATED_SCRIPT));
}

static bool is_value_of_option(const Cli *c, OptionId id, const char *path)
{
    return c->given[id] && os_same_file(c->value[id], path);
}

static bool is_input_of_command(const Cli *c, const char *path)
{
    const size_t files = c->command->run == cmd_sign ? 0                              // smc sign can write over its input
                       : c->command->run == cmd_log && c->files ? 1 : c->files;       // after the log come names of elements

    for (size_t i = 0; i < files; i++)
        if (os_same_file(strcmp(c->file[i], "-") == 0 ? "/dev/stdin" : c->file[i], path))
            return true;
    for (size_t i = 0; i < c->data.n; i++)
        if (os_same_file(c->data.at[i], path))
            return true;
    return is_value_of_option(c, OPT_SV, path) || is_value_of_option(c, OPT_IO, path) || is_value_of_option(c, OPT_NET, path) ||
           is_value_of_option(c, OPT_KEY, path);
}

// Returns the path with links followed; the path itself if that fails.
static const char *real_path(Cli *c, const char *path)
{
    char *real = strcmp(path, "-") == 0 ? NULL : os_real_path(path);
    const char *copy = real ? format_in(&c->session.arena, "%s", real) : path;

    os_alloc(NULL, real, 0);
    return copy;
}

// ---- refused outputs ----

// Checks that an output is not an input and does not have the name of a source.  `option`: the option that named the output, or NULL if the
// command chose the name.
static int check_output_name(Cli *c, const char *path, const char *option)
{
    const char *real = real_path(c, path);
    const char *another = option ? format_in(&c->session.arena, "name another file after %s", option)
                        : c->given[OPT_SCRIPTS] && has_suffix(path, ".ss") ? "name another folder with --scripts"
                        : c->files && has_suffix(c->file[0], ".app") ? "name another folder with -o" : "name another file with -o";

    if (strcmp(path, "-") == 0 || os_is_special(path))
        return EXIT_OK;
    if (is_input_of_command(c, path))
        return cli_usage_error(c, TEXT_output_is_input, path, another);
    if (!option && is_generated_script(c, path))
        return EXIT_OK;
    if (outputs_is_source_name(path, strlen(path)) || outputs_is_source_name(real, strlen(real)))
        return cli_usage_error(c, TEXT_output_is_source, path, another);
    return EXIT_OK;
}

// Checks whether an existing file may be replaced. A missing, empty or non-regular file is accepted, because it has no content to lose. --force
// does not replace a key, because a key cannot be generated again: boards that have it would refuse every other key.
static int check_existing(Cli *c, const char *path)
{
    char *head;
    Head h = {NULL, 0, false};

    if (strcmp(path, "-") == 0 || os_is_special(path))
        return EXIT_OK;
    h.at = head = arena_alloc(&c->session.arena, HEAD);
    if (!os_read_head(path, head, HEAD, &h.n)) {
        cli_print_error(c, TEXT_output_unreadable, path);
        return EXIT_ENVIRONMENT;
    }
    h.is_whole = h.n < HEAD;
    if (key_is_file(h.at, h.n))
        return cli_usage_error(c, TEXT_output_is_key, path);
    if (h.n == 0 || c->given[OPT_FORCE] || is_written_by_smc(&h))
        return EXIT_OK;
    return cli_usage_error(c, TEXT_output_not_ours, path);
}

// Whether two outputs are the same file or stream.
static bool is_same_output(Cli *c, const char *a, const char *b)
{
    if (strcmp(a, "-") == 0 || strcmp(b, "-") == 0)
        return strcmp(a, b) == 0;
    return !os_is_special(a) && (os_same_file(a, b) || strcmp(real_path(c, a), real_path(c, b)) == 0);
}

// Checks all outputs before the first is written: none is an input, the same file as another output, or a file that smc has not written.
// Returns EXIT_OK, or the exit code after a message.
int outputs_check(Cli *c, const OsOutput *out, size_t n)
{
    const char *messages = c->given[OPT_MESSAGE_FILE] ? c->value[OPT_MESSAGE_FILE] : NULL;        // written when the command ends
    int code = EXIT_OK;

    for (size_t i = 0; i < n && code == EXIT_OK; i++) {
        for (size_t k = 0; k < i; k++)
            if (is_same_output(c, out[k].path, out[i].path))
                return cli_usage_error(c, TEXT_outputs_same, out[k].path, out[i].path);
        if (messages && out[i].path != messages && is_same_output(c, messages, out[i].path))
            return strcmp(messages, "-") == 0 ? cli_usage_error(c, TEXT_both_to_stdout, "this output", "--message-file")
                                              : cli_usage_error(c, TEXT_outputs_same, out[i].path, messages);
        if ((code = check_output_name(c, out[i].path, NULL)) == EXIT_OK)
            code = check_existing(c, out[i].path);
    }
    return code;
}

// Returns the value of an option that names an output.  Replaces it with "-" if it is another name of standard output.
static const char *output_named(Cli *c, OptionId id)
{
    if (c->given[id] && os_find_descriptor(c->value[id]) == 1)
        c->value[id] = "-";
    return c->value[id];
}

// Makes the checks of outputs_check for the outputs that options name, before any input is read.
int outputs_check_options(Cli *c)
{
    static const struct { OptionId id; const char *spelling; } option[] = {
        {OPT_OUTPUT, "-o"}, {OPT_DEPS_FILE, "-MF"}, {OPT_TRACE, "--trace"}, {OPT_JUNIT, "--junit"},
        {OPT_COVERAGE_DATA, "--coverage-data"}, {OPT_COVERAGE_JSON, "--coverage-json"}, {OPT_COVERAGE_LCOV, "--coverage-lcov"},
        {OPT_TRACEABILITY, "--traceability"},
        {OPT_MESSAGE_FILE, "--message-file"}};
    const bool can_be_folder = c->command->run == cmd_build || c->command->run == cmd_cover;
    int code = EXIT_OK;

    for (size_t i = 0; i < sizeof option / sizeof *option && code == EXIT_OK; i++) {
        const char *path = output_named(c, option[i].id);
        if (!c->given[option[i].id])
            continue;
        for (size_t k = 0; k < i; k++)
            if (c->given[option[k].id] && is_same_output(c, path, c->value[option[k].id]))
                return cli_usage_error(c, strcmp(path, "-") == 0 ? TEXT_both_to_stdout : TEXT_outputs_equal,
                                       option[k].spelling, option[i].spelling);
        code = check_output_name(c, path, option[i].spelling);
        if (code == EXIT_OK && !(can_be_folder && option[i].id == OPT_OUTPUT))     // -o of a build can be the stem of several names
            code = check_existing(c, path);
    }
    return code;
}
