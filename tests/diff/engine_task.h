// SPDX-License-Identifier: Apache-2.0
// The VM as a machine of the flight runtime, on a guarded state vector.  Other tasks write noise over the whole vector while it steps.  After
// the step, what the machine stored must not be noise, and everything else must be.  The check then removes the noise.
#ifndef TESTS_DIFF_ENGINE_TASK_H
#define TESTS_DIFF_ENGINE_TASK_H

#include "compiler/script/engine.h"

// Like engine_vm_open.  Only locals whose names are in the image can be read.  `decoded`: it runs the decoded form.
Engine *engine_task_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, bool decoded, const char **error);

#endif
