// SPDX-License-Identifier: Apache-2.0
// An Arduino in simavr, on a serial line of this computer.  It adds what simavr lacks: writing a byte of EEPROM takes 3.4 ms, in which the byte
// is undefined.  The board can be killed at any time, as by a power cut, and started again: the EEPROM is stored in a file.
//   board LINE MEMORY         LINE: a terminal device, or "-": it makes one and writes its name to MEMORY.line
//     FIRMWARE, MCU           in the environment: an ELF file and its processor
//     F_CPU                   its clock in Hz, 16000000; a board of 8000000 has 3.3 V and a line of 57600 bits per second
//     PLANT                   the simulated surroundings: none, tank, rocket (plants.c); time advances there while a file MEMORY.go exists
//     SPEED                   how many times faster than real time it may run; 1
// While there is a file MEMORY.armed the arming plug is pulled.  When it is ended by SIGTERM or SIGINT it prints statistics.
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <simavr/avr_adc.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>
#include <simavr/sim_time.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "tests/avr/plants.h"

enum {
    EEPROM_US = 3400, QUEUE = 4096,
    EECR = 0x3F, EEDR = 0x40, EEARL = 0x41, EEARH = 0x42, EERE = 1, EEPE = 2, EEMPE = 4, GPIOR0 = 0x3E, ARM_PIN = 7, PAINT = 0xA5
};

static avr_t *avr;
static uint32_t hertz, byte_cycles;   // byte_cycles: cycles for one byte on the serial line
static unsigned millivolts;           // supply voltage in mV
static int line;
static const char *memory_path;
static uint8_t *eeprom;               // the content of the file
static unsigned eeprom_size;
static uint8_t queue[QUEUE];
static size_t queued, speed = 1;
static const Plant *plant;
static volatile sig_atomic_t ended;

static struct { uint64_t steps, sum, most, begun; unsigned long read_early, written; } seen;

static void say_errors(struct avr_t *a, const int level, const char *format, va_list args)
{
    (void)a;
    if (level > LOG_ERROR)
        return;
    fprintf(stderr, "%.4f s: ", avr ? (double)avr->cycle / hertz : 0);
    vfprintf(stderr, format, args);
}

static bool there_is(const char *what)
{
    char path[512];

    snprintf(path, sizeof path, "%s.%s", memory_path, what);
    return access(path, F_OK) == 0;
}

// ---- EEPROM ----

static unsigned at;                   // address of the byte that is being written
static uint8_t coming;

static avr_cycle_count_t written(struct avr_t *a, avr_cycle_count_t when, void *param)
{
    (void)when, (void)param;
    eeprom[at] = coming;
    a->data[EECR] &= (uint8_t)~EEPE;
    seen.written++;
    return 0;
}

// Called after simavr's own handler, which completes every write at once.
static void on_eecr(struct avr_t *a, avr_io_addr_t address, uint8_t value, void *param)
{
    static bool armed;
    static bool busy;

    (void)address, (void)param;
    busy = avr_cycle_timer_status(a, written, NULL) != 0;
    if (value & EERE && busy)
        seen.read_early++;
    if (value & EEPE && armed && !busy) {
        at = (a->data[EEARL] | (unsigned)a->data[EEARH] << 8) % eeprom_size;
        coming = a->data[EEDR];
        eeprom[at] = (uint8_t)(rand() >> 4);
        avr_cycle_timer_register_usec(a, EEPROM_US, written, NULL);
        busy = true;
    }
    armed = (value & EEMPE) != 0;
    if (busy)
        a->data[EECR] |= EEPE;
}

static bool open_eeprom(void)
{
    avr_eeprom_desc_t all = {NULL, 0, 0};
    const int fd = open(memory_path, O_RDWR | O_CREAT, 0644);
    static uint8_t blank[4096];

    eeprom_size = avr->e2end + 1u;
    if (fd < 0)
        return false;
    memset(blank, 0xff, sizeof blank);
    if (lseek(fd, 0, SEEK_END) < (off_t)eeprom_size && pwrite(fd, blank, eeprom_size, 0) != (ssize_t)eeprom_size)
        return false;
    eeprom = mmap(NULL, eeprom_size, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    close(fd);
    all.ee = eeprom;
    all.size = (uint16_t)eeprom_size;
    if (eeprom == MAP_FAILED)
        return false;
    avr_ioctl(avr, AVR_IOCTL_EEPROM_SET, &all);
    return true;
}

// ---- pins ----

static const char *const uno[] = {"D0", "D1", "D2", "D3", "D4", "D5", "D6", "D7", "B0", "B1", "B2", "B3", "B4", "B5"};
static const char *const mega[] = {"E0", "E1", "E4", "E5", "G5", "E3", "H3", "H4", "H5", "H6", "B4", "B5", "B6", "B7"};

static const char *place(unsigned pin) { return strcmp(getenv("MCU"), "atmega2560") == 0 ? mega[pin] : uno[pin]; }

static avr_irq_t *wire(unsigned pin)
{
    return avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ((unsigned)place(pin)[0]), IOPORT_IRQ_PIN0 + place(pin)[1] - '0');
}

