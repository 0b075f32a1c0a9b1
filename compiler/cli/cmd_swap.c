// SPDX-License-Identifier: Apache-2.0
// smc swap: replaces machines of an application that runs. Compiles sources, sends all images as one swap, and reports what became of it.
#include <string.h>
#include <time.h>

#include "bytecode-vm/swap.h"
#include "compiler/base/os_serial.h"
#include "compiler/base/path.h"
#include "compiler/cli/app_view.h"
#include "compiler/device/sign.h"

enum { MOST_MACHINES = 255, POLL_MS = 20 };
static const char built_in[] = "built-in";            // instead of a file: the machine with which the application was built

typedef VEC(ApplicationChange) Changes;

// ---- what to send ----

// Splits the argument NAME=FILE and returns the name of the machine. Without NAME=, it is the name of the file.
static const char *split_name(Cli *c, const char *argument, const char **file)
{
    const char *equals = strchr(argument, '='), *slash = strchr(argument, '/');

    *file = equals && (!slash || equals < slash) ? equals + 1 : argument;
    return *file == argument ? path_stem(c, argument) : format_in(&c->session.arena, "%.*s", (int)(equals - argument), argument);
}

static int check_names(Cli *c, const Changes *all)
{
    if (all->n > MOST_MACHINES)
        return cli_usage_error(c, TEXT_swap_count, (unsigned)MOST_MACHINES);
    for (size_t i = 0; i < all->n; i++) {
        const size_t n = strlen(all->at[i].machine);
        if (n == 0 || n >= SM_SWAP_NAME)
            return cli_usage_error(c, TEXT_swap_name, all->at[i].machine);
        for (size_t k = 0; k < i; k++)
            if (strcmp(all->at[i].machine, all->at[k].machine) == 0)
                return cli_usage_error(c, TEXT_swap_twice, all->at[i].machine);
    }
    return EXIT_OK;
}

static int check_arguments(Cli *c)
{
    if (c->files == 0)
        return cli_usage_error(c, TEXT_swap_what);
    if (!c->given[OPT_TO])
        return cli_usage_error(c, TEXT_swap_to);
    if (c->given[OPT_CONTINUE] && c->given[OPT_RESTART])
        return cli_usage_error(c, TEXT_swap_modes);
    if (!c->given[OPT_CONTINUE] && !c->given[OPT_RESTART])
        return cli_usage_error(c, TEXT_swap_mode);
    if (c->given[OPT_RESTART] && c->value[OPT_RESTART] && strlen(c->value[OPT_RESTART]) >= SM_SWAP_NAME)
        return cli_usage_error(c, TEXT_swap_name, c->value[OPT_RESTART]);
    return EXIT_OK;
}

// What all machines of a swap are compiled with.
typedef struct Surroundings {
    const Source *vector;             // the state vector of --sv; or NULL
    const MachineInstance *bindings;  // the bindings of --bind; or NULL
    const CompileApp *app;            // the application of --app, which has bindings for each machine; or NULL
} Surroundings;

// Reads the application that --app names, and its state vector.
static int read_app(Cli *c, Surroundings *around)
{
    CompileApp *app = ARENA_NEW(&c->session.arena, CompileApp);
    const char *path = c->value[OPT_APP];
    const Source *src = cli_read_source(c, path);
    int code;

    if (!src)
        return EXIT_ENVIRONMENT;
    compile_open_app(&c->session, src, app);
    if ((code = cli_print_diagnostics(c)) != EXIT_OK)
        return code;
    around->app = app;
    for (size_t i = 0; i < app->files.n; i++)
        if (app->files.at[i].kind == FILE_SV)
            around->vector = cli_read_source(c, path_beside(&c->session.arena, path, app->files.at[i].name.text->text));
    return around->vector ? EXIT_OK : EXIT_ENVIRONMENT;
}

// Reads what machines are compiled with: the application of --app, or the state vector of --sv and the bindings of --bind.
static int read_surroundings(Cli *c, Surroundings *out)
{
    *out = (Surroundings){NULL, NULL, NULL};
    if (c->given[OPT_APP])
        return c->given[OPT_SV] || c->given[OPT_BIND] ? cli_usage_error(c, TEXT_swap_app_alone) : read_app(c, out);
    if (c->given[OPT_SV] && !(out->vector = cli_read_source(c, c->value[OPT_SV])))
        return EXIT_ENVIRONMENT;
    return cli_read_bindings(c, c->files, &out->bindings);
}

