// SPDX-License-Identifier: Apache-2.0
// smc device: lists what a board runs and reports.
#include <stdlib.h>
#include <string.h>

#include "compiler/cli/app_view.h"
#include "compiler/cli/device_parameters.h"

// ---- info and list ----

static int list_images(BoardLine *b, Buf *out)
{
    DeviceImage image;

    for (uint8_t i = 0; i <= b->info.slots; i++) {
        if (!device_read_image_info(&b->host, i < b->info.slots ? i : DEVICE_BUILT_IN, &image))
            return board_report_failure(b, "asking what is there");
        board_describe(out, &image);
    }
    return EXIT_OK;
}

static int show_info(BoardLine *b, Buf *out)
{
    const DeviceInfo *i = &b->info;
    DeviceImage trial;
    bool is_on_trial;

    buf_printf(out, "%u slot%s of %lu bytes, %lu bytes of RAM for machines", (unsigned)i->slots, i->slots == 1 ? "" : "s",
               (unsigned long)i->slot_size, (unsigned long)i->ram);
    if (i->longest)
        buf_printf(out, ", steps of up to %lu instructions", (unsigned long)i->longest);
    buf_str(out, "\n");
    if (i->reports_limits) {
        if (i->machines != 0)
            buf_printf(out, "at most %u machines, ", (unsigned)i->machines);
        buf_str(out, i->windows ? "with rolling windows" : "without rolling windows");
        buf_str(out, i->parameters ? "" : ", without parameters");
        if (i->period != 0)
            buf_printf(out, ", a step every %u ms", (unsigned)i->period);
        if (i->cycles != 0)
            buf_printf(out, ", of up to %u cycles in each of them", (unsigned)i->cycles);
        buf_str(out, "\n");
    }
    if (i->requires_signature) {
        buf_str(out, "takes signed images only");
        if (i->reports_mark)
            buf_printf(out, ", with key %08lx", (unsigned long)i->mark);
        buf_printf(out, ", with numbers above %lu\n", (unsigned long)i->newest);
    }
    is_on_trial = device_find_trial_image(&b->host, i, &trial);
    if (i->may != SM_OK)
        buf_printf(out, "no update may begin: %s\n", sm_result_text(i->may));
    else if (is_on_trial)
        buf_printf(out, "no update may begin: image %08lx is on trial; 'smc device confirm' keeps it, 'smc device erase %08lx' gives it up\n",
                   (unsigned long)trial.checksum, (unsigned long)trial.checksum);
    else
        buf_str(out, "an update may begin\n");
    if (!b->host.answered || b->host.result != SM_OK)
        return board_report_failure(b, "asking what is on trial");
    return list_images(b, out);
}

// ---- confirm and erase ----

// Reports the trial that has ended, if there is one: then the image that the user wants to confirm no longer runs.
static void report_ended_trial(BoardLine *b)
{
    DeviceImage image;

    if (device_find_ended_trial(&b->host, &b->info, &image))
        cli_print_error(b->c, TEXT_trial_ended, (unsigned long)image.checksum, board_trial_end_text(image.end));
}

static int confirm_image(BoardLine *b, Buf *out)
{
    DeviceImage image, trial;

    if (!device_find_running_image(&b->host, &b->info, &image))
        return board_report_failure(b, "asking what runs");
    if (image.slot == DEVICE_BUILT_IN) {
        cli_print_error(b->c, TEXT_nothing_to_confirm);
        report_ended_trial(b);
        if (device_find_trial_image(&b->host, &b->info, &trial))
            board_describe(out, &trial);
        return EXIT_PROBLEM;
    }
    if (!image.chosen || (image.state == DEVICE_CONFIRMED && b->info.may == SM_OK)) {
        cli_print_error(b->c, image.chosen ? TEXT_already_confirmed : TEXT_image_not_selected);
        if (image.chosen)
            report_ended_trial(b);
        board_describe(out, &image);
        return EXIT_PROBLEM;
    }
    if (!device_confirm_image(&b->host, image.checksum) || !device_read_image_info(&b->host, image.slot, &image))
        return board_report_failure(b, "it was not confirmed");
    board_describe(out, &image);
    return EXIT_OK;
}

