// SPDX-License-Identifier: Apache-2.0
// Functions for every subcommand: messages, writing outputs, reporting diagnostics.
#include "compiler/base/path.h"
#include "compiler/cli/cli.h"
#include "compiler/syntax/time_unit.h"
#include "compiler/version.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// ---- messages: to standard error, and to the file that --message-file names ----

typedef enum MessageFormat { MESSAGE_TEXT, MESSAGE_JSON, MESSAGE_SARIF } MessageFormat;

static MessageFormat format_of_option(const Cli *c)
{
    const char *name = c->value[OPT_FORMAT];

    return !c->given[OPT_FORMAT] || strcmp(name, "text") == 0 ? MESSAGE_TEXT : strcmp(name, "json") == 0 ? MESSAGE_JSON : MESSAGE_SARIF;
}

// With --message-file, --message-format is the format of that file, and the console shows text.
bool cli_prints_text(const Cli *c) { return format_of_option(c) == MESSAGE_TEXT && !c->given[OPT_MESSAGE_FILE]; }

static MessageFormat console_format(const Cli *c) { return c->given[OPT_MESSAGE_FILE] ? MESSAGE_TEXT : format_of_option(c); }

// Returns the format of the file of --message-file.  Without --message-format, the suffix of the file's name decides.
static MessageFormat file_format(const Cli *c)
{
    const char *path = c->value[OPT_MESSAGE_FILE];

    if (c->given[OPT_FORMAT])
        return format_of_option(c);
    return has_suffix(path, ".sarif") || has_suffix(path, ".sarif.json") ? MESSAGE_SARIF : has_suffix(path, ".json") ? MESSAGE_JSON : MESSAGE_TEXT;
}

static void put_plain_message(MessageFormat format, const char *severity, const char *text, Buf *out)
{
    if (format == MESSAGE_TEXT)
        buf_printf(out, "smc: %s%s\n", strcmp(severity, "warning") == 0 ? "warning: " : "", text);
    else if (format == MESSAGE_JSON)
        diag_plain_json(severity, text, out);
}

// Adds a message to the file that --message-file names, and does not print it.
void cli_record_message(Cli *c, const char *severity, const char *text)
{
    const PlainMessage message = {severity, text};

    vec_push(&c->session.arena, &c->plain, message);
    if (c->given[OPT_MESSAGE_FILE])
        put_plain_message(file_format(c), severity, text, &c->message_file);
}

// Prints a message and records it. Returns its text, allocated in the session.
static const char *print_message(Cli *c, const char *severity, const char *format, va_list args)
{
    va_list again;
    char *text;
    int n;
    Buf out;

    va_copy(again, args);
    n = vsnprintf(NULL, 0, format, again);
    va_end(again);
    text = arena_alloc(&c->session.arena, (size_t)n + 1);
    vsnprintf(text, (size_t)n + 1, format, args);
    buf_init(&out, &c->session.arena);
    put_plain_message(console_format(c), severity, text, &out);
    fputs(buf_text(&out), stderr);
    cli_record_message(c, severity, text);
    return text;
}

void cli_print_error(Cli *c, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    c->last_error = print_message(c, "error", format, args);
    va_end(args);
}

void cli_print_warning(Cli *c, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    print_message(c, "warning", format, args);
    va_end(args);
}

void cli_print_note(Cli *c, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    print_message(c, "note", format, args);
    va_end(args);
}

// Returns a name for use in a message, with control characters as \x0a; no file with such a name is ever opened. cli_usage_error calls this
// itself.
const char *cli_printable_name(Arena *a, const char *name)
{
    Buf out;

    if (os_is_name(name))
        return name;
    buf_init(&out, a);
    for (; *name; name++)
        if ((unsigned char)*name < 0x20 || *name == 0x7F)
            buf_printf(&out, "\\x%02x", (unsigned)(unsigned char)*name);
        else
            buf_char(&out, *name);
    return buf_text(&out);
}

