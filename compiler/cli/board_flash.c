// SPDX-License-Identifier: Apache-2.0
#include "compiler/cli/board_flash.h"

#include <stdio.h>
#include <string.h>

#include "bytecode-vm/permit.h"
#include "compiler/base/os_serial.h"

// ---- why the image is not sent ----

// Reports a pin that the board does not have; with `other`, two pins that the board cannot use together.
static int report_refused_pin(Cli *c, const char *name, const SmvmPin *p, const SmvmPin *other)
{
    Buf out;

    buf_init(&out, &c->session.arena);
    cli_write_pin(&out, p);
    if (other) {
        buf_str(&out, " and ");
        cli_write_pin(&out, other);
    }
    cli_print_error(c, other ? TEXT_pins_clash : TEXT_pin_absent, name, buf_text(&out));
    return EXIT_PROBLEM;
}

// Reports that the board refuses every update now: it is armed, or a machine is not in a safe state. If that machine is on trial and never
// reaches a safe state, restarts end its trial.
static int report_no_update_now(BoardLine *b)
{
    DeviceImage now;
    int code;

    b->host.result = b->info.may;
    code = board_report_failure(b, "nothing was sent");
    if (b->info.may == SM_E_UNSAFE && device_find_running_image(&b->host, &b->info, &now) && now.state == DEVICE_TRIAL)
        cli_print_note(b->c, TEXT_trial_left, (unsigned)now.starts, b->info.slots > 1 ? TEXT_previous_runs : TEXT_built_in_runs);
    return code;
}

// Reports why the image was not sent, and returns the exit code.
static int report_refusal(BoardLine *b, const char *name, FlashRefusal refusal, const FlashImage *image, const FlashCheck *f)
{
    Cli *const c = b->c;
    const DeviceInfo *i = &b->info;
    const ImageNeeds *n = &f->needs;
    const unsigned long available = (unsigned long)f->period * i->cycles;

    switch (refusal) {
    case FLASH_ACCEPTED:
        return EXIT_OK;
    case FLASH_LINK_FAILED:
        return board_report_failure(b, f->asking);
    case FLASH_TOO_LARGE:
        cli_print_error(c, TEXT_image_too_large, name, (unsigned long)image->length, (unsigned long)i->slot_size);
        break;
    case FLASH_RAM_TOO_SMALL:
        cli_print_error(c, TEXT_ram_too_small, name, (unsigned long)n->ram, (unsigned long)i->ram);
        break;
    case FLASH_STEP_TOO_LONG:
        cli_print_error(c, TEXT_step_too_long, name, (unsigned long)n->longest, (unsigned long)i->longest);
        break;
    case FLASH_HAS_WINDOWS:
        cli_print_error(c, TEXT_no_windows, name);
        break;
    case FLASH_HAS_PARAMETERS:
        cli_print_error(c, TEXT_no_parameters, name);
        break;
    case FLASH_CALLS_FUNCTION:
        cli_print_error(c, TEXT_no_function, name, f->function);
        break;
    case FLASH_TOO_MANY_MACHINES:
        cli_print_error(c, TEXT_too_many_machines, name, (unsigned long)n->machines, (unsigned)i->machines);
        break;
    case FLASH_STEP_TOO_SLOW:
        cli_print_error(c, TEXT_step_too_slow, name, (unsigned long)n->cycles, (unsigned long)f->period, available,
                        (unsigned long)(n->cycles + i->cycles - 1) / i->cycles);
        break;
    case FLASH_PIN_ABSENT:
        return report_refused_pin(c, name, &f->pin, NULL);
    case FLASH_PINS_CLASH:
        return report_refused_pin(c, name, &f->pin, &f->other);
    case FLASH_NO_UPDATE_NOW:
        return report_no_update_now(b);
    case FLASH_OTHER_ON_TRIAL:
        cli_print_error(c, TEXT_on_trial, (unsigned long)f->trial.checksum, (unsigned long)f->trial.checksum);
        break;
    case FLASH_NOT_SIGNED:
        cli_print_error(c, TEXT_must_sign, name);
        break;
    case FLASH_OTHER_KEY:
        cli_print_error(c, TEXT_other_key, name, (unsigned long)f->code.mark, (unsigned long)i->mark, name);
        break;
    case FLASH_OLD_NUMBER:
        cli_print_error(c, TEXT_old_number, name, (unsigned long)f->code.number, (unsigned long)i->newest, name);
        break;
    }
    return EXIT_PROBLEM;
}

// ---- the update ----

typedef struct Progress { uint32_t length; bool shown; } Progress;

// Shows how many bytes have been sent: on a terminal, by rewriting one line. `p->shown`: standard error is a terminal.
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