static int erase_image(BoardLine *b, Buf *out)
{
    const char *word = b->c->file[1];
    const uint32_t checksum = (uint32_t)strtoul(word, NULL, 16);
    bool was_in_slot = false, runs = false;
    DeviceImage image;
    int code;

    for (uint8_t i = 0; i < b->info.slots; i++)
        if (device_read_image_info(&b->host, i, &image) && image.state != DEVICE_EMPTY && image.checksum == checksum) {
            was_in_slot = true;
            runs = runs || image.runs;
        }
    if (device_erase_image(&b->host, checksum) || (was_in_slot && b->host.answered && b->host.result == SM_E_MISSING)) {
        // SM_E_MISSING: the first answer was lost, and the request that followed found nothing more to erase.
        code = list_images(b, out);
        if (runs)                        // the board refuses to stop a running machine: only the user knows when it is safe to stop it
            buf_printf(out, "image %s is erased, but it runs until the next start of the board: press its reset button, or switch it off and on\n",
                       word);
        return code;
    }
    if (!b->host.answered || b->host.result != SM_E_MISSING)
        return board_report_failure(b, "it was not erased");
    cli_print_error(b->c, TEXT_no_slot_with, word);
    return EXIT_PROBLEM;
}

// ---- log ----

static const struct { uint8_t kind; const char *name, *source, *a, *b; } kinds[] = {
#define SM_EVENT(name, number, source, a, b, text) {number, #name, source, a, b},
#define SM_EVENT_OF_SWAP SM_EVENT
#include "runtime-c/events.def"
#undef SM_EVENT
};

enum { EVENT = 19, EVENT_HEAD = 8 };      // bytes of an event, and before the first one, in the answer to LINK_EVENTS

// Writes a field of an event by its name in events.def: checksums in hexadecimal, reasons and results with their sentence.
static void write_field(Buf *out, const char *name, unsigned long value)
{
    if (*name == '\0' || (strcmp(name, "reason") == 0 && value == 0))
        return;
    if (strcmp(name, "image") == 0 || strcmp(name, "old image") == 0 || strcmp(name, "swap") == 0)
        buf_printf(out, ", %s %08lx", name, value);
    else if (strcmp(name, "reason") == 0 && value > 0 && value < 256)
        buf_printf(out, ", %s %lu: %s", name, value, application_reason_text((uint8_t)value));
    else if (strcmp(name, "result") == 0 && value > 0 && value < 128)
        buf_printf(out, ", %s %lu: %s", name, value, sm_result_text((SmResult)-(int)value));
    else
        buf_printf(out, ", %s %lu", name, value);
}

// Writes one line for an event of the log. e: its 19 bytes as the device sent them: time in ns, kind, source, two arguments.
static void write_event(Buf *out, const uint8_t *e)
{
    const double seconds = ((double)sm_link_load(e + 4, 4) * 4294967296.0 + (double)sm_link_load(e, 4)) * 1e-9;
    const unsigned long a = sm_link_load(e + 11, 4), b = sm_link_load(e + 15, 4), source = sm_link_load(e + 9, 2);

    buf_printf(out, "%12.6f s  ", seconds);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (kinds[i].kind == e[8]) {
            buf_printf(out, "%s of %s %lu", kinds[i].name, kinds[i].source, source);
            write_field(out, kinds[i].a, a);
            write_field(out, kinds[i].b, b);
            buf_str(out, "\n");
            return;
        }
    buf_printf(out, "event %u of %lu: %lu, %lu\n", (unsigned)e[8], source, a, b);
}

// Maximum number of events that are read. A board stores far fewer. Without this limit, a board that produces events faster than the line
// transfers them would be queried forever.
enum { EVENTS_SHOWN = 1000 };

// Writes a stored transition, after the number of those that were lost before it. t->time counts units of 2^20 ns.
static void write_transition(Buf *out, const LinkTransition *t)
{
    if (t->lost == LINK_LOST_MAX)
        buf_printf(out, "%u or more transitions were not stored\n", (unsigned)t->lost);
    else if (t->lost > 0)
        buf_printf(out, "%u transition%s not stored\n", (unsigned)t->lost, t->lost == 1 ? " was" : "s were");
    buf_printf(out, "%12.3f s  STATE of machine %u, from %u, to %u\n", t->time * 1048576e-9, (unsigned)t->machine, (unsigned)t->from,
               (unsigned)t->to);
}

