# SPDX-License-Identifier: Apache-2.0
# Builds smc with a C compiler and make, nothing else.  `make help` lists the targets.

B       ?= build
CC      ?= cc
AR      ?= ar
BUILD_CC ?= $(CC)
DEFAULT_CFLAGS = -O2
CFLAGS  ?= $(DEFAULT_CFLAGS)
DEPFLAGS ?= $(if $(findstring tcc,$(CC)),-MD,-MMD -MP)
PREFIX  ?= /usr/local
WARN     = -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -pedantic
# The meaning of a program rests on plain IEEE arithmetic: no contraction of a*b+c, whatever CFLAGS says.  And gcc 12 at -O2 drops
# the rounding of (double)(float)x where its SLP vectoriser does two of them at once.
STRICT_C = -std=c99 -ffp-contract=off -fno-tree-slp-vectorize -I. -I$(B)/gen

VERSION := $(shell sed -n 's/.*SMC_VERSION "\(.*\)".*/\1/p' compiler/version.h)

# Sources, folder by folder in the order data flows through them.
STDLIB   = $(wildcard stdlib/*.c)
VM       = $(wildcard bytecode-vm/*.c)
VM_TEXT  = $(wildcard bytecode-vm/disasm*.c)
VM_FAST  = $(wildcard bytecode-vm/decode*.c) bytecode-vm/fast.c
LINK     = $(wildcard runtime-c/link/*.c)
EMIT_C   = $(filter-out %/embed_tool.c,$(wildcard compiler/emit/c/*.c))
LIBSMC   = $(filter-out compiler/base/os_%,$(wildcard compiler/base/*.c)) $(wildcard compiler/data/*.c compiler/diag/*.c compiler/syntax/*.c compiler/sema/*.c compiler/ir/*.c \
             compiler/facts/*.c compiler/passes/*.c compiler/analysis/*.c compiler/budget/*.c) $(EMIT_C) $(wildcard compiler/emit/bytecode/*.c compiler/report/*.c compiler/script/*.c compiler/cover/*.c compiler/whatif/*.c compiler/diff/*.c compiler/search/*.c compiler/prove/*.c compiler/library/*.c compiler/*.c) $(STDLIB) $(VM) $(LINK)
# os.h on the system that smc is built for: os_files.c, and os_posix.c and os_*_posix.c, or os_windows.c and os_*_windows.c.
SYSTEM   = $(if $(findstring mingw,$(CC)),windows,posix)
OS_FILES = compiler/base/os_files.c $(wildcard compiler/base/os_$(SYSTEM).c compiler/base/os_*_$(SYSTEM).c)
COMMAND  = $(OS_FILES) $(wildcard compiler/device/*.c compiler/cli/*.c)

# `make V=1` shows the commands themselves, `make -s` nothing.
say = $(if $(V)$(findstring s,$(firstword -$(MAKEFLAGS))),,@echo '  $(1)  $(patsubst $(B)/%,%,$@)';)

all: $(B)/smc

# The objects of libsmc are also those of the installed library: position-independent, and only what smc.h declares is exported.
LIB_FLAGS ?= $(if $(findstring tcc,$(CC)),,-fPIC -fvisibility=hidden) -DSMC_LIBRARY
$(LIBSMC:%.c=$(B)/obj/%.o): OWN_FLAGS = $(LIB_FLAGS)
$(B)/obj/%.o: %.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(OWN_FLAGS) $(DEPFLAGS) -c $< -o $@

# The engine vm-soft: the VM once more as on a chip, with soft numbers and opcodes that share code, its names changed so that both fit in one
# program.
VM_SOFT = $(patsubst %.c,$(B)/soft/obj/%.o,compiler/script/engine_vm.c $(VM))
$(B)/gen/soft_names.h: $(wildcard bytecode-vm/*.[ch]) compiler/script/engine_vm.c
	@mkdir -p $(@D)
	$(call say,GEN)cat $^ | tr -c 'a-z0-9_' '\n' | grep '^smvm_\|^engine_vm_' | sort -u | \
	    sed -e 's/.*/#define & soft_&/' -e 's/soft_engine_vm_open/engine_vm_soft_open/' >$@.new && mv $@.new $@
$(B)/soft/obj/%.o: %.c $(B)/gen/soft_names.h
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) -DSM_F64_SOFT=1 -DSMVM_KEEP_TABLES=1 -DSMVM_SPECIALIZE=0 -include $(B)/gen/soft_names.h $(WARN) $(CFLAGS) $(LIB_FLAGS) $(DEPFLAGS) -c $< -o $@

