// SPDX-License-Identifier: Apache-2.0
// The VM as a machine of the flight runtime, on a guarded state vector, among others who write noise over all of it while it steps.  What the
// machine did not store must be noise then, and what it stored must not; after that check the noise is removed.
#ifndef TESTS_DIFF_ENGINE_TASK_H
#define TESTS_DIFF_ENGINE_TASK_H

#include "compiler/script/engine.h"

// As engine_vm_open; of locals only those are known that the image has names for.  `decoded`: it runs the decoded form.
Engine *engine_task_open(Arena *arena, const Program *p, const uint8_t *image, size_t size, bool decoded, const char **error);

#endif