// Prints the transitions that the board has stored in its slots, also those from before its last restart. Returns false if a request failed.
static bool show_stored_transitions(BoardLine *b, Buf *out)
{
    LinkTransition t[LINK_TRANSITIONS];
    DeviceImage image;
    size_t n, all = 0;

    for (uint8_t slot = 0; slot < b->info.slots; slot++) {
        if (!device_read_image_info(&b->host, slot, &image) || !device_read_transitions(&b->host, &b->info, &image, t, &n))
            return false;
        if (n > 0)
            buf_printf(out, "stored by image %08lx, from earlier starts too:\n", (unsigned long)image.checksum);
        for (size_t i = 0; i < n; i++)
            write_transition(out, &t[i]);
        all += n;
    }
    if (all > 0)
        buf_str(out, "since the last start:\n");
    return true;
}

static int show_log(BoardLine *b, Buf *out)
{
    uint8_t body[4] = {0};
    size_t events, shown = 0;

    if (!b->is_application && !show_stored_transitions(b, out))
        return board_report_failure(b, "reading the stored log");
    do {
        if (!link_request(&b->host, LINK_EVENTS, body, sizeof body) || b->host.result != SM_OK || b->host.n < EVENT_HEAD)
            return board_report_failure(b, "reading events");
        memcpy(body, b->host.body, sizeof body);
        if (sm_link_load(b->host.body + 4, 4) > 0)
            buf_printf(out, "%lu earlier events are gone\n", (unsigned long)sm_link_load(b->host.body + 4, 4));
        events = (b->host.n - EVENT_HEAD) / EVENT;
        for (size_t i = 0; i < events; i++)
            write_event(out, b->host.body + EVENT_HEAD + i * EVENT);
        shown += events;
    } while (events > 0 && shown < EVENTS_SHOWN);
    return EXIT_OK;
}

// ---- all of them ----

// The actions of smc device.  run: the function if a board is at the other end of the line; of_application: if an application is.
static const struct { const char *name; int (*run)(BoardLine *b, Buf *out), (*of_application)(BoardLine *b, Buf *out); } actions[] = {
    {"info", show_info, app_show_info}, {"list", list_images, app_list_machines}, {"confirm", confirm_image, app_confirm_swap},
    {"erase", erase_image, app_refuse_erase}, {"log", show_log, show_log}, {"parameters", device_show_parameters, app_refuse_parameters},
    {"set", device_set_parameters, app_refuse_parameters}};
enum { ACTIONS = sizeof actions / sizeof *actions };

static int run_action(Cli *c, size_t action)
{
    BoardLine b;
    Buf out;
    int code = board_open(c, &b);

    if (code != EXIT_OK)
        return code;
    buf_init(&out, &c->session.arena);
    code = (b.is_application ? actions[action].of_application : actions[action].run)(&b, &out);
    board_close(&b);
    return cli_print(c, 1, &out) || code != EXIT_OK ? code : EXIT_ENVIRONMENT;
}

// Returns the maximum number of arguments of an action such as "erase"; its name counts as one.
static size_t most_arguments(size_t action)
{
    return actions[action].run == device_set_parameters ? SIZE_MAX : actions[action].run == erase_image ? 2 : 1;
}

int cmd_device(Cli *c)
{
    const char *names[ACTIONS], *near;

    for (size_t i = 0; i < ACTIONS; i++)
        names[i] = actions[i].name;
    if (c->files == 0)
        return cli_usage_error(c, TEXT_device_what);
    // Checked before the line is opened, because opening it can restart a board.
    if (strcmp(c->file[0], "erase") == 0 &&
        (c->files != 2 || strlen(c->file[1]) != 8 || strspn(c->file[1], "0123456789abcdefABCDEF") != 8))
        return cli_usage_error(c, TEXT_erase_what);
    if (strcmp(c->file[0], "set") != 0 && (c->given[OPT_CONFIRM] || c->given[OPT_DRY_RUN]))
        return cli_usage_error(c, TEXT_device_set_options, c->file[0]);
    for (size_t i = 0; i < ACTIONS; i++)
        if (strcmp(c->file[0], names[i]) == 0 && c->files <= most_arguments(i))
            return actions[i].run == device_set_parameters && !device_check_settings(c) ? EXIT_USAGE : run_action(c, i);
    near = str_nearest(c->file[0], names, ACTIONS);
    return near && strcmp(near, c->file[0]) == 0 ? cli_usage_error(c, TEXT_device_extra, near)
           : near ? cli_usage_error(c, TEXT_device_action_near, c->file[0], near)
                  : cli_usage_error(c, TEXT_device_action, c->file[0]);
}
