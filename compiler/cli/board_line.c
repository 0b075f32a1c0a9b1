// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/board_line.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/base/os_serial.h"

// An Arduino restarts when its serial port is opened, and its boot loader then listens for two seconds. So the first request is repeated
// for up to six seconds: TRIES times WAIT_MS. DEFAULT_SPEED is in bits per second.
enum { WAIT_MS = 500, TRIES = 12, DEFAULT_SPEED = 115200 };

static bool line_send(void *context, const uint8_t *bytes, size_t n)
{
    return os_serial_send(((BoardLine *)context)->fd, bytes, n);
}

static int line_receive(void *context, uint8_t *bytes, size_t room, uint32_t wait)
{
    return os_serial_receive(((BoardLine *)context)->fd, bytes, room, wait);
}

static uint32_t line_now(void *context)
{
    (void)context;
    return os_milliseconds();
}

// ---- messages ----

static const struct { enum { BOARD, APPLICATION } side; SmResult result; const char *text; } refusals[] = {
#define REFUSAL(side, result, text) {side, result, text},
#include "compiler/cli/refusals.def"
#undef REFUSAL
};

// Prints why the last request failed, after `what`: what the host was doing. Returns the exit code.
int board_report_failure(BoardLine *b, const char *what)
{
    const bool is_app = b->is_application;
    const char *why = sm_result_text(b->host.result);

    if (!b->host.answered) {
        const char *gone = is_app ? TEXT_application_gone : TEXT_line_gone, *silent = is_app ? TEXT_application_quiet : TEXT_board_silent;
        cli_print_error(b->c, b->host.gone ? gone : silent, what);
        return EXIT_ENVIRONMENT;
    }
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++)
        if (refusals[i].side == (is_app ? APPLICATION : BOARD) && refusals[i].result == b->host.result)
            why = refusals[i].text;
    cli_print_error(b->c, TEXT_board_refuses, what, why);
    return EXIT_PROBLEM;
}

// Returns why a trial ended (DeviceEnd), as a clause of a sentence.
const char *board_trial_end_text(uint8_t end)
{
    return end == DEVICE_STARTS_USED    ? "it was not confirmed within its starts"
           : end == DEVICE_NOT_RUNNABLE ? "the board cannot run it, as with two pins that are the same"
                                        : "the board stopped it";
}

// Describes an image: its slot, length, checksum and identity, and whether it runs or is on trial.
void board_describe(Buf *out, const DeviceImage *i)
{
    if (i->slot == DEVICE_BUILT_IN)
        buf_str(out, "built in: ");
    else
        buf_printf(out, "slot %u: ", (unsigned)i->slot);
    if (i->state == DEVICE_EMPTY) {
        buf_str(out, i->runs ? "no image; nothing runs" : "no image");
    } else {
        buf_printf(out, "%lu bytes, checksum %08lx, identity ", (unsigned long)i->length, (unsigned long)i->checksum);
        for (size_t k = sizeof i->identity; k-- > 0;)          // most significant byte first, as disasm and report write it
            buf_printf(out, "%02x", i->identity[k]);
        if (i->runs)
            buf_str(out, ", runs");
        if (i->period != 0)
            buf_printf(out, ", every %u ms", (unsigned)i->period);
        if (i->chosen && !i->runs)
            buf_str(out, ", chosen, but does not run before the next start");
        if (i->state == DEVICE_TRIAL)
            buf_printf(out, ", on trial (%u start%s left)", (unsigned)i->starts, i->starts == 1 ? "" : "s");
        else if (i->state == DEVICE_CONFIRMED && i->slot != DEVICE_BUILT_IN)
            buf_str(out, ", confirmed");
        else if (i->state == DEVICE_WHOLE && i->slot != DEVICE_BUILT_IN)
            buf_str(out, i->runs ? ", until the next start" : i->before ? ", runs again if the chosen one does not" : ", not chosen");
        if (i->end != DEVICE_NOT_ENDED)
            buf_printf(out, ", its trial ended: %s", board_trial_end_text(i->end));
    }
    buf_str(out, "\n");
}

// ---- opening ----

// Reads the value of --speed; false if it is not a number.
static bool read_speed(Cli *c, unsigned long *speed)
{
    const char *word = c->given[OPT_SPEED] ? c->value[OPT_SPEED] : NULL;
    char *end;

    *speed = DEFAULT_SPEED;
    if (!word)
        return true;
    *speed = strtoul(word, &end, 10);
    return *end == '\0' && word[0] >= '0' && word[0] <= '9';
}

// Checks that an application has answered whose protocol the host knows.
static int check_application(Cli *c, BoardLine *b, const char *where)
{
    b->is_application = true;
    if (b->app.protocol == LINK_PROTOCOL)
        return EXIT_OK;
    cli_print_error(c, TEXT_link_version, where, (unsigned)b->app.protocol, (unsigned)LINK_PROTOCOL);
    return EXIT_PROBLEM;
}

// Asks the board for its properties. Returns EXIT_OK, or the exit code after a message.
static int query_board(Cli *c, BoardLine *b, const char *port, unsigned long speed)
{
    if (!device_query_info(&b->host, &b->info)) {
        if (b->host.answered && b->host.result == SM_E_UNSUPPORTED && application_query(&b->host, &b->app))
            return check_application(c, b, port);
        cli_print_error(c, b->host.answered ? TEXT_not_a_board : TEXT_no_answer, port, speed);
        return EXIT_ENVIRONMENT;
    }
    if (device_is_usable(&b->info))
        return EXIT_OK;
    cli_print_error(c, TEXT_link_version, port, (unsigned)b->info.protocol, (unsigned)LINK_PROTOCOL);
    return EXIT_PROBLEM;
}

// Opens the line, and sends nothing.
static int open_line(Cli *c, BoardLine *b, const char *where, unsigned long *speed)
{
    const char *why;

    if (!read_speed(c, speed))
        return cli_usage_error(c, TEXT_speed_number, c->value[OPT_SPEED]);
    memset(b, 0, sizeof *b);
    b->c = c;
    if (!os_line_open(where, *speed, &b->fd, &why))
        return cli_print_error(c, TEXT_cannot_open, where, why), EXIT_ENVIRONMENT;
    b->line.context = b;
    b->line.send = line_send;
    b->line.receive = line_receive;
    b->line.now = line_now;
    link_host_init(&b->host, &b->line, WAIT_MS, TRIES, (uint8_t)os_run_nonce());
    return EXIT_OK;
}

// Opens --port and queries the board.  Returns EXIT_OK, or the exit code after a message.
int board_open(Cli *c, BoardLine *b)
{
    unsigned long speed;
    int code;

    if (!c->given[OPT_PORT])
        return cli_usage_error(c, TEXT_port_required, c->command->name);
    if ((code = open_line(c, b, c->value[OPT_PORT], &speed)) != EXIT_OK)
        return code;
    if ((code = query_board(c, b, c->value[OPT_PORT], speed)) != EXIT_OK)
        board_close(b);
    return code;
}

int application_open(Cli *c, BoardLine *b, const char *where)
{
    unsigned long speed;
    int code = open_line(c, b, where, &speed);

    if (code != EXIT_OK)
        return code;
    if (application_query(&b->host, &b->app)) {
        code = check_application(c, b, where);
    } else {
        cli_print_error(c, b->host.answered ? TEXT_not_an_application : TEXT_application_silent, where);
        code = b->host.answered ? EXIT_PROBLEM : EXIT_ENVIRONMENT;
    }
    if (code != EXIT_OK)
        board_close(b);
    return code;
}

void board_close(BoardLine *b) { os_serial_close(b->fd); }
