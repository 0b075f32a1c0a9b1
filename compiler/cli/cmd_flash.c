// SPDX-License-Identifier: Apache-2.0
// smc flash: sends an image to a board over a serial line. The previous image stays selected until the board has received and verified
// the whole new one.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/auth.h"
#include "bytecode-vm/image.h"
#include "compiler/base/os_serial.h"
#include "compiler/budget/cost.h"
#include "compiler/cli/board_line.h"
#include "compiler/cli/key.h"

// The requirements of the image on any computer, its state vector included. The VM's own requirements differ between computers.
typedef struct ImageNeeds { uint32_t ram, longest, machines, windows, cycles; } ImageNeeds;

// The cost of a pin in a step, in cycles of an ATmega: the maximum measured by tests/avr/run_pins.c, rounded up.
enum { DIGITAL_CYCLES = 400, INPUT_CYCLES = 5000, OUTPUT_CYCLES = 5000 };

static void add_pin_needs(const DeviceInfo *info, const Source *image, ImageNeeds *n)
{
    SmvmPins all;
    SmvmPin p;

    (void)smvm_pins((SmvmBytes)image->text, &all);
    while (smvm_next_pin(&all, &p)) {
        n->ram += p.kind & 2 ? info->ram_digital : info->ram_analog;
        n->cycles += p.kind & 2 ? DIGITAL_CYCLES : p.kind & 1 ? OUTPUT_CYCLES : INPUT_CYCLES;
    }
}

static void add_machine_needs(Cli *c, const Source *image, uint32_t i, const SmvmMachine *m, ImageNeeds *n)
{
    Cost cost;

    cost_of_machine(&c->session.arena, (const uint8_t *)image->text, i, COST_CYCLES_EEPROM, &cost);
    n->cycles += cost.worst;
    n->windows += m->windows;
    n->machines++;
    n->ram += i == 0 ? m->sv_size : 0;
    n->ram += smvm_ram_size(m) - ((uint32_t)sizeof(SmVm) + 7) / 8 * 8 - (m->windows * (uint32_t)sizeof(uint64_t *) + 7) / 8 * 8;
}

static ImageNeeds find_image_needs(Cli *c, const DeviceInfo *info, const Source *image, const SmvmVerdict *v)
{
    ImageNeeds n = {0, v->longest, 0, 0, 0};
    SmvmMachine m;

    for (uint32_t i = 0; smvm_machine((SmvmBytes)image->text, i, &m); i++)
        add_machine_needs(c, image, i, &m, &n);
    add_pin_needs(info, image, &n);
    return n;
}

static int refuse_slow_step(Cli *c, const Source *image, uint32_t cycles, uint32_t period, uint32_t most)
{
    const uint32_t wants = (cycles + most - 1) / most;

    cli_print_error(c, TEXT_step_too_slow,
                    image->name, (unsigned long)cycles, (unsigned long)period, (unsigned long)(period * most), (unsigned long)wants);
    return EXIT_PROBLEM;
}

// Checks the limits of the board on sizes and times before anything is sent. Returns EXIT_OK, or the exit code after a message.
static int check_image_fits(Cli *c, const BoardLine *b, const Source *image, const SmvmVerdict *v, uint16_t period)
{
    const DeviceInfo *i = &b->info;
    const ImageNeeds n = find_image_needs(c, i, image, v);
    const uint32_t every = period != 0 ? period : i->period;

    if (image->len > i->slot_size)
        cli_print_error(c, TEXT_image_too_large, image->name, (unsigned long)image->len,
                        (unsigned long)i->slot_size);
    else if (n.ram > i->ram)
        cli_print_error(c, TEXT_ram_too_small, image->name,
                        (unsigned long)n.ram, (unsigned long)i->ram);
    else if (i->longest != 0 && n.longest > i->longest)
        cli_print_error(c, TEXT_step_too_long, image->name,
                        (unsigned long)n.longest, (unsigned long)i->longest);
    else if (i->tells && !i->windows && n.windows > 0)
        cli_print_error(c, TEXT_no_windows, image->name);
    else if (i->machines != 0 && n.machines > i->machines)
        cli_print_error(c, TEXT_too_many_machines, image->name, (unsigned long)n.machines, (unsigned)i->machines);
    else if (i->cycles != 0 && n.cycles > every * i->cycles)
        return refuse_slow_step(c, image, n.cycles, every, i->cycles);
    else
        return EXIT_OK;
    return EXIT_PROBLEM;
}