// Reports the step at which an update failed, and whether the previous image remains. `before`: the image that ran before the update. Returns
// the exit code.
static int report_failure(BoardLine *b, const Update *u, const DeviceImage *before, DeviceStep step)
{
    static const char *const previous_text[] = {TEXT_keeps_previous, TEXT_slot_until_start, TEXT_slot_lost, TEXT_slot_maybe_lost};
    static const char *const what[] = {           // by DeviceStep
        "", "asking what is there", "the update was not begun", "sending", "the image was not accepted", "reading back",
        "the image was not chosen", "it is chosen, but the restart failed"};
    int code;

    if (step == DEVICE_RUN) {
        cli_print_error(b->c, TEXT_new_not_running);
        return EXIT_PROBLEM;
    }
    if (step == DEVICE_END && b->host.answered && u->rule != 0) {
        cli_print_error(b->c, TEXT_verifier_refuses, (unsigned)u->rule, (unsigned long)u->at, smvm_rule_text(u->rule));
        if (u->rule == SMVM_R_FORMAT)
            cli_print_note(b->c, TEXT_firmware_version);
        code = EXIT_PROBLEM;
    } else {
        code = board_report_failure(b, what[step]);
        if (step == DEVICE_BEGIN && b->host.answered && b->host.result == SM_E_UNSIGNED && !u->permit)
            cli_print_note(b->c, TEXT_no_permit);
        if (step == DEVICE_END && b->host.answered && b->host.result == SM_E_MISSING)
            cli_print_note(b->c, TEXT_pin_not_of_board);
    }
    if (step < DEVICE_ACTIVATE)
        cli_print_note(b->c, TEXT_sentence, previous_text[flash_find_previous(&b->host, &b->info, before)]);
    return code;
}

// Prints which image ran before the update and which one runs now.
static int report_success(BoardLine *b, const Update *u, const DeviceImage *before)
{
    DeviceImage now;
    Buf out;

    if (!device_find_running_image(&b->host, &b->info, &now))
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

static int send_image(BoardLine *b, const FlashImage *image, const DeviceImage *before)
{
    Progress p = {image->length, os_is_terminal(2)};
    uint8_t permit[SMVM_PERMIT];
    Update u;
    DeviceStep step;

    memset(&u, 0, sizeof u);
    u.bytes = image->bytes;
    u.length = image->length;
    u.checksum = smvm_uint(image->bytes, SMVM_CRC_AT, 4);
    u.permit = smvm_permit_read(image->bytes, permit) && b->info.requires_signature && b->info.slots == 1 ? permit : NULL;
    u.session = (uint16_t)(os_run_nonce() | 1u);
    u.period = image->period;
    u.progress = show_progress;
    u.context = &p;
    if ((step = device_update(&b->host, &b->info, &u)) != DEVICE_DONE)
        return report_failure(b, &u, before, step);
    if (b->c->given[OPT_CONFIRM] && !device_confirm_image(&b->host, u.checksum))
        return board_report_failure(b, "it runs, but was not confirmed");
    return report_success(b, &u, before);
}

// Warns about an image that the board accepts: it starts in a state without @safe, declares no pins, or overwrites the only slot. `running`:
// the image that runs now.
static void print_warnings(BoardLine *b, const char *name, const FlashImage *image, const DeviceImage *running)
{
    SmvmMachine m;
    SmvmPins all;

    // An image that starts in a state without @safe cannot be confirmed as soon as it runs (language.md 5.46).
    for (uint32_t i = 0; smvm_machine(image->bytes, i, &m); i++)
        if (!smvm_state_is_safe(&m, 1))
            cli_print_warning(b->c, TEXT_unsafe_start, (unsigned long)i + 1, name);
    if (b->info.ram_digital != 0 && !smvm_pins(image->bytes, &all))
        cli_print_warning(b->c, TEXT_no_pins, name);
    if (b->info.slots == 1 && running->slot != DEVICE_BUILT_IN)
        cli_print_warning(b->c, TEXT_slot_replaced, (unsigned long)running->checksum);
}

int board_flash(BoardLine *b, const char *name, const FlashImage *image)
{
    FlashCheck f;
    const FlashRefusal refusal = flash_check(&b->c->session.arena, &b->host, &b->info, image, &f);

    if (refusal != FLASH_ACCEPTED)
        return report_refusal(b, name, refusal, image, &f);
    if (!f.runs_already)
        print_warnings(b, name, image, &f.running);
    if (!b->c->given[OPT_DRY_RUN])
        return send_image(b, image, &f.running);
    cli_print_note(b->c, f.runs_already ? TEXT_runs_already : TEXT_would_send, name);
    return EXIT_OK;
}
