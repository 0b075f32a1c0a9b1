// SPDX-License-Identifier: Apache-2.0
// The pins of an image on an emulated Uno.  Inputs appear in the state vector bit for bit as config.md 9 defines, computed here with double.
// The machine has the same results as on this computer, and its outputs appear at the pins.
//   run_pins ELF STEPS IMAGE.smb…
#include <math.h>
#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/sim_avr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytecode-vm/image.h"
#include "stdlib/convert.h"
#include "tests/avr/mailbox.h"
#include "tests/avr/sim.h"

enum { PINS = 20, ANALOG_FIRST = 14, EEPROM = 1024, SUPPLY = 5000000, TCCR1A = 0x80, TCCR2A = 0xB0 };

typedef struct Bench {
    Sim sim;
    PinsBox *box;
    uint8_t *ram;             // RAM of the chip
    SmvmMachine m;
    SmvmPin pin[PINS];
    unsigned pins;
    uint64_t sv[64], memory[256];                     // state vector and memory on this computer
    uint64_t sum, most, state;
    uint16_t raw[6];          // raw values of the analog channels
    bool level[PINS];
} Bench;

static uint32_t random_below(Bench *b, uint32_t n)
{
    b->state ^= b->state << 13;
    b->state ^= b->state >> 7;
    b->state ^= b->state << 17;
    return (uint32_t)(b->state >> 11) % n;
}

static bool ask(Bench *b, uint8_t what)
{
    b->box->what = what;
    return sim_until_ready(&b->sim);
}

// ---- the chip's pins ----

static char port_of(uint32_t pin) { return pin < 8 ? 'D' : pin < ANALOG_FIRST ? 'B' : 'C'; }
static unsigned bit_of(uint32_t pin) { return pin < 8 ? pin : pin < ANALOG_FIRST ? pin - 8 : pin - ANALOG_FIRST; }

static bool driven_high(Bench *b, uint32_t pin)
{
    avr_ioport_state_t s;

    avr_ioctl(b->sim.avr, AVR_IOCTL_IOPORT_GETSTATE((unsigned)port_of(pin)), &s);
    return s.ddr >> bit_of(pin) & s.port >> bit_of(pin) & 1;
}

// Returns the duty cycle of 255; -1: the pin is not an output.
static int duty(Bench *b, uint32_t pin)
{
    static const struct { uint8_t pin, control, connect, compare; } pwm[] = {
        {3, TCCR2A, 0x20, 0xB4}, {9, TCCR1A, 0x80, 0x88}, {10, TCCR1A, 0x20, 0x8A}, {11, TCCR2A, 0x80, 0xB3}};

    for (unsigned i = 0; i < 4; i++)
        if (pwm[i].pin == pin)
            return b->ram[pwm[i].control] & pwm[i].connect ? b->ram[pwm[i].compare] : driven_high(b, pin) ? 255 : 0;
    return -1;
}

static void set_inputs(Bench *b)
{
    for (unsigned c = 0; c < 6; c++) {
        b->raw[c] = (uint16_t)(random_below(b, 8) ? random_below(b, 1024) : random_below(b, 2) ? 0 : 1023);
        avr_raise_irq(avr_io_getirq(b->sim.avr, AVR_IOCTL_ADC_GETIRQ, (int)(ADC_IRQ_ADC0 + c)), (b->raw[c] * 5000u + 1022) / 1023);
    }
    for (unsigned i = 0; i < b->pins; i++)
        if (b->pin[i].kind == 2) {
            const uint32_t n = b->pin[i].pin;
            b->level[i] = random_below(b, 2);
            avr_raise_irq(avr_io_getirq(b->sim.avr, AVR_IOCTL_IOPORT_GETIRQ((unsigned)port_of(n)), (int)(IOPORT_IRQ_PIN0 + bit_of(n))), b->level[i]);
        }
}

// ---- values by config.md 9 ----

static double number(SmF64 x) { return x; }

static void expect_input(Bench *b, unsigned i)
{
    const SmvmPin *p = &b->pin[i];
    volatile double x;                                // volatile, so that each operation is rounded

    if (p->kind == 2) {
        x = b->level[i] != (p->flags & 1);
    } else {
        x = (double)((int32_t)(b->raw[p->pin] * (uint32_t)(SUPPLY / 64) >> 4)) / 1000000.0;
        x = x * number(p->scale);
        x = x + number(p->zero);
    }
    sm_store((SmType)p->type, (uint8_t *)b->sv + p->offset, x);
}