// ---- pins ----

static int refuse_pin(Cli *c, const Source *image, const SmvmPin *p, const SmvmPin *other)
{
    Buf out;

    buf_init(&out, &c->session.arena);
    cli_write_pin(&out, p);
    if (other) {
        buf_str(&out, " and ");
        cli_write_pin(&out, other);
    }
    cli_print_error(c, other ? TEXT_pins_clash
                     : TEXT_pin_absent,
                    image->name, buf_text(&out));
    return EXIT_PROBLEM;
}

// Queries the board about each pin. An image is not sent if a board of this kind would refuse or ignore one of its pins.
static int check_pins_exist(BoardLine *b, const Source *image)
{
    SmvmPin at[SMVM_NO_PIN] = {{0}};   // by the index of a pin on the board
    bool taken[SMVM_NO_PIN] = {false};
    SmvmPins all;
    SmvmPin p;
    uint8_t index;

    (void)smvm_pins((SmvmBytes)image->text, &all);
    while (smvm_next_pin(&all, &p)) {
        if (!device_find_chip_pin(&b->host, smvm_pin_kind(&p), (uint16_t)p.pin, &index))
            return b->host.answered && b->host.result == SM_E_UNSUPPORTED ? EXIT_OK : board_report_failure(b, "asking about pins");
        if (index == SMVM_NO_PIN || taken[index])
            return refuse_pin(b->c, image, &p, index == SMVM_NO_PIN ? NULL : &at[index]);
        taken[index] = true;
        at[index] = p;
    }
    return EXIT_OK;
}

// ---- what the board accepts now ----

static int check_signature(Cli *c, BoardLine *b, const Source *image)
{
    SmvmAuth a;

    if (!b->info.requires_signature)
        return EXIT_OK;
    if (!smvm_auth_read((SmvmBytes)image->text, &a))
        cli_print_error(c, TEXT_must_sign, image->name);
    else if (b->info.reports_mark && a.mark != b->info.mark)
        cli_print_error(c, TEXT_other_key, image->name, (unsigned long)a.mark, (unsigned long)b->info.mark, image->name);
    else if (a.number <= b->info.newest)
        cli_print_error(c, TEXT_old_number,
                        image->name, (unsigned long)a.number, (unsigned long)b->info.newest, image->name);
    else
        return EXIT_OK;
    return EXIT_PROBLEM;
}

static bool is_same_image(const DeviceImage *there, const Source *image, uint16_t period)
{
    return there->length == image->len && there->checksum == smvm_uint((SmvmBytes)image->text, SMVM_CRC_AT, 4) && there->period == period;
}

// Checks that the board would accept the image. If the board already runs it, or has it on trial, it is not sent and not checked.
static int check_accepted(Cli *c, BoardLine *b, const Source *image, uint16_t period, const DeviceImage *now)
{
    DeviceImage trial;

    if (is_same_image(now, image, period))
        return EXIT_OK;
    if (device_trial(&b->host, &b->info, &trial)) {
        if (is_same_image(&trial, image, period))
            return EXIT_OK;
        cli_print_error(c, TEXT_on_trial,
                        (unsigned long)trial.checksum, (unsigned long)trial.checksum);
        return EXIT_PROBLEM;
    }
    return !b->host.answered ? board_report_failure(b, "asking what is there") : check_signature(c, b, image);
}

// ---- the update ----

typedef struct Progress { uint32_t length; bool shown; } Progress;

static void show_progress(void *context, uint32_t done)
{
    const Progress *p = context;
    const char *why;
    char line[64];

    if (p->shown) {
        snprintf(line, sizeof line, "\r%lu of %lu bytes%s", (unsigned long)done, (unsigned long)p->length,
                 done == p->length ? "\n" : "");
        os_print(2, line, strlen(line), &why);
    }
}

