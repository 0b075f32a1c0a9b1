// SPDX-License-Identifier: Apache-2.0
// Runs while smc is built.  Writes a table of the snippets in the stdlib headers named as arguments to standard output.  A snippet is the source
// of a function or type that the C emitter copies.
//
// In a header, the comment `// snippet of emitted C: NAME` marks the beginning of snippet NAME, which ends at the next such comment;
// `// snippet of emitted C: end` begins no snippet. `// snippet of emitted C: NAME (only where SmF64 is a double)` marks a snippet that exists only
// there.  A snippet depends on those whose names it contains outside comments.  It may only depend on earlier ones, so the emitter can write them in
// table order.
//
// `-lines NAME FILE…` writes whole files as an array of lines instead, without SPDX lines and includes of stdlib files.
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MARK "// snippet of emitted C: "

enum { SNIPPETS_MAX = 250, DEPS_MAX = 24, NAME_MAX_LEN = 40, TEXT_MAX = 4000, LINE_MAX_LEN = 400, LITERAL_MAX = 4000 };

typedef struct Snippet {
    char name[NAME_MAX_LEN];
    bool native;              // the snippet exists only where SmF64 is a double
    char text[TEXT_MAX];      // C99 guarantees string literals of up to 4095 characters
    int dep[DEPS_MAX];        // indices of the snippets that it depends on
    int deps;
} Snippet;

static Snippet snippet[SNIPPETS_MAX];
static int snippets;

// Prints an error and ends the program.
static void exit_with_error(const char *what, const char *which)
{
    fprintf(stderr, "embed_tool: %s: %s\n", what, which);
    exit(1);
}

static bool is_word_char(char c)
{
    return c != '\0' && strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", c) != NULL;
}

static void begin_snippet(const char *name)
{
    Snippet *s = &snippet[snippets];
    if (snippets + 1 >= SNIPPETS_MAX)
        exit_with_error("too many snippets", name);
    if (sscanf(name, "%39s", s->name) != 1)
        exit_with_error("a snippet has no name", name);
    s->native = strstr(name, " (only where SmF64 is a double)\n") != NULL;
    snippets++;
}

static void append_to_snippet(Snippet *s, const char *line)
{
    if (strlen(s->text) + strlen(line) + 1 > TEXT_MAX)
        exit_with_error("this snippet is too long", s->name);
    strcat(s->text, line);
}

static void read_header(const char *path)
{
    char line[LINE_MAX_LEN];
    bool open = false;
    FILE *f = fopen(path, "r");
    if (f == NULL)
        exit_with_error("cannot read", path);
    while (fgets(line, sizeof line, f) != NULL) {
        if (strncmp(line, MARK, strlen(MARK)) == 0) {
            open = strcmp(line, MARK "end\n") != 0;
            if (open)
                begin_snippet(line + strlen(MARK));
        } else if (open) {
            append_to_snippet(&snippet[snippets - 1], line);
        }
    }
    if (open)
        exit_with_error("the last snippet is not closed by " MARK "end", path);
    fclose(f);
}

// Returns the end of the comment or word that starts at p, otherwise p + 1.
static const char *find_token_end(const char *p)
{
    if (p[0] == '/' && p[1] == '/')
        return p + strcspn(p, "\n");
    if (!is_word_char(*p))
        return p + 1;
    while (is_word_char(*p))
        p++;
    return p;
}

// Returns the index of a snippet in the table; -1 if it is not in it.
static int find_snippet(const char *name, size_t n)
{
    for (int i = 0; i < snippets; i++)
        if (strlen(snippet[i].name) == n && strncmp(snippet[i].name, name, n) == 0)
            return i;
    return -1;
}

// Records that the snippet `user` names the snippet `dep` (indexes in `snippet`).
static void add_dependency(int user, int dep)
{
    Snippet *s = &snippet[user];
    for (int i = 0; i < s->deps; i++)
        if (s->dep[i] == dep)
            return;
    if (dep > user)
        exit_with_error("this snippet depends on one that comes after it", s->name);
    if (s->deps == DEPS_MAX)
        exit_with_error("this snippet depends on too many others", s->name);
    s->dep[s->deps++] = dep;
}

