// SPDX-License-Identifier: Apache-2.0
// What the files of the emitter of applications share.
#ifndef SMC_EMIT_C_APP_EMIT_H
#define SMC_EMIT_C_APP_EMIT_H

#include "compiler/emit/c/app.h"

// ---- app_image.c ----

// The variables NAMEImage, NAMEMemory and NAMESelf.
void put_app_image(const AppMachine *m, const Buf *image, Buf *out);

#endif