// Reports the state of the previous image after an update that failed before the new one was selected.
static void report_running(BoardLine *b, const DeviceImage *before)
{
    DeviceImage now;

    if (b->info.slots > 1)
        cli_print_error(b->c, TEXT_keeps_previous);
    else if (!b->host.answered || !device_running(&b->host, &b->info, &now))
        cli_print_error(b->c, TEXT_slot_maybe_lost);
    else if (now.slot == before->slot)
        cli_print_error(b->c, TEXT_keeps_previous);
    else
        cli_print_error(b->c, device_image(&b->host, before->slot, &now) && now.chosen
                          ? TEXT_slot_until_start
                          : TEXT_slot_lost);
}

static int report_failure(BoardLine *b, const Update *u, const DeviceImage *before, DeviceStep step)
{
    static const char *const what[] = {
        "", "asking what is there", "the update was not begun", "sending", "the image was not accepted", "reading back",
        "the image was not chosen", "it is chosen, but the restart failed"};
    int code;

    if (step == DEVICE_RUN) {
        cli_print_error(b->c, TEXT_new_not_running);
        return EXIT_PROBLEM;
    }
    if (step == DEVICE_END && b->host.answered && u->rule != 0) {
        cli_print_error(b->c, TEXT_verifier_refuses, (unsigned)u->rule, (unsigned long)u->at,
                        smvm_rule_text(u->rule));
        if (u->rule == SMVM_R_FORMAT)
            cli_print_error(b->c, TEXT_firmware_version);
        code = EXIT_PROBLEM;
    } else {
        code = board_report_failure(b, what[step]);
        if (step == DEVICE_END && b->host.answered && b->host.result == SM_E_MISSING)
            cli_print_error(b->c, TEXT_pin_not_of_board);
    }
    if (step < DEVICE_ACTIVATE)
        report_running(b, before);
    return code;
}

static int report_success(BoardLine *b, const Update *u, const DeviceImage *before)
{
    DeviceImage now;
    Buf out;

    if (!device_running(&b->host, &b->info, &now))
        return board_report_failure(b, "asking what runs");
    buf_init(&out, &b->c->session.arena);
    buf_str(&out, u->was_running ? "it runs already: " : "before: ");
    board_describe(&out, u->was_running ? &now : before);
    if (!u->was_running) {
        buf_str(&out, "now: ");
        board_describe(&out, &now);
    }
    if (now.state == DEVICE_TRIAL)
        buf_printf(&out, "it is on trial: 'smc device confirm --port=%s' keeps it; without that, %s after %u more starts\n",
                   b->c->value[OPT_PORT], b->info.slots > 1 ? "the previous image runs again" : "the built-in image runs", (unsigned)now.starts);
    return cli_print(b->c, 1, &out) ? EXIT_OK : EXIT_ENVIRONMENT;
}

static int send_image(BoardLine *b, const Source *image, uint16_t period, const DeviceImage *before)
{
    Progress p = {(uint32_t)image->len, os_is_terminal(2)};
    Update u;
    DeviceStep step;

    memset(&u, 0, sizeof u);
    u.bytes = (const uint8_t *)image->text;
    u.length = (uint32_t)image->len;
    u.checksum = smvm_uint((SmvmBytes)image->text, SMVM_CRC_AT, 4);
    u.session = (uint16_t)(os_run_nonce() | 1u);
    u.period = period;
    u.progress = show_progress;
    u.context = &p;
    if ((step = device_update(&b->host, &b->info, &u)) != DEVICE_DONE)
        return report_failure(b, &u, before, step);
    if (b->c->given[OPT_CONFIRM] && !device_request_by_checksum(&b->host, LINK_CONFIRM, u.checksum))
        return board_report_failure(b, "it runs, but was not confirmed");
    return report_success(b, &u, before);
}

// Warns about an image that cannot be confirmed as soon as it runs: it starts in a state without @safe (language.md 5.46).
static void warn_of_unsafe_starts(Cli *c, const Source *image)
{
    SmvmMachine m;

    for (uint32_t i = 0; smvm_machine((SmvmBytes)image->text, i, &m); i++)
        if (!smvm_state_is_safe(&m, 1))
            cli_print_error(c, TEXT_unsafe_start, (unsigned long)i + 1, image->name);
}

