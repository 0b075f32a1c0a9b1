// SPDX-License-Identifier: Apache-2.0
#include "compiler/device/flash.h"

#include <string.h>

#include "bytecode-vm/smvm.h"
#include "compiler/budget/cost.h"

// ---- what the image needs ----

// The cost of a pin in a step, in cycles of an ATmega: the maximum measured by tests/avr/run_pins.c, rounded up.
enum { DIGITAL_CYCLES = 400, INPUT_CYCLES = 5000, OUTPUT_CYCLES = 5000 };

// Computes what an image needs of a board: RAM, cycles, pins, functions and windows.
static ImageNeeds find_image_needs(Arena *arena, const DeviceInfo *info, const FlashImage *image)
{
    ImageNeeds n = {0, image->longest, 0, 0, 0, 0, 0};
    SmvmMachine m;
    SmvmPins all;
    SmvmPin p;
    Cost cost;

    for (uint32_t i = 0; smvm_machine(image->bytes, i, &m); i++) {
        cost_of_machine(arena, image->bytes, i, COST_CYCLES_EEPROM, &cost);
        n.cycles += cost.worst;
        n.functions |= cost.functions;
        n.windows += m.windows;
        n.parameters += m.parameters_size > 0;
        n.machines++;
        n.ram += i == 0 ? m.sv_size : 0;              // the machines of an image share one state vector
        n.ram += smvm_ram_size(&m) - ((uint32_t)sizeof(SmVm) + 7) / 8 * 8 - (m.windows * (uint32_t)sizeof(uint64_t *) + 7) / 8 * 8;
    }
    (void)smvm_pins(image->bytes, &all);
    while (smvm_next_pin(&all, &p)) {
        n.ram += p.kind & 2 ? info->ram_digital : info->ram_analog;
        n.cycles += p.kind & 2 ? DIGITAL_CYCLES : p.kind & 1 ? OUTPUT_CYCLES : INPUT_CYCLES;
    }
    return n;
}

// Returns the name of the first elementary function (sin, exp, …) in a set that is not empty. Bit n is the function with number n.
static const char *name_of_first(uint32_t functions)
{
#define SM_ELEMENTARY(name, arguments, number) if ((functions >> number & 1) != 0) return #name;
#include "stdlib/elementary.def"
#undef SM_ELEMENTARY
    return "a function";
}

// Compares the needs of an image with the limits of the board. Returns the first that it exceeds, or FLASH_ACCEPTED.
static FlashRefusal check_limits(const DeviceInfo *i, const FlashImage *image, FlashCheck *c)
{
    const ImageNeeds *n = &c->needs;

    if (image->length > i->slot_size)
        return FLASH_TOO_LARGE;
    if (n->ram > i->ram)
        return FLASH_RAM_TOO_SMALL;
    if (i->longest != 0 && n->longest > i->longest)
        return FLASH_STEP_TOO_LONG;
    if (i->reports_limits && !i->windows && n->windows > 0)
        return FLASH_HAS_WINDOWS;
    if (!i->parameters && n->parameters > 0)
        return FLASH_HAS_PARAMETERS;
    if ((n->functions & ~i->functions) != 0) {
        c->function = name_of_first(n->functions & ~i->functions);
        return FLASH_CALLS_FUNCTION;
    }
    if (i->machines != 0 && n->machines > i->machines)
        return FLASH_TOO_MANY_MACHINES;
    if (i->cycles != 0 && n->cycles > c->period * i->cycles)
        return FLASH_STEP_TOO_SLOW;
    return FLASH_ACCEPTED;
}

// ---- what the board accepts now ----

// Records during which request the connection failed. `asking`: a phrase for the message.
static FlashRefusal fail_request(FlashCheck *c, const char *asking)
{
    c->asking = asking;
    return FLASH_LINK_FAILED;
}

// Whether the image on the board is the one to send, with the same period.
static bool is_same_image(const DeviceImage *there, const FlashImage *image)
{
    return there->length == image->length && there->checksum == smvm_uint(image->bytes, SMVM_CRC_AT, 4) && there->period == image->period;
}

// Refuses an image while another one is on trial, and one whose signature or number the board would refuse.
static FlashRefusal check_trial_and_signature(LinkHost *h, const DeviceInfo *info, const FlashImage *image, FlashCheck *c)
{
    if (device_find_trial_image(h, info, &c->trial))
        return is_same_image(&c->trial, image) ? FLASH_ACCEPTED : FLASH_OTHER_ON_TRIAL;
    if (!h->answered)
        return fail_request(c, "asking what is there");
    if (!info->requires_signature)
        return FLASH_ACCEPTED;
    if (!smvm_auth_read(image->bytes, &c->code))
        return FLASH_NOT_SIGNED;
    if (info->reports_mark && c->code.mark != info->mark)
        return FLASH_OTHER_KEY;
    return c->code.number <= info->newest ? FLASH_OLD_NUMBER : FLASH_ACCEPTED;
}

// Queries the board about each pin.  A board that does not report pins accepts all of them.
static FlashRefusal check_pins(LinkHost *h, const FlashImage *image, FlashCheck *c)
{
    SmvmPin at[SMVM_NO_PIN] = {{0}};   // by number of the chip's pin: the pin of the image that uses it
    bool taken[SMVM_NO_PIN] = {false};
    SmvmPins all;
    uint8_t index;

    (void)smvm_pins(image->bytes, &all);
    while (smvm_next_pin(&all, &c->pin)) {
        if (!device_find_chip_pin(h, smvm_pin_kind(&c->pin), (uint16_t)c->pin.pin, &index))
            return h->answered && h->result == SM_E_UNSUPPORTED ? FLASH_ACCEPTED : fail_request(c, "asking about pins");
        if (index == SMVM_NO_PIN)
            return FLASH_PIN_ABSENT;
        if (taken[index]) {
            c->other = at[index];
            return FLASH_PINS_CLASH;
        }
        taken[index] = true;
        at[index] = c->pin;
    }
    return FLASH_ACCEPTED;
}

// Decides whether `image` can be sent.  The signature of an image that already runs or is on trial is not checked, because it is not sent.
FlashRefusal flash_check(Arena *arena, LinkHost *h, const DeviceInfo *info, const FlashImage *image, FlashCheck *c)
{
    FlashRefusal refusal;

    memset(c, 0, sizeof *c);
    c->needs = find_image_needs(arena, info, image);
    c->period = image->period != 0 ? image->period : info->period;
    if ((refusal = check_limits(info, image, c)) != FLASH_ACCEPTED)
        return refusal;
    if (info->may != SM_OK)
        return FLASH_NO_UPDATE_NOW;
    if (!device_find_running_image(h, info, &c->running))
        return fail_request(c, "asking what runs");
    c->runs_already = is_same_image(&c->running, image);
    if (!c->runs_already && (refusal = check_trial_and_signature(h, info, image, c)) != FLASH_ACCEPTED)
        return refusal;
    return check_pins(h, image, c);
}

// ---- after a failure ----

// Finds what has become of the image that ran before an update that failed.
FlashPrevious flash_find_previous(LinkHost *h, const DeviceInfo *info, const DeviceImage *previous)
{
    DeviceImage now;

    if (info->slots > 1)
        return PREVIOUS_RUNS;
    if (!h->answered || !device_find_running_image(h, info, &now))
        return PREVIOUS_UNKNOWN;
    if (now.slot == previous->slot)
        return PREVIOUS_RUNS;
    return device_read_image_info(h, previous->slot, &now) && now.chosen ? PREVIOUS_RUNS_AFTER_RESTART : PREVIOUS_OVERWRITTEN;
}