int cli_usage_error(Cli *c, const char *format, ...)
{
    char sentence[5000];
    va_list args;

    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    fprintf(stderr, "smc: %s\n", cli_printable_name(&c->session.arena, sentence));
    if (c->command)
        fprintf(stderr, "Try 'smc %s --help'.\n", c->command->name);
    else
        fputs("Try 'smc --help'.\n", stderr);
    return EXIT_USAGE;
}

static int write_files(Cli *c, const OsOutput *out, size_t n)
{
    const char *path, *why;

    if (os_write_files(out, n, &path, &why))
        return EXIT_OK;
    cli_print_error(c, TEXT_cannot_write, strcmp(path, "-") == 0 ? "standard output" : cli_printable_name(&c->session.arena, path), why);
    return EXIT_ENVIRONMENT;
}

// Writes outputs, after outputs_check.  Returns EXIT_OK, or the exit code after a message: then no file has been replaced.
int cli_write_outputs(Cli *c, const OsOutput *out, size_t n)
{
    const int code = outputs_check(c, out, n);

    return code == EXIT_OK ? write_files(c, out, n) : code;
}

// Writes an edited file over its input, without outputs_check.
int cli_write_edited(Cli *c, const OsOutput *out)
{
    const bool has_other_names = os_has_other_names(out->path);
    const int code = write_files(c, out, 1);

    if (code == EXIT_OK && has_other_names)
        cli_print_note(c, TEXT_hard_link, out->path);
    return code;
}

int cli_write_generated(Cli *c, const OsOutput *out) { return write_files(c, out, 1); }

// Prints to standard output (1) or error (2).  Returns false if that failed, for standard output after a message.
bool cli_print(Cli *c, int fd, const Buf *text)
{
    const char *why;

    if (os_print(fd, buf_text(text), text->n, &why))
        return true;
    if (fd == 1)
        cli_print_error(c, TEXT_cannot_print, why);
    return false;
}

static bool wants_color(const Cli *c)
{
    const char *when = c->given[OPT_COLOR] ? c->value[OPT_COLOR] : "auto", *force;

    if (strcmp(when, "auto") != 0)
        return strcmp(when, "always") == 0;
    if (os_getenv("NO_COLOR"))
        return false;
    if ((force = os_getenv("CLICOLOR_FORCE")) != NULL && strcmp(force, "0") != 0)
        return true;
    return os_shows_colors(2);
}

static void append_diagnostics(const Diags *d, MessageFormat format, const DiagStyle *style, Buf *out)
{
    if (format == MESSAGE_TEXT)
        diags_render_text(d, style, out);
    else if (format == MESSAGE_JSON)
        diags_render_json(d, out);
}

// Adds the session's diagnostics to those that have been reported.
static void record_diagnostics(Cli *c)
{
    const Diags *d = &c->session.diags;
    const DiagStyle plain = {false, 0};

    for (size_t i = 0; i < d->list.n; i++)
        vec_push(&c->session.arena, &c->reported.list, d->list.at[i]);
    for (size_t i = 0; i < d->allowed.n; i++)
        vec_push(&c->session.arena, &c->reported.allowed, d->allowed.at[i]);
    if (c->given[OPT_MESSAGE_FILE])
        append_diagnostics(d, file_format(c), &plain, &c->message_file);
}

// Prints the session's diagnostics to standard error, as -W… selects them, and empties the list.  Returns the exit code that they require.
int cli_print_diagnostics(Cli *c)
{
    Diags *d = &c->session.diags;
    const DiagStyle style = {wants_color(c), 20};
    Buf out;
    int code;

    diags_apply_allows(d);
    diags_select(d, &c->warn);
    diags_sort(d);
    diags_fold(d);
    buf_init(&out, &c->session.arena);
    append_diagnostics(d, console_format(c), &style, &out);
    record_diagnostics(c);
    code = d->errors ? EXIT_PROBLEM : EXIT_OK;
    if (!cli_print(c, 2, &out) && !code)
        code = EXIT_ENVIRONMENT;
    diags_clear(d);
    return code;
}