// Finds the bindings that the application has for machine `name`; *out is NULL if the application has no bindings for it.
static int find_bindings(Cli *c, const Surroundings *around, const char *name, const MachineInstance **out)
{
    const AppFiles *files = around->app ? &around->app->files : NULL;
    MachineInstance *instance = ARENA_NEW(&c->session.arena, MachineInstance);
    const char *names = "";

    *out = around->bindings;
    if (!files)
        return EXIT_OK;
    for (size_t i = 0; i < files->instances; i++) {
        const AstAppTask *task = files->instance[i].task;
        names = format_in(&c->session.arena, "%s%s%s", names, *names ? ", " : "", task->name.text->text);
        if (strcmp(task->name.text->text, name) != 0)
            continue;
        *instance = (MachineInstance){task->name.text, task->name.span, task->bindings.at, task->bindings.n, false};
        *out = task->bindings.n ? instance : NULL;
        return EXIT_OK;
    }
    cli_print_error(c, TEXT_swap_app_machine, cli_printable_name(&c->session.arena, c->value[OPT_APP]), name, *names ? names : "none");
    return EXIT_PROBLEM;
}

// Compiles a machine to an image with names: without names it could not continue.
static int compile_machine(Cli *c, const char *path, const Surroundings *around, ApplicationChange *out)
{
    CompileInput in = {0};
    CompileSource source = {0};
    CompileOptions o;
    Compiled made;
    bool ok;
    int code;

    if ((code = find_bindings(c, around, out->machine, &in.instance)) != EXIT_OK)
        return code;
    if ((source.text = cli_read_source(c, path)) == NULL)
        return EXIT_ENVIRONMENT;
    source.kind = FILE_SM;
    in.at = &source;
    in.n = 1;
    in.vector = around->vector;
    if (!cli_compile_options(c, &o))
        return EXIT_USAGE;
    o.emit = EMIT_BYTECODE;
    o.names = true;
    ok = compile_sources(&c->session, &in, &o, &made);
    if ((code = cli_print_diagnostics(c)) != EXIT_OK || !ok)
        return code != EXIT_OK ? code : EXIT_PROBLEM;
    out->image = (const uint8_t *)made.artefact.at[0].bytes->at;
    out->size = (uint32_t)made.artefact.at[0].bytes->n;
    return EXIT_OK;
}

static int load_image(Cli *c, const char *path, ApplicationChange *out)
{
    SmvmVerdict v;
    Source *image;
    const int code = cli_load_image(c, path, &image, &v);

    if (code != EXIT_OK)
        return code;
    out->image = (const uint8_t *)image->text;
    out->size = (uint32_t)image->len;
    return EXIT_OK;
}

// Loads the image that replaces a machine: compiles a .sm, or reads a .smb. NAME=built-in (`is_named`) has none. Returns EXIT_OK, or the exit
// code after a message.
static int load_change(Cli *c, const char *file, bool is_named, const Surroundings *around, ApplicationChange *out)
{
    if (is_named && strcmp(file, built_in) == 0)
        return EXIT_OK;
    if (has_suffix(file, ".sm"))
        return compile_machine(c, file, around, out);
    return has_suffix(file, ".smb") ? load_image(c, file, out) : cli_usage_error(c, TEXT_swap_file, file);
}

// Reads or compiles every file that the command line names.
static int load_changes(Cli *c, Changes *all)
{
    Surroundings around;
    int code = read_surroundings(c, &around);

    for (size_t i = 0; i < c->files && code == EXIT_OK; i++) {
        ApplicationChange change = {0};
        const char *file;
        change.machine = split_name(c, c->file[i], &file);
        change.mode = c->given[OPT_CONTINUE] ? SM_SWAP_CONTINUE : SM_SWAP_RESTART;
        change.state = c->given[OPT_RESTART] ? c->value[OPT_RESTART] : NULL;
        code = load_change(c, file, file != c->file[i], &around, &change);
        vec_push(&c->session.arena, all, change);
    }
    return code == EXIT_OK ? check_names(c, all) : code;
}

// ---- what the application has ----

// The machines of the application that the changes of a swap name.
typedef struct Target {
    uint16_t *number;         // by change: the number of its machine in the application
    ApplicationMachine *machine;      // by change: the machine before the swap
} Target;

// Finds the machine of a change.  Adds the names of all machines that can be swapped to `names`.
static int find_machine(BoardLine *b, const char *name, uint16_t *number, ApplicationMachine *found, Buf *names)
{
    ApplicationMachine m;

    for (uint16_t i = 0; i < b->app.machines; i++) {
        if (!application_read_machine(&b->host, i, &m))
            return board_report_failure(b, "asking for the machines");
        if (m.can_swap)
            buf_printf(names, "%s%s", names->n ? ", " : "", m.name);
        if (strcmp(m.name, name) == 0) {
            *number = i;
            *found = m;
        }
    }
    return EXIT_OK;
}