static void warn_of_no_pins(BoardLine *b, const Source *image)
{
    SmvmPins all;

    if (b->info.ram_digital != 0 && !smvm_pins((SmvmBytes)image->text, &all))
        cli_print_error(b->c, TEXT_no_pins, image->name);
}

// Reports why the board refuses any update now: it is armed, or a machine is not in a safe state. Restarts discard a machine on trial that
// never reaches a safe state.
static int report_refused_update(BoardLine *b)
{
    DeviceImage now;
    int code;

    b->host.result = b->info.may;
    code = board_report_failure(b, "nothing was sent");
    if (b->info.may == SM_E_UNSAFE && device_running(&b->host, &b->info, &now) && now.state == DEVICE_TRIAL)
        cli_print_error(b->c, TEXT_trial_left, (unsigned)now.starts,
                        b->info.slots > 1 ? TEXT_previous_runs : TEXT_built_in_runs);
    return code;
}

static void warn_if_slot_is_overwritten(BoardLine *b, const DeviceImage *now)
{
    if (b->info.slots == 1 && now->slot != DEVICE_BUILT_IN)
        cli_print_error(b->c, TEXT_slot_replaced,
                        (unsigned long)now->checksum);
}

static int flash_image(Cli *c, BoardLine *b, const Source *image, const SmvmVerdict *v, uint16_t period)
{
    DeviceImage now;
    int code = check_image_fits(c, b, image, v, period);

    if (code != EXIT_OK)
        return code;
    if (b->info.may != SM_OK)
        return report_refused_update(b);
    if (!device_running(&b->host, &b->info, &now))
        return board_report_failure(b, "asking what runs");
    if ((code = check_accepted(c, b, image, period, &now)) != EXIT_OK || (code = check_pins_exist(b, image)) != EXIT_OK)
        return code;
    if (!is_same_image(&now, image, period)) {
        warn_of_unsafe_starts(c, image);
        warn_of_no_pins(b, image);
        warn_if_slot_is_overwritten(b, &now);
    }
    if (!c->given[OPT_DRY_RUN])
        return send_image(b, image, period, &now);
    cli_print_error(c, is_same_image(&now, image, period) ? TEXT_runs_already : TEXT_would_send, image->name);
    return EXIT_OK;
}

// Reads the value of --period, "20" or "20ms", in milliseconds; 0 if it is absent. Returns false for any other value.
static bool read_period(Cli *c, uint16_t *period)
{
    const char *word = c->given[OPT_PERIOD] ? c->value[OPT_PERIOD] : NULL;
    unsigned long n;
    char *end;

    *period = 0;
    if (!word)
        return true;
    n = strtoul(word, &end, 10);
    *period = (uint16_t)n;
    return word[0] >= '0' && word[0] <= '9' && n >= 1 && n <= UINT16_MAX && (!*end || strcmp(end, "ms") == 0);
}

// A board reports which key it has. But it detects a modified image only after receiving all of it; a board with one slot has then lost
// its previous image.
static int check_signed_with_key(Cli *c, const Source *image)
{
    uint8_t key[SMVM_KEY];
    const int code = c->given[OPT_KEY] ? key_load(c, key) : EXIT_OK;

    if (code != EXIT_OK || !c->given[OPT_KEY])
        return code;
    return key_check_signature(c, image, key, "; nothing was sent") ? EXIT_OK : EXIT_PROBLEM;
}

int cmd_flash(Cli *c)
{
    uint16_t period;
    BoardLine b;
    Source *image;
    SmvmVerdict v;
    int code;

    if (c->files != 1)
        return cli_usage_error(c, TEXT_flash_what);
    if (has_suffix(c->file[0], ".sm"))
        return cli_usage_error(c, TEXT_flash_source, c->file[0]);
    if (!read_period(c, &period))
        return cli_usage_error(c, TEXT_period_number, c->value[OPT_PERIOD]);
    if ((code = cli_load_image(c, c->file[0], &image, &v)) != EXIT_OK || (code = check_signed_with_key(c, image)) != EXIT_OK ||
        (code = board_open(c, &b)) != EXIT_OK)
        return code;
    code = flash_image(c, &b, image, &v, period);
    board_close(&b);
    return code;
}