# What need not be fast is built in half the time.  (The command only tests with the VM; the library is built apart.)
SELDOM = $(filter-out compiler/script/ref% compiler/script/script_run.c compiler/script/monitor.c compiler/script/schedule.c, \
             $(filter compiler/cli/% compiler/device/% compiler/diag/% compiler/report/% compiler/script/%,$(LIBSMC) $(COMMAND)))
$(B)/obj/bytecode-vm/interp.o $(B)/obj/bytecode-vm/fast.o $(SELDOM:%.c=$(B)/obj/%.o): override CFLAGS := $(CFLAGS:-O2=-O1)
$(VM_SOFT): override CFLAGS := $(patsubst -O%,-O0,$(CFLAGS))

$(B)/libsmc.a: $(LIBSMC:%.c=$(B)/obj/%.o) $(VM_SOFT)
	@rm -f $@
	$(call say,AR)$(AR) rcs $@ $^

$(B)/smc $(B)/smc.exe: $(COMMAND:%.c=$(B)/obj/%.o) $(B)/libsmc.a
	$(call say,LD)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(if $(filter %.exe,$@),-lws2_32)

# The texts of the stdlib functions that emitted C quotes.
EMBEDDED = stdlib/f64.h stdlib/convert.h stdlib/math.h stdlib/roll.h stdlib/flash.h stdlib/elementary.h
$(B)/embed_tool: compiler/emit/c/embed_tool.c
	@mkdir -p $(@D)
	$(call say,CC)$(BUILD_CC) -std=c99 -pedantic -Wall -Wextra $< -o $@

$(B)/gen/stdlib_text.h: $(B)/embed_tool $(EMBEDDED)
	@mkdir -p $(@D)
	$(call say,GEN)$(B)/embed_tool $(EMBEDDED) >$@.new && mv $@.new $@

# Soft binary64 as it goes with emitted C for chips without it.
SOFT_EMBEDDED = header:stdlib/soft.h,stdlib/f64_soft.h cells:stdlib/soft_cells.h \
                code:stdlib/soft_pack.h,stdlib/soft_arith.c,stdlib/soft_convert.c,stdlib/soft_cells.c \
                assembly:stdlib/soft_pack.h,stdlib/soft_avr.S,stdlib/soft_cells_avr.S,stdlib/soft_sqrt_avr.S