bool board_pin(unsigned pin)          // whether the chip drives the pin high
{
    avr_ioport_state_t s;

    avr_ioctl(avr, AVR_IOCTL_IOPORT_GETSTATE((unsigned)place(pin)[0]), &s);
    return s.ddr >> (place(pin)[1] - '0') & s.port >> (place(pin)[1] - '0') & 1;
}

// Drives a pin, with more current than the chip's pull-up resistor.  (One pin of each port at a time.)
void board_set_pin(unsigned pin, bool level)
{
    const unsigned bit = 1u << (place(pin)[1] - '0');
    avr_ioport_external_t e = {0};

    e.name = (unsigned char)place(pin)[0] & 0x7fu;
    e.mask = (unsigned char)bit;
    e.value = (unsigned char)(level ? bit : 0);
    avr_ioctl(avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(e.name), &e);
    avr_raise_irq(wire(pin), level);
}

void board_set_volts(unsigned channel, double volts)
{
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, (int)(ADC_IRQ_ADC0 + channel)),
                  volts < 0 ? 0 : volts * 1000 > millivolts ? millivolts : (uint32_t)(volts * 1000 + 0.5));
}

// ---- the line ----

static void on_sent(struct avr_irq_t *irq, uint32_t value, void *param)
{
    const uint8_t byte = (uint8_t)value;

    (void)irq, (void)param;
    if (write(line, &byte, 1) != 1)
        ended = 1;
}

static avr_cycle_count_t bring(struct avr_t *a, avr_cycle_count_t when, void *param)
{
    if (queued < QUEUE / 2) {
        const ssize_t n = read(line, queue + queued, QUEUE - queued);
        if (n > 0 && queued == 0)
            board_set_pin(ARM_PIN, there_is("armed"));
        queued += n > 0 ? (size_t)n : 0;
    }
    if (queued > 0) {
        avr_raise_irq(avr_io_getirq(a, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT), queue[0]);
        memmove(queue, queue + 1, --queued);
    }
    (void)param;
    return when + (queued > 0 ? byte_cycles : 8 * byte_cycles);
}

static bool open_line(const char *name)
{
    struct termios raw;
    char path[512];
    FILE *f;

    if (strcmp(name, "-") != 0)
        line = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK);
    else if ((line = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) >= 0 && grantpt(line) == 0 && unlockpt(line) == 0) {
        (void)open(ptsname(line), O_RDWR | O_NOCTTY);          // held open, so that the terminal continues to exist when a program ends
        snprintf(path, sizeof path, "%s.line", memory_path);
        if ((f = fopen(path, "w")) == NULL)
            return false;
        fprintf(f, "%s\n", ptsname(line));
        fclose(f);
    }
    if (line < 0 || tcgetattr(line, &raw) != 0)
        return false;
    cfmakeraw(&raw);
    return tcsetattr(line, TCSANOW, &raw) == 0;
}

// ---- time ----

static avr_cycle_count_t millisecond(struct avr_t *a, avr_cycle_count_t when, void *param)
{
    static bool gone;

    if (when / (hertz / 1000) % 64 == 0) {
        board_set_pin(ARM_PIN, there_is("armed"));
        gone = there_is("go");
    }
    if (plant)
        plant->step(gone ? 0.001 : 0);
    (void)a, (void)param;
    return when + hertz / 1000;
}

static uint64_t wall(void)            // real time in µs
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (uint64_t)t.tv_sec * 1000000u + (uint64_t)t.tv_nsec / 1000u;
}

