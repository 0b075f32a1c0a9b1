// SPDX-License-Identifier: Apache-2.0
// A machine of an application that runs on the VM: its image as a constant, and its memory.
#include "bytecode-vm/image.h"
#include "compiler/emit/c/app_emit.h"
#include "compiler/emit/c/emit_c.h"
#include "stdlib/roll.h"

static unsigned window_words(const SmvmMachine *m)
{
    unsigned words = 0;

    for (uint32_t w = 0; w < m->windows; w++) {
        uint32_t entry = smvm_window(m->image, m->windows_at, w);
        words += sm_roll_words(entry & SMVM_WINDOW_SIZE_MASK, entry >> SMVM_WINDOW_SIZE_BITS);
    }
    return words;
}

void put_app_image(const AppMachine *m, const Buf *image, Buf *out)
{
    const char *n = m->name->text;
    SmvmMachine vm;

    smvm_machine((const uint8_t *)image->at, 0, &vm);
    buf_printf(out, "static const uint8_t %sImage[] SMVM_IMAGE_IN = {        // %s.sm as bytecode", n, m->program->name->text);
    emit_c_bytes(image, out);
    buf_printf(out,
               "\n};\nstatic uint64_t %sMemory[SMVM_WORDS(%u, %u, %u, %u)];"
               "        // windows, their words, bytes of locals, outputs\n",
               n, (unsigned)vm.windows, window_words(&vm), (unsigned)vm.locals, (unsigned)vm.outputs);
    buf_printf(out,
               "static SmvmTarget %sSelf = {.image = SMVM_IMAGE(%sImage), .size = sizeof %sImage, "
               ".memory = %sMemory, .memory_size = sizeof %sMemory};\n",
               n, n, n, n, n);
}