static bool is_set(Bench *b, unsigned i, double x)
{
    const SmvmPin *p = &b->pin[i];
    volatile double v = x;
    double millionths;

    if (p->kind == 3)
        return driven_high(b, p->pin) == ((x != 0) != (p->flags & 1));
    v = v - number(p->zero);
    v = v / number(p->scale);
    v = v * 1000000.0;
    millionths = round(v);
    return duty(b, p->pin) == (millionths <= 0 ? 0 : millionths >= SUPPLY ? 255 : (int)(((uint32_t)millionths * 51 + SUPPLY / 10) / (SUPPLY / 5)));
}

static bool outputs_are(Bench *b, bool safe)
{
    bool are = true;

    for (unsigned i = 0; i < b->pins; i++) {
        const SmvmPin *p = &b->pin[i];
        if ((p->kind & 1) && !is_set(b, i, safe ? number(p->safe) : number(sm_load((SmType)p->type, (uint8_t *)b->sv + p->offset)))) {
            printf("output %u (pin %u) is not as it should be\n", i, (unsigned)p->pin);
            are = false;
        }
    }
    return are;
}

// ---- running ----

static bool same(const Bench *b)
{
    const uint8_t *there = b->ram + b->box->memory, *here = (const uint8_t *)b->sv;

    for (uint32_t i = 0; i < b->m.sv_size; i++)
        if (there[i] != here[i])
            return printf("byte %lu of the state vector is %02x, expected %02x\n", (unsigned long)i, there[i], here[i]), false;
    return true;
}

static bool start(Bench *b)
{
    SmvmVector v = {b->sv, b->m.sv_size, b->m.layout};

    memset(b->sv, 0, sizeof b->sv);
    if (smvm_init(b->memory, sizeof b->memory, &b->m, &v, 1) != SM_OK || !ask(b, PINS_OPEN))
        return false;
    return b->box->result == 0 && outputs_are(b, true);
}

static bool step(Bench *b, uint64_t g)
{
    set_inputs(b);
    b->box->g = g;
    for (unsigned i = 0; i < b->pins; i++)
        if (!(b->pin[i].kind & 1))
            expect_input(b, i);
    memcpy((uint8_t *)b->sv + b->m.g, &g, sizeof g);
    (void)smvm_step((SmVm *)b->memory, b->sv);
    if (!ask(b, PINS_STEP) || !same(b) || !outputs_are(b, false))
        return false;
    b->sum += b->sim.cycles;
    b->most = b->sim.cycles > b->most ? b->sim.cycles : b->most;
    return true;
}

static bool test(Bench *b, uint8_t *image, unsigned long steps)
{
    static uint8_t eeprom[EEPROM];
    SmvmPins all;
    unsigned long i = 0;

    memcpy(eeprom, image, EEPROM);
    sim_eeprom(&b->sim, eeprom, EEPROM);
    b->sum = b->most = 0;
    b->state = 88172645463325252u;
    for (b->pins = 0, smvm_pins(image, &all); smvm_next_pin(&all, &b->pin[b->pins]);)
        b->pins++;
    if (!ask(b, PINS_VERIFY) || b->box->result != 0 || !start(b))
        return printf("does not start: %d\n", b->box->result), false;
    while (i < steps && step(b, i + 1))
        i++;
    if (i < steps)
        return printf("differs in step %lu\n", i), false;
    return ask(b, PINS_STOP) && outputs_are(b, true);
}

int main(int argc, char **argv)
{
    static uint8_t image[EEPROM];
    static Bench b;
    SmvmVerdict why;
    unsigned failed = 0;

    if (argc < 4 || !sim_open(&b.sim, argv[1]))
        return 1;
    ((avr_t *)b.sim.avr)->vcc = ((avr_t *)b.sim.avr)->avcc = ((avr_t *)b.sim.avr)->aref = 5000;
    if (!sim_until_ready(&b.sim))
        return 1;
    b.box = sim_mailbox(&b.sim);
    b.ram = sim_ram(&b.sim);
    for (int i = 3; i < argc; i++) {
        const unsigned long steps = strtoul(argv[2], NULL, 10);
        FILE *f = fopen(argv[i], "rb");
        const size_t n = f ? fread(image, 1, sizeof image, f) : 0;
        if (f)
            fclose(f);
        if (smvm_verify(image, (uint32_t)n, &why) != 0 || !smvm_machine(image, 0, &b.m) || !test(&b, image, steps)) {
            printf("%s: failed\n", argv[i]);
            failed++;
        } else
            printf("%s: %lu steps, %lu cycles on average, %lu at most\n", argv[i], steps, (unsigned long)(b.sum / steps), (unsigned long)b.most);
    }
    return failed != 0 || argc < 4;
}