// While the chip sleeps, this process sleeps too, if the simulation is ahead of real time.
static void sleep_if_ahead(avr_t *a, avr_cycle_count_t cycles)
{
    static uint64_t start;
    const uint64_t here = avr_cycles_to_usec(a, a->cycle + cycles);
    struct pollfd p = {line, POLLIN, 0};
    uint64_t now = wall();

    if (start == 0 || (now - start) * speed > here + 100000)
        start = now - here / speed;            // the simulation is too slow to reach real time again
    if ((now - start) * speed + 2000 < here)
        poll(&p, queued == 0, (int)((here - (now - start) * speed) / speed / 1000) + 1);
}

// Called by the firmware at the beginning and the end of a step.
static void on_step(struct avr_t *a, avr_io_addr_t address, uint8_t value, void *param)
{
    a->data[address] = value;
    if (value == 1) {
        seen.begun = a->cycle;
    } else if (seen.begun != 0) {
        const uint64_t took = a->cycle - seen.begun;
        seen.steps++;
        seen.sum += took;
        seen.most = took > seen.most ? took : seen.most;
    }
    (void)param;
}

// ---- the stack ----

static unsigned stack_from;           // the first address after static data

static void paint(const elf_firmware_t *f)
{
    stack_from = (avr->ramend > 0x8ff ? 0x200u : 0x100u) + f->datasize + f->bsssize + 16;
    memset(avr->data + stack_from, PAINT, avr->ramend + 1u - stack_from);
}

static unsigned deepest(void)
{
    unsigned i = stack_from;

    while (avr->data[i] == PAINT)
        i++;
    return avr->ramend + 1u - i;
}

static void on_end(int number) { (void)number, ended = 1; }

static void read_clock(const char *text)
{
    const bool slow = text && strcmp(text, "8000000") == 0;

    hertz = slow ? 8000000 : 16000000;
    byte_cycles = hertz / (slow ? 57600 : 115200) * 10;
    millivolts = slow ? 3300 : 5000;
}

static bool start(const char *elf, const char *mcu)
{
    elf_firmware_t firmware = {0};
    uint32_t flags = 0;

    avr_global_logger_set(say_errors);
    avr = avr_make_mcu_by_name(mcu);
    if (avr == NULL || elf_read_firmware(elf, &firmware) != 0)
        return false;
    avr_init(avr);
    firmware.frequency = hertz;
    avr_load_firmware(avr, &firmware);
    paint(&firmware);
    avr->vcc = avr->avcc = avr->aref = millivolts;
    avr->sleep = sleep_if_ahead;
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), on_sent, NULL);
    avr_register_io_write(avr, EECR, on_eecr, NULL);
    avr_register_io_write(avr, GPIOR0, on_step, NULL);
    avr_cycle_timer_register(avr, byte_cycles, bring, NULL);
    avr_cycle_timer_register(avr, hertz / 1000, millisecond, NULL);
    return true;
}

int main(int argc, char **argv)
{
    const char *elf = getenv("FIRMWARE"), *mcu = getenv("MCU");
    int state = cpu_Running;

    if (argc != 3 || !elf || !mcu)
        return fprintf(stderr, "board LINE MEMORY, and FIRMWARE and MCU in the environment\n"), 2;
    memory_path = argv[2];
    srand((unsigned)getpid());
    speed = getenv("SPEED") ? strtoul(getenv("SPEED"), NULL, 10) : 1;
    plant = plant_named(getenv("PLANT"));
    read_clock(getenv("F_CPU"));
    signal(SIGTERM, on_end);
    signal(SIGINT, on_end);
    if (!start(elf, mcu) || !open_eeprom() || !open_line(argv[1]))
        return fprintf(stderr, "the board cannot be run\n"), 3;
    while (!ended && state != cpu_Done && state != cpu_Crashed)
        state = avr_run(avr);
    printf("%.3f s, %llu steps, %llu cycles on average, %llu at most, %lu bytes of EEPROM written, "
           "%u bytes of stack, %u free\n",
           (double)avr->cycle / hertz, (unsigned long long)seen.steps, (unsigned long long)(seen.steps ? seen.sum / seen.steps : 0),
           (unsigned long long)seen.most, seen.written, deepest(), avr->ramend + 1u - stack_from - deepest());
    if (plant)
        plant->report();
    if (seen.read_early > 0 || state == cpu_Crashed)
        return printf("EEPROM was read %lu times while it was being written; state %d\n", seen.read_early, state), 1;
    return 0;
}
