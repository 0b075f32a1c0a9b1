// SPDX-License-Identifier: Apache-2.0
// smc log: shows the contents of a flight log.
#include <stdlib.h>
#include <string.h>

#include "compiler/cli/cli.h"
#include "compiler/report/flight.h"

typedef void WriteFlight(const Flight *f, Buf *out);

static const CliFormat formats[] = {
    {"text", {".txt", NULL, NULL}, NULL}, {"csv", {".csv", NULL, NULL}, NULL}, {"json", {".json", ".jsonl", NULL}, NULL},
    {"svg", {".svg", NULL, NULL}, NULL}};
enum { FORMATS = sizeof formats / sizeof *formats, TEXT = 0, SVG = 3 };

static const uint32_t size_most = 0x7FFFFFFF;

// ---- the file ----

// Reports which parts of the log are damaged or unreadable. Returns EXIT_OK, or EXIT_PROBLEM if the log has no readable session.
static int report_damage(Cli *c, const char *path, const Log *log)
{
    if (log->newer)
        cli_print_note(c, TEXT_log_later, path);
    if (log->session.n == 0) {
        cli_print_error(c, log->size == 0 ? TEXT_log_empty : TEXT_log_not, path);
        return EXIT_PROBLEM;
    }
    if (log->damaged > log->torn)
        cli_print_note(c, TEXT_log_damaged, path, (unsigned long long)log->damaged);
    else if (log->torn)
        cli_print_note(c, TEXT_log_torn, path, (unsigned long long)log->torn);
    if (log->unread)
        cli_print_note(c, TEXT_log_unread, path, (unsigned long long)log->unread);
    return EXIT_OK;
}

// ---- the selected session ----

// Sets f->session to the session that is shown: the one of --session, else the last.  Only for text without --session it stays NULL: all sessions
// are shown.  Returns EXIT_OK, or the exit code after a message.
static int choose_session(Cli *c, Flight *f, size_t format)
{
    const size_t n = f->log->session.n;
    const char *word = c->given[OPT_SESSION] ? c->value[OPT_SESSION] : NULL;
    unsigned long long wanted = n;
    char *end;

    if (word) {
        wanted = strtoull(word, &end, 10);
        if (word[0] < '0' || word[0] > '9' || *end)
            return cli_usage_error(c, TEXT_session_number, word);
    }
    if (wanted < 1 || wanted > n) {
        cli_print_error(c, TEXT_no_session, f->name, word, (unsigned long)n);
        return EXIT_PROBLEM;
    }
    if (word || format != TEXT)
        f->session = f->log->session.at[wanted - 1];
    if (!word && format != TEXT && n > 1)
        cli_print_note(c, TEXT_last_session, f->name, (unsigned long)n);
    return EXIT_OK;
}

static int report_unknown_name(Cli *c, const Flight *f, const char *what, const char *name, const char *const *names, size_t n)
{
    const char *near = str_nearest(name, names, n);

    cli_print_error(c, near ? TEXT_log_name_near : TEXT_log_name, f->name, what, name, near);
    return EXIT_PROBLEM;
}

// Selects the state-vector elements that the arguments after the log name, and the machine that --machine names.
static int choose_elements_and_machine(Cli *c, Flight *f)
{
    const LogSession *last = f->log->session.at[f->log->session.n - 1];
    const LogDescription *d = f->session ? f->session->d : last->d;       // if all sessions are shown, names are those of the last one
    const LogElement **element = ARENA_ARRAY(f->arena, const LogElement *, c->files);
    const char **names = ARENA_ARRAY(f->arena, const char *, d->elements + d->machines + 1);

    for (uint32_t i = 0; i < d->elements; i++)
        names[i] = d->element[i].name;
    for (size_t i = 1; i < c->files; i++)
        if ((element[i - 1] = log_find_element(d, c->file[i])) == NULL)
            return report_unknown_name(c, f, "element", c->file[i], names, d->elements);
    f->element = element;
    f->elements = c->files - 1;
    if (f->elements && !f->session)
        f->session = last;
    for (uint32_t i = 0; i < d->machines; i++)
        names[i] = d->machine[i].name;
    if (!c->given[OPT_MACHINE])
        f->machine = d->machines ? &d->machine[0] : NULL;
    else if ((f->machine = log_find_machine(d, c->value[OPT_MACHINE])) == NULL)
        return report_unknown_name(c, f, "machine", c->value[OPT_MACHINE], names, d->machines);
    return EXIT_OK;
}

// ---- the command ----

static int write_flight(Cli *c, Flight *f, size_t format)
{
    static WriteFlight *const writer[FORMATS] = {flight_write_text, flight_write_csv, flight_write_json, flight_write_svg};
    OsOutput file = {c->given[OPT_OUTPUT] ? c->value[OPT_OUTPUT] : "-", NULL, 0};
    int code;
    Buf out;

    if ((code = report_damage(c, f->name, f->log)) != EXIT_OK || (code = choose_session(c, f, format)) != EXIT_OK ||
        (code = choose_elements_and_machine(c, f)) != EXIT_OK)
        return code;
    if (format == SVG && f->session->records == 0)
        return cli_print_error(c, TEXT_no_record, f->name), EXIT_PROBLEM;
    buf_init(&out, f->arena);
    writer[format](f, &out);
    file.bytes = buf_text(&out);
    file.n = out.n;
    return cli_write_outputs(c, &file, 1);
}

int cmd_log(Cli *c)
{
    const char *why;
    Flight f;
    size_t format, n;
    char *bytes;
    int code;

    if (c->files == 0)
        return cli_usage_error(c, TEXT_log_what);
    if (!cli_choose_format(c, formats, FORMATS, &format))
        return EXIT_USAGE;
    if (!os_read_file(c->file[0], size_most, &bytes, &n, &why)) {
        cli_print_error(c, TEXT_cannot_read, cli_printable_name(&c->session.arena, c->file[0]), why);
        return EXIT_ENVIRONMENT;
    }
    memset(&f, 0, sizeof f);
    f.arena = &c->session.arena;
    f.name = strcmp(c->file[0], "-") == 0 ? "<stdin>" : c->file[0];
    f.log = log_read(f.arena, (const uint8_t *)bytes, (uint32_t)n);       // f.log points into `bytes`, which must live as long
    code = write_flight(c, &f, format);
    os_alloc(NULL, bytes, 0);
    return code;
}