static int write_message_file(Cli *c, const Buf *document)
{
    const Buf *text = file_format(c) == MESSAGE_SARIF ? document : &c->message_file;
    const OsOutput file = {c->value[OPT_MESSAGE_FILE], buf_text(text), text->n};

    return cli_write_outputs(c, &file, 1);
}

// Prints a SARIF document of all messages, and writes the file that --message-file names. code: the exit code so far; returns it, or that of a
// failure.
int cli_finish(Cli *c, int code)
{
    const bool prints_sarif = console_format(c) == MESSAGE_SARIF, writes_file = c->given[OPT_MESSAGE_FILE];
    int written = EXIT_OK;
    Buf document;

    if ((!prints_sarif && !writes_file) || code == EXIT_USAGE)
        return code;
    buf_init(&document, &c->session.arena);
    diags_render_sarif(&c->reported, &c->plain, SMC_VERSION, &document);
    if (prints_sarif && !cli_print(c, 2, &document))
        written = EXIT_ENVIRONMENT;
    if (writes_file)
        written = write_message_file(c, &document);
    return code != EXIT_OK ? code : written;
}

bool has_suffix(const char *path, const char *suffix)
{
    size_t n = strlen(path), m = strlen(suffix);
    return n >= m && strcmp(path + n - m, suffix) == 0;
}

// Whether the value of an option is "-", which is standard output.
bool cli_is_standard_output(const Cli *c, OptionId id) { return c->given[id] && strcmp(c->value[id], "-") == 0; }

// ---- formats ----

// Whether the path ends in one of the suffixes of a format.
static bool has_format_suffix(const char *path, const CliFormat *f)
{
    for (size_t i = 0; i < sizeof f->suffix / sizeof *f->suffix && f->suffix[i]; i++)
        if (has_suffix(path, f->suffix[i]))
            return true;
    return false;
}

// Reports a --format that the command cannot write. Always returns false, the result of cli_choose_format.
static bool report_unknown_format(Cli *c, const CliFormat *format, size_t formats)
{
    Buf list;

    buf_init(&list, &c->session.arena);
    for (size_t i = 0; i < formats; i++)
        buf_printf(&list, "%s%s", i == 0 ? "" : i + 1 < formats ? ", " : " or ", format[i].name);
    cli_usage_error(c, TEXT_format_values, buf_text(&list), c->value[OPT_AS]);
    return false;
}

// Refuses an output name such as x.pdf: programs that open it would report the file as damaged. Returns whether it printed a message.
static bool report_foreign_suffix(Cli *c, const CliFormat *format, size_t formats)
{
    static const char *const foreign[] = {".pdf", ".png", ".jpg", ".jpeg", ".gif", ".docx", ".doc", ".xlsx", ".pptx"};
    const char *path = c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "";
    Buf list;
    size_t f = 0;

    while (f < sizeof foreign / sizeof *foreign && !has_suffix(path, foreign[f]))
        f++;
    if (f == sizeof foreign / sizeof *foreign)
        return false;
    buf_init(&list, &c->session.arena);
    for (size_t i = 0; i < formats; i++)
        buf_printf(&list, "%s%s", i == 0 ? "" : i + 1 < formats ? ", " : " or ", format[i].suffix[0]);
    cli_usage_error(c, TEXT_foreign_ending, path, foreign[f], buf_text(&list));
    return true;
}

// Refuses to flood a terminal if neither an output nor a format is given. Returns whether it printed a message.
static bool report_flooded_terminal(Cli *c, const CliFormat *format)
{
    if (c->given[OPT_OUTPUT] || !format->viewer || !os_is_terminal(1))
        return false;
    cli_usage_error(c, TEXT_not_for_terminal, format->viewer, path_stem(c, c->file[0]), format->suffix[0]);
    return true;
}

