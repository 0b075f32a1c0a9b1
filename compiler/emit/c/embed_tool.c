// SPDX-License-Identifier: Apache-2.0
// Runs while smc is built.  Turns the stdlib headers named as arguments into a table of snippets, on standard output, from which the C
// emitter copies.  A line `//: NAME` begins the snippet NAME and the next such line ends it (`//: end` begins none).  `//: NAME double`
// marks a snippet that exists only where SmF64 is a double.  Dependencies are found by searching snippets for each other's names, except in
// comments.  A snippet can only need earlier ones, so the emitter writes them in table order.  `-lines NAME FILE…` outputs whole files as
// an array of lines, without SPDX lines and includes of stdlib files.
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SNIPPETS_MAX = 200, DEPS_MAX = 16, NAME_MAX_LEN = 40, TEXT_MAX = 4000, LINE_MAX_LEN = 400 };

typedef struct Snippet {
    char name[NAME_MAX_LEN];
    bool native;              // only where SmF64 is a double
    char text[TEXT_MAX];      // C99 guarantees string literals of up to 4095 characters
    int dep[DEPS_MAX];
    int deps;
} Snippet;

static Snippet snippet[SNIPPETS_MAX];
static int snippets;

static void fail(const char *what, const char *which)
{
    fprintf(stderr, "embed_tool: %s: %s\n", what, which);
    exit(1);
}

static bool is_word(char c)
{
    return c != '\0' && strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", c) != NULL;
}

static void snippet_open(const char *name)
{
    Snippet *s = &snippet[snippets];
    if (snippets + 1 >= SNIPPETS_MAX)
        fail("too many texts", name);
    if (sscanf(name, "%39s", s->name) != 1)
        fail("a text has no name", name);
    s->native = strstr(name, " double\n") != NULL;
    snippets++;
}

static void snippet_append(Snippet *s, const char *line)
{
    if (strlen(s->text) + strlen(line) + 1 > TEXT_MAX)
        fail("this text is too long", s->name);
    strcat(s->text, line);
}

static void read_header(const char *path)
{
    char line[LINE_MAX_LEN];
    bool open = false;
    FILE *f = fopen(path, "r");
    if (f == NULL)
        fail("cannot read", path);
    while (fgets(line, sizeof line, f) != NULL) {
        if (strncmp(line, "//: ", 4) == 0) {
            open = strcmp(line, "//: end\n") != 0;
            if (open)
                snippet_open(line + 4);
        } else if (open) {
            snippet_append(&snippet[snippets - 1], line);
        }
    }
    if (open)
        fail("the last text is not closed by //: end", path);
    fclose(f);
}

// The end of the comment or word that starts at p; otherwise p + 1.
static const char *token_end(const char *p)
{
    if (p[0] == '/' && p[1] == '/')
        return p + strcspn(p, "\n");
    if (!is_word(*p))
        return p + 1;
    while (is_word(*p))
        p++;
    return p;
}

static int snippet_find(const char *name, size_t n)
{
    for (int i = 0; i < snippets; i++)
        if (strlen(snippet[i].name) == n && strncmp(snippet[i].name, name, n) == 0)
            return i;
    return -1;
}

static void dep_add(int user, int dep)
{
    Snippet *s = &snippet[user];
    for (int i = 0; i < s->deps; i++)
        if (s->dep[i] == dep)
            return;
    if (dep > user)
        fail("this text needs one that comes after it", s->name);
    if (s->deps == DEPS_MAX)
        fail("this text needs too many others", s->name);
    s->dep[s->deps++] = dep;
}

static void find_deps(int user)
{
    for (const char *p = snippet[user].text, *end; *p != '\0'; p = end) {
        end = token_end(p);
        const int dep = is_word(*p) ? snippet_find(p, (size_t)(end - p)) : -1;
        if (dep >= 0 && dep != user)
            dep_add(user, dep);
    }
}

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

static void print_lines(const char *path)
{
    char line[LINE_MAX_LEN];
    FILE *f = fopen(path, "r");
    if (f == NULL)
        fail("cannot read", path);
    while (fgets(line, sizeof line, f) != NULL)
        if (strncmp(line, "#include \"stdlib/", 17) != 0 && strncmp(line, "// SPDX", 7) != 0) {
            print_text(line);
            fputs("\",\n", stdout);
        }
    fclose(f);
}

static int print_files(const char *name, char **path)
{
    printf("// Made by embed_tool.\nstatic const char *const %s[] = {\n", name);
    for (; *path != NULL; path++)
        print_lines(*path);
    puts("      NULL\n};\n");
    return ferror(stdout) != 0 || fclose(stdout) != 0;
}

int main(int argc, char **argv)
{
    if (argc > 2 && strcmp(argv[1], "-lines") == 0)
        return print_files(argv[2], argv + 3);
    for (int i = 1; i < argc; i++)
        read_header(argv[i]);
    for (int i = 0; i < snippets; i++)
        find_deps(i);
    puts("// The texts of stdlib functions, in an order in which each comes after those it needs.  Made by embed_tool.");
    puts("#ifndef STDLIB_TEXT_H\n#define STDLIB_TEXT_H\n\n#include <stdbool.h>\n");
    puts("typedef struct StdlibText {");
    puts("    const char *name;");
    puts("    bool native;         // stands only where SmF64 is a double");
    puts("    // Which others it needs: indices into the table, all smaller than its own.");
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