// Finds the machine of every change in the application.  An unknown name is reported before anything is sent.
static int find_machines(BoardLine *b, const Changes *all, Target *t)
{
    Arena *arena = &b->c->session.arena;

    t->number = ARENA_ARRAY(arena, uint16_t, all->n);
    t->machine = ARENA_ARRAY(arena, ApplicationMachine, all->n);
    for (size_t i = 0; i < all->n; i++) {
        Buf names;
        int code;
        buf_init(&names, arena);
        if ((code = find_machine(b, all->at[i].machine, &t->number[i], &t->machine[i], &names)) != EXIT_OK)
            return code;
        if (t->machine[i].can_swap)
            continue;
        cli_print_error(b->c, *t->machine[i].name ? TEXT_swap_fixed : TEXT_swap_no_machine, all->at[i].machine, names.n ? buf_text(&names) : "none");
        return EXIT_PROBLEM;
    }
    return EXIT_OK;
}

// ---- what is kept ----

// Lists which states, locals and windows machine `number` took over from its predecessor, and which it did not.
static bool describe_kept(BoardLine *b, uint16_t number, Buf *out)
{
    static const char *const kind[] = {"state", "local", "window"}, *const fate[] = {"kept", "added", "removed", "changed"};
    Buf items[4];
    ApplicationItem item;

    for (int i = 0; i < 4; i++)
        buf_init(&items[i], &b->c->session.arena);
    for (uint32_t i = 0; application_read_item(&b->host, number, i, &item); i++)
        if (item.kind < 3 && item.fate < 4)
            buf_printf(&items[item.fate], "%s%s %s", items[item.fate].n ? ", " : "", kind[item.kind], item.name);
    for (int i = 0; i < 4; i++)
        if (items[i].n > 0)
            buf_printf(out, "  %-8s %s\n", fate[i], buf_text(&items[i]));
    return b->host.answered && b->host.result == SM_E_MISSING;
}

// Writes a line for each exchanged machine: the new image, the old one, and whether the machine continues or restarts.
static int describe_exchange(BoardLine *b, const Changes *all, const Target *t, Buf *out)
{
    ApplicationMachine now;

    for (size_t i = 0; i < all->n; i++) {
        if (!application_read_machine(&b->host, t->number[i], &now))
            return board_report_failure(b, "asking for the machines");
        buf_printf(out, "%s: %s %08lx replaces %08lx, and %s%s%s\n", all->at[i].machine, all->at[i].size ? "image" : "the built-in image",
                   (unsigned long)now.checksum, (unsigned long)t->machine[i].checksum, all->at[i].mode == SM_SWAP_CONTINUE ? "continues" : "restarts",
                   all->at[i].state ? " in " : "", all->at[i].state ? all->at[i].state : "");
        if (all->at[i].mode == SM_SWAP_CONTINUE && !describe_kept(b, t->number[i], out))
            return board_report_failure(b, "asking what is kept");
    }
    return EXIT_OK;
}

// ---- the swap ----

static int report_refused_swap(BoardLine *b, const ApplicationSwap *s)
{
    ApplicationMachine m;

    if (s->machine != UINT16_MAX && application_read_machine(&b->host, s->machine, &m))
        cli_print_error(b->c, TEXT_swap_refused_machine, m.name, application_reason_text(s->reason));
    else
        cli_print_error(b->c, TEXT_swap_refused, application_reason_text(s->reason));
    if (s->reason == SM_SWAP_NO_LAYOUT && !b->c->given[OPT_SV] && !b->c->given[OPT_APP])
        cli_print_error(b->c, TEXT_swap_vector);
    return EXIT_PROBLEM;
}

// Waits while the swap is in phase `from` or one between it and `to`. Stores its state in *s.
static int wait_for_phase(BoardLine *b, uint32_t checksum, SmSwapPhase from, SmSwapPhase to, ApplicationSwap *s)
{
    for (;;) {
        uint32_t start = os_milliseconds();
        if (!application_read_swap(&b->host, s))
            return board_report_failure(b, "waiting for the swap");
        if (s->checksum != checksum) {
            cli_print_error(b->c, TEXT_swap_other);
            return EXIT_PROBLEM;
        }
        if (s->phase < (uint8_t)from || s->phase > (uint8_t)to)
            return EXIT_OK;
        while (os_milliseconds() - start < POLL_MS) {
            uint8_t late;
            if (os_serial_receive(b->fd, &late, 1, POLL_MS) < 0)
                break;
        }
    }
}

