// SPDX-License-Identifier: Apache-2.0
// A build of the VM that counts the instructions it runs.
#ifndef TESTS_COST_CONFIG_H
#define TESTS_COST_CONFIG_H

void cost_count_instruction(void);

#define SMVM_ON_INSTRUCTION cost_count_instruction()

#endif