// Stores the index of the format that --format names, or else the suffix of the -o name.  Returns false after a message.
bool cli_choose_format(Cli *c, const CliFormat *format, size_t formats, size_t *found)
{
    *found = 0;
    for (size_t i = 0; i < formats; i++)
        if (c->given[OPT_AS] ? strcmp(c->value[OPT_AS], format[i].name) == 0
                             : c->given[OPT_OUTPUT] && has_format_suffix(c->value[OPT_OUTPUT], &format[i])) {
            *found = i;
            return true;
        }
    return c->given[OPT_AS] ? report_unknown_format(c, format, formats)
                            : !report_foreign_suffix(c, format, formats) && !report_flooded_terminal(c, format);
}

// ---- names ----

// Returns a file's name without folders and ending: "tank" for "dir/tank.sm", "stdin" for "-".
const char *path_stem(Cli *c, const char *path)
{
    const char *start = path_file_name(path), *dot = strrchr(start, '.');

    if (strcmp(path, "-") == 0 || strcmp(path, "<stdin>") == 0)
        return "stdin";
    return format_in(&c->session.arena, "%.*s", (int)(dot && dot != start ? (size_t)(dot - start) : strlen(start)), start);
}

// Reads a whole number.  Returns false if the text is anything else, or 64 bits cannot hold it.
bool cli_read_whole(const char *text, uint64_t *number)
{
    const char *digit = text;

    for (*number = 0; *digit >= '0' && *digit <= '9'; digit++) {
        const uint64_t value = (uint64_t)(*digit - '0');
        if (*number > (UINT64_MAX - value) / 10)
            return false;
        *number = *number * 10 + value;
    }
    return *digit == '\0' && digit > text;
}

// Reads a time such as 400, '4 s' or 250ms, and converts it to units of G (`unit`).
int cli_read_time(Cli *c, const char *text, TimeUnit unit, uint64_t *g)
{
    const size_t digits = strspn(text, "0123456789.");
    const char *after = text + digits + strspn(text + digits, " ");
    const TimeUnit from = *after ? time_unit_find(after) : unit;
    SmF64 x;

    if (from == TIME_NONE || !isdigit((unsigned char)text[0]) || text[digits - 1] == '.' || strchr(text, '.') != strrchr(text, '.') ||
        !time_to_f64(text, digits, from, unit, &x))
        return cli_usage_error(c, TEXT_at_time, text);
    if (!sm_lt(x, sm_from_u64(UINT64_C(1) << 53)) || !sm_eq(sm_from_u64(sm_to_u64(x)), x))
        return cli_usage_error(c, TEXT_at_time_part, text, time_unit_name(unit));
    *g = sm_to_u64(x);
    return EXIT_OK;
}

bool cli_read_count(const char *text, uint64_t *count) { return cli_read_whole(text, count) && *count > 0; }

bool cli_read_limit(Cli *c, OptionId id, const char *spelling, uint64_t most, uint64_t *count)
{
    const char *text = c->value[id];

    if (!c->given[id] || (cli_read_count(text, count) && *count <= most))
        return true;
    if (*text != '\0' && text[strspn(text, "0123456789")] == '\0' && strspn(text, "0") < strlen(text))
        cli_usage_error(c, TEXT_number_at_most, spelling, (unsigned long long)most, text);
    else
        cli_usage_error(c, TEXT_number_from_1, spelling, text);
    return false;
}

// Reads a percentage from 0 to 100, with up to six digits after the point.  Returns what follows it, or NULL.
const char *cli_read_percent(const char *at, double *percent)
{
    const char *begin = at;
    double scale = 1;
    int digits = 0;

    for (*percent = 0; *at >= '0' && *at <= '9' && digits < 3; at++, digits++)
        *percent = *percent * 10 + (*at - '0');
    if (at == begin)
        return NULL;
    if (*at == '.')
        for (at++, digits = 0; *at >= '0' && *at <= '9' && digits < 6; at++, digits++)
            *percent += (*at - '0') * (scale /= 10);
    return *percent <= 100 ? at : NULL;
}