// Reports whether all machines of a confirmed swap run again after a restart.
static int describe_confirmed(BoardLine *b, const Changes *all, const Target *t, Buf *out)
{
    bool is_stored = true;

    for (size_t i = 0; i < all->n; i++) {
        ApplicationMachine now;
        if (!application_read_machine(&b->host, t->number[i], &now))
            return board_report_failure(b, "asking for the machines");
        is_stored = is_stored && (now.is_built_in || now.is_stored);
    }
    buf_str(out, is_stored ? "confirmed; it also runs after a restart of the application\n"
                           : "confirmed until the application ends: its .app has no 'swap_store', so after a restart the built-in machine runs\n");
    return EXIT_OK;
}

// Reports how the trial continues or has ended.
static int finish_trial(BoardLine *b, const Changes *all, const Target *t, const uint8_t *key, ApplicationSwap *s, Buf *out)
{
    int code = EXIT_OK;

    if (b->c->given[OPT_CONFIRM] && s->phase == SM_SWAP_TRIAL && !application_confirm(&b->host, s, key))
        return board_report_failure(b, "it runs, but was not confirmed");
    if (b->c->given[OPT_CONFIRM] || b->c->given[OPT_WAIT])
        code = wait_for_phase(b, s->checksum, SM_SWAP_TRIAL, SM_SWAP_TRIAL, s);
    if (code != EXIT_OK)
        return code;
    if (s->phase == SM_SWAP_RETURNED) {
        cli_print_error(b->c, TEXT_swap_returned, app_trial_end_text(s->end));
        return EXIT_PROBLEM;
    }
    if (s->phase != SM_SWAP_TRIAL)
        return describe_confirmed(b, all, t, out);
    buf_printf(out, "on trial: 'smc device confirm --port=%s' keeps it; without that, the old machines return\n", b->c->value[OPT_TO]);
    return EXIT_OK;
}

// Waits until the swap that has been sent has been made or refused, and reports the result. Returns the exit code.
static int follow_swap(BoardLine *b, const Changes *all, const Target *t, uint32_t checksum, const uint8_t *key)
{
    ApplicationSwap s;
    Buf out;
    int code = wait_for_phase(b, checksum, SM_SWAP_PREPARING, SM_SWAP_WAITING, &s);

    if (code != EXIT_OK)
        return code;
    if (s.phase == SM_SWAP_REFUSED)
        return report_refused_swap(b, &s);
    buf_init(&out, &b->c->session.arena);
    code = describe_exchange(b, all, t, &out);
    if (code == EXIT_OK)
        code = finish_trial(b, all, t, key, &s, &out);
    return cli_print(b->c, 1, &out) || code != EXIT_OK ? code : EXIT_ENVIRONMENT;
}

// Chooses the number of a signed swap: the time, or one more than the highest number that was used. Returns false after a message.
static bool choose_number(BoardLine *b, uint32_t *number)
{
    const uint32_t now = sign_number_at((int64_t)time(NULL));

    *number = now > b->app.newest ? now : b->app.newest + 1;
    if (b->app.newest < SIGN_NUMBER_MOST)
        return true;
    cli_print_error(b->c, TEXT_swap_number, (unsigned long)b->app.newest);
    return false;
}

static int send_swap(BoardLine *b, const Changes *all, const Target *t)
{
    static const char *const what[] = {"", "the swap was not begun", "sending", "the swap was not accepted"};      // by ApplicationStep
    uint8_t room[SMVM_KEY];
    const uint8_t *key;
    uint32_t number = 0;
    ApplicationStep step;
    Buf bytes;
    int code = app_load_key(b, room, &key);

    if (code != EXIT_OK)
        return code;
    if (key && !choose_number(b, &number))
        return EXIT_PROBLEM;
    buf_init(&bytes, &b->c->session.arena);
    application_write_swap(all->at, all->n, key, number, &bytes);
    if (bytes.n > b->app.room) {
        cli_print_error(b->c, TEXT_swap_too_large, (unsigned long)bytes.n, (unsigned long)b->app.room);
        return EXIT_PROBLEM;
    }
    step = application_send_swap(&b->host, &b->app, &bytes, key, number, (uint16_t)(os_run_nonce() | 1u));
    if (step != APPLICATION_DONE)
        return board_report_failure(b, what[step]);
    return follow_swap(b, all, t, application_swap_checksum(&bytes), key);
}

int cmd_swap(Cli *c)
{
    Changes all = {0};
    Target t;
    BoardLine b;
    int code;

    if ((code = check_arguments(c)) != EXIT_OK || (code = load_changes(c, &all)) != EXIT_OK)
        return code;
    if ((code = application_open(c, &b, c->value[OPT_TO])) != EXIT_OK)
        return code;
    code = find_machines(&b, &all, &t);
    if (code == EXIT_OK)
        code = send_swap(&b, &all, &t);
    board_close(&b);
    return code;
}