// Records every snippet whose name occurs in the text of the snippet `user`.
static void find_dependencies(int user)
{
    for (const char *p = snippet[user].text, *end; *p != '\0'; p = end) {
        end = find_token_end(p);
        const int dep = is_word_char(*p) ? find_snippet(p, (size_t)(end - p)) : -1;
        if (dep >= 0 && dep != user)
            add_dependency(user, dep);
    }
}

// Prints a text as C string literals, one for each line.
static void print_text(const char *text)
{
    fputs("      \"", stdout);
    for (const char *p = text; *p != '\0'; p++) {
        if (*p == '\n')
            fputs(p[1] == '\0' ? "\\n" : "\\n\"\n      \"", stdout);
        else
            printf(*p == '"' || *p == '\\' ? "\\%c" : "%c", *p);
    }
}

static void print_snippet(const Snippet *s)
{
    printf("    { \"%s\", %d, %d, { ", s->name, s->native, s->deps);
    for (int i = 0; i < s->deps; i++)
        printf("%d, ", s->dep[i]);
    printf("%s},\n", s->deps == 0 ? "0 " : "");
    print_text(s->text);
    fputs("\" },\n", stdout);
}

// Prints the lines of a file as strings of several lines, each as long as C99 promises for a literal: every pointer to a string is a
// relocation each time the command starts.
static void print_lines(const char *path)
{
    char line[LINE_MAX_LEN];
    size_t length = 0;                // of the string that is open
    FILE *f = fopen(path, "r");
    if (f == NULL)
        exit_with_error("cannot read", path);
    while (fgets(line, sizeof line, f) != NULL)
        if (strncmp(line, "#include \"stdlib/", 17) != 0 && strncmp(line, "// SPDX", 7) != 0) {
            if (length > 0)
                puts(length + strlen(line) > LITERAL_MAX ? "\"," : "\"");
            length = (length + strlen(line) > LITERAL_MAX ? 0 : length) + strlen(line);
            print_text(line);
        }
    if (length > 0)
        puts("\",");
    fclose(f);
}

static int print_files_as_lines(const char *name, char **path)
{
    printf("// Generated by embed_tool.\nstatic const char *const %s[] = {\n", name);
    for (; *path != NULL; path++)
        print_lines(*path);
    puts("      NULL\n};\n");
    return ferror(stdout) != 0 || fclose(stdout) != 0;
}

int main(int argc, char **argv)
{
    if (argc > 2 && strcmp(argv[1], "-lines") == 0)
        return print_files_as_lines(argv[2], argv + 3);
    for (int i = 1; i < argc; i++)
        read_header(argv[i]);
    for (int i = 0; i < snippets; i++)
        find_dependencies(i);
    puts("// The source of stdlib functions and types as snippets.  Each follows those that it depends on.  Generated by embed_tool.");
    puts("#ifndef STDLIB_TEXT_H\n#define STDLIB_TEXT_H\n\n#include <stdbool.h>\n");
    puts("typedef struct StdlibText {");
    puts("    const char *name;");
    puts("    bool native;         // it exists only where SmF64 is a double");
    puts("    // The snippets that it depends on: their number, and their indices in the table, all smaller than its own.");
    printf("    unsigned char deps, dep[%d];\n", DEPS_MAX);
    puts("    const char *text;");
    puts("} StdlibText;\n");
    printf("enum { STDLIB_TEXT_COUNT = %d };\n\n", snippets);
    puts("static const StdlibText stdlib_text[STDLIB_TEXT_COUNT] = {");
    for (int i = 0; i < snippets; i++)
        print_snippet(&snippet[i]);
    puts("};\n\n#endif");
    return ferror(stdout) != 0 || fclose(stdout) != 0;
}