$(B)/gen/soft_text.h: $(B)/embed_tool $(wildcard stdlib/*soft*)
	@mkdir -p $(@D)
	$(call say,GEN)for f in $(SOFT_EMBEDDED); do $(B)/embed_tool -lines soft_$${f%%:*} $$(echo $${f#*:} | tr , ' ') || exit 1; done >$@.new && mv $@.new $@

$(EMIT_C:%.c=$(B)/obj/%.o): | $(B)/gen/stdlib_text.h $(B)/gen/soft_text.h

# The generic firmware of Arduino boards (docs/boards.md): `make firmware MCU=atmega2560` (Mega) or atmega328p (Uno, Nano, Pro Mini) makes
# build/firmware/MCU.hex.  F_CPU: the board's clock in Hz, 16000000 or, for a Pro Mini of 3.3 V, 8000000.  SAFE: another image to be built in; ARM_PIN: the pin with the arming plug; KEY: a file of smc key, and no image but those signed
# with it is run.
MCU         ?= atmega2560
F_CPU       ?= 16000000
AVR_CC      ?= avr-gcc
FIRMWARE_OUT = $(B)/firmware
FIRMWARE_SRC = $(addprefix bytecode-vm/,firmware/firmware.c firmware/runner.c target/store.c target/agent.c target/state_log.c target/io.c auth.c permit.c pins.c load.c verify.c interp.c function.c interp_avr_eeprom.S) \
               runtime-c/link/link.c runtime-c/link/transition.c runtime-c/pin.c runtime-c/event.c $(wildcard runtime-c/psl/avr/*.c stdlib/soft_*.c stdlib/soft_*.S)
# What makes avr-gcc 5.4 make the least of it, together 3 % less than -Os, -mcall-prologues, -mrelax and -flto alone.
FIRMWARE_SMALL = -Os -mcall-prologues -mrelax -mstrict-X -flto -flto-partition=one -fira-algorithm=priority -fshort-enums -fno-ipa-sra -fno-tree-dominator-opts \
               -finline-limit=6 -fno-jump-tables -fno-move-loop-invariants -fno-gcse -fno-tree-tail-merge -fno-tree-pta
FIRMWARE_C   = $(AVR_CC) -mmcu=$(MCU) -DF_CPU=$(F_CPU)UL $(FIRMWARE_SMALL) -std=c99 $(filter-out -pedantic,$(WARN)) -Wno-maybe-uninitialized -I. -I$(FIRMWARE_OUT) \
               -ffunction-sections -fdata-sections -Wl,--gc-sections $(foreach v,SMVM_CONFIG SM_CONFIG,-D$(v)='"bytecode-vm/firmware/config.h"') $(if $(ARM_PIN),-DFIRMWARE_ARM_PIN=$(ARM_PIN)) $(if $(KEY),-DFIRMWARE_KEY)
firmware: $(B)/smc
	@case '$(MCU)' in atmega328p | atmega2560) ;; *) echo "MCU=$(MCU): atmega328p is an Uno, a Nano or a Pro Mini, atmega2560 a Mega" >&2; exit 1 ;; esac
	@case '$(F_CPU)' in 16000000 | 8000000) ;; *) echo "F_CPU=$(F_CPU): the clock of the board in Hz is 16000000 or 8000000" >&2; exit 1 ;; esac
	@case '$(ARM_PIN)' in '' | [0-9] | [1-9][0-9]) ;; *) echo "ARM_PIN=$(ARM_PIN): it is the number of a digital pin, as in ARM_PIN=7" >&2; exit 1 ;; esac
	@mkdir -p $(FIRMWARE_OUT)
	$(B)/smc build -w bytecode-vm/firmware/safe.sm --sv bytecode-vm/firmware/safe.sv --io bytecode-vm/firmware/safe.io -o $(FIRMWARE_OUT)/safe.smb
	@$(B)/smc verify '$(or $(SAFE),$(FIRMWARE_OUT)/safe.smb)' >$(FIRMWARE_OUT)/safe.txt
	@! grep -q 'not marked @safe' $(FIRMWARE_OUT)/safe.txt || echo 'warning: $(SAFE) starts in a state that is not marked @safe: until it has left it, the board takes no image' >&2
	od -An -v -tx1 $(or $(SAFE),$(FIRMWARE_OUT)/safe.smb) | sed 's/ \(..\)/0x\1,/g' >$(FIRMWARE_OUT)/safe_image.inc
ifneq ($(KEY),)
	@grep -qx '[0-9a-fA-F]\{32\}' '$(KEY)' || { echo "KEY=$(KEY) is no key of smc key, 32 hexadecimal digits: 'smc key FILE' makes one" >&2; exit 1; }
	@umask 077 && sed 's/\(..\)/0x\1,/g' '$(KEY)' >$(FIRMWARE_OUT)/key.inc
endif
	$(call say,AVR)$(FIRMWARE_C) $(FIRMWARE_SRC) -Wl,-Map=$(FIRMWARE_OUT)/$(MCU).map -o $(FIRMWARE_OUT)/$(MCU).elf
	avr-objcopy -O ihex -R .eeprom $(FIRMWARE_OUT)/$(MCU).elf $(FIRMWARE_OUT)/$(MCU).hex
	avr-size $(FIRMWARE_OUT)/$(MCU).elf
.PHONY: firmware

# `make emulate MCU=atmega328p`: an emulated Uno (or Mega) with this firmware, at a line of this computer, until Ctrl-C.  Needs libsimavr.
emulate: $(B)/smc
	@case '$(MCU)' in atmega328p | atmega2560) ;; *) echo "MCU=$(MCU): atmega328p is an Uno, atmega2560 a Mega" >&2; exit 1 ;; esac
	@exec sh tests/avr/emulate.sh '$(MAKE)' '$(B)' '$(CC)' $(MCU)
.PHONY: emulate

# ---- the Arduino library ----

# `make arduino`: the library, for the Arduino IDE, arduino-cli and PlatformIO, in $(B)/arduino/smc, and as a .zip where there is zip.
# PROJECT_URL: the address where the project is published, for its description; without one the library names none.
PROJECT_URL      ?=
ARDUINO           = $(B)/arduino/smc
ARDUINO_SOURCES   = $(sort $(STDLIB) $(filter-out $(VM_TEXT) %/debug.c %/swap.c,$(VM)) $(FIRMWARE_SRC))
ARDUINO_INPUTS    = $(wildcard arduino/* arduino/examples/*/* stdlib/* bytecode-vm/*.* bytecode-vm/firmware/* bytecode-vm/target/* runtime-c/*.* \
                      runtime-c/link/* runtime-c/pal/* runtime-c/psl/avr/*) docs/arduino.md compiler/version.h
arduino: $(ARDUINO)/library.properties
$(ARDUINO)/library.properties: $(ARDUINO_INPUTS) $(B)/smc
	$(call say,ARDUINO)sh arduino/make.sh $(B)/smc $(ARDUINO) '$(VERSION)' '$(PROJECT_URL)' $(ARDUINO_SOURCES)
.PHONY: arduino

# ---- installing ----

DEST = $(DESTDIR)$(PREFIX)
INSTALLED_HEADERS = $(wildcard stdlib/*.h stdlib/*.def bytecode-vm/*.h bytecode-vm/*.def)
# What smc.mk builds applications from, as it lies here.
INSTALLED_RUNTIME = $(sort $(shell find runtime-c stdlib bytecode-vm -type f ! -name "*.in"))

# The library is built with CFLAGS as they are, position-independent, and exports the functions of smvm.h, swap.h and result.h only.
VM_LIB_FLAGS ?= -fPIC -fvisibility=hidden
$(B)/lib/obj/%.o: %.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(VM_LIB_FLAGS) -DSMVM_LIBRARY $(DEPFLAGS) -c $< -o $@

$(B)/libsmvm.a: $(VM:%.c=$(B)/lib/obj/%.o) $(STDLIB:%.c=$(B)/lib/obj/%.o)
	@rm -f $@
	$(call say,AR)$(AR) rcs $@ $^

# libsmc, for programs that compile and run machines (smc.h).  The archive has one object, whose only global names are those of smc.h, so that
# it can be linked beside anything.  Its VM is built with CFLAGS as they are, because programs step machines with it.
SONAME      = libsmc.so.$(shell sed -n 's/^.define SMC_API_VERSION //p' compiler/library/smc.h)
LIB_VM      = bytecode-vm/interp bytecode-vm/fast
LIB_OBJECTS = $(filter-out $(LIB_VM:%=$(B)/obj/%.o),$(LIBSMC:%.c=$(B)/obj/%.o)) $(LIB_VM:%=$(B)/lib/smc/%.o) $(VM_SOFT)
OBJCOPY    ?= objcopy
$(LIB_VM:%=$(B)/lib/smc/%.o): $(B)/lib/smc/%.o: %.c
	@mkdir -p $(@D)
	$(call say,CC)$(CC) $(STRICT_C) $(WARN) $(CFLAGS) $(LIB_FLAGS) $(DEPFLAGS) -c $< -o $@
$(B)/lib/libsmc.a: $(LIB_OBJECTS)
	@rm -f $@
	$(call say,AR)$(CC) -r -nostdlib -o $(@D)/libsmc.o $^ && $(OBJCOPY) --localize-hidden $(@D)/libsmc.o && $(AR) rcs $@ $(@D)/libsmc.o
$(B)/lib/$(SONAME): $(LIB_OBJECTS)
	$(call say,LD)$(CC) $(CFLAGS) -shared -Wl,-soname,$(SONAME) -o $@ $^

install: all $(B)/libsmvm.a $(B)/lib/libsmc.a $(B)/lib/$(SONAME)
	mkdir -p "$(DEST)/bin" "$(DEST)/lib/pkgconfig" "$(DEST)/share/smc/docs/evidence" "$(DEST)/include/smc/stdlib" "$(DEST)/include/smc/bytecode-vm"
	cp $(B)/smc "$(DEST)/bin/smc"
	cp $(B)/libsmvm.a "$(DEST)/lib/libsmvm.a"
	cp $(B)/lib/libsmc.a "$(DEST)/lib/libsmc.a"
	cp $(B)/lib/$(SONAME) "$(DEST)/lib/$(SONAME)"
	ln -sf $(SONAME) "$(DEST)/lib/libsmc.so"
	cp compiler/library/smc.h "$(DEST)/include/smc.h"
	sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' bytecode-vm/smvm.pc.in >"$(DEST)/lib/pkgconfig/smvm.pc"
	sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' compiler/library/smc.pc.in >"$(DEST)/lib/pkgconfig/smc.pc"
	cp compiler/smc.mk "$(DEST)/share/smc/smc.mk"
	cp docs/*.md docs/*.svg "$(DEST)/share/smc/docs"
	cp docs/evidence/*.md "$(DEST)/share/smc/docs/evidence"
	cp -r editors "$(DEST)/share/smc"
	@for f in $(INSTALLED_HEADERS); do cp $$f "$(DEST)/include/smc/$$f" || exit 1; done
	@for f in $(INSTALLED_RUNTIME); do mkdir -p "$(DEST)/share/smc/$$(dirname $$f)" && cp $$f "$(DEST)/share/smc/$$f" || exit 1; done

# ---- Python ----

# `make wheel`: the package of python/ for any Python 3 of this platform, in WHEEL.  PIP_FLAGS: more options of pip.
# `make wheel-windows`: the same for Windows, 64 and 32 bits, by MinGW-w64.
PYTHON ?= python3
WHEEL  ?= $(B)/wheel
wheel:
	B='$(B)' $(PYTHON) -m pip wheel -q --disable-pip-version-check --no-deps $(PIP_FLAGS) -w '$(WHEEL)' ./python
wheel-windows:
	for machine in x86_64 i686; do SMC_WINDOWS=$$machine $(MAKE) --no-print-directory wheel || exit 1; done

# Runs a program with the package of this tree.
RUN_PYTHON = SMC_LIBRARY='$(abspath $(B)/lib/$(SONAME))' PYTHONPATH=python PYTHONDONTWRITEBYTECODE=1 $(PYTHON)
bench-python: $(B)/lib/$(SONAME)
	@$(RUN_PYTHON) tests/python/speed.py

# `make rocketpy FLIGHTS=100`: examples/rocketpy.  Needs numpy, cffi, matplotlib and rocketpy.
FLIGHTS ?= 100
rocketpy: $(B)/lib/$(SONAME)
	$(RUN_PYTHON) examples/rocketpy/fly.py --flights $(FLIGHTS) --cc '$(CC)' -o $(B)/rocketpy
.PHONY: wheel wheel-windows bench-python rocketpy

uninstall:
	rm -f "$(DEST)/bin/smc" "$(DEST)/lib/libsmvm.a" "$(DEST)/lib/pkgconfig/smvm.pc" \
	    "$(DEST)/lib/libsmc.a" "$(DEST)/lib/libsmc.so" "$(DEST)/lib/$(SONAME)" "$(DEST)/lib/pkgconfig/smc.pc" "$(DEST)/include/smc.h"
	rm -rf "$(DEST)/share/smc" "$(DEST)/include/smc"

# ---- Windows ----

# `make windows`: smc.exe and smc.dll for Windows, in $(B)/windows-x86_64 and $(B)/windows-i686, by MinGW-w64.  windows-x86_64 or
# windows-i686 makes one of them.  WINDOWS_CFLAGS is added for both.
# 32-bit x86: SSE2, because x87 registers would change results; and callers such as LabVIEW align the stack to 4 bytes only.
WINDOWS_x86_64 =
WINDOWS_i686   = -msse2 -mfpmath=sse -mstackrealign
WINDOWS_FILES  = smc.exe smc.dll
WINDOWS_LD     = -s -static-libgcc -Wl,--stack,8388608
windows: windows-x86_64 windows-i686
windows-x86_64 windows-i686: windows-%:
	@command -v $*-w64-mingw32-gcc >/dev/null || { echo "there is no $*-w64-mingw32-gcc; on Debian or Ubuntu: apt-get install gcc-mingw-w64-$(subst _,-,$*)" >&2; exit 1; }
	@$(MAKE) --no-print-directory B='$(B)/$@' CC=$*-w64-mingw32-gcc AR=$*-w64-mingw32-ar BUILD_CC='$(BUILD_CC)' LIB_FLAGS=-DSMC_LIBRARY \
	    CFLAGS='$(CFLAGS) $(WINDOWS_$*)' LDFLAGS='$(LDFLAGS) $(WINDOWS_LD)' $(WINDOWS_FILES:%='$(B)/$@/%')
.PHONY: windows windows-x86_64 windows-i686

# smc.dll exports what smc.h and labview.h declare, undecorated also on 32-bit x86, and depends on KERNEL32 and msvcrt alone.  smc.def lists
# the names for linkers that need an import library of their own.
DLL_HEADERS = compiler/library/smc.h compiler/labview/labview.h
$(B)/smc.def: $(DLL_HEADERS)
	@mkdir -p $(@D)
	$(call say,GEN)(echo EXPORTS; sed -n 's/^[a-zA-Z].*[ *]\(smc[a-z]*_[a-z0-9_]*\)(.*/\1/p' $(DLL_HEADERS)) >$@.new && mv $@.new $@
$(B)/smc.dll: $(LIB_OBJECTS) $(B)/obj/compiler/labview/labview.o $(B)/smc.def
	$(call say,LD)$(CC) $(CFLAGS) -shared $(LDFLAGS) -Wl,--exclude-all-symbols -Wl,--out-implib,$(B)/libsmc.dll.a -o $@ $^

# ---- NI sbRIO ----

# `make sbrio`: the runtime, and the test stand as an example, for NI Linux Real-Time, in SBRIO (docs/sbrio.md).
#   CROSS    the prefix of a cross compiler, such as arm-nilrt-linux-gnueabi-, with SYSROOT where it needs one; without: CC, for x86-64
#   NIFPGA   the folder of NiFpga.c, NiFpga.h and NiFpga_Teststand.h, which NI's generator writes; without: the stand-in of the tests
CROSS   ?=
SYSROOT ?=
NIFPGA  ?= tests/sbrio
SBRIO   ?= $(B)/sbrio
sbrio: $(B)/smc
	@mkdir -p '$(SBRIO)' && rm -f '$(SBRIO)'/NiFpga*
	@cp -p examples/sbrio/* $(addprefix examples/teststand/,teststand.app teststand.io teststand.sv monitor.sm stand.sm) '$(NIFPGA)'/NiFpga* '$(SBRIO)'
	@env -u MAKEFLAGS -u MAKELEVEL $(MAKE) -s --no-print-directory -C '$(SBRIO)' SMC='$(abspath $(B)/smc)' SMC_MK='$(abspath compiler/smc.mk)' CFLAGS='$(CFLAGS)' \
	    $(if $(CROSS),CROSS='$(CROSS)' SYSROOT='$(SYSROOT)',CC='$(CC)') $(if $(filter command,$(word 1,$(origin PSL_WATCHDOG))),PSL_WATCHDOG='$(PSL_WATCHDOG)')
.PHONY: sbrio

help:
	@echo 'make                 builds $(B)/smc'
	@echo 'make quick           runs the tests of the developer loop: 20 seconds on two cores'
	@echo 'make check           runs every test that this computer can run, and names the tools that skipped tests need; JOBS=1: one after another'
	@echo 'make check-NAME      runs one test; make list-tests: their names and commands; make check-thorough, check-targets: a part of them'
	@echo 'make test T=FILE     runs some conformance cases on every engine'
	@echo 'make diff N=100000   runs so many random programs on all engines, from seed SEED=1, in J=2 processes'
	@echo 'make f64-campaign N=100000000  tries soft binary64 on so many random operands for each operation'
	@echo 'make avr-cycles      measures again what instructions take on an ATmega328P, for reports'
	@echo 'make avr-campaign N=10000  runs so many random programs as images on an emulated ATmega328P'
	@echo 'make avr-c-campaign N=1000  runs so many random programs as C on an emulated ATmega328P, and every conformance case'
	@echo 'make sound N=100000  runs so many random programs and holds them against what the analyses say of them'
	@echo 'make stress-runtime  N=1000000 steps of random applications of the flight runtime, from SEED=1; make lateness: how late ticks begin here'
	@echo 'make library-campaign N=100000  makes random calls into libsmc under the sanitizers, from SEED=1'
	@echo 'make asan            runs the tests under the address and undefined-behaviour sanitizers'
	@echo 'make fuzz            fuzzes with clang: FUZZ=target FUZZ_SECONDS=60'
	@echo 'make docs            writes docs/diagnostics.md and the pictures of documents; wrap-docs: wraps documents at 100 columns; grammars: writes the grammars in editors/'
	@echo 'make bench           measures what a step costs and what code weighs: W=mission, one workload; bench-scale: how compile time grows; bench-runtime: the state vector'
	@echo 'make sizes           measures what the parts take on boards: flash, RAM, stack, cycles'
	@echo 'make emulate MCU=atmega328p  runs an emulated Uno (atmega2560: Mega) with the firmware, for smc flash and smc device; needs libsimavr'
	@echo 'make arduino         makes the Arduino library, $(ARDUINO) and smc.zip beside it'
	@echo 'make wheel           makes the Python package, $(WHEEL)/smc-….whl; wheel-windows: those for Windows; bench-python: its speed; rocketpy: flies examples/rocketpy FLIGHTS=100 times'
	@echo 'make windows         smc.exe and smc.dll for Windows, 64 and 32 bits, by MinGW-w64; windows-x86_64, windows-i686: one of them'
	@echo 'make sbrio           the runtime and the test stand for NI Linux Real-Time, in $(SBRIO); CROSS=arm-linux-gnueabi-: for ARM; NIFPGA=FOLDER: with the files of NI'
	@echo 'make install         to PREFIX ($(PREFIX)), below DESTDIR if that is set; uninstall removes it'
	@echo 'make clean           removes $(B)'

clean:
	rm -rf $(B)

.PHONY: all install uninstall help clean

include tests/tests.mk
-include $(shell find $(B) -name '*.d' 2>/dev/null)
